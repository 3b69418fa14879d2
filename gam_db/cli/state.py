"""The state in a database: made, proved, kept small, removed.

This module owns ``gam migrate``, ``gam check --state``, ``gam prune``, ``gam compact`` and ``gam drop``,
and their pages; :mod:`gam_db.stored` does the work.
"""

import datetime as dt
from collections.abc import Sequence
from typing import Annotated

import pyarrow as pa
import pyarrow.compute as pc
import typer
from rich.console import Console

from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.progress import working
from gam_db.cli.watch import watched
from gam_db.clock import TimeKind, shown_instant
from gam_db.config import Settings
from gam_db.engines import NAMES, engine_named
from gam_db.engines.session import Session
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


@options.taking("schema", "prefix", source=False, state=True)
def migrate(
    settings: Settings,
    status: Annotated[
        bool,
        typer.Option(
            "--status", help="Change nothing; say what was applied. Exit code 2: some are pending."
        ),
    ] = False,
    sql: Annotated[
        bool,
        typer.Option("--sql", help="Print the script, for a database administrator; open no database."),
    ] = False,
    engine: Annotated[
        str | None, typer.Option(help=f"With --sql: one of {', '.join(NAMES)} (default duckdb).")
    ] = None,
    grants: Annotated[
        str | None,
        typer.Option(
            metavar="owner=NAME,writer=NAME,reader=NAME",
            help="With --sql --engine postgres: let the tables belong to the owner, and give writer "
            "(calibrate, score, check, prune) and reader (status, views) what they need.",
        ),
    ] = None,
    as_json: options.Json = False,
) -> None:
    """Make the state tables in a database, or bring those of an older gam-db up to date.

    It can be run at any time: what was applied is recorded and not applied again, and rows stay.
    """
    if sql and (status or as_json):
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
    page.tell(Exit.ATTENTION if found.pending else Exit.FINE, figures, show, as_json)


def _show_migrations(out: Console, tables: StateTables, found: Status) -> None:
    rows = [
        *((row.number, row.name, row.applied_at, f"gam-db {row.gam_version}") for row in found.applied),
        *((one.number, one.name, None, "") for one in found.pending),
    ]
    columns = {
        "number": [str(number) for number, *_ in rows],
        "migration": [name for _, name, *_ in rows],
        "applied": [_when(time) for _, _, time, _ in rows],
        "by": [version for *_, version in rows],
    }
    page.table(out, columns, left=("migration", "applied", "by"))
    if found.pending:
        page.say(out, f"{tables}*: {len(found.pending)} pending; run `gam migrate`")
    else:
        page.say(out, f"{tables}*: up to date")


def _when(applied_at: int | None) -> str:
    if applied_at is None:
        return "pending"
    return f"{dt.datetime.fromtimestamp(applied_at / 1e6, dt.UTC):%Y-%m-%d %H:%M UTC}"


#: Parts that follow from the source, and of which is told what was counted.
_MENDED = ("scored", "calibration")


def check_state(
    settings: Settings,
    relation: str | tuple[str, ...] | None,
    threads: int | None,
    everything: bool,
    as_json: bool,
    quiet: bool,
) -> None:
    """Compare the state of a monitor with its source, and print what differs.

    Args:
        settings: say which monitor.
        relation: what to read instead of the relation that it was made from.
        threads: processor threads.
        everything: print every difference.
        as_json: print figures instead.
        quiet: print nothing.

    Raises:
        UserError: there is no such monitor, or its source cannot be used.
    """
    name = settings.monitor.name
    session = options.opened(settings, threads, writable=False)
    with working(session, quiet) as on_step:
        monitor, known = watched(session, settings, relation)
        found = monitor.checked_state(on_step=on_step)
    # Only now, and shortly: a DuckDB file that is open for writing is open for nobody else.
    unkept = None
    try:
        with options.opened(settings, threads) as session:
            _keep(session, settings, found.proof)
    except EngineError as error:
        unkept = str(error)
    kind, rows, proof = kind_of(known), found.differences.to_pylist(), found.proof

    def show(out: Console) -> None:
        _show_differences(out, name, proof, rows, kind, everything)
        if unkept is not None:
            page.say(out, f"that this was checked could not be recorded: {unkept}")

    figures = {
        "monitor": name,
        "checked_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP),
        "recorded": unkept is None,
        "channels": proof.channels,
        "versions": proof.versions,
        "buckets": proof.buckets,
        "differences": [{**row, "day": _day(row), "since": _since(row, kind)} for row in rows],
    }
    page.tell(Exit.ATTENTION if rows else Exit.FINE, figures, show, as_json, quiet)


