"""Print how large what users read is, how large the kernel, and what a run costs on DuckDB.

`python tests/tools/measures.py`; with `list`, print the statements of such a run in full instead.
"""

import io
import os
import statistics
import sys
import tokenize
from pathlib import Path
from typing import Any

import duckdb
import sqlglot

import gam_db
from gam_db.engines import engine_named
from gam_db.engines.base import temporary
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables

ROOT = Path(__file__).parents[2]

#: The parts of the package that every form is made of; what is at its top belongs to them.
KERNEL = ("settings", "composing", "method", "study", "engines", "reading", "stored", "alarms")

_NO_CODE = (
    *(tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT),
    tokenize.ENDMARKER,
)


def size_of(text: str) -> str:
    """Return the characters and lines of a text."""
    return f"{len(text):,} characters, {len(text.splitlines()):,} lines"


def code_lines(text: str) -> int:
    """Return how many lines of a module hold code: no comment, docstring or blank line."""
    lines: set[int] = set()
    is_first = True  # of a statement, where a text alone is a docstring
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type in _NO_CODE:
            is_first = is_first or token.type != tokenize.COMMENT
            continue
        if not (token.type == tokenize.STRING and is_first):
            lines.update(range(token.start[0], token.end[0] + 1))
        is_first = False
    return len(lines)


class Plant:
    """So many channels, a sample each second; runs once an hour, of ten minutes each."""

    def __init__(self, channels: int) -> None:
        self.channels, self.length = channels, 4_000
        self.connection = duckdb.connect()
        self.connection.execute("SET threads = 1")
        self.connection.execute(f"CREATE TABLE telemetry AS {self._rows(0, self.length)}")
        self.session = DuckSession(self.connection)
        source = gam_db.Source("telemetry")
        method = gam_db.Parameters.paper(bins=20, window=500), gam_db.Calibration(duration="2000 s")
        self.monitor = Monitor(self.session, source, *method, lookback="10 min")
        self.monitor.migrate()
        self.monitor.calibrate()
        self.monitor.score()
        self.statements: list[str] = []
        for name in ("execute", "rows", "fetch", "keep"):
            self._note(name)

    def hour(self) -> float:
        """Let ten minutes come, and score them; return the processor seconds of the run."""
        self.connection.execute(f"INSERT INTO telemetry {self._rows(self.length, self.length + 600)}")
        self.length += 600
        self.statements.clear()
        before = sum(os.times()[:2])
        self.monitor.score()
        return sum(os.times()[:2]) - before

    def _rows(self, start: int, end: int) -> str:
        return (
            "SELECT 'a' || c // 10 AS asset, 'c' || c % 10 AS channel, "
            "TIMESTAMP '2026-01-01' + INTERVAL 1 SECOND * i AS time, "
            "sin(i / 7.0 + c) + hash(i, c) % 1000 / 20000.0 AS value "
            f"FROM range({start}, {end}) AS instants(i), range({self.channels}) AS channels(c)"
        )

    def _note(self, name: str) -> None:
        call = getattr(self.session.driver, name)

        def noted(said: Any, *more: Any) -> Any:
            text = self.session.engine.text(temporary(said, *more)) if more else said
            self.statements.append(text)
            return call(said, *more)

        setattr(self.session.driver, name, noted)


def print_list() -> None:
    """Print the statements of an hourly run of ten channels, in order."""
    plant = Plant(10)
    plant.hour()
    for text in plant.statements:
        print(sqlglot.parse_one(text, dialect="duckdb").sql(dialect="duckdb", pretty=True) + ";\n")


def main() -> None:
    """Print the measures."""
    source = gam_db.Source("telemetry", time_kind="timestamp")
    calibration = gam_db.Calibration(fraction=0.2)
    for engine in ("duckdb", "postgres"):
        script = gam_db.render("view", engine, source, gam_db.Parameters.paper(), calibration)
        print(f"gam compile, one plain table, view form, {engine}: {size_of(script)}")
    for engine in ("duckdb", "postgres"):
        print(f"gam migrate --sql, {engine}: {size_of(rendered(engine_named(engine), StateTables()))}")
    files = [*(ROOT / "gam_db").glob("*.py")]
    for part in KERNEL:
        files += (ROOT / "gam_db" / part).rglob("*.py")
    texts = [path.read_text(encoding="utf-8") for path in files]
    lines, code = (sum(map(count, texts)) for count in (lambda one: one.count("\n"), code_lines))
    print(f"kernel: {lines:,} lines, {code:,} of code; {len(files)} modules")
    for folder in ("sql", "migrations"):
        found = [path.read_text(encoding="utf-8") for path in (ROOT / folder).rglob("*.sql")]
        print(f"{folder}: {sum(one.count(chr(10)) for one in found):,} lines; {len(found)} files")

    for channels in (1, 100):
        plant = Plant(channels)
        seconds = statistics.median(plant.hour() for _ in range(5))
        said = f"{len(plant.statements)} statements, {seconds:.2f} s of processor"
        print(f"hourly run, DuckDB, {channels} channels: {said}")


if __name__ == "__main__":
    print_list() if "list" in sys.argv[1:] else main()
