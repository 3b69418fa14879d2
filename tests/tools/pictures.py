"""The pictures of the page in README.md and docs/report.md: ``python tests/tools/pictures.py``.

They show the simulated plant, as ``gam demo --report`` writes it.
"""

import tempfile
from pathlib import Path

from typer.testing import CliRunner

import browser
from gam_db.cli import app

DOCS = Path(__file__).parents[2] / "docs"

#: file -> where in the page, how wide and how high
PICTURES = {
    "report-fleet.png": ("", 1320, 1200),
    "report-signal.png": ("#/robot%202/speed", 1320, 1660),
}


def main() -> None:
    """Write them anew."""
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
