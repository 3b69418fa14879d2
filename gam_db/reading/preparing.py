"""Preparing a source: columns of other types are read as numbers and times.

This module owns what becomes of a column by its type and by what was said of how it is written (method,
section 2), and the errors on words that do not fit. All forms of the method read through it.
"""

import contextlib
import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from sqlglot import exp

from gam_db.clock import SINCE_1970, TimeKind
from gam_db.composing import template
from gam_db.engines.session import Session
from gam_db.errors import wrong
from gam_db.reading import look
from gam_db.reading.words import (
    Misfits,
    but_nulls,
    check_header,
    check_numbers,
    first_of,
    no_times,
    suspects,
    ways_of,
)
from gam_db.settings.source import AnySource, Programs, parsed_condition


@dataclass(frozen=True)
class Prepared:
    """A source that can be read."""

    source: AnySource  # as it was given, with its channels named
    columns: dict[str, str]  # name -> type of the columns as they are stored
    stored: exp.Expr  # the node that reads them
    rows: AnySource  # how the relation below is read; conditions that it holds already are left out
    relation: exp.Expr  # the node that reads columns of numbers and times
    kind: TimeKind  # how time is told there
    programs: Programs | None = None  # the column that says which program a machine runs


def prepared(session: Session, source: AnySource) -> Prepared:
    """Return a source as the method reads it.

    Raises:
        SourceError: a column is missing or of the wrong type, or a word in it does not fit; the message
            names the first such word, how many like it, and the options that would read it.
    """
    stored = session.relation(source.relation, source)
    columns = session.describe(stored)
    if source.where is not None:
        session.check_condition(stored, parsed_condition(source.where), str(source.where))
    source = look.resolved(source, columns, session)
    ready = _prepared(session, source, columns, stored)
    if (condition := source.valid_when) is not None:
        valid = parsed_condition(condition, "valid_when")
        session.check_condition(ready.relation, valid, condition, "valid_when")
    if source.source_time_zone is not None:
        _check_local(session, source, ready.columns, ready.stored)
    if (column := source.program) is None:
        return ready
    programs = Programs(column, session.engine.types.is_whole(ready.columns[column]))
    return dataclasses.replace(ready, programs=programs)


def _prepared(
    session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr
) -> Prepared:
    """Return a source of which it is known that its columns are there."""
    columns, stored = as_written(session, source, columns, stored)
    session.suspects += suspects(session, source, columns, stored)
    changes = _changes(session, source, columns, stored)
    if not changes:
        kind = look.kind_of(source, columns, session)
        return Prepared(source, columns, stored, source, stored, kind)
    inner = exp.select("*").from_(stored.copy()).where(parsed_condition(source.where))
    relation = _with(changes, columns).from_(inner.subquery("written")).subquery("prepared")
    rows = dataclasses.replace(source, where=None)
    # Not every engine tells what a query gives: PostgreSQL tells it of tables alone, SQLite the type
    # of the column in it.
    described = columns
    if source.time in changes:
        is_computed = source.time_unit is not None
        described = {source.time: "TIMESTAMP"} if is_computed else session.describe(relation)
    kind = look.kind_of(rows, described, session)
    return Prepared(source, columns, stored, rows, relation, kind)


def as_written(
    session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr
) -> tuple[dict[str, str], exp.Expr]:
    """Return the columns and the node of a text file with the types of its texts; of others unchanged.

    Raises:
        SourceError: a word of the time column is no time, or no count.
    """
    retyped = session.engine.retyped(stored, _retyped(session, source, columns))
    if retyped is stored:
        return columns, stored
    columns = session.describe(retyped)
    return columns, with_times_read(session, source, columns, retyped)


def _with(changes: Mapping[str, exp.Expr], columns: Iterable[str], *more: exp.Expr) -> exp.Select:
    """Return what selects columns, some of them changed, and more."""
    every = [
        exp.alias_(changes.get(name, template.column(name)), template.name(name)) for name in columns
    ]
    return exp.select(*every, *more)


def _retyped(session: Session, source: AnySource, columns: dict[str, str]) -> dict[str, str]:
    """Return the columns of a text file whose types its beginning does not tell, and these.

    A name is read as it is written: 007 is not 7.
    """
    types = session.engine.types
    wanted = "VARCHAR" if source.thousands else "DOUBLE"
    values = {
        name: wanted
        for name in source.value_columns
        if types.is_whole(columns[name]) or (source.thousands and types.is_numeric(columns[name]))
    }
    names = (source.asset, getattr(source, "channel", None), source.program)
    return values | {name: "VARCHAR" for name in names if name is not None and name not in values}


