"""The pictures in README.md and docs/report.md: ``python tests/tools/pictures.py``.

They show what ``gam demo`` prints, and the simulated plant as ``gam demo --report`` writes it.
"""

import io
import tempfile
from pathlib import Path

from rich.console import Console
from rich.text import Text
from typer.testing import CliRunner

import browser
from gam_db.cli import app

DOCS = Path(__file__).parents[2] / "docs"

#: file -> where in the page, how wide and how high
PICTURES = {
    "report-fleet.png": ("", 1320, 1200),
    "report-signal.png": ("#/robot%202/speed", 1320, 1660),
}


def draw_demo() -> None:
    """Draw what the demo says of the machine, without what is said before and after."""
    wide = {"COLUMNS": "100", "FORCE_COLOR": "1"}
    printed = CliRunner().invoke(app, ["demo"], env=wide, color=True).stdout
    start, end = printed.index("\nsimulated machine:") + 1, printed.index("Next, try your own data")
    console = Console(record=True, width=100, file=io.StringIO())
    console.print("$ gam demo", Text.from_ansi(printed[start:end].rstrip()), sep="\n")
    console.save_svg(str(DOCS / "demo.svg"), title="gam demo")


def main() -> None:
    """Write them anew."""
    draw_demo()
    with tempfile.TemporaryDirectory() as folder, browser.browser() as chrome:
        page = Path(folder) / "report.html"
        done = CliRunner().invoke(app, ["demo", "--report", str(page)])
        assert done.exit_code == 0, done.output
        for name, (at, wide, high) in PICTURES.items():
            size = {"width": wide, "height": high}
            with browser.Seen(chrome, page, at, viewport=size, color_scheme="light") as seen:
                seen.page.screenshot(path=DOCS / name)


if __name__ == "__main__":
    main()
