"""The site of all pages, in build/site: ``python tests/tools/site_of_pages.py``. Warnings are errors."""

import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).parents[2]


def build(root: Path, out: Path) -> subprocess.CompletedProcess[str]:
    """Build the site of the pages below a folder; a dead link, file or anchor is an error.

    Args:
        root: the folder that the pages lie in, as in the checkout.
        out: the folder that the site is written to.
    """
    settings = ROOT / "docs" / "site"
    words = ["-q", "-W", "--keep-going", "-E", "-d", f"{out}.doctrees", "-c", str(settings)]
    return subprocess.run(
        [sys.executable, "-m", "sphinx", *words, str(root), str(out)],
        capture_output=True,
        text=True,
        check=False,
    )


if __name__ == "__main__":
    built = build(ROOT, ROOT / "build" / "site")
    print(built.stdout, built.stderr, sep="", end="", file=sys.stderr)
    if not built.returncode:
        print("build/site/docs/index.html")
    sys.exit(built.returncode)
