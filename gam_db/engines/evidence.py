"""What is known of each engine at work: the table ``evidence.csv``, a row per engine.

``tests/engines/test_engines.py`` holds the table to what the tests
run, and ``python tests/tools/evidence.py`` writes version and date anew after running them.
"""

import csv
from dataclasses import dataclass
from functools import cache

from gam_db import data


@dataclass(frozen=True)
class Evidence:
    """A row of the table.

    Attributes:
        engine: its name.
        evidence: how much is known, in words; docs/engines.md says what each kind means.
        by: what ran or parsed the SQL.
        version: of that, in the last run.
        date: of the last run, as YYYY-MM-DD.
        tests: the file of the tests.
    """

    engine: str
    evidence: str
    by: str
    version: str
    date: str
    tests: str


@cache
def evidence() -> dict[str, Evidence]:
    """Return the rows of the table, by engine, in its order."""
    lines = data.text("gam_db.engines", "evidence.csv").splitlines()
    return {row["engine"]: Evidence(**row) for row in csv.DictReader(lines)}
