"""Sources: the relation of the telemetry, and the roles of its columns.

This module owns the two layouts and turns a source into the step *readings*. It runs nothing.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

import sqlglot
from sqlglot import exp
from sqlglot.errors import SqlglotError

from gam_db.arguments import public
from gam_db.clock import Length, TimeKind
from gam_db.composing import template
from gam_db.errors import SourceError, wrong
from gam_db.settings.form import Form
from gam_db.settings.local_time import LocalTime, local_time
from gam_db.settings.setting import check

ONLY_ASSET = "asset"
FILE_ENDINGS = (".parquet", ".pq", ".csv", ".tsv", ".csv.gz", ".tsv.gz", ".csv.zst")
_SPREADSHEETS = (".xlsx", ".xls", ".xlsm", ".xlsb", ".ods", ".numbers")

TimeNode = Callable[[exp.Expr], exp.Expr]


@public
@dataclass(frozen=True)
class Source(Form):
    """A long table: one row per reading.

    Attributes:
        relation: name of a table or view (dots separate catalogue, schema and table; a tuple of parts
            is taken as it is), path of a Parquet or CSV file (wildcards allowed) or a list of such, a
            folder (its path ends in a slash), an Arrow table (anything with
            ``__arrow_c_stream__``, such as a data frame), or a 1-D array or series, which has the
            columns ``time`` and ``value`` (called like the series, where that has a name).
        asset, channel: columns that name the machine and the signal; None if there is one only: its
            asset is called ``asset`` and its channel like the value column.
        time: column with a timestamp (without zone: UTC), its text, or an integer counter.
        value: numeric column; true and false are 1 and 0.
        where: a condition in SQL (DuckDB's dialect), applied before everything else.
        time_kind: "timestamp" or "counter"; needed only where SQL is made without looking at the
            relation, which then counts as "counter" by default.
        clock_tolerance: a row that is later than now, by the database's clock, by more than this length
            is left out until its time comes; default five minutes, False for any time. A counter has no
            clock.

    How numbers and times are written is said by keywords, see :class:`gam_db.settings.form.Form`:
    decimal, thousands, unit, null, delimiter, skip_rows, encoding, time_format, time_unit,
    source_time_zone, valid_when. ``program`` is a column of texts or whole numbers that says what a
    machine runs at a row (both sides, section 5): a state is then healthy for a program.
    """

    relation: Any
    asset: str | None = "asset"
    channel: str | None = "channel"
    time: str = "time"
    value: str = "value"
    where: str | exp.Expr | None = None
    time_kind: str | None = None
    clock_tolerance: Length | Literal[False] | None = None

    def __post_init__(self) -> None:
        _check_names(self, ("asset", "channel"), ("time", "value"))

    @property
    def columns(self) -> dict[str, str]:
        """The columns to read, by role."""
        columns = {"asset": self.asset, "channel": self.channel, "time": self.time, "value": self.value}
        columns["program"] = self.program
        return {role: column for role, column in columns.items() if column is not None}

    @property
    def value_columns(self) -> tuple[str, ...]:
        """The columns that hold readings."""
        return (self.value,)


@public
@dataclass(frozen=True)
class WideSource(Form):
    """A wide table: one column per channel; a NULL cell is a missing sample, not an absent row.

    Attributes:
        relation, asset, time, where, time_kind, clock_tolerance, and how things are written: as in
            :class:`Source`.
        channels: the numeric columns, each a channel of that name; None for all numeric columns.
    """

    relation: Any
    channels: Sequence[str] | None = None
    asset: str | None = "asset"
    time: str = "time"
    where: str | exp.Expr | None = None
    time_kind: str | None = None
    clock_tolerance: Length | Literal[False] | None = None

    def __post_init__(self) -> None:
        _check_names(self, ("asset",), ("time",))
        if self.channels is not None:
            if isinstance(self.channels, str) or not isinstance(self.channels, Iterable):
                raise SourceError("channels takes a list of column names.")
            object.__setattr__(self, "channels", tuple(self.channels))
            if not all(isinstance(channel, str) and channel for channel in self.channels):
                raise SourceError(f"channels is {self.channels!r}; it takes the names of columns.")
            if not self.channels:
                raise SourceError("channels is empty; name at least one column, or leave it out.")

    @property
    def columns(self) -> dict[str, str]:
        """The columns to read, by role; channels are numbered."""
        columns = {"asset": self.asset, "time": self.time, "program": self.program}
        named = {role: column for role, column in columns.items() if column is not None}
        return named | {f"channel {n}": column for n, column in enumerate(self.value_columns, 1)}

    @property
    def value_columns(self) -> tuple[str, ...]:
        """The columns that hold readings."""
        return tuple(self.channels or ())


AnySource = Source | WideSource


@dataclass(frozen=True)
class Programs:
    """The column of programs.

    Attributes:
        column: its name in the source.
        is_whole: whether it holds whole numbers, which are ordered by size; texts are by their bytes.
    """

    column: str
    is_whole: bool = False


#: Columns of a wide source from which on it is not read as a union with a branch for each: that takes an
#: engine long to plan, though it keeps the order in which few columns are stored.
UNPIVOTED_FROM = 50

#: Branches of one union; SQLite takes no more than 500, and so no more columns than the square of these.
MOST_BRANCHES = 400


def declared_kind(source: AnySource) -> TimeKind | None:
    """Return the way of telling time that the user declared, if any; a zone is that of timestamps.

    Raises:
        SourceError: it is none, or a time zone is declared of a source that tells none or another one.
    """
    if source.time_kind is None:
        return None if source.source_time_zone is None else TimeKind.TIMESTAMP
    try:
        kind = TimeKind(source.time_kind)
    except ValueError:
        raise wrong("time_kind", time_kind=source.time_kind) from None
    check_zone(source, kind)
    return kind


def check_zone(source: AnySource, kind: TimeKind) -> None:
    """Refuse (SourceError) a time zone of a source that counts, or one whose timestamps have one."""
    if source.source_time_zone is None:
        return
    if source.time_unit is not None:
        raise wrong("zone_of_no_local_time", time=source.time, kind="numbers since 1970, which are UTC")
    if kind.is_counter or kind.has_zone:
        raise wrong("zone_of_no_local_time", time=source.time, kind=f"a {kind.value}")


def clock_of(source: AnySource) -> LocalTime | None:
    """Return the local clock of a source; None if that is UTC."""
    return None if source.source_time_zone is None else local_time(source.source_time_zone)


def repeat_of(source: AnySource) -> int:
    """Return how far apart the instants of one local time may be, in microseconds."""
    clock = clock_of(source)
    return 0 if clock is None else clock.longest_repeat


def readings(
    source: AnySource,
    relation: exp.Expr,
    micros_of: TimeNode,
    number_of: TimeNode = lambda column: column,
    unpivots: bool = False,
    validity: bool = False,
    until: exp.Expr | int | None = None,
) -> exp.Query:
    """Return the step *readings*: the rows of the source, its channels named, in the method's words.

    *micros_of* turns the time column into integer microseconds, or leaves a counter as it is; *unpivots*
    says whether the engine can make a row of each of many columns by itself; *number_of* reads a column
    of numbers so that nothing of a value is dropped. With *validity* a reading is 1 or 0, as the user's
    condition on readings holds or not. Rows later than *until*, an integer time, are left out; rows
    without a time stay.
    """
    condition = parsed_condition(source.where)
    asset = named_by(source.asset, ONLY_ASSET)
    if unpivots and len(source.value_columns) >= UNPIVOTED_FROM:
        time = micros_of(template.column(source.time))
        shared = {"asset": asset, "time": time, "condition": condition, **_program(source)}
        return up_to(_unpivoted(source, relation, shared, validity), "time", until)
    branches: list[exp.Query] = []
    for value in source.value_columns:
        slots: dict[str, template.Slot] = {
            "asset": asset,
            "channel": named_by(source.channel if isinstance(source, Source) else None, value),
            "time": micros_of(template.column(source.time)),
            "reading": _reading(source, number_of(template.column(value)), validity),
            "condition": condition,
            **_program(source),
        }
        filled = template.fill("source/readings", slots)
        read_from(relation, filled)
        branches.append(up_to(filled, "instant", until))  # type: ignore[arg-type]
    if len(branches) > MOST_BRANCHES:
        starts = range(0, len(branches), MOST_BRANCHES)
        parts = [stacked(branches[start : start + MOST_BRANCHES]) for start in starts]
        columns = [exp.column(name) for name in parts[0].named_selects]
        branches = [exp.select(*columns).from_(part.subquery("stacked", copy=False)) for part in parts]
    return stacked(branches)


def up_to(rows: exp.Query, time: str, until: exp.Expr | int | None) -> exp.Query:
    """Leave out rows whose time, a column of a name, is later than an integer time; in place."""
    if until is None:
        return rows
    column, limit = exp.column(time), until if isinstance(until, exp.Expr) else template.node_of(until)
    return rows.where(exp.or_(column <= limit, column.copy().is_(exp.null())), copy=False)


def _program(source: AnySource) -> dict[str, template.Slot]:
    """Return the slots of the column of programs; empty if there is none."""
    if source.program is None:
        return {"program": [], "carried": []}
    named = exp.alias_(exp.cast(template.column(source.program), "VARCHAR"), "program_name")
    return {"program": [named], "carried": [exp.alias_(exp.column("program_name"), "program")]}


def _reading(source: AnySource, reading: exp.Expr, validity: bool) -> exp.Expr:
    """Return a reading; missing, or 0 where validity is wanted, where it is not valid."""
    if source.valid_when is None:
        return template.node_of(1) if validity else reading
    slots: dict[str, template.Slot] = {"valid": parsed_condition(source.valid_when, "valid_when")}
    if validity:
        return template.fill("source/validity_term", slots)
    return template.fill("source/valid_term", {**slots, "reading": reading})


def stacked(branches: Sequence[exp.Query]) -> exp.Query:
    """Return the rows of all branches, which become part of it."""
    return branches[0] if len(branches) == 1 else exp.union(*branches, distinct=False, copy=False)


def named_by(column: str | None, otherwise: str) -> exp.Expr:
    """Return the column that holds a name; the name itself where there is none."""
    return template.text(otherwise) if column is None else template.column(column)


def _unpivoted(
    source: AnySource, relation: exp.Expr, shared: Mapping[str, template.Slot], validity: bool
) -> exp.Query:
    """Return the readings of a wide source in one select."""
    columns, named = [], []
    for number, value in enumerate(source.value_columns, 1):
        column = f"column_{number}"
        columns.append(
            exp.alias_(exp.cast(_reading(source, template.column(value), validity), "DOUBLE"), column)
        )
        named.append(exp.PivotAlias(this=exp.column(column), alias=template.name(value)))
    filled = template.fill("source/unpivoted", {**shared, "columns": columns, "named": named})
    read_from(relation, filled)
    return filled  # type: ignore[return-value]


def read_from(relation: exp.Expr, filled: exp.Expr) -> None:
    """Let a tree read the relation where it names ``source``; in place."""
    for table in list(filled.find_all(exp.Table)):
        if table.name == "source" and not table.db:
            alias = table.args.get("alias")
            table.replace(relation.copy() if alias is None else relation.as_(alias))


def parsed_condition(where: str | exp.Expr | None, called: str = "where") -> exp.Expr:
    """Return the user's condition, which a message names so, as a tree; TRUE where there is none.

    Raises:
        SourceError: it is not one condition in DuckDB's dialect.
    """
    if where is None:
        return exp.EQ(this=exp.Literal.number(1), expression=exp.Literal.number(1))
    if isinstance(where, exp.Expr):
        return where
    refusal = wrong("where_is_no_condition", called=called, where=where)
    if not isinstance(where, str):
        raise refusal
    try:
        parsed = sqlglot.parse_one(where, dialect="duckdb", into=exp.Condition)
    except SqlglotError as error:
        raise refusal from error
    if isinstance(parsed, exp.Star) or parsed.find(exp.Placeholder, exp.Parameter):
        raise refusal
    return exp.Paren(this=parsed)


def under(source: AnySource, *conditions: exp.Expr) -> AnySource:
    """Return a source under conditions on its own columns, beside the user's."""
    return replace(source, where=exp.and_(parsed_condition(source.where), *conditions))


def is_file(relation: object) -> bool:
    """Tell whether a relation is the path of a file, of a folder (which ends in a slash), or some."""
    if isinstance(relation, Path):
        return True
    if isinstance(relation, (list, tuple)):
        return bool(relation) and all(map(is_file, relation))
    return isinstance(relation, str) and relation.lower().endswith((*FILE_ENDINGS, "/"))


def is_spreadsheet(relation: object) -> bool:
    """Tell whether a relation is the path of a spreadsheet."""
    return isinstance(relation, (str, Path)) and str(relation).lower().endswith(_SPREADSHEETS)


def as_folder(path: Any) -> Any:
    """Return the path of a folder with a slash at the end; anything else unchanged."""
    is_folder = isinstance(path, (str, Path)) and path != "" and Path(path).is_dir()
    return f"{str(path).rstrip('/')}/" if is_folder else path


def slashed(path: str | Path, original: str) -> str:
    """Return a changed path, with the slash of a folder at the end if the original had one."""
    return f"{path}/" if original.endswith("/") else str(path)


def paths_of(relation: Any) -> list[str]:
    """Return the paths that a relation names."""
    return [str(path) for path in (relation if isinstance(relation, (list, tuple)) else [relation])]


def shown_relation(relation: Any) -> str:
    """Return a relation as a page or a message shows it: the first of a list, and how many more."""
    is_list = isinstance(relation, list) or is_file(relation)
    first, *more = paths_of(relation) if is_list else [relation]
    return f"{first} and {len(more)} more" if more else str(first)


def table_names(relation: str | Sequence[str]) -> list[exp.Expr]:
    """Return what a table name can mean, the likeliest first.

    A name with dots is first taken as the parts of a path, then as one name that holds dots; its parts
    may be quoted.

    Raises:
        SourceError: it is empty or has too many parts.
    """
    if not isinstance(relation, str):
        return [_table(tuple(relation))]
    if not relation.strip():
        raise SourceError("relation is empty; name a table, a file or an Arrow table.")
    whole = _table((relation,))
    if "." not in relation:
        return [whole]
    try:
        parsed = exp.to_table(relation, dialect="duckdb")
        parts = tuple(part.name for part in parsed.parts)
    except SqlglotError:
        return [whole]
    return [_table(parts), whole] if len(parts) <= 3 and all(parts) else [whole]


def _table(parts: tuple[str, ...]) -> exp.Expr:
    if not 1 <= len(parts) <= 3 or not all(isinstance(part, str) and part for part in parts):
        raise SourceError(f"relation is {parts!r}; a table has one to three parts.")
    names = [template.name(part) for part in reversed(parts)]
    return exp.Table(**dict(zip(("this", "db", "catalog"), names, strict=False)))


def _check_names(source: Form, optional: Sequence[str], needed: Sequence[str]) -> None:
    check(source, SourceError)
    for role in (*optional, *needed):
        column = getattr(source, role)
        if column is None and role in optional:
            continue
        if not isinstance(column, str) or not column:
            raise SourceError(f"{role} is {column!r}; it takes the name of a column.")
