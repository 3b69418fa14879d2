"""The state in a database: made, proved, kept small, removed.

This module owns ``gam migrate``, ``gam check --state``, ``gam prune``, ``gam compact`` and ``gam drop``,
and their pages; :mod:`gam_db.stored` does the work.
"""

import datetime as dt
from collections.abc import Sequence
from functools import partial
from typing import Annotated

import pyarrow as pa
import typer
from rich.console import Console

from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.monitors import watched
from gam_db.cli.options import option
from gam_db.cli.progress import working
from gam_db.clock import TimeKind, shown_instant, told_time
from gam_db.config import Settings
from gam_db.engines import NAMES, engine_named
from gam_db.errors import ConfigurationError, EngineError, printable
from gam_db.findings import Row
from gam_db.stored import dropping, migrations, pruning
from gam_db.stored.dropping import Removal
from gam_db.stored.migrations import Status
from gam_db.stored.proving import Proof, keep
from gam_db.stored.pruning import COUNTED, Retention
from gam_db.stored.roles import Roles
from gam_db.stored.state import State, kind_of
from gam_db.stored.tables import StateTables


@options.taking("schema", "prefix", "as_json", source=False, state=True)
def migrate(
    settings: Settings,
    common: options.Common,
    status: Annotated[
        bool,
        option(*("--status", "Change nothing; say what was applied. Exit code 2: some are pending.")),
    ] = False,
    sql: Annotated[
        bool,
        option("--sql", "Print the script, for a database administrator; open no database."),
    ] = False,
    engine: Annotated[
        str | None, option("", f"With --sql: one of {', '.join(NAMES)} (default duckdb).")
    ] = None,
    grants: Annotated[
        str | None,
        option(
            "owner=NAME,writer=NAME,reader=NAME",
            "With --sql --engine postgres: let the tables belong to the owner, and give writer "
            "(calibrate, score, check, prune) and reader (status, views) what they need.",
        ),
    ] = None,
) -> None:
    """Make the state tables in a database, or bring those of an older gam-db up to date.

    It can be run at any time: what was applied is recorded and not applied again, and rows stay.
    """
    if sql and (status or common.as_json):
        raise ConfigurationError("--sql prints a script; leave out --status and --json.")
    if engine is not None and not sql:
        raise ConfigurationError("--engine says for which engine --sql prints; add --sql.")
    if grants is not None and not sql:
        raise ConfigurationError("--grants says what --sql prints besides; add --sql.")
    tables = settings.monitor.tables
    if sql:
        who = None if grants is None else Roles.parsed(grants)
        print(migrations.rendered(engine_named(engine or "duckdb"), tables, who), end="")
        return
    with options.opened(settings, writable=not status, must_exist=False) as session:
        done = () if status else migrations.migrate(session, tables)
        found = migrations.status(session, tables)

    def show(out: Console) -> None:
        if status:
            _show_migrations(out, tables, found)
        elif done:
            applied = ", ".join(f"{one.number} {one.name}" for one in done)
            out.print(printable(f"{tables}*: applied {applied}"), soft_wrap=True)
        else:
            page.say(out, f"{tables}*: up to date, {len(found.applied)} migrations")

    figures = {
        "schema": tables.schema,
        "prefix": tables.prefix,
        "applied": found.applied,
        "applied_now": [one.number for one in done],
        "pending": [{"number": one.number, "name": one.name} for one in found.pending],
    }
    page.tell(Exit.ATTENTION if found.pending else Exit.FINE, figures, show, common)


def _show_migrations(out: Console, tables: StateTables, found: Status) -> None:
    rows = [vars(row) | {"by": f"gam-db {row.gam_version}"} for row in found.applied]
    rows += [vars(one) | {"applied_at": None, "by": ""} for one in found.pending]
    columns: dict[str, page.Cell] = {
        "number": lambda row: str(row["number"]),
        "migration": "name",
        "applied": lambda row: _when(row["applied_at"]),
        "by": "by",
    }
    page.table(out, rows, columns, left=("migration", "applied", "by"))
    pending = f"{len(found.pending)} pending; run `gam migrate`"
    page.say(out, f"{tables}*: {pending if found.pending else 'up to date'}")


def _when(applied_at: int | None) -> str:
    if applied_at is None:
        return "pending"
    return page.time_text(told_time(applied_at, TimeKind.TIMESTAMP), named=True)


#: Parts that follow from the source, and of which is told what was counted.
_MENDED = ("scored", "calibration")


