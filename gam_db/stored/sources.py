"""The source of a monitor, as its row keeps it: a later run needs no word of it.

This module owns how a source becomes columns of ``gam_state_monitor`` and comes back.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlencode

from sqlglot import exp

from gam_db.composing import template
from gam_db.errors import ConfigurationError, StateError
from gam_db.settings.form import Form
from gam_db.settings.local_time import local_time
from gam_db.settings.setting import settings_of
from gam_db.settings.source import AnySource, Source, WideSource, is_file, paths_of

#: The columns of ``gam_state_monitor`` that tell of the source.
SOURCE_COLUMNS = (
    *("source", "layout", "asset_column", "channel_column"),
    *("time_column", "value_column", "condition"),
)

_OBJECT = "an Arrow table"

#: Of several files the first is the source, and the others stand in its fragment under this name.
_MORE = "and"


def described(source: AnySource) -> dict[str, str | None]:
    """Return the stored description of a source: the values of :data:`SOURCE_COLUMNS`."""
    condition = source.where.sql("duckdb") if isinstance(source.where, exp.Expr) else source.where
    return {
        "source": _shown(source.relation) + _written(source),
        "layout": "long" if isinstance(source, Source) else "wide",
        "asset_column": source.asset,
        "channel_column": getattr(source, "channel", None),
        "time_column": source.time,
        "value_column": getattr(source, "value", None),
        "condition": condition,
    }


def source_of(monitor: Mapping[str, Any], channels: Sequence[str], relation: Any = None) -> AnySource:
    """Return the source that a monitor was made from, or one like it with another ``relation``.

    The names of its channels are the columns of a wide source: all numeric ones if it has none.

    Raises:
        ConfigurationError: it was made from an Arrow table, and no relation is given.
        StateError: its row holds something that gam-db does not write.
    """
    original, written = _parted(monitor["source"])
    relation = original if relation is None else relation
    if isinstance(relation, str) and relation == _OBJECT:
        raise ConfigurationError(
            f"The monitor {monitor['name']!r} was made from an Arrow table, which is not stored; "
            "name its "
            "source."
        )
    arguments = {
        "asset": monitor["asset_column"],
        "time": monitor["time_column"],
        "where": monitor["condition"],
        **written,
    }
    if monitor["layout"] not in ("long", "wide"):
        raise StateError(
            f"The row of the monitor {monitor['name']!r} was changed by hand: its layout is "
            f"{monitor['layout']!r}, neither long nor wide. Restore it from a copy of the database."
        )
    if monitor["layout"] == "wide":
        return WideSource(relation, channels=sorted(set(channels)) or None, **arguments)
    return Source(
        relation, channel=monitor["channel_column"], value=monitor["value_column"], **arguments
    )


def relation_of(monitor: Mapping[str, Any]) -> str | list[str]:
    """Return the relation that a monitor was made from, as its row keeps it."""
    return _parted(monitor["source"])[0]


def repeat_of(source: str) -> int:
    """Return how far apart the instants of a local time may be, by the source of a monitor."""
    zone = _parted(source)[1].get("source_time_zone")
    return 0 if zone is None else local_time(zone).longest_repeat


def _written(source: AnySource) -> str:
    """Return further files, and how numbers and times are written, as the fragment of an address."""
    more = paths_of(source.relation)[1:] if is_file(source.relation) else []
    fields = {**({_MORE: more} if more else {}), **source.written}
    return f"#{urlencode(fields, doseq=True)}" if fields else ""


def _parted(address: str) -> tuple[str | list[str], dict[str, Any]]:
    """Return a relation and how things are written there, as it was kept."""
    first, mark, fragment = address.rpartition("#")
    fields, settings = parse_qs(fragment), settings_of(Form)
    if not mark or not fields or not fields.keys() <= {_MORE, *settings}:
        return address, {}
    more = fields.pop(_MORE, [])
    relation = [first, *more] if more else first
    many = {"null": tuple(fields["null"])} if "null" in fields else {}
    skipped = {"skip_rows": int(fields["skip_rows"][0])} if "skip_rows" in fields else {}
    return relation, {name: values[0] for name, values in fields.items()} | many | skipped


def _shown(relation: Any) -> str:
    if isinstance(relation, (str, Path)):
        return str(relation)
    if is_file(relation):
        return paths_of(relation)[0]
    if isinstance(relation, (tuple, list)):
        parts = [template.name(part).sql("duckdb") for part in relation]
        return ".".join(parts)
    return _OBJECT
