"""Snowflake's SQL on two relatives, and a driver on each: fakesnow and Databend's embedded wheel.

``GAM_SNOWFLAKES`` is the folder of an environment that holds both (.ci/snowflakes.txt): they pin
versions of what gam-db needs, too, so each runs in a process of that environment
(:mod:`snowflake_worker`). fakesnow reads Snowflake's words and runs them on DuckDB. Databend is an
engine with most of these words; what version 1.2.453 has not is taken out of the text here
(:func:`for_databend`), and nowhere else.
"""

import atexit
import functools
import math
import os
import pickle
import re
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines import engine_named
from gam_db.engines.base import temporary, with_columns
from gam_db.engines.driver import Driver, by_table, usual
from gam_db.errors import UserError
from googlesql import statements

RELATIVES = ("fakesnow", "databend")
FOLDER = os.environ.get("GAM_SNOWFLAKES", "")

SNOWFLAKE = engine_named("snowflake")


class SnowflakeError(Exception):
    """A relative refused a statement."""


class Relative:
    """A process that answers on a relative.

    Attributes:
        name: of the relative.
        version: of it.
    """

    def __init__(self, name: str) -> None:
        self.name = name
        python = Path(FOLDER) / "bin" / "python"
        words = [str(python), str(Path(__file__).with_name("snowflake_worker.py")), name]
        self._folder = tempfile.TemporaryDirectory()  # where Databend keeps what it has, and its logs
        self._process = subprocess.Popen(
            words,
            cwd=self._folder.name,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )
        self._shared: Callable[[str], str] = {"databend": for_databend}.get(name, str)
        self.version: str = self._answer()

    def run(self, statement: str, as_it_is: bool = False) -> pa.Table | None:
        """Run a statement, without what the relative has not; return its rows, if there are any.

        Raises:
            SnowflakeError: it is refused.
        """
        assert self._process.stdin
        pickle.dump(statement if as_it_is else self._shared(statement), self._process.stdin)
        self._process.stdin.flush()
        return self._answer()

    def close(self) -> None:
        """End the process, and with it all that is in its database."""
        assert self._process.stdin
        self._process.stdin.close()
        self._process.wait()
        self._folder.cleanup()

    def _answer(self) -> Any:
        assert self._process.stdout
        kind, found = pickle.load(self._process.stdout)
        if kind == "refused":
            raise SnowflakeError(found)
        return found


@functools.cache
def relative(name: str) -> Relative:
    """Return the process of a relative that the tests of this process share."""
    if not FOLDER:
        pytest.skip("left out: GAM_SNOWFLAKES names no environment with fakesnow and databend")
    started = Relative(name)
    atexit.register(started.close)
    return started


def version() -> str:
    """Return the version of fakesnow."""
    return relative("fakesnow").version


BACKSLASH = r"\\"

#: A text of SQL, and the comments that a definition holds.
_TEXT = r"'(?:[^']|'')*'"
_COMMENTS = re.compile(rf"\n?\s*COMMENT\s?=?\s?{_TEXT}")
_LIKE = re.compile(rf"LIKE ({_TEXT}) ESCAPE '!'")
_ENTRY = re.compile(r"(?<=[\s,])(\w+ AS )\((?=\s)")


def for_databend(statement: str) -> str:
    """Return a statement without what Databend 1.2.453 has not; Snowflake's documentation has all of it.

    - Temporary tables: they are tables, which :meth:`SnowflakeDriver.run` drops.
    - Comments of views: left out.
    - The microseconds of an instant by DATE_PART, and SYSDATE: TO_INT64, NOW.
    - The unit of a number in TO_TIMESTAMP_NTZ: TO_TIMESTAMP guesses it, microseconds from 1971 on.
    - ESCAPE after LIKE: the sign is the backslash.
    - Several columns before IN (SELECT ...) in DELETE: asked for by EXISTS.
    - Rows of constants that are joined under a window, at which its executor panics (unable append
      column): their WITH entry is marked MATERIALIZED.
    """
    statement = re.sub(r"\ACREATE TEMPORARY TABLE", "CREATE TABLE", statement)
    statement = statement.replace("DATE_PART(EPOCH_MICROSECOND, ", "TO_INT64(").replace(
        "SYSDATE()", "NOW()"
    )
    statement = re.sub(r"\bTO_TIMESTAMP_[NL]TZ\((.*?), 6\)", r"TO_TIMESTAMP(\1)", statement)
    statement = _LIKE.sub(_by_backslash, statement)
    if statement.startswith("CREATE OR REPLACE VIEW"):
        head, between, body = statement.partition(" AS\n")
        statement = _COMMENTS.sub("", head) + between + body
    statement = _correlated(statement)
    return _ENTRY.sub(_marked, statement)


def _by_backslash(like: re.Match[str]) -> str:
    """Return LIKE with a pattern that is escaped by backslashes, each written twice in a text."""
    return "LIKE " + re.sub(
        "!(.)", lambda sign: ("" if sign[1] == "!" else BACKSLASH) + sign[1], like[1]
    )


def _closing(text: str, opening: int) -> int:
    """Return the place of the parenthesis that closes one."""
    depth = 0
    for place in range(opening, len(text)):
        depth += (text[place] == "(") - (text[place] == ")")
        if not depth:
            return place
    raise AssertionError(text[opening : opening + 200])


