"""The class of engines: a page of data and a few small rewrites.

This module owns how a tree becomes the text of one engine. Only this package tests which engine it is.
Making SQL needs no driver and no connection.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cache, partial
from typing import Any

from sqlglot import exp
from sqlglot.dialects.dialect import Dialect
from sqlglot.errors import ErrorLevel, UnsupportedError

from gam_db import data
from gam_db.clock import FAR_AHEAD, LONG_AGO, TimeKind
from gam_db.composing import template
from gam_db.engines.rewrites import at_home, drop_flow_hint, newest_as_largest, strip_null_order
from gam_db.engines.storage import APART, Storage
from gam_db.engines.types import USUAL, Types
from gam_db.errors import EngineError
from gam_db.method.bits import Bits
from gam_db.settings.form import Form
from gam_db.settings.local_rows import ranged_readings, undated
from gam_db.settings.source import AnySource, clock_of

Rewrite = Callable[[exp.Expr], exp.Expr]
#: A formula for each kind of time: that of TIMESTAMP for all that have none of their own.
Formulas = str | Mapping[TimeKind, str]
RangeRewrite = Callable[[exp.Expr, int | None, int | None], list[exp.Expr]]

_ENGINES = data.table("gam_db.engines", "engines.toml")

#: Begins what a statement says that met a value which is not whole.
REFUSES = "gam-db: "

#: A day, in microseconds.
DAY = 86_400_000_000

#: Texts of late by engine, its home and the hash of the tree, and how many there are at most.
_TEXTS: dict[tuple[str, str | None, int], str] = {}
_MOST_TEXTS = 3000


def temporary(table: exp.Expr, query: exp.Query | None = None, *storage: exp.Expr) -> exp.Create:
    """Return a temporary table: of the rows of a query, or empty with the columns of a schema."""
    return table_as(table.copy(), query, exp.TemporaryProperty(), *(node.copy() for node in storage))


def with_columns(table: exp.Table, types: Mapping[str, exp.DataType]) -> exp.Schema:
    """Return a table with the columns that it is to have, their types by name."""
    columns = [exp.ColumnDef(this=template.name(name), kind=of) for name, of in types.items()]
    return exp.Schema(this=table.copy(), expressions=columns)


@dataclass(frozen=True)
class Texts:
    """How an engine reads text: the nodes are NULL where a word does not fit."""

    number: Callable[[exp.Expr, Form], exp.Expr]  # the number of a word that is written in a form
    #: The timestamp of a word in a format, None for ISO 8601.
    instant: Callable[[exp.Expr, str | None], exp.Expr]
    count: Callable[[exp.Expr], exp.Expr]  # the integer of a word


def table_as(table: exp.Expr, query: exp.Query | None, *storage: exp.Expr) -> exp.Create:
    """Return CREATE TABLE ... AS, with its storage."""
    properties = exp.Properties(expressions=list(storage)) if storage else None
    return exp.Create(this=table, kind="TABLE", expression=query, properties=properties)


@cache
def _formula(text: str) -> template.Template:
    parsed = template.parse(text, text)
    whole = exp.Paren(this=parsed.tree)
    for call in reversed(list(whole.find_all(exp.Dot))):
        call.replace(call.expression)
    for word in list(whole.find_all(exp.Column)):
        word.replace(exp.var(word.name))
    return replace(parsed, tree=whole.this.pop())


def formula(text: str, /, **slots: template.Slot) -> exp.Expr:
    """Return an expression with its slots filled.

    Args:
        text: in DuckDB's dialect. What is an engine's own is left as it is: functions that are called
            ``own.F(x)``, and words that stand alone or in double quotes.
        slots: as for :func:`gam_db.composing.template.fill`.
    """
    return template.fill_template(_formula(text), slots)


@dataclass(frozen=True)
class Engine:
    """One engine, as data."""

    name: str  # what users call it
    title: str  # what it calls itself
    dialect: str  # sqlglot's name of its SQL
    #: The integer time of a column (``:time``) of a kind of calendar time, see :func:`formula`.
    micros: Formulas = field(hash=False)
    instant: Formulas = field(hash=False)  # the way back (of ``:micros``), for the last step of a query
    now: str  # the clock of the database, in microseconds since 1970 (UTC), likewise
    #: The same as what a column of a kind is compared with, where it takes no other instant.
    compared: Mapping[TimeKind, str] = field(default_factory=dict, hash=False)
    #: The integer time of a column that counts; engines refuse the product of a timestamp.
    counted: str = "CAST(:time * 1 AS BIGINT)"
    #: Whether a column of times tells none.
    timeless: str = ":time IS NULL"
    #: How a column (``{column}``) is compared with a timestamp in a user's condition, and the condition
    #: that it tells an instant.
    comparable: str = "{column}"
    dated: str = "{column} BETWEEN TIMESTAMP '1900-01-01 00:00:00' AND TIMESTAMP '2200-01-01 00:00:00'"
    #: What a script begins with that stops it where the time column has a type that it was not made for.
    guard: Callable[[exp.Table, str, TimeKind], exp.Expr] | None = None
    #: Whether a text tells a time with its zone; None where no column of text tells time.
    zoned: Rewrite | None = None
    #: Conditions on a column of times, where its own order is not that of the instants.
    range_of: RangeRewrite | None = None
    types: Types = USUAL  # what those of its columns mean
    #: What must hold of a value (``:word``) that is read as a number, truth, count or time, where an
    #: engine drops what it cannot read; *word* checks a time at length.
    whole: Mapping[str, str] = field(default_factory=dict, hash=False)
    #: What is read (``:read``), and an error if the column (``:word``) is a text.
    of_no_text: str = ""
    refusing: str = ""  # an expression that fails; its error message contains ``REFUSES``
    #: The same with a sentence (``:text``), and a number of ``:rows``, so that it is no constant; empty
    #: where a script cannot end by itself.
    failing: str = ""
    #: What its command line is told by a script that must end with an error.
    client: Sequence[str] = field(default=(), hash=False)
    begins: str = "BEGIN"  # begins a transaction
    #: What a session is set to while a script computes, and what is undone of it before it publishes.
    working: Sequence[exp.Expr] = field(default=(), hash=False)
    resting: Sequence[exp.Expr] = field(default=(), hash=False)
    analyzes: bool = False  # whether its planner has to be told what is in a table that was made
    #: The day of an instant (``:micros``) as text, where a time is a text and its days are compared.
    day: str = ""
    #: How numbers and times are read from text; None where that is left to views.
    texts: Texts | None = None
    #: Lets columns of a text file be read as other types (name -> type).
    retyped: Callable[[exp.Expr, Mapping[str, str]], exp.Expr] = lambda relation, _: relation
    heeds: frozenset[str] = frozenset()  # of how things are written, what it heeds without reading texts
    rewrites: Sequence[Rewrite] = ()  # from tree to tree, each with its reason in its docstring
    #: CREATE TABLE ... AS with what the engine wants to know of storage.
    create_table: Callable[[exp.Table, exp.Query], exp.Create] = table_as
    #: How tables and views of the state are kept, with keys, formats and comments.
    storage: Storage = APART
    schemas: bool = True  # whether CREATE SCHEMA is known
    #: The schema of tables that name none, which is then written out; None leaves it to the engine. In a
    #: session it is the current schema of the connection.
    home: str | None = None
    temporary: str | None = None  # the schema that temporary tables are written with; None for none
    opening: Sequence[exp.Expr] = ()  # what a script begins with
    #: How a script replaces the one before, in one transaction: ``replace`` (CREATE OR REPLACE),
    #: ``rename`` (built beside it, then renamed) or ``drop``; empty where nothing undoes it.
    swaps: str = ""
    ordering: Sequence[Rewrite] = ()  # for names that are put in an order: equal ones are equal bytes
    drops_several: bool = False  # whether DROP takes several names
    #: What its printed queries may leave out, of :data:`gam_db.composing.brief.FORMS`.
    brief: Sequence[str] = field(default=(), hash=False)
    condition_note: str = ""  # a note on conditions of users that the engine refuses
    flow_hint: bool = False  # whether a WITH entry can be marked NOT MATERIALIZED
    newest_of: int = 0  # among fewer rows LAST_VALUE(... IGNORE NULLS) gives the newest of a kind
    reads_files: bool = False  # whether a Parquet or CSV path can stand in FROM
    unpivots: bool = False  # whether UNPIVOT INCLUDE NULLS is known
    #: Defines a function (its name, a view) of one signal of the view.
    of_signal: Callable[[exp.Table, exp.Table], exp.Create] | None = None
    oldest: str | None = None  # the oldest version that is accepted; None where gam-db does not connect
    extra: str | None = None  # of this package, that installs its driver; None for none
    transactions: bool = True  # whether statements can be undone together
    undoes_definitions: bool = True  # whether that holds of tables and views that were made, too
    commits_definitions: bool = False  # whether a transaction ends where a temporary table is made
    limits: str = ""  # its limitations, for users
    #: For one whose tables give their rows in the order in which they were stored, and whose windows
    #: without an order follow it (:mod:`gam_db.study.streaming`); None for all others.
    bits: Bits | None = None
    #: The body of the delay vectors that costs least (:mod:`gam_db.method.delays`); None for windows.
    delays: str | None = None
    holds_delays: bool = False  # whether that body has all of a source in memory at once
    delays_by_column: bool = False  # whether LAG takes a delay that differs by row
    reads_first: bool = False  # whether it joins columns by hash, but no expressions: each with each
    by_sets: bool = False  # whether a row is looked up in a set (IN) at less cost than it is joined
    #: Asks how many rows a set may have for that (one row, *most*); None for any number.
    most_in_set: exp.Query | None = None

    @classmethod
    def named(cls, name: str, **code: Any) -> "Engine":
        """Return an engine from its data in ``engines.toml`` and the parts that need code."""
        fields = dict(_ENGINES[name])
        for key in {"micros", "instant", "compared"} & fields.keys():
            if isinstance(of := fields[key], dict):
                fields[key] = {TimeKind(kind): text for kind, text in of.items()}
        return cls(name=name, **{**fields, **code})

    def is_too_old(self, version: str) -> bool:
        """Tell whether a version is older than the oldest that is accepted."""
        oldest = [int(part) for part in (self.oldest or "0").split(".")]
        return [int(part) for part in version.split(".")[: len(oldest)]] < oldest

    def check_version(self, version: str) -> None:
        """Refuse, by an EngineError, a version that is too old."""
        if self.is_too_old(version):
            raise EngineError(f"{self.title} {version} is too old; gam-db needs {self.oldest} or later.")

    def micros_of(self, kind: TimeKind, column: exp.Expr) -> exp.Expr:
        """Return the integer time of a column with a kind of time."""
        read = formula(self.counted if kind.is_counter else _of_kind(self.micros, kind), time=column)
        return self.insisting("count" if kind.is_counter else "time", column, read, "BIGINT")

    def tells_none(self, kind: TimeKind, column: exp.Expr) -> exp.Expr:
        """Return the condition that a column has no usable time: NULL, or a value outside any range."""
        nothing: exp.Expr = exp.Is(this=column.copy(), expression=exp.null())
        rule = self.whole.get("count" if kind.is_counter else "time")
        if rule is None or "word" not in self.whole:
            return nothing
        return exp.or_(nothing, exp.Not(this=exp.paren(formula(rule, word=column))))

    def number_of(self, column: exp.Expr) -> exp.Expr:
        """Return a column of readings as numbers, without dropping a part of a value."""
        return self.insisting("number", column, column, "DOUBLE")

    def insisting(self, what: str, column: exp.Expr, read: exp.Expr, of: str) -> exp.Expr:
        """Return the value of a column; the statement fails if it cannot be read as a whole.

        Cause: SQLite and MariaDB read as much of a text as they can, ClickHouse gives NULL. Symptom: the
        word Bad is a reading of 0, or missing.
        """
        if self.of_no_text:
            return formula(self.of_no_text, word=column, read=read)
        if what not in self.whole:
            return read
        is_there = exp.Not(this=exp.Is(this=column.copy(), expression=exp.null()))
        refused = exp.cast(formula(self.refusing, word=column), of)
        cases = ((formula(self.whole[what], word=column), read), (is_there, refused))
        return exp.Case(ifs=[exp.If(this=when, true=then.copy()) for when, then in cases])

    def failure(self, sentence: str, rows: exp.Expr) -> exp.Expr:
        """Return an expression that ends a script with a sentence and a number of rows, a column."""
        slots = {"text": template.text(sentence), "rows": rows}
        used = _formula(self.failing).slots
        return formula(self.failing, **{name: slots[name] for name in used})

    def clock(self) -> exp.Expr:
        """Return the expression of this instant by the database's clock, in microseconds since 1970."""
        return formula(self.now)

    def instant_of(self, kind: TimeKind, time: exp.Expr) -> exp.Expr:
        """Return an integer time as a source with a kind of time has it."""
        return time if kind.is_counter else formula(_of_kind(self.instant, kind), micros=time)

    def readings(
        self,
        source: AnySource,
        relation: exp.Expr,
        kind: TimeKind,
        earliest: int = LONG_AGO,
        latest: int = FAR_AHEAD,
        validity: bool = False,
        until: exp.Expr | int | None = None,
    ) -> exp.Query:
        """Return the step *readings* of a source with a kind of time, for a range of instants.

        Rows later than ``until``, an integer time, are left out; rows without a time stay.
        """
        within = partial(self.in_range, kind, template.column(source.time))
        nodes = partial(self.micros_of, kind), self.number_of, within
        edges = earliest, latest
        return ranged_readings(source, relation, *nodes, self.unpivots, *edges, validity, until)

    def near(self, source: AnySource, kind: TimeKind, earliest: int, latest: int) -> list[exp.Expr]:
        """Return conditions on the time column that hold for all rows of a range, perhaps for others."""
        clock = clock_of(source)
        ends = (earliest, latest) if clock is None else (clock.earliest(earliest), clock.latest(latest))
        return self.in_range(kind, template.column(source.time), *ends)

    def undated(self, source: AnySource, relation: exp.Expr, kind: TimeKind) -> exp.Query:
        """Return the query that counts the rows of a source without a usable time, by cause."""
        return undated(source, relation, partial(self.micros_of, kind))

    def in_range(
        self, kind: TimeKind, column: exp.Expr, earliest: int | None, latest: int | None
    ) -> list[exp.Expr]:
        """Return the conditions that a time lies in a range, both ends included.

        None is no limit, nor is what lies beyond all that the column can tell. They are on the column
        itself: an index or the statistics of a file serve.
        """
        furthest = kind.furthest
        first = None if earliest is None or earliest <= -furthest else min(earliest, furthest)
        last = None if latest is None or latest >= furthest else max(latest, -furthest)
        if self.range_of is not None and not kind.is_counter:
            return self.range_of(column, first, last)
        conditions: list[exp.Expr] = []
        if first is not None:
            conditions.append(exp.GTE(this=column.copy(), expression=self._bound(kind, first)))
        if last is not None:
            # The next one is excluded, so that nanoseconds after the last microsecond are not.
            conditions.append(exp.LT(this=column.copy(), expression=self._bound(kind, last + 1)))
        return conditions

    def _bound(self, kind: TimeKind, time: int | exp.Expr) -> exp.Expr:
        """Return an integer time as a column of a kind can be compared with it."""
        if kind in self.compared:
            return formula(self.compared[kind], micros=time)
        return self.instant_of(kind, template.node_of(time))

    def beside(self, kind: TimeKind, column: exp.Expr, time: exp.Expr, is_after: bool) -> list[exp.Expr]:
        """Return the conditions that a time is not before, or is before, one that a query gives.

        They are on the column itself, as those of a range; NULL holds for no row.
        """
        compared = exp.GTE if is_after else exp.LT
        if not self.day or kind.is_counter:
            return [compared(this=column.copy(), expression=self._bound(kind, time))]
        # A day further, since an offset may be another day.
        further = time.copy() - DAY if is_after else time.copy() + 2 * DAY
        day = formula(self.day, micros=exp.paren(further))
        micros = self.micros_of(kind, column)
        return [
            compared(this=column.copy(), expression=day),
            compared(this=micros, expression=time.copy()),
        ]

    def text(self, tree: exp.Expr, pretty: bool = False) -> str:
        """Return a tree as SQL of this engine.

        What was written lately is not written again: a run puts the same queries to work for each group
        of channels, and writing one takes longer than running it over few rows.

        Raises:
            EngineError: the engine has no form for part of it.
        """
        if pretty:  # for people, who get the comments, too; equal trees may differ in them
            return self._written(tree, pretty)
        # Trees are equal where their hashes are, by sqlglot's own rule; to hold the trees takes memory.
        key = self.name, self.home, hash(tree)
        if (text := _TEXTS.get(key)) is None:
            if len(_TEXTS) >= _MOST_TEXTS:
                _TEXTS.clear()
            text = _TEXTS[key] = self._written(tree, pretty)
        return text

    def unordered(self) -> "Engine":
        """Return the engine for queries that compare names, and put them in no order."""
        return replace(self, rewrites=[edit for edit in self.rewrites if edit not in self.ordering])

    def beginning(self) -> str:
        """Return the text that a script begins with; may be empty."""
        return "".join(f"{self.text(statement)};\n" for statement in self.opening)

    def _written(self, tree: exp.Expr, pretty: bool) -> str:
        dialect = _dialect(self.dialect)
        rewritten = strip_null_order(tree.copy(), dialect)
        if not self.flow_hint:
            rewritten = drop_flow_hint(rewritten)
        rewritten = newest_as_largest(rewritten, self.newest_of)
        if self.home is not None:
            rewritten = at_home(rewritten, self.home)
        for rewrite in self.rewrites:
            rewritten = rewrite(rewritten)
        try:
            return rewritten.sql(
                dialect=dialect, pretty=pretty, unsupported_level=ErrorLevel.RAISE, copy=False
            )
        except UnsupportedError as error:
            raise EngineError(f"{self.name} has no form for part of this query: {error}") from error


