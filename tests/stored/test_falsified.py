"""Whatever column of whatever state table is wrong, ``gam check --state`` finds it, or here is why not.

The columns are those of the migrations, so that a new one cannot be forgotten. A state of many like
channels has one falsified value in each, so that one check judges them all, each by its own channel.
"""

import itertools
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cache
from typing import Any

import pyarrow as pa
import pytest
from sqlglot import exp

import engines
import gam_db
import scripts
from gam_db.errors import UserError
from gam_db.stored.monitor import Monitor
from gam_db.stored.schema.migration_files import definitions
from gam_db.stored.sources import source_of
from strategies import Row

PARAMETERS = gam_db.Parameters(m=2, tau=2, bins=4, window=8, stride=4)
ALARMS = gam_db.Alarms("5 per 1000 judgements")
LOOKBACK = 6
CALIBRATED, CALM = 79, 120
ENDS = (100, 125, 150, 170)

#: What may differ without being wrong: columns no number depends on, or that nothing can be held to.
MAY_DIFFER = {
    ("version", "program_column"): "told for people; without one the programs are missed",
    ("run", "started"): "a clock",
    ("run", "committed"): "a clock; it says when a channel was last looked at",
    ("run", "rows_read"): "rows may come and go within the lookback until the next run reads them",
    ("run", "calibration_readings IS NULL"): "not every run counts; the one before speaks then",
    ("horizon", "first_bucket"): "gam score --full brings older buckets back; one too small is found",
    ("horizon", "first_novel"): "likewise",
    ("monitor", "created"): "a clock",
    ("migration", "applied_at"): "a clock",
    ("migration", "gam_version"): "told for people",
    ("run", "planned_from"): "the run that it names may be pruned; one too small is found",
    ("run", "planned_from IS NULL"): "runs of before it was recorded have none",
    ("run", "hides IS NULL"): "earlier runs are looked at for nothing",
    ("run", "episodes_pending"): "the next run follows more judgements than it has to",
    (
        "run",
        "hides",
    ): "whether all earlier runs are looked at; one that hides all the same shows rows twice",
    **{
        ("unplaced", column): "a record of what a run met then; nothing is computed from it"
        for column in (
            *("monitor_id", "started", "nameless", "undated", "strangers", "stranger_channels"),
            *("held", "invalid", "held IS NULL", "invalid IS NULL"),
        )
    },
    **{
        ("left_out", column): "a record of what the newest run met; nothing is computed from it"
        for column in ("monitor_id", "started", "kind", "asset", "channel", "readings", "latest")
    },
    ("limit", "created"): "a clock",
    ("limit", "cause"): "told for people",
    ("limit", "family"): "tells families of one calibration apart; nothing is computed from it",
    ("episode", "noticed_at"): "a clock",
    ("label", "created"): "a clock",
    ("label", "note"): "what somebody said",
    (
        "band_visit",
        "band",
    ): "told for people; vectors and novel ones of all bands are held to the judgement",
    **{
        ("move", column): "told for people; nothing is computed from it but a sentence"
        for column in (
            *("version_id", "judgement_no", "run_id", "move_no", "factor", "displacement"),
            *("vectors", "novel", "regained", "lost", "deleted"),
        )
    },
    **{
        ("proof", column): "a record of what was found then; nothing is computed from it"
        for column in ("proved_at", "extent", "channels", "versions", "buckets", "differences")
    },
}

#: What the tables say against one another, too large or too small: the raw rows may be gone by then.
CONTRADICTED = {
    ("bucket", "novel"): "novel cells",
    ("bucket", "novel_in_window"): "buckets",
    ("bounds", "cells"): "versions",
    ("bounds", "deleted"): "versions",
}

