"""Engines: the SQL of each, as flat data and small rewrites, and its connection.

What is data of one is in ``engines.toml``. One that is executed has a folder: its ``__init__.py`` says
how its SQL is written, its ``driver.py`` how it is run. Of one that is only rendered there is a file.
Nothing outside asks which engine it is.

What is known of an engine at work is in ``evidence.csv``: ``tests/engines/test_engines.py`` holds it to
what the tests run, and ``python tests/tools/evidence.py`` writes version and date anew after that.
"""

import csv
import importlib
from dataclasses import dataclass

from gam_db import data
from gam_db.engines.base import Engine
from gam_db.errors import EngineError, nearest


@dataclass(frozen=True)
class Evidence:
    """A row of the table: what ran or parsed the SQL of an engine, its version, when, in which tests.

    Of the kinds of evidence docs/engines.md says what each means. ``also`` is another version or
    relative, and the file of the tests that run on it; empty for none.
    """

    engine: str
    evidence: str
    by: str
    version: str
    date: str
    tests: str
    also: str


#: The rows of the table, by engine, in its order.
EVIDENCE = {
    row["engine"]: Evidence(**row)
    for row in csv.DictReader(data.text("gam_db.engines", "evidence.csv").splitlines())
}
NAMES = tuple(EVIDENCE)


def engine_named(name: str) -> Engine:
    """Return the engine of that name.

    Raises:
        EngineError: there is none; the message suggests the nearest.
    """
    if name not in NAMES:
        raise EngineError(f"There is no engine {name!r}{nearest(name, NAMES)}")
    engine = importlib.import_module(f"gam_db.engines.{name}").ENGINE
    assert isinstance(engine, Engine)
    return engine
