"""Preparing a source: columns that hold something else than numbers and times are read as such.

This module owns what becomes of a column by its type and by what was said of how it is written (method,
section 2), and what is said of words that do not fit. All forms of the method read through it.
"""

import contextlib
import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

from sqlglot import exp

from gam_db.clock import SINCE_1970, TimeKind
from gam_db.composing import template
from gam_db.engines.session import Row, Session
from gam_db.errors import SourceError, wrong
from gam_db.reading import look
from gam_db.settings.form import LOOKED_AT, formats_for_times, options_for_numbers, shortened
from gam_db.settings.source import AnySource, parsed_condition, read_from


@dataclass(frozen=True)
class Prepared:
    """A source that can be read."""

    source: AnySource  # as it was given, with its channels named
    columns: dict[str, str]  # name -> type of the columns as they are stored
    stored: exp.Expr  # the node that reads them
    rows: AnySource  # how the relation below is read; conditions that it holds already are left out
    relation: exp.Expr  # the node that reads columns of numbers and times
    kind: TimeKind  # how time is told there


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
    made = _made(session, source, columns, stored)
    if (condition := source.valid_when) is not None:
        valid = parsed_condition(condition, "valid_when")
        session.check_condition(made.relation, valid, condition, "valid_when")
    if source.source_time_zone is not None:
        _check_local(session, source, made.columns, made.stored)
    return made


def _made(session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr) -> Prepared:
    """Return a source of which it is known that its columns are there."""
    if retyped := _retyped(session, source, columns):
        stored = session.engine.retyped(stored, retyped)
        columns = session.describe(stored)
    changes = _changes(session, source, columns, stored)
    if not changes:
        kind = look.kind_of(source, columns, session)
        return Prepared(source, columns, stored, source, stored, kind)
    inner = exp.select("*").from_(stored.copy()).where(parsed_condition(source.where))
    every = [
        exp.alias_(changes.get(name, template.column(name)), template.name(name)) for name in columns
    ]
    relation = exp.select(*every).from_(inner.subquery("written")).subquery("prepared")
    rows = dataclasses.replace(source, where=None)
    # Not every engine tells what a query gives: PostgreSQL tells it of tables alone, SQLite the type
    # of the column in it.
    described = columns
    if source.time in changes:
        is_made = source.time_unit is not None
        described = {source.time: "TIMESTAMP"} if is_made else session.describe(relation)
    kind = look.kind_of(rows, described, session)
    return Prepared(source, columns, stored, rows, relation, kind)


def _retyped(session: Session, source: AnySource, columns: dict[str, str]) -> dict[str, str]:
    """Return the columns of a text file whose types its beginning does not tell, and these."""
    types = session.engine.types
    wanted = "VARCHAR" if source.thousands else "DOUBLE"
    return {
        name: wanted
        for name in source.value_columns
        if types.is_whole(columns[name]) or (source.thousands and types.is_numeric(columns[name]))
    }


def _changes(
    session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr
) -> dict[str, exp.Expr]:
    """Return what is read in the place of columns."""
    types, texts = session.engine.types, session.engine.texts
    changes: dict[str, exp.Expr] = {}
    for name in source.value_columns:
        column = template.column(name)
        if types.is_truth(columns[name]):
            changes[name] = template.fill("source/truth_term", {"flag": column})
        elif texts is not None and types.is_text(columns[name]):
            words = _but_nulls(column, source.null)
            changes[name] = texts.number(words, source)
            found = _misfits(session, source, words, changes[name], stored)
            _check_numbers(source, name, columns[name], found)
        elif source.null and types.is_numeric(columns[name]):
            numbers = []
            for word in source.null:
                with contextlib.suppress(ValueError):
                    numbers.append(template.node_of(float(word)))
            if numbers:
                missing = exp.In(this=exp.cast(column.copy(), "DOUBLE"), expressions=numbers)
                changes[name] = exp.Case(ifs=[exp.If(this=missing, true=exp.null())], default=column)
    time = columns[source.time]
    if texts is not None and types.is_text(time):
        words = _but_nulls(template.column(source.time), source.null)
        meant = changes[source.time] = texts.instant(words, source.time_format)
        _check_times(source, time, _misfits(session, source, words, meant, stored))
    elif source.time_unit and types.is_numeric(time):
        changes[source.time] = _since_1970(session, source, time)
    elif texts is not None and not source.time_format and not types.is_numeric(time):
        _check_order(session, source, stored)
    return changes


