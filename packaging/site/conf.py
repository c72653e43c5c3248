"""Settings of Sphinx for the site of ./dev docs: the pages of docs/, and the reference of the Python module."""

import os
import pathlib
import re
import sys

from pygments.lexers.special import TextLexer

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(pathlib.Path(os.environ.get("FIELDFAB_BUILD", ROOT / "build" / "release")) / "python"))

project = "Fieldfab"
extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "packaging/site/index"
include_patterns = ["packaging/site/*.md", "README.md", "CONTRIBUTING.md", "docs/*.md"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 3
highlight_language = "text"
html_theme = "alabaster"
html_theme_options = {"description": "Solids from formulas, scans and meshes", "page_width": "1100px"}
html_show_copyright = False
html_copy_source = False
autodoc_member_order = "bysource"


def escaped(lines):
    """Returns the lines of a plain docstring as reStructuredText; indented ones become literal blocks."""
    out, literal = [], False
    for line in lines:
        if line.startswith("    ") or (literal and not line.strip()):
            if not literal:
                out += ["", "::", ""]
            literal = True
            out.append(line)
        else:
            if literal:
                out.append("")
            literal = False
            out.append(re.sub(r"([\\*`|_])", r"\\\1", line.strip()))
    return out


def setup(app):
    for language in ("frep", "haproxy", "ko", "openscad", "set", "tool"):
        app.add_lexer(language, TextLexer)
    app.connect("autodoc-process-docstring",
                lambda app, what, name, obj, options, lines: lines.__setitem__(slice(None), escaped(lines)))
