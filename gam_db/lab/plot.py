"""Figures for a notebook, by Plotly: the indicator of a signal, and the fleet over time.

Their figures are those of the views of a monitor, or of what ``gam run`` wrote; nothing is computed here
but which stretch of time a bucket falls into. The page of ``gam report`` needs none of this.
"""

import html
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.engines.connecting import connect
from gam_db.errors import ConfigurationError, nearest, wrong
from gam_db.extras import needed
from gam_db.stored.monitor import Monitor

#: Stretches of time of the fleet.
STRETCHES = 240

_ENDING = ".parquet"


def signal(results: Monitor | str | Path, asset: str, channel: str) -> Any:
    """Return a figure of the indicator of one signal with its limit, where it has one.

    Args:
        results: a monitor, or what ``gam run`` wrote: the Parquet file of the indicator, with
            NAME.support.parquet beside it, or the DuckDB file.
        asset: the machine.
        channel: its signal.

    Raises:
        UserError: there is no such signal or file, or Plotly is not installed.
    """
    figures = needed("plotly.graph_objects", "plot")
    rows, limits = _read(results)
    if (asset, channel) not in limits:
        known = [" / ".join(name) for name in limits]
        asked = f"{asset} / {channel}"
        raise ConfigurationError(f"There is no signal {asked!r}{nearest(asked, known)}")
    mine = rows.filter(pa.array((_texts(rows, "asset") == asset) & (_texts(rows, "channel") == channel)))
    limit = limits[asset, channel]
    drawn = figures.Figure(
        figures.Scatter(x=mine["time"].to_pylist(), y=mine["hi"].to_pylist(), name="indicator")
    )
    if limit is not None:
        drawn.add_hline(y=limit, line_dash="dash", annotation_text="limit")
    title = {"text": html.escape(f"{asset} · {channel}", quote=False)}
    return drawn.update_layout(title=title, yaxis={"range": [0, 1], "title": {"text": "hi"}})


def fleet(results: Monitor | str | Path) -> Any:
    """Return a figure of the machines over time: how many signals were above at once.

    Args:
        results: as in :func:`signal`. Signals without a limit count nowhere.

    Raises:
        UserError: there is no such file, nothing in it is judged, or Plotly is not installed.
    """
    figures = needed("plotly.graph_objects", "plot")
    rows, limits = _read(results)
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


def _read(results: Monitor | str | Path) -> tuple[pa.Table, dict[tuple[str, str], float | None]]:
    """Return what is drawn: rows of the indicator, and the limit of each signal."""
    if isinstance(results, Monitor):
        rows, known = results.health(), results.status()
        time = rows["last_tick"] if rows["last_time"].null_count == rows.num_rows else rows["last_time"]
        rows = rows.select(["asset", "channel", "hi"]).append_column("time", time)
    else:
        rows, known = _of_file(Path(results))
    return rows, {(row["asset"], row["channel"]): row["hi_limit"] for row in known.to_pylist()}


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
    for one in (path, beside):
        if path.suffix != _ENDING or not one.is_file():
            raise wrong("no_result_to_plot", one=one, ending=_ENDING)
    return (pq.read_table(path, columns=list(wanted[0])), pq.read_table(beside, columns=list(wanted[1])))
