"""``gam migrate``, ``prune`` and ``drop``: the state is made, kept small, removed."""

from collections.abc import Iterator

import typer

from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.options import option
from gam_db.cli.render import Page, Section, Table, Verbatim, show, time_text, write
from gam_db.clock import TimeKind, time_of
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
    """Create or update the state tables in a database.

    You can run it at any time: it applies only new migrations, and rows stay.
    """
    if sql and (status or common.as_json):
        raise ConfigurationError("--sql prints a script; leave out --status and --json.")
    if engine is not None and not sql:
        raise ConfigurationError("--engine chooses the engine of --sql; add --sql.")
    if grants is not None and not sql:
        raise ConfigurationError("--grants adds rights to the script of --sql; add --sql.")
    tables = settings.monitor.tables
    if sql:
        who = None if grants is None else Roles.parsed(grants)
        print(migrations.rendered(engine_named(engine or "duckdb"), tables, who), end="")
        return
    with options.opened(settings, writable=not status, must_exist=False) as session:
        done = () if status else migrations.migrate(session, tables)
        schema_status = migrations.status(session, tables)

    def sections() -> Iterator[Section]:
        if status:
            yield from _migrations(tables, schema_status)
        elif done:
            applied = ", ".join(f"{migration.number} {migration.name}" for migration in done)
            yield Verbatim(f"{tables}*: applied {applied}")
        else:
            yield f"{tables}*: up to date, {len(schema_status.applied)} migrations"

    figures = {
        "schema": tables.schema,
        "prefix": tables.prefix,
        "applied": schema_status.applied,
        "applied_now": [migration.number for migration in done],
        "pending": [
            {"number": migration.number, "name": migration.name} for migration in schema_status.pending
        ],
    }
    show(Page(figures, sections(), urgent=bool(schema_status.pending)), common)


def _migrations(tables: StateTables, schema_status: Status) -> Iterator[Section]:
    rows = []
    for migration in schema_status.applied:
        when = time_text(time_of(migration.applied_at, TimeKind.TIMESTAMP), named=True)
        rows.append(vars(migration) | {"when": when, "by": f"gam-db {migration.gam_version}"})
    rows += [vars(migration) | {"when": "pending", "by": ""} for migration in schema_status.pending]
    yield Table("migrations", rows)
    pending = f"{len(schema_status.pending)} pending; run `gam migrate`"
    yield f"{tables}*: {pending if schema_status.pending else 'up to date'}"


_KINDS = dict(zip(COUNTED, ("buckets", "novel cells", "runs", "support"), strict=True))


@options.of_state(*options.STATE, "keep", "keep_novel", "everything", "as_json")
def prune(
    settings: Settings,
    common: options.Common,
    keep_versions: int | None = option("prune.keep_versions"),
    dry_run: bool = option("prune.dry_run", False),
) -> None:
    """Delete old results and show the size of every channel.

    It deletes buckets, novel cells, retired versions and records of runs. Their age counts from the
    newest bucket of the channel. The rows that the next run needs stay: the buckets within lookback, and
    a window before them. The file does not shrink, but its free space is used again.

    It also deletes hidden rows: replaced by a later run, or left by an interrupted one. On engines
    without transactions (ClickHouse, Spark), where scoring only appends, nothing else deletes them.
    """
    monitor = settings.monitor
    lengths = monitor.keep, monitor.keep_novel, keep_versions, monitor.lookback
    with options.opened(settings) as session:
        sizes = pruning.prune(State(session, monitor.tables), monitor.name, *lengths, dry_run)
    rows = sizes.to_pylist()
    words = {kind: f"rows of {word}" for kind, word in _KINDS.items()} | {"versions": "versions"}
    counts = {kind: sum(row[kind] - row[f"{kind}_after"] for row in rows) for kind in words}
    gone = ", ".join(f"{count:,} {words[kind]}" for kind, count in counts.items() if count)

    def left(row: Row, kind: str) -> str:
        after, before = row[f"{kind}_after"], row[kind]
        return f"{after:,}" if after == before else f"{after:,} of {before:,}"

    def sections() -> Iterator[Section]:
        shown = [
            {"name": f"{row['asset']} {row['channel']}", **{kind: left(row, kind) for kind in _KINDS}}
            for row in common.of(rows)
        ]
        yield Table("sizes", shown)
        yield from page.cut(rows, common.everything)
        yield ""
        deleted = f"{'would delete' if dry_run else 'deleted'}: {gone}"
        yield deleted if gone else "nothing to delete"

    show(Page({"monitor": monitor.name, "dry_run": dry_run, "channels": rows}, sections()), common)


@options.of_state("schema", "prefix")
def drop(
    settings: Settings, name: str | None = option("drop.name"), yes: bool = option("drop.yes", False)
) -> None:
    """Delete the state tables, or the rows of one monitor.

    It lists the tables of --schema and --prefix (with --name: the rows of that monitor), and you type
    the name to confirm. The source, the schema and other tables stay.
    """
    tables = settings.monitor.tables
    with options.opened(settings) as session:
        removals = dropping.removals(session, tables, name)
        if not yes:
            shown = [
                {"name": ".".join(part.name for part in removal.table.parts)}
                | {"size": "view" if removal.rows is None else str(removal.rows)}
                for removal in removals
            ]
            of = "" if name is None else f" of monitor {name}"
            write([f"This removes{of}:", Table("removals", shown)])
            _ask(str(tables) if name is None else name)
        dropping.remove(session, removals)
    removed = f"{tables}*" if name is None else f"monitor {name} from {tables}*"
    print(f"removed: {printable(removed)}")


def _ask(expected: str) -> None:
    try:
        typed = typer.prompt(f"Type {expected} to remove it", default="", show_default=False)
    except typer.Abort:
        raise wrong("nobody_confirms") from None
    if typed != expected:
        raise ConfigurationError(f"Nothing was removed: {expected} was not typed.")
