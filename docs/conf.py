# SPDX-FileCopyrightText: 2026 The Mahlwerk authors
# SPDX-License-Identifier: Apache-2.0
"""Configuration of Sphinx for the documentation site; tools/build_docs builds it."""
import os
import pathlib
import re
import sys

HOME = pathlib.Path(__file__).resolve().parents[1]
sys.path.insert(0, str(HOME / "docs" / "site"))
# The package as it was built, with its compiled part, or its sources alone.
PYTHON = os.environ.get("MAHLWERK_PYTHON_PACKAGE") or str(HOME / "python")
sys.path.insert(0, PYTHON)

project = "Mahlwerk"
author = "The Mahlwerk authors"
copyright = "2026 The Mahlwerk authors"  # the name that Sphinx wants
release = version = re.search(r"^version: *(\S+)", (HOME / "CITATION.cff").read_text(), re.M)[1]

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.mathjax", "equations", "cells", "docstrings", "snippets"]
if os.environ.get("MAHLWERK_DOXYGEN_XML"):
    extensions.append("breathe")
    breathe_projects = {"mahlwerk": os.environ["MAHLWERK_DOXYGEN_XML"]}
    breathe_default_project = "mahlwerk"

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 6
myst_dmath_double_inline = False

exclude_patterns = []
root_doc = "index"
smartquotes = False  # --set stays --set
highlight_language = "none"  # indented code is output
pygments_style = "tango"
pygments_dark_style = "monokai"

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
python_use_unqualified_type_names = True
if not list(pathlib.Path(PYTHON).glob("mahlwerk/_core*.so")):
    autodoc_mock_imports = ["mahlwerk._core"]

html_theme = "furo"
html_title = f"Mahlwerk {release}"
html_static_path = [str(HOME / "docs" / "site" / "static")]
html_css_files = ["site.css"]
html_extra_path = [path for path in os.environ.get("MAHLWERK_SITE_EXTRA", "").split(os.pathsep) if path]
html_copy_source = False
html_search_scorer = str(HOME / "docs" / "site" / "search_scores.js")
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#0b5d7a", "color-brand-content": "#0b5d7a"},
    "dark_css_variables": {"color-brand-primary": "#6fc3df", "color-brand-content": "#6fc3df"},
    "footer_icons": [],
}
# A copy in the site: no page asks another server for anything.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"showMathMenu": False, "messageStyle": "none", "displayAlign": "left",
                   "SVG": {"scale": 92, "linebreaks": {"automatic": True}},
                   "tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]],
                               "processClass": "tex2jax_process|mathjax_process|math|output_area"}}


def setup(app):
    from pygments.lexers.special import TextLexer

    app.add_lexer("csv", TextLexer)