def check_state(
    settings: Settings, relation: str | tuple[str, ...] | None, common: options.Common
) -> None:
    """Compare the state of a monitor with its source, and print what differs.

    Args:
        settings: say which monitor.
        relation: what to read instead of the relation that it was made from.
        common: how it is printed.

    Raises:
        UserError: there is no such monitor, or its source cannot be used.
    """
    name = settings.monitor.name
    session = options.opened(settings, common.threads, writable=False)
    with working(session, common.quiet) as on_step:
        monitor, known = watched(session, settings, relation)
        found = monitor.checked_state(on_step=on_step)
    # Only now, and shortly: a DuckDB file that is open for writing is open for nobody else.
    unkept = None
    try:
        with options.opened(settings, common.threads) as session:
            state = State(session, settings.monitor.tables)
            keep(state, state.monitor(name)["monitor_id"], found.proof)
    except EngineError as error:
        unkept = str(error)
    kind, rows, proof = kind_of(known), found.differences.to_pylist(), found.proof

    def show(out: Console) -> None:
        _show_differences(out, name, proof, rows, kind, common)
        if unkept is not None:
            page.say(out, f"that this was checked could not be recorded: {unkept}")

    figures = {
        "monitor": name,
        "checked_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP),
        "recorded": unkept is None,
        **{name: getattr(proof, name) for name in ("channels", "versions", "buckets")},
        "differences": [{**row, "day": _day(row), "since": _since(row, kind)} for row in rows],
    }
    page.tell(Exit.ATTENTION if rows else Exit.FINE, figures, show, common)


def _show_differences(
    out: Console,
    name: str,
    proof: Proof,
    rows: Sequence[Row],
    kind: TimeKind,
    common: options.Common,
) -> None:
    if not rows:
        page.say(
            out,
            f"monitor {name}: {proof.channels:,} channels, {proof.buckets:,} buckets: all of it is what "
            "the source gives, and what calibration froze",
        )
        return
    others = {(row["asset"], row["channel"]) for row in rows if row["asset"] is not None}
    page.say(
        out, f"monitor {name}: {len(others):,} of {proof.channels:,} channels are not as they should be"
    )
    for row in common.of(rows):
        page.say(out, f"  {_line(row, kind)}")
    page.cut(out, rows, common.everything)
    since = [row["since"] for row in rows if row["since"] is not None]
    if since:
        page.say(out, f"gam score --from {shown_instant(min(since), kind)} scores them anew")
    if any(row["part"] == "calibration" for row in rows):
        page.say(out, "gam calibrate --again makes new versions of the calibration as it is now")
    if any(row["part"] not in _MENDED and row["since"] is None for row in rows):
        page.say(
            out,
            "what no scoring mends was changed or damaged in the tables: put them back from a copy of "
            "the database; or gam calibrate --again makes new versions, and gam prune --keep-versions 0 "
            "removes the others",
        )


def _line(row: Row, kind: TimeKind) -> str:
    if row["part"] not in _MENDED:
        return _damage(row, kind)
    named = printable(f"{row['asset']} {row['channel']}")
    counted = f"{row['samples_then']:,} then, {row['samples_now']:,} now"
    if row["part"] == "calibration":
        return f"{named}: calibration: rows {counted}; {row['differing']:,} cells visited otherwise"
    day = _day(row)
    when = "" if day is None else f" {day}"
    return (
        f"{named}:{when} samples {counted}; {row['differing']:,} buckets differ, from "
        f"{shown_instant(row['since'], kind)} on"
    )


def _damage(row: Row, kind: TimeKind) -> str:
    """Return what is said of a difference that the source did not make."""
    said = f"{row['part']}: {row['what']} ({row['differing']:,})"
    if row["since"] is not None:
        said += f", from {shown_instant(row['since'], kind)} on"
    if row["asset"] is None:
        return said
    named = printable(f"{row['asset']} {row['channel']}")
    return f"{named}: version {row['version']}: {said}"


def _day(row: Row) -> str | None:
    if row["day"] is None:
        return None
    return (dt.date(1970, 1, 1) + dt.timedelta(days=row["day"])).isoformat()


def _since(row: Row, kind: TimeKind) -> str | None:
    return None if row["since"] is None else shown_instant(row["since"], kind)


_KINDS = dict(zip(COUNTED, ("buckets", "novel cells", "runs", "support"), strict=True))


