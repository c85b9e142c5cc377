"""How ``make docs`` builds these pages with Sphinx."""

from __future__ import annotations

import re
from typing import Any

from laplace_core import __version__

project = "Laplace code workbench"
release = __version__
language = "en"

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "sphinx.ext.napoleon",
    "sphinx-mathjax-offline",  # built pages need no network
]
exclude_patterns = ["_build", "paper/README.md", "searches", "inverse"]
templates_path = ["_templates"]
html_theme = "furo"
html_title = project

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4

suppress_warnings = ["ref.python"]  # classes may share the names of their fields
napoleon_use_ivar = True
autodoc_member_order = "bysource"
autodoc_inherit_docstrings = False  # those of gymnasium are not ours
autodoc_default_options = {"members": True}
python_maximum_signature_line_length = 100


def setup(app: Any) -> None:
    app.connect("autodoc-process-docstring", _plain_bars)


def _plain_bars(_app: Any, _what: str, _name: str, _object: Any, _options: Any, lines: list[str]) -> None:
    """Docstrings write |x| for the size of x, where reStructuredText would look for a substitution."""
    for i, line in enumerate(lines):
        lines[i] = "".join(
            part if part.startswith("``") else part.replace("|", r"\|") for part in re.split(r"(``.*?``)", line)
        )
