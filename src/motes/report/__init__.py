"""A fit as a page to look at: `write_report`, `write_time_report`; and pictures of materials: `render_sphere`."""

from motes.report.over_time import write_time_report
from motes.report.page import write_report
from motes.report.sphere import render_sphere, sphere_radiance

__all__ = ["render_sphere", "sphere_radiance", "write_report", "write_time_report"]