def _of_kind(formulas: Formulas, kind: TimeKind) -> str:
    by_kind = {TimeKind.TIMESTAMP: formulas} if isinstance(formulas, str) else formulas
    return by_kind.get(kind, by_kind[TimeKind.TIMESTAMP])


#: A dialect of sqlglot, made once: a run writes hundreds of texts.
_dialect = cache(Dialect.get_or_raise)


def deletion(table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> exp.Delete:
    """Return the statement that deletes the rows of a table whose keys are among the rows of a query."""
    key = exp.Tuple(expressions=[exp.column(exp.to_identifier(name)) for name in keys])
    among = exp.In(this=key, query=exp.Subquery(this=key_rows))
    return exp.Delete(this=table.copy(), where=exp.Where(this=among))


def settings(values: Mapping[str, str | int], kind: str | None = None) -> list[exp.Expr]:
    """Return the SET statements of a session; a kind precedes the name."""
    statements: list[exp.Expr] = []
    for name, value in values.items():
        node = template.text(value) if isinstance(value, str) else template.node_of(value)
        set_to = exp.EQ(this=exp.var(name), expression=node)
        statements.append(exp.Set(expressions=[exp.SetItem(this=set_to, kind=kind)]))
    return statements


def called(function: str, *arguments: exp.Expr) -> exp.Expr:
    """Return a call of an engine's own function, left as it is."""
    return exp.Anonymous(this=function, expressions=list(arguments))
