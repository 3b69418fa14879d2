"""Figures for a notebook, by Plotly: the indicator of a signal, and the fleet over time.

Their figures are those of the views of a monitor, of what ``gam run`` wrote, or of what
:func:`gam_db.health_indicator` returns; nothing is computed here but which stretch of time a bucket
falls into. The page of ``gam report`` needs none of this.
"""

import html
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.arguments import public
from gam_db.engines.connecting import connect
from gam_db.engines.frames import arrow_table
from gam_db.errors import ConfigurationError, nearest, wrong
from gam_db.extras import needed
from gam_db.stored.monitor import Monitor

#: Stretches of time of the fleet.
STRETCHES = 240

_ENDING = ".parquet"

_NAMED = 4
"""Signals that an error names."""


@public
def signal(
    results: Monitor | pa.Table | str | Path,
    asset: str | None = None,
    channel: str | None = None,
    support: pa.Table | None = None,
) -> Any:
    """Return a figure of the indicator of one signal with its limit, where it has one.

    Args:
        results: a monitor; what :func:`gam_db.health_indicator` or :func:`gam_db.health_at_buckets`
            returns; or what ``gam run`` wrote: the Parquet file of the indicator, with
            NAME.support.parquet beside it, or the DuckDB file.
        asset: the machine; None if all signals are of one.
        channel: its signal; None if there is one only.
        support: what :func:`gam_db.support` returns, which has the limits, where results are a table.

    Raises:
        UserError: there is no such signal or file, several could be meant, or Plotly is not installed.
    """
    figures = needed("plotly.graph_objects", "plot")
    rows, limits = _read(results, support)
    asset, channel = _meant(asset, channel, list(limits))
    mine = rows.filter(pa.array((_texts(rows, "asset") == asset) & (_texts(rows, "channel") == channel)))
    limit = limits[asset, channel]
    drawn = figures.Figure(
        figures.Scatter(x=mine["time"].to_pylist(), y=mine["hi"].to_pylist(), name="indicator")
    )
    if limit is not None:
        drawn.add_hline(y=limit, line_dash="dash", annotation_text="limit")
    title = {"text": html.escape(f"{asset} · {channel}", quote=False)}
    return drawn.update_layout(title=title, yaxis={"range": [0, 1], "title": {"text": "hi"}})


