"""Texts of a column that cannot be read as numbers or times, and the errors that name them.

This module owns the search for values from which a conversion would drop a part. It also proposes
options that read them.
"""

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import formula
from gam_db.engines.session import Row, Session
from gam_db.errors import SourceError, UserError, wrong
from gam_db.settings.form import (
    LOOKED_AT,
    formats_for_times,
    options_for_null,
    options_for_numbers,
    shortened,
)
from gam_db.settings.source import AnySource, is_file, parsed_condition, read_from

#: Most columns for which a message proposes an option each; with more, the options would not help.
MOST_PROPOSED = 6


@dataclass(frozen=True)
class Misfits:
    """The words of a column of text that cannot be read."""

    session: Session
    relation: exp.Expr  # the relation that holds the column
    condition: exp.Expr  # the rows that count
    words: exp.Expr  # the column, without words that mean a missing value
    meant: exp.Expr  # the words as numbers or times; NULL where they cannot be read

    def first(self) -> list[Row]:
        """Return the first misfits, see ``sql/source/misfits.sql``; a counting pass runs first."""
        ((count,),) = (row.values() for row in self.session.rows(self._filled("source/misfit_count")))
        return self.session.rows(self._filled("source/misfits", most=LOOKED_AT)) if count else []

    def _filled(self, name: str, **more: template.Slot) -> exp.Expr:
        slots = {"words": self.words, "meant": self.meant, "condition": self.condition}
        query = template.fill(name, {**slots, **more})
        read_from(self.relation, query)
        return query


def but_nulls(column: exp.Expr, nulls: Sequence[str] | None) -> exp.Expr:
    """Return a column of text without the words that mean a missing value."""
    if not nulls:
        return column
    missing = exp.In(this=column.copy(), expressions=[template.text(word) for word in nulls])
    return exp.Case(ifs=[exp.If(this=exp.Not(this=missing), true=column)])


def suspects(
    session: Session, source: AnySource, columns: Mapping[str, str], stored: exp.Expr
) -> list[Callable[[], None]]:
    """Return a check per column that finds values that are not whole, once a statement met one."""
    engine, types = session.engine, session.engine.types
    if not engine.whole:
        return []
    kinds = {}
    for name in source.value_columns:
        kinds[name] = "truth" if types.is_truth(columns[name]) else "number"
    kind = types.time_kind(columns[source.time])
    is_count = types.is_whole(columns[source.time])
    kinds[source.time] = (
        ("count" if is_count else "number") if kind is None or kind.is_counter else "time"
    )
    return [
        partial(_look_at_words, session, source, name, columns[name], what, stored)
        for name, what in kinds.items()
    ]


def _look_at_words(
    session: Session, source: AnySource, name: str, type_name: str, what: str, stored: exp.Expr
) -> None:
    """Refuse a column if it holds values that are not whole."""
    column, engine = template.column(name), session.engine
    rules = [formula(engine.whole[what], word=column)]
    if what == "time" and "word" in engine.whole:
        rules.append(formula(engine.whole["word"], word=column))
    meant = exp.Case(ifs=[exp.If(this=exp.and_(*rules), true=exp.Literal.number(1))])
    words = but_nulls(column, source.null if what == "number" else None)
    misfits = Misfits(session, stored, parsed_condition(source.where), words, meant).first()
    if not misfits:
        return
    first = misfits[0]
    nulls = [row["word"] for row in misfits if not any(map(str.isdigit, row["word"]))][:MOST_PROPOSED]
    options = " ".join(map(options_for_null, nulls)) if what == "number" else ""
    hint = (
        (f"{options} would take them for missing values; correct the others")
        if options
        else "correct them"
    )
    wanted = {"count": "integers", "truth": "0 or 1", "time": "times in ISO 8601"}.get(what, "numbers")
    raise wrong(
        "words_among_numbers",
        count=first["of_all"],
        texts=first["texts"],
        name=name,
        wanted=wanted,
        type_name=type_name,
        word=shortened(first["word"]),
        of_word=first["of_word"],
        hint=hint,
    )


def ways_of(source: AnySource, misfits: list[Row], misread: Callable[[str], Misfits]) -> list[str]:
    """Return the formats by which all words of a column are times; none if the source has a format."""
    if source.time_format is not None:
        return []
    return [
        way for way in formats_for_times([row["word"] for row in misfits]) if not misread(way).first()
    ]


def check_numbers(source: AnySource, name: str, type_name: str, misfits: list[Row]) -> None:
    """Refuse a column of text without settings that make it numbers, or with words that do not fit."""
    if source.reads_words and not misfits:
        return
    role = "value" if name == getattr(source, "value", None) else "channel"
    sentence = f"The {role} column {name!r} is of type {type_name}; readings must be numbers: "
    if not misfits:
        raise wrong("texts_are_numbers", said=sentence)
    check_header(source, name, misfits)
    words = [row["word"] for row in misfits]
    if misfits[0]["of_all"] == misfits[0]["texts"] and not any(map(str.isdigit, "".join(words))):
        shown = ", ".join(map(shortened, words[:5])) + ", ..." * (len(words) > 5)
        raise wrong("texts_are_words", said=sentence, shown=shown)
    proposed = options_for_numbers(words)
    raise SourceError(
        f"{sentence}{first_of(misfits)}; {proposed} would read them, or cast it in a view."
    )


def no_times(source: AnySource, misfits: list[Row], ways: Sequence[str]) -> UserError:
    """Return the error on words that are not times in ISO 8601, or in the format of the source."""
    check_header(source, source.time, misfits)
    wanted = f"a time like {source.time_format!r}" if source.time_format else "a time in ISO 8601"
    proposed = " or ".join(f"--time-format {way!r}" for way in ways[:4])
    hint = f"{proposed} would read them" if ways else "give --time-format, or --null for a missing time"
    if len(ways) > 1:
        hint += ": choose one"
    sentence = f"{first_of(misfits)}; {hint}"
    return wrong("texts_are_no_times", time=source.time, wanted=wanted, said=sentence)


def check_header(source: AnySource, name: str, misfits: list[Row]) -> None:
    """Refuse a text file in which lines below the first repeat the header."""
    repeated = next((row["of_word"] for row in misfits if row["word"] == name), 0)
    if repeated and is_file(source.relation):
        columns = [source.time, *source.value_columns]
        condition = f"{template.column(source.time).sql('duckdb')} IS NOT NULL"
        options = " ".join([*map(options_for_null, columns), "--where", shlex.quote(condition)])
        otherwise = f", or give {options}" if len(columns) <= MOST_PROPOSED else ""
        raise wrong("header_repeated", count=repeated, name=name, otherwise=otherwise)


def first_of(misfits: list[Row]) -> str:
    """Return the first word that does not fit, and how often it occurs."""
    first = misfits[0]
    same = f", {first['of_word']:,} times" if first["of_word"] > 1 else ""
    return (
        f"{first['of_all']:,} of {first['texts']:,} values do not fit, the first is "
        f"{shortened(first['word'])}{same}"
    )
