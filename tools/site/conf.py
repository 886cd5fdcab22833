"""The site of all documents: see tools/docs."""

project = "sbeh"
author = "the maintainers of sbeh"
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "furo"
html_title = "sbeh"
html_copy_source = False
myst_heading_anchors = 4
exclude_patterns = ["tools/site/*"]
suppress_warnings = ["myst.header"]
autodoc_member_order = "bysource"
autodoc_typehints = "description"
