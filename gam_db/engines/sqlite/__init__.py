"""SQLite: the engine of the standard library; times are ISO 8601 texts or integers.

A text without an offset is in UTC.
"""

import datetime as dt
from collections.abc import Callable

from sqlglot import exp

from gam_db.clock import SECOND, TimeKind
from gam_db.composing import template
from gam_db.engines.base import Engine, formula
from gam_db.engines.storage import Storage
from gam_db.engines.types import Types

_DAY = 86_400 * SECOND

#: From here on there is no day after the next that could be written: 9999-12-31 is the last.
_LAST_DAYS = 253_402_214_400 * SECOND - _DAY

#: 0001-01-02, before which no day is written.
_FIRST_DAYS = -62_135_510_400 * SECOND


def range_of(column: exp.Expr, earliest: int | None, latest: int | None) -> list[exp.Expr]:
    """Return the conditions that a text tells an instant in a range.

    Cause: texts are compared sign by sign. Symptom: ``12:00:00`` is less than ``12:00:00.000000``, and
    ``T12:00:00`` greater than both, so that a row at the edge of a range is left out. The day alone is
    compared as a text, for an index, and a day further, since an offset may be another day; the instant
    decides.
    """
    conditions: list[exp.Expr] = []
    micros = ENGINE.micros_of(TimeKind.TIMESTAMP, column)
    if earliest is not None:
        if _FIRST_DAYS <= earliest < _LAST_DAYS:
            conditions.append(exp.GTE(this=column.copy(), expression=_day(earliest - _DAY)))
        conditions.append(exp.GTE(this=micros.copy(), expression=template.node_of(earliest)))
    if latest is not None:
        if _FIRST_DAYS <= latest < _LAST_DAYS:
            conditions.append(exp.LT(this=column.copy(), expression=_day(latest + 2 * _DAY)))
        conditions.append(exp.LTE(this=micros.copy(), expression=template.node_of(latest)))
    return conditions


def _day(micros: int) -> exp.Expr:
    epoch = dt.datetime(1970, 1, 1)
    return template.text((epoch + dt.timedelta(microseconds=micros)).date().isoformat())


def is_zoned(words: exp.Expr) -> exp.Expr:
    """Return whether texts tell times with their zones: a sign of one stands behind the day."""
    return formula("own.SUBSTR(:words, 12) GLOB '*[Zz+-]*'", words=words)


def glob_for_like(tree: exp.Expr) -> exp.Expr:
    """Write patterns with GLOB.

    Cause: LIKE folds the case of ASCII letters. Symptom: an override for ``A*`` also applies to
    ``a1`` (the agreement tests fail without this).
    """
    for escape in list(tree.find_all(exp.Escape)):
        like = escape.this
        signs = iter(like.expression.this)
        pattern = "".join(
            _literal(next(signs)) if sign == "!" else {"%": "*", "_": "?"}.get(sign, _literal(sign))
            for sign in signs
        )
        escape.replace(exp.Glob(this=like.this, expression=template.text(pattern)))
    return tree


def _literal(sign: str) -> str:
    return f"[{sign}]" if sign in "*?[" else sign


def _with_part(parts: str) -> Callable[[Types, str], bool]:
    """Return the method that tells whether a type has one of some parts in it."""
    return lambda _, type_name: any(part in type_name for part in parts.split())


class Affinities(Types):
    """SQLite takes any word for a type; what it holds follows from parts of the word."""

    def time_kind(self, type_name: str) -> TimeKind | None:
        """Return how a column of this type tells time: an integer counts, a text is a timestamp."""
        if "INT" in type_name:
            return TimeKind.COUNTER
        is_date = any(word in type_name for word in ("TIME", "DATE"))
        return TimeKind.TIMESTAMP if is_date or self.is_text(type_name) else None

    is_numeric = _with_part("INT REAL FLOA DOUB NUM DEC")
    is_name = _with_part("INT CHAR TEXT CLOB")  # of an asset or a channel
    is_text = _with_part("CHAR TEXT CLOB")


ENGINE = Engine.named(
    "sqlite",
    delays_by_column=True,
    types=Affinities("sqlite"),
    heeds=frozenset({"null"}),
    range_of=range_of,
    zoned=is_zoned,
    storage=Storage("none", index=True, replaces_views=False),
    rewrites=(glob_for_like,),
)