def _marked(entry: re.Match[str]) -> str:
    """Return the beginning of a WITH entry, marked if the entry reads no table."""
    body = entry.string[entry.end() : _closing(entry.string, entry.end() - 1)]
    is_constant = re.search(r"\bFROM\b", body) is None
    return f"{entry[1]}{'MATERIALIZED ' * is_constant}("


def _correlated(statement: str) -> str:
    """Return a DELETE that asks for its key of several columns by EXISTS."""
    among = re.search(r"\ADELETE FROM (\S+)\s+WHERE\s+\(([\w, ]+)\) IN \(", statement)
    if not among:
        return statement
    closing = _closing(statement, among.end() - 1)
    query = statement[among.end() : closing]
    same = [f"among.{name.strip()} = {among[1]}.{name.strip()}" for name in among[2].split(",")]
    there = f"EXISTS (SELECT 1 FROM ({query}) AS among WHERE {' AND '.join(same)})"
    return f"DELETE FROM {among[1]} WHERE {there}{statement[closing + 1 :]}"


def _is_comment(statement: str) -> bool:
    """Tell whether a statement has nothing but comments, as the first lines of a script have."""
    return all(line.startswith("--") for line in statement.strip().splitlines())


#: Arrow's type of a column -> the name that Snowflake has for it.
_TYPES: list[tuple[Callable[[pa.DataType], bool], str]] = [
    (pa.types.is_boolean, "BOOLEAN"),
    (pa.types.is_integer, "BIGINT"),
    (pa.types.is_floating, "DOUBLE"),
    (pa.types.is_date, "DATE"),
    (pa.types.is_timestamp, "TIMESTAMP"),
    (lambda kind: True, "VARCHAR"),
]


def _type_of(kind: pa.DataType) -> str:
    return next(name for is_such, name in _TYPES if is_such(kind))


def _written(value: Any) -> str:
    """Return a value as SQL."""
    if value is None:
        return "NULL"
    if isinstance(value, float) and not math.isfinite(value):
        return f"CAST('{value}' AS DOUBLE)"
    return SNOWFLAKE.text(template.text(value)) if isinstance(value, str) else repr(value)


class SnowflakeDriver(Driver):
    """A relative as a driver; see :class:`gam_db.engines.driver.Driver`.

    What Python sends goes statement by statement, and nothing of it is undone; a script can be.
    """

    engine = SNOWFLAKE
    errors: tuple[type[Exception], ...] = (SnowflakeError,)
    most_rows = 1_000_000

    def __init__(self, name: str) -> None:
        self.relative = relative(name)

    def execute(self, statement: str) -> None:
        if not _is_comment(statement):
            self.relative.run(statement)

    def fetch(self, query: str) -> pa.Table:
        """Return the rows of a query, names of columns in lower case."""
        found = self.relative.run(query)
        assert found is not None
        return usual(found.rename_columns([name.lower() for name in found.column_names]))

    def run(self, script: str) -> None:
        """Run a script as a command line does, in a session of its own, and to the first error.

        Snowflake commits before each definition, which the relatives do not: a script that has one in a
        transaction is no good. Temporary tables go with the session, and so does what is not committed.
        """
        is_open, made = False, []
        try:
            for statement in statements(script):
                is_open = (is_open or statement == "BEGIN") and statement != "COMMIT"
                assert not (is_open and statement.startswith(("CREATE", "DROP", "ALTER"))), statement
                made += re.findall(r"\ACREATE TEMPORARY TABLE (\S+)", statement)
                self.execute(statement)
        finally:
            if is_open:
                self.execute("ROLLBACK")
            for table in made:
                self.execute(f"DROP TABLE IF EXISTS {table}")

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        self.execute(self.engine.text(temporary(table, query)))

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        types = {one.name: exp.DataType.build(_type_of(one.type)) for one in rows.schema}
        self.execute(self.engine.text(temporary(with_columns(table, types))))
        self.append(table, rows)

    def append(self, table: exp.Table, rows: pa.Table) -> None:
        """Append rows to a table, as values in the text of statements."""
        names = ", ".join(rows.column_names)
        told = [f"({', '.join(map(_written, row.values()))})" for row in rows.to_pylist()]
        for start in range(0, len(told), 5_000):
            text = ", ".join(told[start : start + 5_000])
            self.execute(f"INSERT INTO {self.engine.text(table)} ({names}) VALUES {text}")

    def tables(self) -> list[tuple[str, ...]]:
        return [(name,) for name in self.relations(None)]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        probe = exp.select(exp.Star()).from_(relation.copy()).limit(0)
        return {one.name: _type_of(one.type) for one in self.fetch(self.engine.text(probe)).schema}

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        assert schema is None
        rows = self.rows(
            "SELECT table_name, column_name FROM information_schema.columns "
            "WHERE LOWER(table_schema) IN ('public', 'default') ORDER BY table_name, ordinal_position"
        )
        return by_table((row["table_name"], row["column_name"].lower()) for row in rows)

    def problem(self, error: Exception) -> UserError | None:
        return None

    def close(self) -> None:
        """Leave the relative to other tests."""
