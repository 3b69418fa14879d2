"""What is known of each engine at work: the table ``evidence.csv``, a row per engine.

This module owns what may be said. ``tests/engines/test_engines.py`` holds the table to what the tests
run, and ``python tests/tools/evidence.py`` writes version and date anew after running them.
"""

import csv
from dataclasses import dataclass
from functools import cache
from importlib import resources

#: What may be said of an engine, from the strongest to the weakest, and what it means.
CLASSES = {
    "executed": "the tests run gam-db's SQL on it and compare every integer with a NumPy reference",
    "executed, reads only (reference implementation)": (
        "the same, not on the service but on its maker's reference implementation of the language; "
        "storage and transactions were not seen"
    ),
    "rendered, run on a relative": (
        "the SQL made for it was run on an engine whose language it extends, with the same integers; "
        "what only it has was parsed or left out"
    ),
    "rendered, checked by a grammar": (
        "the SQL made for it was parsed by a grammar that is not ours; names, types and functions were "
        "seen by nobody"
    ),
    "rendered": "the SQL was made, and parsed again by what made it",
}


@dataclass(frozen=True)
class Evidence:
    """A row of the table.

    Attributes:
        engine: its name.
        evidence: one of :data:`CLASSES`.
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
    table = resources.files("gam_db.engines") / "evidence.csv"
    lines = table.read_text(encoding="utf-8").splitlines()
    return {row["engine"]: Evidence(**row) for row in csv.DictReader(lines)}
