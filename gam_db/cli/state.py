"""``gam migrate``, ``prune`` and ``drop``: the state is made, kept small, removed."""

from functools import partial

import typer

from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.options import option
from gam_db.clock import TimeKind, told_time
from gam_db.engines import NAMES, engine_named
from gam_db.errors import ConfigurationError, printable, wrong
from gam_db.findings import Row
from gam_db.stored import pruning
from gam_db.stored.pruning import COUNTED
from gam_db.stored.schema import dropping, migrations
from gam_db.stored.schema.migrations import Status
from gam_db.stored.schema.roles import Roles
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.state import State


@options.of_state("schema", "prefix", "as_json")
def migrate(
    settings: Settings,
    common: options.Common,
    status: bool = option("migrate.status", False),
    sql: bool = option("migrate.sql", False),
    engine: str | None = option("migrate.engine", names=", ".join(NAMES)),
    grants: str | None = option("migrate.grants"),
) -> None:
    """Make the state tables in a database.

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

    def show(out: page.Out) -> None:
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
    page.tell(figures, show, common, urgent=bool(found.pending))


def _show_migrations(out: page.Out, tables: StateTables, found: Status) -> None:
    rows = []
    for one in found.applied:
        when = page.time_text(told_time(one.applied_at, TimeKind.TIMESTAMP), named=True)
        rows.append(vars(one) | {"when": when, "by": f"gam-db {one.gam_version}"})
    rows += [vars(one) | {"when": "pending", "by": ""} for one in found.pending]
    columns: dict[str, page.Cell] = {
        "number": lambda row: str(row["number"]),
        "migration": "name",
        "applied": "when",
        "by": "by",
    }
    page.table(out, rows, columns, left=("migration", "applied", "by"))
    pending = f"{len(found.pending)} pending; run `gam migrate`"
    page.say(out, f"{tables}*: {pending if found.pending else 'up to date'}")


_KINDS = dict(zip(COUNTED, ("buckets", "novel cells", "runs", "support"), strict=True))


@options.of_state(*options.STATE, "keep", "keep_novel", "everything", "as_json")
def prune(
    settings: Settings,
    common: options.Common,
    keep_versions: int | None = option("prune.keep_versions"),
    dry_run: bool = option("prune.dry_run", False),
) -> None:
    """Delete old buckets, novel cells, versions and records of runs; say how large each channel is.

    Age is counted from the newest bucket of each channel. What the next run needs stays whatever its
    age: the buckets that lookback reaches, and a window before them. The file does not shrink; the room
    is used again.

    Rows that nobody sees go, too: hidden by a later run, or left by one that was cut short. On engines
    without transactions (ClickHouse, Spark), where scoring only appends, nothing else removes them.
    """
    said = settings.monitor
    kept = said.keep, said.keep_novel, keep_versions, said.lookback
    with options.opened(settings) as session:
        sizes = pruning.prune(State(session, said.tables), said.name, *kept, dry_run)
    rows = sizes.to_pylist()
    words = {kind: f"rows of {word}" for kind, word in _KINDS.items()} | {"versions": "versions"}
    counts = {kind: sum(row[kind] - row[f"{kind}_after"] for row in rows) for kind in words}
    gone = ", ".join(f"{count:,} {words[kind]}" for kind, count in counts.items() if count)

    def left(row: Row, kind: str) -> str:
        after, before = row[f"{kind}_after"], row[kind]
        return f"{after:,}" if after == before else f"{after:,} of {before:,}"

    def show(out: page.Out) -> None:
        columns: dict[str, page.Cell] = {"channel": lambda row: f"{row['asset']} {row['channel']}"}
        columns |= {word: partial(left, kind=kind) for kind, word in _KINDS.items()}
        page.table(out, common.of(rows), columns)
        page.cut(out, rows, common.everything)
        out.print()
        deleted = f"{'would delete' if dry_run else 'deleted'}: {gone}"
        page.say(out, deleted if gone else "nothing to delete")

    page.tell({"monitor": said.name, "dry_run": dry_run, "channels": rows}, show, common)


@options.of_state("schema", "prefix")
def drop(
    settings: Settings, name: str | None = option("drop.name"), yes: bool = option("drop.yes", False)
) -> None:
    """Remove the state tables of a schema and prefix, or with --name the rows of one monitor.

    It lists what would go and asks for the name to be typed. The source, a schema and other tables stay.
    """
    tables = settings.monitor.tables
    with options.opened(settings) as session:
        found = dropping.removals(session, tables, name)
        if not yes:
            out = page.console()
            page.say(out, "This removes" if name is None else f"This removes, of monitor {name},")
            columns: dict[str, page.Cell] = {
                "table": lambda row: ".".join(part.name for part in row["table"].parts),
                "rows": lambda row: "view" if row["rows"] is None else str(row["rows"]),
            }
            page.table(out, list(map(vars, found)), columns)
            _ask(str(tables) if name is None else name)
        dropping.remove(session, found)
    said = f"{tables}*" if name is None else f"monitor {name} from {tables}*"
    print(f"removed: {printable(said)}")


def _ask(expected: str) -> None:
    try:
        typed = typer.prompt(f"Type {expected} to remove it", default="", show_default=False)
    except typer.Abort:
        raise wrong("nobody_confirms") from None
    if typed != expected:
        raise ConfigurationError(f"Nothing was removed: {expected} was not typed.")