#: Of a table: which row of a channel is falsified, of those in the order of their first columns.
Rows = list[dict[str, Any]]
CHOSEN: dict[str, dict[str, Callable[[Rows], dict[str, Any]]]] = {
    **{
        table: {"": lambda rows: rows[-1]}
        for table in ("version", "calibration", "bounds", "checksum", "horizon", "extent", "limit")
    },
    "buffered": {"": lambda rows: rows[len(rows) // 2]},
    "band": {"": lambda rows: rows[0]},
    "band_visit": {"": lambda rows: rows[-1]},
    "move": {"": lambda rows: rows[-1]},
    "judgement": {"settled": lambda rows: rows[6], "newest": lambda rows: rows[-1]},
    "block": {"": lambda rows: rows[1]},
    "ladder": {"": lambda rows: rows[1]},
    "probe": {"": lambda rows: rows[1]},
    "program": {"": lambda rows: rows[0]},
    "support": {"": lambda rows: rows[len(rows) // 2]},
    "bucket": {"settled": lambda rows: rows[2], "newest": lambda rows: rows[-1]},
    "novel": {"settled": lambda rows: rows[0], "newest": lambda rows: rows[-1]},
    "unknown_program": {"settled": lambda rows: rows[0], "newest": lambda rows: rows[-1]},
    "run": {"newest": lambda rows: rows[-1]},
}

#: Tables of which a row that is there twice is harmless: the largest counts, or each speaks for itself.
MAY_DOUBLE = ("horizon", "band_visit", "move")

#: Tables whose rows are not of one channel; each of their columns is falsified alone.
SHARED = ("migration", "monitor", "channel", "proof", "unplaced", "left_out", "episode", "label")


TYPES = {"BIGINT": pa.int64(), "DOUBLE": pa.float64(), "TEXT": pa.string(), "VARCHAR": pa.string()}


@cache
def kinds() -> dict[tuple[str, str], str]:
    """Return the type of every column of every state table."""
    return {
        (name, column.name): column.args["kind"].sql("duckdb")
        for name, definition in definitions().items()
        if not definition.is_view
        for column in definition.create.this.expressions
    }


def columns() -> Iterator[tuple[str, str, bool]]:
    """Give every column of every state table, and whether it may be NULL."""
    for name, definition in definitions().items():
        for column in () if definition.is_view else definition.create.this.expressions:
            rules = [rule.kind for rule in column.constraints]
            present = any(isinstance(rule, exp.NotNullColumnConstraint) for rule in rules)
            yield name, column.name, not present


#: Columns of text that may be NULL.
TEXTS = (
    *("reason", "would_not_see", "blind_reason", "taught_by", "member_verdict"),
    *("program", "program_column"),
)


def other(column: str, value: Any, less: bool = False) -> Any:
    """A value that is not this one, and near it unless it is a key or a length."""
    if value is None:
        return "1" if column in TEXTS else 1
    if isinstance(value, str):
        return f"{value}0"
    if less:
        return value - 1
    if isinstance(value, float):
        return value + 0.125
    return value + (10**6 if column.endswith("_id") or column == "lookback" else 1)


#: What is done to a row of a channel.
CHANGED, LESSENED, EMPTIED, DELETED, DOUBLED = "changed", "smaller", "NULL", "deleted", "twice"

#: Tables of what was learnt: a figure that is too small is found there as well as one that is too large.
LEARNT = (
    *("bounds", "block", "ladder", "probe", "program", "support", "extent", "limit", "bucket"),
    *("judgement", "unknown_program"),
)


@dataclass(frozen=True)
class Case:
    """One wrong thing in one table, of one channel."""

    table: str
    which: str
    done: str
    column: str = ""

    @property
    def place(self) -> tuple[str, str]:
        """What is said of it where it may be so."""
        return self.table, f"{self.column} IS NULL" if self.done == EMPTIED else self.column or self.done

    def spoil(self, rows: Rows, all_rows: Rows) -> bool:
        """Make the rows of a channel wrong, and tell whether that was possible."""
        row = CHOSEN[self.table][self.which](rows)
        if self.done == DELETED:
            all_rows.remove(row)
        elif self.done == DOUBLED:
            all_rows.append(dict(row))
        elif self.done in (EMPTIED, LESSENED) and row[self.column] is None:
            return False
        elif self.done == EMPTIED:
            row[self.column] = None
        else:
            row[self.column] = other(self.column, row[self.column], self.done == LESSENED)
        return True


def ways(table: str, column: str, may_be_null: bool) -> Iterator[str]:
    """Give what can be wrong with a column."""
    yield CHANGED
    if may_be_null:
        yield EMPTIED
    if table in LEARNT and "INT" in kinds()[table, column] and not column.endswith("_id"):
        yield LESSENED


def cases() -> list[Case]:
    """Return what can be wrong in the rows of a channel."""
    changed = [
        Case(table, which, done, column)
        for table, column, may_be_null in columns()
        if table not in SHARED
        for which in CHOSEN[table]
        for done in ways(table, column, may_be_null)
    ]
    whole = [
        Case(table, which, done)
        for table, chosen in CHOSEN.items()
        for which in chosen
        for done in (DELETED, DOUBLED)
        if table != "version" and not (done == DOUBLED and table in MAY_DOUBLE)
    ]
    return [*changed, *whole]


def series(asset: str, end: int) -> list[Row]:
    """A channel that repeats a pattern, and more and more often does not."""
    values = (
        (time % 5 if time <= CALIBRATED or time % (7 if time < CALM else 3) else time % 9)
        for time in range(end)
    )
    return [(asset, "x", time, float(value)) for time, value in enumerate(values)]


def with_programs(session: Any, table: exp.Table) -> str:
    """Make a view of the rows in which machines run something new twice, the second time to the end."""
    time, name = exp.column("time"), engines.fresh_name("programs")
    is_new = exp.or_(time.between(131, 136), time.copy() >= 165)
    program = exp.case().when(is_new, exp.Literal.string("new")).else_(exp.Literal.string("old"))
    rows = exp.select("asset", "channel", "time", "value", program.as_("product")).from_(table.copy())
    session.execute(exp.Create(this=exp.to_table(name), kind="VIEW", expression=rows))
    return name


def made(engine: str, assets: list[str], has_programs: bool = False) -> Monitor:
    """A monitor that was scored three times, and pruned, with a retired version of each channel.

    Each has an episode, and that of the first one a label.
    """
    session = engines.session(engine)
    table = scripts.telemetry(session, [row for asset in assets for row in series(asset, ENDS[0])])
    reach: dict[str, Any] = {"lookback": LOOKBACK, "prefix": engines.fresh_name("state")}
    calibration = gam_db.Calibration(intervals=[(0, CALIBRATED)])
    source = gam_db.Source(table.name)
    if has_programs:
        source = gam_db.Source(with_programs(session, table), program="product")
    monitor = Monitor(session, source, PARAMETERS, calibration, ALARMS, **reach)
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    monitor.calibrate(again=True)
    for start, end in itertools.pairwise(ENDS):
        rows = [row for asset in assets for row in series(asset, end)[start:]]
        scripts.arrive(session, table, rows)
        monitor.score(everything=True)
    monitor.prune(keep=60, keep_novel=45)
    monitor.label("true_fault", 1)
    return monitor


def stored(monitor: Monitor, table: str) -> pa.Table:
    """All rows of a state table, in the order of their columns."""
    node = monitor.state.tables.table(table)
    names = list(monitor.session.describe(node))
    chosen = [exp.column(exp.to_identifier(name)) for name in names]
    rows = monitor.session.fetch(exp.select(*chosen).from_(node).order_by(*names))
    # A column without a value has no type on SQLite.
    return rows.cast(pa.schema([(name, TYPES[kinds()[table, name]]) for name in names]))


def put_back(monitor: Monitor, table: str, rows: pa.Table) -> None:
    """Let a state table hold these rows and no others; every engine can do that."""
    node = monitor.state.tables.table(table)
    key = rows.column_names[0]
    monitor.session.delete(node, [key], exp.select(exp.column(key)).distinct().from_(node))
    monitor.state.append_rows(table, rows.to_pylist())


def owners(monitor: Monitor) -> dict[str, dict[int, str]]:
    """Which asset an active version, and its support, belong to."""
    assets = {row["channel_id"]: row["asset"] for row in stored(monitor, "channel").to_pylist()}
    newest = {row["channel_id"]: row for row in stored(monitor, "version").to_pylist()}
    return {
        key: {row[key]: assets[channel] for channel, row in newest.items()}
        for key in ("version_id", "support_id")
    }


def differing(monitor: Monitor) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = monitor.checked_state().differences.to_pylist()
    return found


@pytest.mark.thorough
def test_whatever_is_wrong_in_a_table_is_found() -> None:
    find_all("duckdb")


@pytest.mark.full
def test_whatever_is_wrong_is_found_on_every_engine(engine: str) -> None:
    find_all(engine)


def find_all(engine: str) -> None:
    """Spoil something in each of many channels, and look whether each is found."""
    asked = {f"c{number:03}": case for number, case in enumerate(cases())}
    monitor = made(engine, list(asked), has_programs=True)
    # Pruning that was cut short may leave the record of an earlier one beside its own.
    earlier = {"first_bucket": 0, "first_novel": 0}
    known = stored(monitor, "horizon")
    monitor.state.append_rows("horizon", [{**row, **earlier} for row in known.to_pylist()])
    assert differing(monitor) == []
    put_back(monitor, "horizon", known)
    owned = owners(monitor)
    untouched = set()
    for table in CHOSEN:
        rows = stored(monitor, table)
        key = "support_id" if rows.column_names[0] == "support_id" else "version_id"
        of_asset: dict[str, Rows] = {}
        changed = rows.to_pylist()
        for row in changed:
            of_asset.setdefault(owned[key].get(row[key], ""), []).append(row)
        for asset, case in asked.items():
            if case.table == table and not case.spoil(of_asset[asset], changed):
                untouched.add(asset)
        put_back(monitor, table, pa.Table.from_pylist(changed, schema=rows.schema))
    told = [(row["asset"], row["part"]) for row in differing(monitor)]
    found = {asset for asset, _ in told}
    missed = {case.place for asset, case in asked.items() if asset not in found | untouched}
    # Without transactions no run says that it hides nothing: it is NULL anyway.
    is_null = set() if monitor.session.transactions else {("run", "hides IS NULL")}
    assert missed == {place for place in MAY_DIFFER if place[0] in CHOSEN} - is_null
    for asset, case in asked.items():
        if case.which != "settled" and case.done != EMPTIED and case.place in CONTRADICTED:
            assert (asset, CONTRADICTED[case.place]) in told, case
    emptied = {asked[asset].place for asset in untouched if asked[asset].done == EMPTIED}
    assert emptied <= {
        *(("version", f"{column} IS NULL") for column in ("max_gap", "score_from")),
        ("run", "withdrawn IS NULL"),
        ("run", "episodes_pending IS NULL"),
        *is_null,
        *(
            ("bounds", f"{column} IS NULL")
            for column in (
                *("lowest_dropped", "highest_dropped", "sees_slower", "would_not_see", "blind_reason"),
                *("teachers", "taught_by", "member_verdict", "member_floor", "member_floor_sd"),
                *("member_floor_max", "member_finest_bins"),
            )
        ),
        *(
            ("version", "still_after IS NULL"),
            ("bucket", "still IS NULL"),
            ("run", "still_since IS NULL"),
            ("extent", "order_ratio IS NULL"),
            *(
                ("limit", f"{column} IS NULL")
                for column in ("order_ratio", "judgements_per_day", "reason")
            ),
        ),
    }


def found_by_command(monitor: Monitor) -> bool:
    """Tell whether the check finds anything, with the source that the tables name."""
    try:
        row = monitor.state.monitor(monitor.name)
        monitor.source = source_of(row, ["x"])
        return bool(differing(monitor))
    except UserError:
        return True


@pytest.mark.full
def test_whatever_is_wrong_in_what_channels_share_is_found(engine: str) -> None:
    monitor = made(engine, ["one"])
    stranger: Row = ("two", "x", ENDS[-1], 1.0)
    scripts.arrive(monitor.session, exp.to_table(str(monitor.source.relation)), [stranger])
    monitor.score()
    monitor.check_state()
    assert not found_by_command(monitor)
    missed = set()
    for table, column, _ in columns():
        if table in SHARED:
            rows = stored(monitor, table)
            changed = rows.to_pylist()
            changed[-1][column] = other(column, changed[-1][column] or (0, "")[is_text(rows, column)])
            put_back(monitor, table, pa.Table.from_pylist(changed, schema=rows.schema))
            if not found_by_command(monitor):
                missed.add((table, column))
            put_back(monitor, table, rows)
    whole = {(table, column) for table, column, _ in columns() if table in SHARED}
    assert missed == whole.intersection(MAY_DIFFER)
    for table in ("monitor", "channel", "version", "episode", "label"):
        rows = stored(monitor, table)
        for spoilt in (rows.slice(0, len(rows) - 1), pa.concat_tables([rows, rows])):
            put_back(monitor, table, spoilt)
            assert found_by_command(monitor), table
        put_back(monitor, table, rows)
    assert not found_by_command(monitor)


def is_text(rows: pa.Table, column: str) -> bool:
    return bool(pa.types.is_string(rows.schema.field(column).type))
