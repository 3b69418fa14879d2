"""Running the rendered scripts the way a warehouse team does: no Python of ours between the lines."""

import re
from collections.abc import Sequence
from dataclasses import replace

import duckdb
import pyarrow as pa
import sqlglot
from sqlglot import exp

import comparisons
import engines
import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.engines.session import Session
from harness import Answer, ProgramRow, Row, arrow

#: question -> relation of the view form, and its order
RELATIONS = {
    "health_indicator": ("health", ("asset", "channel", "time")),
    "support": ("support_summary", ("asset", "channel")),
    "certificate": ("certificate", ("asset", "channel", "block")),
}

#: A script's statements end with a semicolon at the end of a line, and no text in them does.
END = re.compile(r";\n")


#: Engines that put each step of one query in the place of its names before they plan: the rounds of a
#: robust range are then too many for one query, and its exact form is that of all values.
INLINING = ("clickhouse", "spark", "databricks")


def of_one_query(engine: str, parameters: gam_db.Parameters) -> gam_db.Parameters:
    """Return the parameters under which an engine is given the exact form."""
    return replace(parameters, range="min_max") if engine in INLINING else parameters


def on(
    engine: str,
    rows: Sequence[Row] | Sequence[ProgramRow],
    parameters: gam_db.Parameters,
    calibration: gam_db.Calibration,
) -> dict[str, Answer]:
    """Answer by the scripts on an engine: the view form, and under ``exact`` the exact one."""
    if engine == "duckdb":  # a script may use all of a connection: its own, and in one piece
        with duckdb.connect() as connection, DuckSession(connection) as session:
            return _answers(session, rows, parameters, calibration)
    return _answers(engines.session(engine), rows, parameters, calibration)


def _answers(
    session: Session,
    rows: Sequence[Row] | Sequence[ProgramRow],
    parameters: gam_db.Parameters,
    calibration: gam_db.Calibration,
) -> dict[str, Answer]:
    prefix, name = engines.fresh_name("script"), session.engine.name
    table = telemetry(session, rows)
    has_programs = any(len(row) > 4 for row in rows)
    source = gam_db.Source(table.name, program="program" if has_programs else None)
    exact = gam_db.render("exact", name, source, of_one_query(name, parameters), calibration)
    found = {"exact": fetched(session, exact)}
    run(session, gam_db.render("view", name, source, parameters, calibration, prefix))
    for question, (relation, order) in RELATIONS.items():
        query = exp.select("*").from_(exp.to_table(f"{prefix}{relation}")).order_by(*order)
        found[question] = session.fetch(query).to_pylist()
    clear(session, table.name, prefix)
    comparisons.compared(name, "view", rows, parameters, calibration)
    return found


COUNTER = exp.column("time")


def telemetry(
    session: Session, rows: Sequence[Row] | Sequence[ProgramRow], time: exp.Expr = COUNTER
) -> exp.Table:
    """Make a table of telemetry, as a team would find it in its warehouse.

    Args:
        session: of the engine.
        rows: that it holds.
        time: what becomes of their ``time``.
    """
    table = exp.to_table(engines.fresh_name("telemetry"))
    with session.lent(arrow(rows)) as lent:
        query = _columns(time, any(len(row) > 4 for row in rows)).from_(lent)
        session.execute(session.engine.create_table(table, query))
    return table


def arrive(
    session: Session,
    table: exp.Table,
    rows: Sequence[Row] | Sequence[ProgramRow],
    time: exp.Expr = COUNTER,
) -> None:
    """Append rows to a table of telemetry."""
    with session.lent(arrow(rows)) as lent:
        query = _columns(time, any(len(row) > 4 for row in rows)).from_(lent)
        names = [exp.to_identifier(column) for column in query.named_selects]
        into = exp.Schema(this=table.copy(), expressions=names)
        session.execute(exp.Insert(this=into, expression=query))


def _columns(time: exp.Expr, has_programs: bool = False) -> exp.Select:
    programs = [exp.column("program")] * has_programs
    return exp.select("asset", "channel", exp.alias_(time, "time"), "value", *programs)


def fetched(session: Session, script: str) -> Answer:
    """Return the rows of a script that is one query, after what it begins with."""
    rows: pa.Table
    if isinstance(session, DuckSession):
        rows = session.connection.sql(script).to_arrow_table()
    else:
        assert isinstance(session, Session)
        *first, query = END.split(script.removesuffix(";\n"))
        run(session, ";\n".join(first))
        rows = session.driver.fetch(query)
    answer: Answer = rows.to_pylist()
    return answer


def run(session: Session, script: str) -> None:
    """Run a script, statement by statement where the engine takes no more at once."""
    if isinstance(session, DuckSession):
        session.connection.execute(script)
        return
    assert isinstance(session, Session)
    for statement in END.split(script):
        if statement.strip():
            session.driver.execute(statement)


def clear(session: Session, table: str, prefix: str) -> None:
    """Drop what a script made, and its telemetry."""
    made = [name for name in session.relations() if name.startswith(prefix)]
    is_view = {f"{prefix}health", f"{prefix}program_summary"}
    for name in sorted(made, key=lambda name: name not in is_view):
        kind = "VIEW" if name in is_view else "TABLE"
        session.execute(exp.Drop(tables=[exp.to_table(name)], kind=kind))
    session.execute(sqlglot.parse_one(f"DROP TABLE {table}"))
