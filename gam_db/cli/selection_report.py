"""The report of a selection: curves and choices as lines, or as one object of JSON.

This module owns how they look. What they mean is said by :class:`gam_db.selection.Selection`.
"""

import dataclasses
import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pyarrow as pa
from rich.console import Console
from rich.text import Text

import gam_db
from gam_db.cli.report import (
    BLOCKS,
    PLAIN_BLOCKS,
    SHOWN,
    Job,
    can_show,
    columns_line,
    healthy_part,
    printable,
    say,
    sparkline,
)
from gam_db.selection import Search, Selection

Row = dict[str, Any]

_CURVE = 40
"""Characters of a curve."""

_TAU = {
    "given": "as given",
    "first_minimum": "first minimum of mutual information",
    "acf_1e": "first autocorrelation below 1/e",
    "acf_zero": "first autocorrelation at or below zero",
    "none": "no delay means anything: a sample tells nothing of the next",
}
_CAO = {
    "saturated": "Cao: {m}",
    "no_saturation": "Cao: not saturated",
    "stochastic": "Cao: stochastic",
    "none": "Cao: none",
}


def show(out: Console, job: Job, found: Selection, everything: bool = False) -> None:
    """Print curves and choices, channel by channel.

    Args:
        out: where to.
        job: for the heading.
        found: the selection.
        everything: show every channel, however many there are.
    """
    choices: list[Row] = found.choices.to_pylist()
    blocks = BLOCKS if can_show(out, BLOCKS) else PLAIN_BLOCKS
    say(out, f"{printable(job.name)}: {len(choices):,} channel{'s' * (len(choices) != 1)}")
    say(out, columns_line(job.guess))
    say(out, f"chosen from {healthy_part(job.calibration)}")
    lags, dimensions = _by_channel(found.lags), _by_channel(found.dimensions)
    budget = _by_channel(found.budget)
    shown = choices if everything else choices[:SHOWN]
    for one in shown:
        key = (one["asset"], one["channel"])
        out.print()
        out.print(Text(f"{printable(one['asset'])} {printable(one['channel'])}", style="bold"))
        for line in _lines(one, lags[key], dimensions[key], budget[key], job, blocks):
            say(out, f"  {line}")
    for one in found.failures.to_pylist():
        out.print()
        name = f"{printable(one['asset'])} {printable(one['channel'])}"
        say(out, f"{name}: nothing chosen, by a fault of gam-db or its engine: {one['reason']}")
    if len(choices) > len(shown):
        out.print()
        say(out, f"and {len(choices) - len(shown)} more; --all")


def figures(job: Job, search: Search, found: Selection) -> dict[str, Any]:
    """Return the selection as one object that JSON can hold: what was asked, then every table.

    Args:
        job: what was asked.
        search: how it was looked for.
        found: the selection.
    """
    tables = {field.name: getattr(found, field.name) for field in dataclasses.fields(found)}
    return {
        "version": gam_db.__version__,
        "source": {"name": job.name, "guessed": dict(job.guess.guessed)},
        "settings_file": job.settings,
        "search": dataclasses.asdict(search),
        "asked": {
            name: getattr(job.parameters, name) for name in ("m", "bins", "window", "target_floor")
        },
        **{name: [_plain(row) for row in table.to_pylist()] for name, table in tables.items()},
    }


def _lines(
    one: Row,
    lags: Sequence[Row],
    dimensions: Sequence[Row],
    budget: Sequence[Row],
    job: Job,
    blocks: str,
) -> list[str]:
    if one["verdict"] in ("constant", "no_data"):
        said = {"constant": "did not move", "no_data": "no usable sample or no whole vector"}
        return [f"{one['verdict']}: {said[one['verdict']]} in {one['samples']:,} samples"]
    tau = "-" if one["tau"] is None else one["tau"]
    others = ", ".join(
        f"{name} {one[lag]}"
        for name, lag in (
            ("minimum", "ami_minimum"),
            ("acf < 1/e", "acf_1e"),
            ("acf <= 0", "acf_zero"),
        )
        if one[lag] is not None
    )
    lines = [f"tau    {tau}: {_TAU[one['tau_rule']]}" + (f" ({others})" if others else "")]
    if len(lags) > 1:
        curve = sparkline(_scaled([row["ami"] for row in lags[1:]]), _CURVE, blocks)
        highest = max(row["ami"] for row in lags[1:])
        lines.append(f"       AMI  {curve} lags 1 to {lags[-1]['delay']}, up to {highest:.2f} nats")
        curve = sparkline(_scaled([row["acf"] for row in lags[1:]]), _CURVE, blocks)
        lines.append(f"       acf  {curve}")
    lines.append(f"m      {_dimension(one)}")
    if dimensions:
        shares = [row["false_share"] for row in dimensions]
        shown = " ".join("-" if share is None else f"{100 * share:.1f}" for share in shares)
        lines.append(f"       false neighbours, m = 1 to {len(shares)}: {shown} %")
    lines.append(f"window {_window(one, job.parameters.window)}")
    if budget:
        grids = " ".join(
            "-" if row["finest_bins"] is None else str(row["finest_bins"]) for row in budget
        )
        lines.append(f"bins   finest grid that this calibration fills, m = 1 to {len(budget)}: {grids}")
    lines.append(_together(one))
    return lines


def _dimension(one: Row) -> str:
    said = {
        "fnn": f"{one['m_fnn']}: the first with at most 1 % false neighbours",
        "noise_floor": "-: noise floor, neighbours part in every dimension",
        "none": "-: no vector has a neighbour",
    }
    return f"{said[one['fnn_status']]}; {_CAO[one['cao_status']].format(m=one['m_cao'])}"


def _window(one: Row, window: int) -> str:
    if one["window_status"] == "no_cycle":
        return f"{window}: as asked for; no cycle seen"
    cycle = one["cycle_length"]
    held = f"{window} holds {window / cycle:.1f} cycles of {cycle} samples"
    if one["window_status"] == "enough":
        return f"{window}: {held}"
    return f"{one['recommended_window']}: {held}, which is short; take at least 5"


def _together(one: Row) -> str:
    taken = {
        "--m": one["recommended_m"],
        "--tau": 1 if one["tau"] is None else one["tau"],
        "--bins": one["recommended_bins"],
        "--window": one["recommended_window"],
    }
    line = "take   " + " ".join(f"{option} {value}" for option, value in taken.items())
    if one["verdict"] == "needs_data":
        needed = one["vectors_needed"]
        more = "" if needed is None else f", about {needed:,} vectors more"
        return f"{line} (needs_data: no grid passes; calibrate longer{more})"
    return f"{line} (floor {one['recommended_floor']:.3f})"


def _by_channel(table: pa.Table) -> Mapping[tuple[str, str], list[Row]]:
    rows: dict[tuple[str, str], list[Row]] = defaultdict(list)
    for row in table.to_pylist():
        rows[row["asset"], row["channel"]].append(row)
    return rows


def _scaled(curve: Sequence[float | None]) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Return a curve between 0 and 1, whatever its range."""
    points = np.array([math.nan if point is None else point for point in curve], dtype=np.float64)
    known = points[~np.isnan(points)]
    if not len(known) or known.max() == known.min():
        return points * 0
    scaled: np.ndarray[Any, np.dtype[np.float64]] = (points - known.min()) / (known.max() - known.min())
    return scaled


def _plain(row: Row) -> Row:
    """Return a row in the types of JSON; NaN and infinity are null."""
    return {
        name: None if isinstance(value, float) and not math.isfinite(value) else value
        for name, value in row.items()
    }
