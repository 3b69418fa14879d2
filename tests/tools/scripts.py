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
            return answered_by(session, rows, parameters, calibration)
    return answered_by(engines.session(engine), rows, parameters, calibration)


def answered_by(
    session: Session,
    rows: Sequence[Row] | Sequence[ProgramRow],
    parameters: gam_db.Parameters,
    calibration: gam_db.Calibration,
) -> dict[str, Answer]:
    """Answer by the scripts in a session."""
    prefix, name = engines.fresh_name("script"), session.engine.name
    table = telemetry(session, rows)
    has_programs = any(len(row) > 4 for row in rows)
    source = gam_db.Source(table.name, program="program" if has_programs else None)
    exact = gam_db.render("exact", name, source, of_one_query(name, parameters), calibration)
    found = {"exact": fetched(session, exact)}
    run(session, gam_db.render("view", name, source, parameters, calibration, prefix, without=()))
    found |= answered(session, prefix)
    if not has_programs and not calibration.pools:
        check_judged(found)
    clear(session, table.name, prefix)
    comparisons.compared(name, "view", rows, parameters, calibration)
    return found


def answered(session: Session, prefix: str) -> dict[str, Answer]:
    """Return the rows of what a script made."""
    found: dict[str, Answer] = {}
    for question, (relation, order) in RELATIONS.items():
        query = exp.select("*").from_(exp.to_table(f"{prefix}{relation}")).order_by(*order)
        found[question] = session.fetch(query).to_pylist()
    return found


def check_judged(found: dict[str, Answer]) -> None:
    """Take what judges out of the rows of the view: it is that of the channel's summary.

    A range of all values leaves no sample out, which its script does not say.
    """
    for row in found["support"]:
        row.setdefault("dropped_below", 0)
        row.setdefault("dropped_above", 0)
        row.setdefault("lowest_dropped", None)
        row.setdefault("highest_dropped", None)
        for name in ("vouched_by", "taught_by", "member_floor"):
            row.setdefault(name, None)
    known = {(row["asset"], row["channel"]): row for row in found["support"]}
    for row in found["health_indicator"]:
        learnt = known[row["asset"], row["channel"]]
        assert row.pop("verdict") == learnt["verdict"]
        limit = row.pop("hi_limit")
        assert limit == learnt["hi_limit"]
        is_known = limit is not None and row["hi"] is not None
        assert row.pop("is_above") == (int(row["hi"] > limit) if is_known else None)


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


#: The views that scripts have made, and which place they were made at.
VIEWS: dict[str, int] = {}

_VIEW = re.compile(r"(?:CREATE (?:OR REPLACE )?VIEW|ALTER VIEW \S+ RENAME TO) (?:\S*\.)?[\"`]?(\w+)")


def run(session: Session, script: str) -> None:
    """Run a script, statement by statement where the engine takes no more at once."""
    VIEWS.update((name, place) for place, name in enumerate(_VIEW.findall(script)))
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
    # A view goes before what it reads, which was made earlier.
    for name in sorted(made, key=lambda name: -VIEWS.get(name, -1)):
        kind = "VIEW" if name in VIEWS else "TABLE"
        # On PostgreSQL a function of one signal reads the view.
        cascades = kind == "VIEW" and session.engine.name == "postgres"
        session.execute(exp.Drop(tables=[exp.to_table(name)], kind=kind, cascade=cascades))
    session.execute(sqlglot.parse_one(f"DROP TABLE {table}"))


SIGNALS = [(f"a{n}", "c", time, float(time * 7 % 11)) for n in range(40) for time in range(600)]


def filtered(engine: str) -> tuple[Session, str, str]:
    """Make a script's tables over eight signals, and return the query of one of them."""
    session = engines.session(engine)
    table, prefix = telemetry(session, SIGNALS), engines.fresh_name("filtered")
    parameters = gam_db.Parameters(m=2, tau=1, bins=4, window=20, range="min_max")
    calibration = gam_db.Calibration(fraction=0.5)
    source = gam_db.Source(table.name)
    run(session, gam_db.render("view", engine, source, parameters, calibration, prefix))
    home = "public." if engine == "postgres" else ""
    view = f"SELECT * FROM {home}{prefix}health WHERE asset = 'a3' AND channel = 'c'"
    function = f"SELECT * FROM {home}{prefix}health_of('a3', 'c')"
    rows = [session.driver.fetch(f"{query} ORDER BY time").to_pylist() for query in (view, function)]
    assert len(rows[0]) == 300
    assert rows[0] == rows[1]
    return session, table.name, view
