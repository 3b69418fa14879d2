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


@pytest.mark.parametrize(
    ("link", "named"),
    [
        ("[none](there.md)", "there.md"),
        ("[none](../there.sql)", "there.sql"),
        ("[none](../there)", "'../there'"),
        ("[none](#there)", "there"),
        ("[none](page.md#there)", "there"),
        ("![none](there.svg)", "there.svg"),
        ("[page](page.md#a-heading), [itself](index.md), [file](../LICENSE), [folder](../sql)", ""),
    ],
)
def test_a_dead_link_ends_the_build(link: str, named: str, tmp_path: Path) -> None:
    """A page, a file, a folder, a heading here or on another page, a picture; the last case has none."""
    pages = tmp_path / "pages"
    for name, text in {
        "docs/index.md": f"# All\n\n{link}\n\n## Start\n\n- [page](page.md)\n- [s](../sql/README.md)\n",
        "docs/page.md": "# Page\n\n## A heading\n\nText.\n",
        "sql/README.md": "# SQL\n",
        "LICENSE": "free\n",
    }.items():
        (pages / name).parent.mkdir(parents=True, exist_ok=True)
        (pages / name).write_text(text, encoding="utf-8")
    done = site_of_pages.build(pages, tmp_path / "out")
    assert done.returncode == int(bool(named))
    assert named in done.stderr
    assert done.stderr.count("WARNING") == int(bool(named)), done.stderr


def test_a_page_that_no_list_names_ends_the_build(tmp_path: Path) -> None:
    pages = tmp_path / "pages" / "docs"
    pages.mkdir(parents=True)
    (pages / "index.md").write_text("# All\n\n## Start\n\n- [listed](listed.md)\n", encoding="utf-8")
    (pages / "listed.md").write_text("# Listed\n", encoding="utf-8")
    (pages / "lonely.md").write_text("# Lonely\n", encoding="utf-8")
    done = site_of_pages.build(pages.parent, tmp_path / "out")
    assert done.returncode == 1
    assert ("lonely.md" in done.stderr, "listed.md" in done.stderr) == (True, False)


def test_no_warning_is_suppressed() -> None:
    settings = (ROOT / "docs" / "site" / "conf.py").read_text(encoding="utf-8")
    assert not re.search(r"suppress_warnings|nitpick_ignore|logging", settings)
    assert "intersphinx" not in settings
