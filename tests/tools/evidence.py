"""Run what the table of evidence names, write versions and date anew.

``python tests/tools/evidence.py`` does it.
"""

import csv
import dataclasses
import datetime as dt
import subprocess
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from gam_db.engines import EVIDENCE, Evidence

ROOT = Path(__file__).parents[2]
TABLE = ROOT / "gam_db" / "engines" / "evidence.csv"


def version_of(row: Evidence) -> Callable[[], str]:
    """Return how the file of the tests finds the version of what it runs.

    Raises:
        KeyError: the file does not say that it runs this engine.
    """
    runs: dict[str, Callable[[], str]] = import_module(Path(row.tests).stem).RUNS
    return runs[row.engine]


def main() -> None:
    """Run the files, then write the table."""
    rows = list(EVIDENCE.values())
    for file in dict.fromkeys(row.tests for row in rows):
        words = ["-q", "-m", "", "--engines", "all", file]
        subprocess.run([sys.executable, "-m", "pytest", *words], cwd=ROOT, check=True)
    today = dt.datetime.now(dt.UTC).date().isoformat()
    rows = [dataclasses.replace(row, version=version_of(row)(), date=today) for row in rows]
    with TABLE.open("w", encoding="utf-8", newline="") as lines:
        table = csv.writer(lines, lineterminator="\n")
        table.writerow([field.name for field in dataclasses.fields(Evidence)])
        table.writerows(dataclasses.astuple(row) for row in rows)


if __name__ == "__main__":
    main()