def with_times_read(
    session: Session, source: AnySource, columns: Mapping[str, str], stored: exp.Expr
) -> exp.Expr:
    """Return the node of a text file with its times read from the words that stand there.

    Cause: a reader of text files guesses formats by the first lines, and cuts off what it cannot use of
    the words below. Symptom: 03.03.26 is a day of 2003, and an offset or PM far down is dropped.
    """
    engine, time = session.engine, source.time
    kind, of_words = engine.types.time_kind(columns[time]), engine.retyped(stored, {time: "VARCHAR"})
    if engine.texts is None or of_words is stored or kind is None:
        return stored
    words = template.column(time)

    def read(meant: exp.Expr, *more: exp.Expr) -> exp.Expr:
        return _with({time: meant}, columns, *more).from_(of_words.copy()).subquery("timed")

    def misread(meant: exp.Expr) -> Misfits:
        # The condition is on times, and a word that is none does not make it false.
        condition = parsed_condition(source.where)
        holds = exp.or_(condition, exp.Is(this=exp.paren(condition.copy()), expression=exp.null()))
        word = template.name("gam_word")
        relation = read(meant, exp.alias_(words.copy(), word))
        return Misfits(session, relation, holds, exp.column(word), words)

    if kind.is_counter:
        meant = engine.texts.count(words)
        if misfits := misread(meant).first():
            check_header(source, time, misfits)
            raise wrong("texts_are_no_counts", time=time, said=first_of(misfits))
        return read(meant)
    meant = engine.texts.instant(words, source.time_format)
    if misfits := misread(meant).first():
        ways = ways_of(source, misfits, lambda way: misread(engine.texts.instant(words, way)))  # type: ignore[union-attr]
        if len(ways) != 1 or "%Y" not in ways[0]:
            raise no_times(source, misfits, ways)
        meant = engine.texts.instant(words, ways[0])
    if kind is TimeKind.TIMESTAMP_WITH_ZONE or "%z" in (source.time_format or ""):
        meant = engine.instant_of(kind, engine.micros_of(TimeKind.TIMESTAMP_WITH_ZONE, meant))
    return read(meant)


def _changes(
    session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr
) -> dict[str, exp.Expr]:
    """Return the expressions to read instead of columns."""
    types, texts = session.engine.types, session.engine.texts
    changes: dict[str, exp.Expr] = {}
    misread = partial(Misfits, session, stored, parsed_condition(source.where))
    for name in source.value_columns:
        column: exp.Expr = template.column(name)
        if types.is_truth(columns[name]):
            flag = session.engine.insisting("truth", column, column, "BIGINT")
            changes[name] = template.fill("source/truth_term", {"flag": flag})
        elif texts is not None and types.is_text(columns[name]):
            words = but_nulls(column, source.null)
            number = changes[name] = texts.number(words, source)
            check_numbers(source, name, columns[name], misread(words, number).first())
        elif source.null and types.is_numeric(columns[name]):
            changes |= _but_numbers(session, column, name, source.null)
    time = columns[source.time]
    if texts is not None and types.is_text(time):
        words, of_format = but_nulls(template.column(source.time), source.null), texts.instant
        meant = changes[source.time] = of_format(words, source.time_format)
        if misfits := misread(words, meant).first():
            raise no_times(
                source,
                misfits,
                ways_of(source, misfits, lambda way: misread(words, of_format(words, way))),
            )
    elif source.time_unit and types.is_numeric(time):
        changes[source.time] = _since_1970(session, source, time)
    return changes


def _check_local(session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr) -> None:
    """Refuse a time zone of a source in whose texts times have one."""
    engine = session.engine
    of_texts = engine.texts is None or engine.types.is_text(columns[source.time])
    if engine.zoned is None or not of_texts:
        return
    condition = exp.and_(parsed_condition(source.where), engine.zoned(template.column(source.time)))
    query = exp.select(exp.Literal.number(1).as_("one")).from_(stored.copy()).where(condition).limit(1)
    if session.rows(query):
        raise wrong("zone_of_no_local_time", time=source.time, kind="times with a zone")


def _but_numbers(
    session: Session, column: exp.Expr, name: str, nulls: Sequence[str]
) -> dict[str, exp.Expr]:
    """Return a column of numbers without those that mean a missing value, by its name.

    Where texts may stand among the numbers, those that mean one are left out first.
    """
    numbers = []
    for word in nulls:
        with contextlib.suppress(ValueError):
            numbers.append(template.node_of(float(word)))
    may_be_text = "number" in session.engine.whole
    ifs = [exp.In(this=column.copy(), expressions=[*map(template.text, nulls)])] * may_be_text
    if numbers:
        read = exp.cast(session.engine.number_of(column), "DOUBLE")
        ifs.append(exp.In(this=read, expressions=numbers))
    if not ifs:
        return {}
    return {
        name: exp.Case(
            ifs=[exp.If(this=condition, true=exp.null()) for condition in ifs], default=column
        )
    }


def _since_1970(session: Session, source: AnySource, type_name: str) -> exp.Expr:
    """Return numbers since 1970 as timestamps; a binary fraction counts as the nearest microsecond."""
    types = session.engine.types
    column: exp.Expr = template.column(source.time)
    what = "count" if types.is_whole(type_name) else "number"
    column = session.engine.insisting(what, column, column, "DOUBLE" if what == "number" else "BIGINT")
    _, of_second = SINCE_1970[source.time_unit or "us"]
    factor, parts = max(10**6 // of_second, 1), max(of_second // 10**6, 1)
    farthest = 4 * 10**18 // factor
    micros: exp.Expr
    if types.is_binary_float(type_name):
        micros = template.fill(
            "source/binary_term",
            {"ticks": column, "farthest": farthest, "micros": factor, "parts": parts},
        )
    else:
        whole: exp.Expr = column
        if not types.is_whole(type_name):
            whole = template.fill(
                "source/decimal_term", {"ticks": column, "farthest": farthest, "smaller": factor}
            )
            factor = 1
        if parts > 1:
            micros = template.fill("source/nanoseconds_term", {"ticks": whole})
        else:
            micros = template.fill("source/units_term", {"ticks": whole, "micros": factor})
    return session.engine.instant_of(TimeKind.TIMESTAMP, micros)
