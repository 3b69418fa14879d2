"""Engines under test: which are asked for, and an open session on each.

``pytest --engines fast`` (the default) runs on DuckDB and SQLite, ``all`` on every engine that is called
executed, and ``NAME,...`` on those named. One that is asked for and cannot be started is a failure.
"""

import itertools
from collections.abc import Callable
from functools import cache

import pytest
from hypothesis import settings

from gam_db.connect import connect
from gam_db.engines.session import Session

FAST = ("duckdb", "sqlite")

#: engine -> what opens a session on it, once in every process of the tests
OPENERS: dict[str, Callable[[], Session]] = {
    "duckdb": lambda: connect(),
    "sqlite": lambda: connect("sqlite://"),
    "clickhouse": lambda: connect("chdb://"),
}

#: engine -> random cases of the agreement tests, about as many as take the same time on each
EXAMPLES = {"duckdb": 100, "sqlite": 60, "clickhouse": 12}


def examples(name: str) -> int:
    """Return how many random cases an engine is given; HYPOTHESIS_PROFILE=many gives more of them."""
    return max(EXAMPLES[name] * settings().max_examples // 100, 4)


_numbers = itertools.count()


def chosen(asked: str) -> list[str]:
    """Return the engines that an option of the command line asks for."""
    names = {"fast": FAST, "all": tuple(OPENERS)}.get(asked, tuple(asked.split(",")))
    for name in names:
        if name not in OPENERS:
            raise pytest.UsageError(
                f"--engines: there is no {name!r}; fast, all or {', '.join(OPENERS)}"
            )
    return list(names)


@cache
def session(name: str) -> Session:
    """Return the session on an engine; it stays open for the tests that follow."""
    return OPENERS[name]()


def fresh_name(stem: str) -> str:
    """Return the name of a table or a prefix that no test has used before."""
    return f"{stem}{next(_numbers)}_"