@options.taking(
    *(*options.STATE, "keep", "keep_novel", "everything", "as_json"), source=False, state=True
)
def prune(
    settings: Settings,
    common: options.Common,
    keep_versions: Annotated[
        int | None,
        option("N", "Retired versions of each channel that stay. Default: all of them.", min=0),
    ] = None,
    dry_run: Annotated[bool, option("--dry-run", "Say what would go, and change nothing.")] = False,
) -> None:
    """Delete old buckets, novel cells, versions and records of runs; say how large each channel is.

    Age is counted from the newest bucket of each channel. What the next run needs stays whatever its
    age: the buckets that lookback reaches, and a window before them. The file does not shrink; the room
    is used again.
    """
    said = settings.monitor
    retention = Retention(said.keep, said.keep_novel, keep_versions, said.lookback)
    with options.opened(settings) as session:
        sizes = pruning.prune(session, said.tables, said.name, retention, dry_run)
    _tell_sizes(sizes, said.name, dry_run, common)


@options.taking(*options.STATE, "everything", "as_json", source=False, state=True)
def compact(settings: Settings, common: options.Common) -> None:
    """Delete rows that nobody sees: hidden by a later run, or left by one that was cut short.

    For engines without transactions (ClickHouse, Spark), where scoring only appends; on the others it
    finds nothing. The indicator does not change.
    """
    with options.opened(settings) as session:
        sizes = pruning.compact(session, settings.monitor.tables, settings.monitor.name)
    _tell_sizes(sizes, settings.monitor.name, False, common)


def _tell_sizes(sizes: pa.Table, monitor: str, dry_run: bool, common: options.Common) -> None:
    """Print how much there was and is of each channel."""
    rows = sizes.to_pylist()

    def show(out: Console) -> None:
        columns: dict[str, page.Cell] = {"channel": lambda row: f"{row['asset']} {row['channel']}"}
        columns |= {word: partial(_left, kind=kind) for kind, word in _KINDS.items()}
        page.table(out, common.of(rows), columns)
        page.cut(out, rows, common.everything)
        out.print()
        page.say(out, _summary(rows, dry_run))

    page.tell(Exit.FINE, {"monitor": monitor, "dry_run": dry_run, "channels": rows}, show, common)


def _left(row: Row, kind: str) -> str:
    after, before = row[f"{kind}_after"], row[kind]
    return f"{after:,}" if after == before else f"{after:,} of {before:,}"


def _summary(rows: Sequence[Row], dry_run: bool) -> str:
    said = {kind: f"rows of {word}" for kind, word in _KINDS.items()} | {"versions": "versions"}
    counts = {kind: sum(row[kind] - row[f"{kind}_after"] for row in rows) for kind in said}
    gone = [f"{count:,} {said[kind]}" for kind, count in counts.items() if count]
    if not gone:
        return "nothing to delete"
    return f"{'would delete' if dry_run else 'deleted'}: {', '.join(gone)}"


@options.taking("schema", "prefix", source=False, state=True)
def drop(
    settings: Settings,
    name: Annotated[
        str | None,
        option("MONITOR", "Remove the rows of this monitor only; the tables and all others stay."),
    ] = None,
    yes: Annotated[bool, option("--yes", "Do not ask.")] = False,
) -> None:
    """Remove the state tables of a schema and prefix, or with --name the rows of one monitor.

    It lists what would go and asks for the name to be typed. The source, a schema and other tables stay.
    """
    tables = settings.monitor.tables
    with options.opened(settings) as session:
        found = dropping.removals(session, tables, name)
        if not yes:
            _show_removals(tables, found, name)
            _ask(str(tables) if name is None else name)
        dropping.remove(session, found)
    said = f"{tables}*" if name is None else f"monitor {name} from {tables}*"
    print(f"removed: {printable(said)}")


def _show_removals(tables: StateTables, found: Sequence[Removal], name: str | None) -> None:
    out = page.console()
    page.say(out, "This removes" if name is None else f"This removes, of monitor {name},")
    columns: dict[str, page.Cell] = {
        "table": lambda row: tables.shown(row["name"]),
        "rows": lambda row: "view" if row["rows"] is None else str(row["rows"]),
    }
    page.table(out, list(map(vars, found)), columns)


def _ask(expected: str) -> None:
    try:
        typed = typer.prompt(f"Type {expected} to remove it", default="", show_default=False)
    except typer.Abort:
        raise ConfigurationError(
            "Nothing was removed: nobody could be asked; say --yes if it is meant."
        ) from None
    if typed != expected:
        raise ConfigurationError(f"Nothing was removed: {expected} was not typed.")
