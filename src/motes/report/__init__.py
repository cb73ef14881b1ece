"""A fit as a page to look at: `write_report`, `write_time_report`; and pictures of materials: `render_sphere`."""

from motes.drawing.sphere import render_sphere, sphere_radiance
from motes.report.fit_page import write_report
from motes.report.time_page import write_time_report

__all__ = ["render_sphere", "sphere_radiance", "write_report", "write_time_report"]
