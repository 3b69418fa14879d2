"""Rows without a usable time: how many there are, why, and the condition that leaves them out.

This module owns the query that counts them, and its words.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from sqlglot import exp

from gam_db.clock import SECOND, TimeKind, shown_instant
from gam_db.composing import template
from gam_db.engines.base import Engine, formula
from gam_db.engines.session import Session
from gam_db.settings.source import AnySource, clock_of, parsed_condition, under

#: A name that may need no quotes in a condition: engines fold others, in one case or the other.
_PLAIN = re.compile(r"[a-z_][a-z0-9_]*")
#: Words that an engine refuses as a name, or takes for something else.
_RESERVED = {
    *("all", "any", "asc", "case", "check", "column", "default", "desc", "end", "from"),
    *("group", "key", "limit", "offset", "order", "primary", "range", "rank", "row", "rows"),
    *("select", "system", "table", "to", "user", "using", "when", "where", "window"),
}
_HOUR = 3600 * SECOND


@dataclass(frozen=True)
class Undated:
    """Rows of a source without a usable time; also rows whose local time means two instants.

    Attributes:
        absent: their time is NULL.
        endless: it is set but is not an instant: infinite, or 0000-00-00.
        skipped: it is a local time that no clock of its zone shows, as clocks go forward.
        first_skipped, last_skipped: the first and the last such time, as integer time; None for none.
        twice: rows whose local time comes twice, as clocks go back; they are read.
    """

    absent: int
    endless: int
    skipped: int
    first_skipped: int | None
    last_skipped: int | None
    twice: int

    @property
    def count(self) -> int:
        """How many rows have no usable time."""
        return self.absent + self.endless + self.skipped

    def causes(self, source: AnySource) -> str:
        """Return the reasons, in words."""
        causes = []
        if self.absent:
            causes.append(f"{self.absent:,} NULL")
        if self.endless:
            causes.append(f"{self.endless:,} an infinite time or a date that does not exist")
        if self.skipped:
            zone, (first, last) = source.source_time_zone, self._edges()
            causes.append(
                f"{self.skipped:,} a local time that does not exist in {zone}, as clocks go forward: "
                f"{first} to {last}"
            )
        return ", ".join(causes)

    def advice(self, source: AnySource) -> str:
        """Return the advice to set a zone whose clocks do not skip these times."""
        clock = clock_of(source)
        if not self.skipped or clock is None:
            return ""
        before = clock.pieces(latest=self.last_skipped or 0)
        shift = next((piece.shift for piece in reversed(before) if piece.shift is not None), 0)
        name = "UTC" if shift == 0 else f"Etc/GMT{-shift // _HOUR:+d}"
        if shift % _HOUR:
            return " A clock without daylight saving shows them: then give such a zone."
        return f" A clock without daylight saving shows them: then give --source-time-zone {name}."

    def condition(self, source: AnySource, engine: Engine) -> str:
        """Return the condition that leaves these rows out, as ``where`` takes it on an engine."""
        time = shown_column(source.time)
        compared = engine.comparable.format(column=time)
        conditions = [f"{time} IS NOT NULL"] if self.absent and not self.endless else []
        conditions += [engine.dated.format(column=time)] if self.endless else []
        for first, last in self._gaps(source):
            edges = f">= TIMESTAMP '{_shown(first)}'", f"< TIMESTAMP '{_shown(last + 1)}'"
            conditions.append(f"NOT ({compared} {edges[0]} AND {compared} {edges[1]})")
        return " AND ".join(conditions)

    def _gaps(self, source: AnySource) -> Iterator[tuple[int, int]]:
        clock = clock_of(source)
        if clock is None or self.first_skipped is None or self.last_skipped is None:
            return
        for first, last in clock.skipped():
            if first <= self.last_skipped and last >= self.first_skipped:
                yield first, last

    def _edges(self) -> tuple[str, str]:
        return _shown(self.first_skipped or 0), _shown(self.last_skipped or 0)


def undated(
    session: Session, source: AnySource, relation: exp.Expr, kind: TimeKind, among_all: bool = True
) -> Undated:
    """Return how many rows of a source have no usable time, and why.

    Args:
        session: an open session.
        source: the source.
        relation: the node that reads it.
        kind: how it tells time.
        among_all: count the local times that come twice, too, for which all rows are looked at.
    """
    (row,) = session.rows(counting(session.engine, source, relation, kind, among_all))
    return Undated(**row)


def counting(
    engine: Engine, source: AnySource, relation: exp.Expr, kind: TimeKind, among_all: bool
) -> exp.Query:
    """Return the query of :func:`undated`."""
    if not among_all:
        time = template.column(source.time)
        suspect = [engine.tells_none(kind, time)]
        if not kind.is_counter:
            suspect.append(formula(engine.timeless, time=time))
        clock = clock_of(source)
        for edges in () if clock is None else clock.skipped():
            suspect.append(exp.and_(*engine.in_range(kind, time, *edges), copy=False))
        source = under(source, exp.paren(exp.or_(*suspect, copy=False), copy=False))
    return engine.undated(source, relation, kind)


def without(source: AnySource, *conditions: str) -> str:
    """Return the user's condition and further ones, as ``where`` takes them."""
    existing = [] if source.where is None else [parsed_condition(source.where).sql("duckdb")]
    return " AND ".join([*existing, *conditions])


def shown_column(name: str) -> str:
    """Return the name of a column as a condition can hold it, in quotes where it needs them."""
    is_plain = _PLAIN.fullmatch(name) is not None and name not in _RESERVED
    return name if is_plain else exp.to_identifier(name, quoted=True).sql("duckdb")


def _shown(micros: int) -> str:
    """Return a local time to the second."""
    return shown_instant(micros, TimeKind.TIMESTAMP).replace("T", " ").partition(".")[0]