@public
def fleet(results: Monitor | pa.Table | str | Path, support: pa.Table | None = None) -> Any:
    """Return a figure of the machines over time: how many signals were above at once.

    Args:
        results: as in :func:`signal`. Signals without a limit count nowhere.
        support: likewise; needed where results are a table.

    Raises:
        UserError: there is no such file, nothing in it is judged, or Plotly is not installed.
    """
    figures = needed("plotly.graph_objects", "plot")
    rows, limits = _read(results, support)
    if support is None and not isinstance(results, (Monitor, str, Path)):
        raise wrong("no_limits_to_plot")
    asset, channel = _texts(rows, "asset"), _texts(rows, "channel")
    limit = np.array([limits[name] for name in zip(asset, channel, strict=True)], dtype=float)
    hi = rows["hi"].to_numpy(zero_copy_only=False).astype(float)
    judged = ~np.isnan(limit + hi)
    if not judged.any():
        raise ConfigurationError("No signal can be judged yet: none has a limit and a full window.")
    time = rows["time"].cast(pa.int64()).to_numpy()
    first, last = int(time[judged].min()), int(time[judged].max())
    wide = max(1, -(-(last - first + 1) // STRETCHES))
    machines = sorted(set(asset[judged]))
    place = {name: number for number, name in enumerate(machines)}
    many = (last - first) // wide + 1
    above: list[list[set[str] | None]] = [[None] * many for _ in machines]
    for at in np.flatnonzero(judged):
        row, column = above[place[asset[at]]], (int(time[at]) - first) // wide
        seen = row[column] = row[column] or set()
        if hi[at] > limit[at]:
            seen.add(channel[at])
    begins = pa.array(first + wide * np.arange(many)).cast(rows["time"].type)
    counts = [[None if seen is None else len(seen) for seen in row] for row in above]
    shown = [html.escape(name, quote=False) for name in machines]  # Plotly takes a little markup
    drawn = figures.Figure(figures.Heatmap(x=begins.to_pylist(), y=shown, z=counts, zmin=0))
    return drawn.update_layout(
        title={"text": "Signals above their limit"}, yaxis={"autorange": "reversed", "type": "category"}
    )


def _texts(rows: pa.Table, column: str) -> NDArray[Any]:
    return np.array(rows[column].to_pylist(), dtype=object)


def _meant(
    asset: str | None, channel: str | None, signals: Sequence[tuple[str, str]]
) -> tuple[str, str]:
    """Return the signal that is meant, of those that there are."""
    fitting = [name for name in signals if asset in (None, name[0]) and channel in (None, name[1])]
    if len(fitting) == 1:
        return fitting[0]
    shown = [" / ".join(name) for name in signals]
    if fitting:
        raise wrong("several_signals_to_plot", count=len(fitting), names=", ".join(shown[:_NAMED]))
    signal = " / ".join("*" if part is None else part for part in (asset, channel))
    raise ConfigurationError(f"There is no signal {signal!r}{nearest(signal, shown, _NAMED)}")


def _read(
    results: Monitor | pa.Table | str | Path, support: pa.Table | None
) -> tuple[pa.Table, dict[tuple[str, str], float | None]]:
    """Return what is drawn: rows of the indicator, and the limit of each signal."""
    limit_rows: pa.Table
    if not isinstance(results, (Monitor, str, Path)):
        if not hasattr(results, "__arrow_c_stream__"):
            raise wrong("nothing_to_plot", kind=type(results).__name__)
        rows, limit_rows = _of_table(arrow_table(results)), support
    elif support is not None:
        raise wrong("limits_to_plot_twice")
    elif isinstance(results, Monitor):
        rows, limit_rows = results.health(), results.status()
        time = rows["last_tick"] if rows["last_time"].null_count == rows.num_rows else rows["last_time"]
        rows = rows.select(["asset", "channel", "hi"]).append_column("time", time)
    else:
        rows, limit_rows = _of_file(Path(results))
    if limit_rows is None:
        names = rows.group_by(["asset", "channel"], use_threads=False).aggregate([])
        return rows, {(row["asset"], row["channel"]): None for row in names.to_pylist()}
    limits = {(row["asset"], row["channel"]): row["hi_limit"] for row in limit_rows.to_pylist()}
    return rows, limits


def _of_table(health: pa.Table) -> pa.Table:
    """Return what is drawn of the health indicator, of each vector or of each bucket."""
    columns = ["asset", "channel", "time" if "time" in health.column_names else "last_time", "hi"]
    for name in columns:
        if name not in health.column_names:
            raise wrong("no_health_to_plot", column=name)
    return health.select(columns).rename_columns(["asset", "channel", "time", "hi"])


def _of_file(path: Path) -> tuple[pa.Table, pa.Table]:
    """Return the indicator and the support that ``gam run`` wrote."""
    wanted = ("asset", "channel", "time", "hi"), ("asset", "channel", "hi_limit")
    if path.suffix in (".duckdb", ".db"):
        tables = ("gam_health_indicator", "gam_support_summary")
        with connect(path, writable=False) as session:
            health, support = (
                session.fetch(exp.select(*columns).from_(name))
                for name, columns in zip(tables, wanted, strict=True)
            )
        return health, support
    beside = path.with_name(
        f"{path.name.removesuffix(_ENDING).removesuffix('.health')}.support{_ENDING}"
    )
    for file in (path, beside):
        if path.suffix != _ENDING or not file.is_file():
            raise wrong("no_result_to_plot", one=file, ending=_ENDING)
    return (pq.read_table(path, columns=list(wanted[0])), pq.read_table(beside, columns=list(wanted[1])))