def _keep(session: Session, settings: Settings, proof: Proof) -> None:
    """Record the check, in a session that can write."""
    state = State(session, settings.monitor.tables)
    keep(state, state.monitor(settings.monitor.name)["monitor_id"], proof)


def _show_differences(
    out: Console, name: str, proof: Proof, rows: Sequence[Row], kind: TimeKind, everything: bool
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
    for row in rows if everything else rows[: options.SHOWN]:
        page.say(out, f"  {_line(row, kind)}")
    page.cut(out, rows, everything)
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


@options.taking(*options.STATE, "keep", "keep_novel", source=False, state=True)
def prune(
    settings: Settings,
    keep_versions: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=0, help="Retired versions of each channel that stay. Default: all of them."
        ),
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would go, and change nothing.")
    ] = False,
    everything: options.All = False,
    as_json: options.Json = False,
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
    _tell_sizes(sizes, said.name, dry_run, everything, as_json)


@options.taking(*options.STATE, source=False, state=True)
def compact(
    settings: Settings,
    everything: options.All = False,
    as_json: options.Json = False,
) -> None:
    """Delete rows that nobody sees: hidden by a later run, or left by one that was cut short.

    For engines without transactions (ClickHouse, Spark), where scoring only appends; on the others it
    finds nothing. The indicator does not change.
    """
    with options.opened(settings) as session:
        sizes = pruning.compact(session, settings.monitor.tables, settings.monitor.name)
    _tell_sizes(sizes, settings.monitor.name, False, everything, as_json)


def _tell_sizes(sizes: pa.Table, monitor: str, dry_run: bool, everything: bool, as_json: bool) -> None:
    """Print how much there was and is of each channel."""
    rows = sizes.to_pylist()

    def show(out: Console) -> None:
        shown = rows if everything else rows[: options.SHOWN]
        columns = {"channel": [f"{row['asset']} {row['channel']}" for row in shown]}
        for kind, word in _KINDS.items():
            columns[word] = [_left(row[f"{kind}_after"], row[kind]) for row in shown]
        page.table(out, columns)
        page.cut(out, rows, everything)
        out.print()
        page.say(out, _summary(sizes, dry_run))

    page.tell(Exit.FINE, {"monitor": monitor, "dry_run": dry_run, "channels": rows}, show, as_json)


def _left(after: int, before: int) -> str:
    return f"{after:,}" if after == before else f"{after:,} of {before:,}"


def _summary(sizes: pa.Table, dry_run: bool) -> str:
    gone = []
    for kind, word in _KINDS.items():
        count = (pc.sum(sizes[kind]).as_py() or 0) - (pc.sum(sizes[f"{kind}_after"]).as_py() or 0)
        if count:
            gone.append(f"{count:,} rows of {word}")
    versions = pc.sum(pc.subtract(sizes["versions"], sizes["versions_after"])).as_py()
    if versions:
        gone.append(f"{versions:,} versions")
    if not gone:
        return "nothing to delete"
    return f"{'would delete' if dry_run else 'deleted'}: {', '.join(gone)}"


@options.taking("schema", "prefix", source=False, state=True)
def drop(
    settings: Settings,
    name: Annotated[
        str | None,
        typer.Option(
            metavar="MONITOR",
            help="Remove the rows of this monitor only; the tables and all others stay.",
        ),
    ] = None,
    yes: Annotated[bool, typer.Option("--yes", help="Do not ask.")] = False,
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
    columns = {
        "table": [tables.shown(removal.name) for removal in found],
        "rows": ["view" if removal.rows is None else f"{removal.rows}" for removal in found],
    }
    page.table(out, columns)


def _ask(expected: str) -> None:
    try:
        typed = typer.prompt(f"Type {expected} to remove it", default="", show_default=False)
    except typer.Abort:
        raise ConfigurationError(
            "Nothing was removed: nobody could be asked; say --yes if it is meant."
        ) from None
    if typed != expected:
        raise ConfigurationError(f"Nothing was removed: {expected} was not typed.")
