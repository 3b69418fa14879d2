"""Simulated series in a file: Parquet, or tables of a DuckDB file, with the truth beside them.

What was there before stays as it was until everything is written.
"""

import contextlib
import secrets
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import duckdb
import pyarrow as pa
from pyarrow import csv, parquet
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.driver import LARGE_LOG
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConfigurationError, SourceError
from gam_db.lab.simulate.fleet import TRUTH, Fleet

TABLE = "telemetry"
DATABASE_ENDINGS = (".duckdb", ".db")

_PART = "gam_part"  # what the rows on their way are called
_MEMORY = "500MB"  # enough for a joint; without a limit DuckDB keeps what it has written

Writer = Callable[[pa.Table], None]


def check_target(path: Path) -> None:
    """Refuse a file that the series cannot be written to.

    Raises:
        ConfigurationError: its ending says neither Parquet nor DuckDB, or its folder is not there.
    """
    if path.suffix not in (".parquet", *DATABASE_ENDINGS):
        raise ConfigurationError(f"--out is {path}; give a name in .parquet or .duckdb.")
    if not path.parent.is_dir():
        raise ConfigurationError(f"--out is {path}, but there is no folder {path.parent}.")


def truth_of(path: Path, table: str = TABLE) -> str:
    """Return where the truth about a file's series lies: a file, or a table of the same file."""
    if path.suffix in DATABASE_ENDINGS:
        return f"{table}_truth"
    return str(path.with_name(f"{path.stem}.truth.parquet"))


def store_fleet(
    fleet: Fleet,
    robots: Iterable[int],
    path: Path,
    table: str = TABLE,
) -> tuple[int, list[dict[str, Any]]]:
    """Write robots of a fleet, joint by joint, and the truth about them.

    Args:
        fleet: the fleet.
        robots: numbers of its robots, from 1.
        path: NAME.parquet (the truth goes to NAME.truth.parquet), or a DuckDB file.
        table: table of the DuckDB file (the truth goes to TABLE_truth).

    Returns:
        How many readings were written, and the rows of the truth.

    Raises:
        SourceError: the file cannot be written.
    """
    truths = []
    rows = 0
    with _written(path, table) as (write, write_truth):
        for robot in robots:
            for joint in fleet.robot(robot):
                write(joint.readings)
                rows += joint.readings.num_rows
                truths.append(joint.truth)
        write_truth(pa.Table.from_pylist(truths, schema=TRUTH))
    return rows, truths


def check_outcomes(path: Path) -> None:
    """Refuse a file that outcomes cannot be written to.

    Raises:
        ConfigurationError: its ending says neither CSV nor Parquet, or its folder is not there.
    """
    if path.suffix not in (".csv", ".parquet"):
        raise ConfigurationError(f"--outcomes is {path}; give a name in .csv or .parquet.")
    if not path.parent.is_dir():
        raise ConfigurationError(f"--outcomes is {path}, but there is no folder {path.parent}.")


def store_outcomes(outcomes: pa.Table, path: Path) -> None:
    """Write outcomes as a CSV or Parquet file.

    Raises:
        SourceError: the file cannot be written.
    """
    unfinished = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
    try:
        if path.suffix == ".csv":
            csv.write_csv(outcomes, unfinished)
        else:
            parquet.write_table(outcomes, unfinished)
        unfinished.replace(path)
    except OSError as error:
        raise SourceError(f"{path} cannot be written.") from error
    finally:
        unfinished.unlink(missing_ok=True)


def store_series(series: pa.Table, truth: pa.Table, path: Path, table: str = TABLE) -> None:
    """Write one table of readings and its truth, as :func:`store_fleet` does.

    Raises:
        SourceError: the file cannot be written.
    """
    with _written(path, table) as (write, write_truth):
        write(series)
        write_truth(truth)


@contextlib.contextmanager
def _written(path: Path, table: str) -> Iterator[tuple[Writer, Writer]]:
    """Yield what writes a part of the readings, and what writes the truth."""
    writing = _in_database if path.suffix in DATABASE_ENDINGS else _in_parquet
    try:
        with writing(path, table) as writers:
            yield writers
    except duckdb.CatalogException as error:
        raise SourceError(f"In {path} something else than a table is called {table!r}.") from error
    except (duckdb.IOException, OSError) as error:
        raise SourceError(f"{path} cannot be written; does another process hold it?") from error


@contextlib.contextmanager
def _in_parquet(path: Path, table: str) -> Iterator[tuple[Writer, Writer]]:
    truth = Path(truth_of(path, table))
    mark = secrets.token_hex(4)
    unfinished = [file.with_name(f".{file.name}.{mark}") for file in (path, truth)]
    try:
        with contextlib.ExitStack() as opened:
            writers: list[parquet.ParquetWriter] = []

            def write(part: pa.Table) -> None:
                if not writers:
                    writer = parquet.ParquetWriter(unfinished[0], part.schema, compression="zstd")
                    writers.append(opened.enter_context(writer))
                writers[0].write_table(part)

            yield write, lambda part: parquet.write_table(part, unfinished[1])
        for file, target in zip(unfinished, (path, truth), strict=True):
            file.replace(target)
    finally:
        for file in unfinished:
            file.unlink(missing_ok=True)


@contextlib.contextmanager
def _in_database(path: Path, table: str) -> Iterator[tuple[Writer, Writer]]:
    # Written under other names and renamed in the end: a transaction around it all would keep all of
    # it in memory.
    mark = f"gam_unfinished_{secrets.token_hex(4)}"
    targets = (table, truth_of(path, table))
    unfinished = [_table(f"{mark}_{number}") for number in range(len(targets))]
    with DuckSession(path, writable=True) as session:
        connection = session.connection
        connection.execute("SET memory_limit = ?", [_MEMORY])

        def run(tree: exp.Expr) -> None:
            connection.execute(ENGINE.text(tree))
            session.driver.checkpoint(LARGE_LOG)

        def writer_of(target: exp.Table) -> Writer:
            begun = False

            def write(part: pa.Table) -> None:
                nonlocal begun
                connection.register(_PART, part)
                rows = exp.select(*map(template.column, part.column_names)).from_(_PART)
                run(
                    exp.insert(rows, target)
                    if begun
                    else exp.Create(this=target, kind="TABLE", expression=rows)
                )
                connection.unregister(_PART)
                begun = True

            return write

        try:
            yield writer_of(unfinished[0]), writer_of(unfinished[1])
            connection.begin()
            for new_table, name in zip(unfinished, targets, strict=True):
                run(exp.Drop(tables=[_table(name)], kind="TABLE", exists=True))
                renamed = exp.AlterRename(this=_table(name))
                run(exp.Alter(this=new_table, kind="TABLE", actions=[renamed]))
            connection.commit()
        except BaseException:
            with contextlib.suppress(duckdb.Error):  # there is nothing to take back but in the end
                connection.rollback()
            for new_table in unfinished:
                run(exp.Drop(tables=[new_table], kind="TABLE", exists=True))
            raise


def _table(name: str) -> exp.Table:
    return exp.Table(this=template.name(name))