def _check_local(session: Session, source: AnySource, columns: dict[str, str], stored: exp.Expr) -> None:
    """Refuse a time zone of a source in whose texts times have one."""
    engine = session.engine
    of_texts = engine.texts is None or engine.types.is_text(columns[source.time])
    if engine.zoned is None or not of_texts:
        return
    condition = exp.and_(parsed_condition(source.where), engine.zoned(template.column(source.time)))
    found = exp.select(exp.Literal.number(1).as_("one")).from_(stored.copy()).where(condition).limit(1)
    if session.rows(found):
        raise wrong("zone_of_no_local_time", time=source.time, kind="times with a zone")


def _but_nulls(column: exp.Expr, nulls: Sequence[str] | None) -> exp.Expr:
    """Return a column of text without the words that mean a missing value."""
    if not nulls:
        return column
    missing = exp.In(this=column.copy(), expressions=[template.text(word) for word in nulls])
    return exp.Case(ifs=[exp.If(this=exp.Not(this=missing), true=column)])


def _since_1970(session: Session, source: AnySource, type_name: str) -> exp.Expr:
    """Return numbers since 1970 as timestamps; a binary fraction counts as the nearest microsecond."""
    types, column = session.engine.types, template.column(source.time)
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


def _misfits(
    session: Session, source: AnySource, words: exp.Expr, meant: exp.Expr, stored: exp.Expr
) -> list[Row]:
    """Return the first words of a column that have no meaning; see ``sql/source/misfits.sql``."""
    condition = parsed_condition(source.where)
    slots: dict[str, template.Slot] = {"words": words, "meant": meant, "condition": condition}
    query = template.fill("source/misfits", slots | {"most": LOOKED_AT})
    read_from(stored, query)
    return session.rows(query)


def _check_numbers(source: AnySource, name: str, type_name: str, found: list[Row]) -> None:
    """Refuse a column of text that was not said to hold numbers, or holds other words, too."""
    if source.reads_words and not found:
        return
    role = "value" if name == getattr(source, "value", None) else "channel"
    said = f"The {role} column {name!r} is of type {type_name}; readings must be numbers. "
    if not found:
        raise wrong("texts_are_numbers", said=said)
    words = [row["word"] for row in found]
    if found[0]["of_all"] == found[0]["texts"] and not any(map(str.isdigit, "".join(words))):
        shown = ", ".join(map(shortened, words[:5])) + ", ..." * (len(words) > 5)
        raise wrong("texts_are_words", said=said, shown=shown)
    proposed = options_for_numbers(words)
    raise SourceError(f"{said}{_first(found)}; {proposed} would read them. Cast it in a view otherwise.")


def _check_times(source: AnySource, type_name: str, found: list[Row]) -> None:
    """Refuse words that are no times in ISO 8601, or as was said."""
    if not found:
        return
    wanted = f"a time like {source.time_format!r}" if source.time_format else "a time in ISO 8601"
    formats = formats_for_times([row["word"] for row in found])
    proposed = " or ".join(f"--time-format {way!r}" for way in formats[:2])
    hint = f"{proposed} would read them" if formats else "say --time-format, or --null for what is none"
    if len(formats) > 1:
        hint += ": say which is meant"
    time, said = source.time, f"{_first(found)}; {hint}"
    raise wrong("texts_are_no_times", time=time, type_name=type_name, wanted=wanted, said=said)


def _check_order(session: Session, source: AnySource, stored: exp.Expr) -> None:
    """Refuse dates of a text file that can be read day before month, or the other way round."""
    texts, asked = session.engine.texts, session.engine.seen_formats(stored)
    if texts is None or asked is None:
        return
    for way in filter(None, session.rows(asked)[0].values()):
        other = way.translate(str.maketrans("dm", "md"))
        if way.startswith("%Y") or "%d" not in way or "%m" not in way:
            continue
        words = template.column(source.time)
        as_text = session.engine.retyped(stored, {source.time: "VARCHAR"})
        if not _misfits(session, source, words, texts.instant(words, other), as_text):
            raise wrong("order_of_day_and_month", time=source.time, way=way, other=other)


def _first(found: list[Row]) -> str:
    """Return the first word that did not fit, and how many there are like it."""
    first = found[0]
    same = f", {first['of_word']:,} times" if first["of_word"] > 1 else ""
    return (
        f"{first['of_all']:,} of {first['texts']:,} words do not fit, the first is "
        f"{shortened(first['word'])}{same}"
    )
