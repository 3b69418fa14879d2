"""Checks of a source before it is read: missing columns, columns of a wrong type, unusable rows.

This module decides which sources are refused (method, section 2), and words the errors for users.
"""

import dataclasses
from collections.abc import Callable, Mapping
from typing import Any

import pyarrow as pa

from gam_db.clock import FAR_AHEAD, TimeKind
from gam_db.engines.base import Engine
from gam_db.engines.session import Session
from gam_db.errors import SourceError, nearest, wrong
from gam_db.reading.undated import Undated, shown_column, without
from gam_db.settings.source import AnySource, Source, WideSource, check_zone, declared_kind

NO_ROW = "The source has no row (after where, if there is one)."

#: Columns that an error names.
_NAMED = 6


def resolved(source: AnySource, columns: dict[str, str], session: Session) -> AnySource:
    """Return the source with its channels named; check its columns against those of the relation.

    Raises:
        SourceError: a column is missing or of the wrong type.
    """
    if isinstance(source, WideSource) and source.channels is None:
        types, others = session.engine.types, (source.asset, source.time, source.program)
        for holds in (types.is_numeric, types.is_truth):
            if channels := tuple(
                name for name, of in columns.items() if name not in others and holds(of)
            ):
                break
        else:
            raise SourceError("The wide table has no numeric column beside asset and time.")
        source = dataclasses.replace(source, channels=channels)
    for role, column in source.columns.items():
        if column not in columns:
            sentence = f"The relation has no column {column!r} for {role}"
            sentence += f" ({role}=None if there is only one)" if role in ("asset", "channel") else ""
            if isinstance(source, Source) and source.columns == Source("").columns:
                sentence += (
                    "; name the columns, or pass the relation itself, so that gam-db guesses its columns"
                )
            raise SourceError(f"{sentence}{nearest(column, columns, _NAMED)}")
        _check_type(role, column, columns[column], session, source.time_unit)
    return source


def kind_of(source: AnySource, columns: dict[str, str], session: Session) -> TimeKind:
    """Return how the source tells time, from the type of its time column.

    Raises:
        SourceError: the column is not a time as it is stored, or not the kind that the user declared.
    """
    if (kind := session.engine.types.time_kind(columns[source.time])) is None:
        raise wrong("tells_no_time", column=source.time, type_name=columns[source.time], hint="")
    check_zone(source, kind)
    declared = declared_kind(source)
    if declared is not None and declared.is_counter != kind.is_counter:
        type_name = columns[source.time]
        raise wrong("time_kind_differs", value=declared.value, time=source.time, said=type_name)
    return kind


def check_rows(names: pa.Table, source: AnySource, ask: Callable[[], Undated], engine: Engine) -> None:
    """Refuse a source with rows that lack an asset, a channel or a time.

    Args:
        names: the step of that name.
        source: the source.
        ask: returns the rows without a usable time.
        engine: that reads it.

    Raises:
        SourceError: rows without asset, channel or time (the counts are given), a counter beyond
            2^62, or no row at all.
    """
    rows: list[dict[str, Any]] = names.to_pylist()
    if not rows:
        raise SourceError(NO_ROW)
    nameless = {
        role: sum(row["readings"] + row["without_time"] for row in rows if row[role] is None)
        for role in ("asset", "channel")
    }
    nameless["time"] = sum(row["without_time"] for row in rows)
    if any(nameless.values()):
        undated = ask() if nameless["time"] else None
        counts, where, advice = nowhere(source, nameless, undated, engine)
        raise wrong("nameless_rows", names=counts, where=where, advice=advice)
    check_clock(names)


def nowhere(
    source: AnySource, nameless: Mapping[str, int], undated: Undated | None, engine: Engine
) -> tuple[str, str, str]:
    """Return counts of rows that lack a name or time, the condition that leaves them out, and advice.

    Args:
        source: the source.
        nameless: how many rows lack an asset, a channel.
        undated: the rows without a usable time; None for none.
        engine: that reads it.
    """
    counts, conditions, advice = [], [], ""
    for role in ("asset", "channel"):
        if nameless[role]:
            counts.append(f"{nameless[role]:,} without {role}")
            conditions.append(f"{shown_column(source.columns[role])} IS NOT NULL")
    if undated is not None and undated.count:
        counts.append(f"{undated.count:,} without time ({undated.causes(source)})")
        conditions.append(undated.condition(source, engine))
        advice = undated.advice(source)
    return ", ".join(counts), without(source, *conditions), advice


def check_clock(names: pa.Table) -> None:
    """Refuse (SourceError) a counter beyond 2^62; ``names`` is the step of that name."""
    edges = [row[edge] for row in names.to_pylist() for edge in ("earliest", "latest")]
    if any(edge is not None and abs(edge) >= FAR_AHEAD for edge in edges):
        raise wrong("beyond_the_clock")


def _check_type(role: str, column: str, type_name: str, session: Session, time_unit: str | None) -> None:
    types = session.engine.types
    is_read = session.engine.texts is not None and types.is_text(type_name)
    if role == "time":
        counts = types.is_numeric(type_name)
        if time_unit is not None and not counts:
            raise wrong("unit_of_no_number", column=column, type_name=type_name)
        if types.time_kind(type_name) is None and not is_read and not (counts and time_unit):
            hint = "Give --time-unit (s, ms, us, ns) if it counts from 1970. " * counts
            raise wrong("tells_no_time", column=column, type_name=type_name, hint=hint)
    elif role in ("asset", "channel", "program"):
        if not types.is_name(type_name):
            raise wrong("no_name", role=role, column=column, type_name=type_name)
    elif not (types.is_numeric(type_name) or types.is_truth(type_name) or is_read):
        role = "value" if role == "value" else "channel"
        raise wrong("no_number", role=role, column=column, type_name=type_name)
