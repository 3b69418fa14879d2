"""The site of all pages builds without a warning and loads nothing; a dead link ends the build."""

import re
from pathlib import Path

import pytest

import site_of_pages

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def built(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("site")
    done = site_of_pages.build(ROOT, out)
    assert (done.returncode, done.stderr) == (0, "")
    return out


def test_every_page_is_on_the_site(built: Path) -> None:
    for page in [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md"), ROOT / "sql" / "README.md"]:
        assert (built / page.relative_to(ROOT)).with_suffix(".html").is_file(), page


def test_the_sidebar_is_the_index(built: Path) -> None:
    text = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    (sidebar,) = re.findall(
        r'<div class="sidebar-tree">.*?</div>', (built / "docs/index.html").read_text(), re.DOTALL
    )
    for section in ("Start", "Guides", "Reference", "Explanation"):
        assert f"\n## {section}\n" in text
        assert f'<span class="caption-text">{section}</span>' in sidebar
    assert sidebar.count('class="toctree-l1"') == len(re.findall(r"^- \[", text, re.MULTILINE)) > 20


def test_no_page_loads_anything_from_the_network(built: Path) -> None:
    pages = list(built.rglob("*.html"))
    assert len(pages) > 20
    for page in pages:
        loads = re.findall(
            r'<(?:script|link|img|iframe)\b[^>]*?(?:src|href)="([^"]+)"', page.read_text()
        )
        assert loads
        assert [name for name in loads if re.match(r"(https?:)?//", name)] == [], page
    for sheet in built.rglob("*.css"):
        assert re.findall(r"url\(['\"]?(?:https?:)?//|@import", sheet.read_text()) == [], sheet


#: Dead links, each with what its warning names: a page, a file, a folder, headings, a picture.
DEAD = {
    "[none](there.md)": "'there.md'",
    "[none](../there.sql)": "'../there.sql'",
    "[none](../there)": "'../there'",
    "[none](#here)": "'here'",
    "[none](page.md#there)": "'docs/page': 'there'",
    "![none](there.svg)": "there.svg",
}
ALIVE = ("[a](page.md)", "[b](page.md#a-heading)", "[c](#all)", "[d](../LICENSE)", "[e](../sql)")


@pytest.mark.parametrize("dead", [True, False])
def test_a_dead_link_or_a_page_that_no_list_names_ends_the_build(dead: bool, tmp_path: Path) -> None:
    links = [*(DEAD if dead else ()), *ALIVE]
    pages = {
        "docs/index.md": "# All\n\n## Start\n\n- [page](page.md)\n- [sql](../sql/README.md)\n",
        "docs/page.md": "# Page\n\n## A heading\n\nText.\n",
        "sql/README.md": "# SQL\n",
        "LICENSE": "free\n",
    }
    pages["docs/index.md"] += "\n## Links\n\n" + "\n\n".join(links) + "\n"
    if dead:
        pages["docs/lonely.md"] = "# Lonely\n"
    for name, text in pages.items():
        (tmp_path / "pages" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "pages" / name).write_text(text, encoding="utf-8")
    done = site_of_pages.build(tmp_path / "pages", tmp_path / "out")
    assert done.returncode == int(dead), done.stderr
    warnings = [line for line in done.stderr.splitlines() if "WARNING" in line]
    for named in (*DEAD.values(), "lonely.md"):
        assert sum(named in line for line in warnings) == int(dead), (named, done.stderr)
    assert len(warnings) == (len(DEAD) + 1 if dead else 0), done.stderr


def test_every_page_begins_with_what_it_is_for() -> None:
    for page in (ROOT / "docs").glob("*.md"):
        title, first = page.read_text(encoding="utf-8").split("\n\n")[:2]
        assert title.startswith("# "), page
        assert first.startswith("This page "), page


def test_no_warning_is_suppressed() -> None:
    settings = (ROOT / "docs" / "site" / "conf.py").read_text(encoding="utf-8")
    assert not re.search(r"suppress_warnings|nitpick_ignore|logging", settings)
    assert "intersphinx" not in settings
