"""Settings of the site that Sphinx builds from the pages: ``python tests/tools/site_of_pages.py``.

Sphinx reads the pages where they lie: its source folder is the checkout, and this folder holds the
settings alone. So a link such as ``../sql/README.md`` is the same link on the forge, in an editor and on
the site, and no page is copied. The lists of ``docs/index.md`` are the navigation. A page
that no list names is a warning, and every warning ends the build.
"""

import posixpath
import re
from typing import Any

from sphinx.addnodes import pending_xref

project = "gam-db"
extensions = ["myst_parser"]
root_doc = "docs/index"
include_patterns = ["docs/*.md", "*.md", "sql/README.md", "migrations/README.md", "tests/spec/README.md"]
exclude_patterns = [".*", "build", "dist", "gam_db", "docs/site", "**/node_modules"]

#: Missing targets are warnings, and links to headings are held to the headings, as the forge names them.
nitpicky = True
myst_heading_anchors = 4

html_theme = "furo"
html_title = "gam-db"
#: 100 columns of a terminal fit the width of a page.
_WIDTHS = {"code-font-size": "0.72em"}
html_theme_options = {"light_css_variables": _WIDTHS, "dark_css_variables": _WIDTHS}
html_copy_source = False
html_show_sphinx = False
html_show_copyright = False
#: Words of other tools that Pygments has no lexer for are plain text.
highlight_language = "text"

_SECTION = re.compile(r"^## (.+)\n((?:(?!^## )[\s\S])*)", re.MULTILINE)
_ENTRY = re.compile(r"^- \[([^]]+)\]\(([^)#:]+)\.md\)", re.MULTILINE)


def _navigation(app: Any, docname: str, source: list[str]) -> None:
    """Append to the index a hidden list of pages for each of its sections, which makes the sidebar."""
    if docname != root_doc:
        return
    for title, text in _SECTION.findall(source[0]):
        pages = "\n".join(f"{words} <{page}>" for words, page in _ENTRY.findall(text))
        source[0] += f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{pages}\n```\n"


def _folders(app: Any, doctree: Any) -> None:
    """Let a link to a folder lead to the README of the folder, which a forge shows there."""
    for link in doctree.findall(pending_xref):
        here = posixpath.dirname(link.get("refdoc", ""))
        page = posixpath.normpath(posixpath.join(here, link["reftarget"], "README"))
        if link["reftype"] == "myst" and link["refdomain"] != "doc" and page in app.env.found_docs:
            link["refdomain"], link["reftarget"], link["reftargetid"] = "doc", page, None


def setup(app: Any) -> None:
    """Connect what reads the navigation and what leads to folders."""
    app.connect("source-read", _navigation)
    app.connect("doctree-read", _folders)
