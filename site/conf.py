"""Sphinx's settings for the documentation site; `tools/site_build.py` lays its sources out and runs it."""

from __future__ import annotations

import sys
from pathlib import Path

import motes

project = "Motes"
author = "the Motes developers"
copyright = "the Motes developers"
version = release = motes.__version__
sys.path.insert(0, str(Path(__file__).parent / "_ext"))
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "motes_pages"]
exclude_patterns = ["_build"]
default_role = "py:obj"
html_theme = "furo"
html_title = "Motes"
html_static_path = ["_static"]
html_css_files = ["motes.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_math_renderer = "mathml"  # no script and no font from elsewhere
html_theme_options = {"navigation_with_keys": True}
pygments_style, pygments_dark_style = "xcode", "github-dark"

myst_enable_extensions = ["deflist"]
myst_heading_anchors = 4
myst_links_external_new_tab = False

napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_use_ivar = True  # attributes stand in a list, and each once
autodoc_typehints = "none"  # numpydoc's sections say the types that matter, shapes and units
autodoc_member_order = "bysource"
autodoc_mock_imports: list[str] = []
