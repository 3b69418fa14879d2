"""``gam status``: what the state says of every channel, without a look at the source.

This module owns the command and its page. What is told is made by :mod:`gam_db.stored.status`.
"""

import datetime as dt
import json
from collections.abc import Iterator
from typing import Annotated, Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
import typer
from rich.cells import cell_len
from rich.console import Console
from rich.text import Text

import gam_db
from gam_db.cli import monitor_options, options, report
from gam_db.cli.figures import plain
from gam_db.clock import TimeKind, shown_instant
from gam_db.errors import ConfigurationError
from gam_db.findings import any_needs_attention, share
from gam_db.parameters import pattern_matches
from gam_db.stored import status as stored_status
from gam_db.stored.proving import Proof

NEEDS_ATTENTION = 2

ASSETS = 20
"""Assets shown unless all are asked for."""

_WIDE = 100
"""Columns below which times are shown without their year."""


def status(
    database: monitor_options.DatabaseOption = None,
    config: options.ConfigOption = None,
    name: monitor_options.NameOption = None,
    schema: monitor_options.SchemaOption = None,
    prefix: monitor_options.PrefixOption = None,
    asset: Annotated[
        str | None,
        typer.Option(metavar="PATTERN", help="Only these machines; * and ? stand for any text or sign."),
    ] = None,
    park_after: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="A channel that lags behind the newest data by more is called silent: seconds or a "
            "text like '1 d' (the default); steps of a counter.",
        ),
    ] = None,
    everything: Annotated[
        bool,
        typer.Option(
            "--all",
            help=f"Print every channel and asset, not only the {report.SHOWN} and {ASSETS} most urgent.",
        ),
    ] = False,
    as_json: monitor_options.JsonOption = False,
) -> None:
    """Say how every channel is: verdict, floor, indicator, trend, and what is wrong with its data.

    It reads the state in the database, not the source. A channel needs attention (exit code 2) by the
    same rule as in `gam run`: its indicator is above its limit, or its calibration is not good enough.
    """
    session, tables, settings = monitor_options.opened(
        file=config, database=database, name=name, schema=schema, prefix=prefix, writable=False
    )
    monitor = settings.monitor.name
    silence = settings.monitor.park_after if park_after is None else options.length(park_after)
    with session:
        channels = stored_status.status(session, tables, monitor, silence)
        proof = stored_status.proved(session, tables, monitor)
    unheard = stored_status.unheard_for(channels, silence, dt.datetime.now(dt.UTC))
    if asset is not None:
        channels = _of_assets(channels, asset)
    told = zip(channels["status"].to_pylist(), channels["verdict"].to_pylist(), strict=True)
    code = NEEDS_ATTENTION if any_needs_attention(told) else 0
    if as_json:
        figures = {
            "version": gam_db.__version__,
            "database": settings.source.shown_database,
            "monitor": monitor,
            "no_data_for_seconds": None if unheard is None else unheard.total_seconds(),
            "proved": None if proof is None else _proved(proof),
            "channels": plain(channels.to_pylist()),
            "assets": plain(stored_status.by_asset(channels).to_pylist()),
            "needs_attention": code == NEEDS_ATTENTION,
            "exit_code": code,
        }
        print(json.dumps(figures, ensure_ascii=False, indent=1))
    else:
        out = report.console()
        report.say(out, _heading(channels, f"{settings.source.shown_database}, monitor {monitor}"))
        if unheard is not None:
            report.say(out, _silence(unheard))
        report.say(out, _proof(proof, dt.datetime.now(dt.UTC)))
        out.print()
        _show(out, channels, everything)
    if code:
        raise typer.Exit(code)


def _of_assets(channels: pa.Table, pattern: str) -> pa.Table:
    named = [pattern_matches(pattern, asset) for asset in channels["asset"].to_pylist()]
    found = channels.filter(pa.array(named, pa.bool_()))
    if not found.num_rows:
        raise ConfigurationError(f"No asset of this monitor is called like {pattern!r}.")
    return found


def _heading(channels: pa.Table, where: str) -> str:
    assets = len(channels["asset"].unique())
    newest = pc.max(channels["last_data"]).as_py()
    return (
        f"{report.printable(where)}: {channels.num_rows:,} channel{'s' * (channels.num_rows != 1)} of "
        f"{assets:,} asset{'s' * (assets != 1)}, newest data {report.time_text(newest)}"
    )


def _silence(unheard: dt.timedelta) -> str:
    length = stored_status.shown_length(unheard // dt.timedelta(microseconds=1), TimeKind.TIMESTAMP)
    return f"no data at all for {length}: is the source filled, and is gam score run?"


def _proof(proof: Proof | None, now: dt.datetime) -> str:
    if proof is None:
        return "the state was never compared with its source; gam check --state does it"
    epoch = dt.datetime(1970, 1, 1, tzinfo=dt.UTC)
    age = (now - epoch) // dt.timedelta(microseconds=1) - proof.proved_at
    ago = stored_status.shown_length(age, TimeKind.TIMESTAMP)
    found = f"{proof.differences:,} differences" if proof.differences else "no difference"
    return f"the state was last compared with its source {ago} ago: {found} (gam check --state)"


def _proved(proof: Proof) -> dict[str, Any]:
    said = {name: value for name, value in vars(proof).items() if name != "extent"}
    return {**said, "proved_at": shown_instant(proof.proved_at, TimeKind.TIMESTAMP)}


def _show(out: Console, channels: pa.Table, everything: bool) -> None:
    if not channels.num_rows:
        report.say(out, "no channel is calibrated yet; run gam calibrate")
        return
    shown = channels if everything else channels.slice(0, report.SHOWN)
    one_asset = len(channels["asset"].unique()) == 1
    lines = [_line(row, one_asset, out.width < _WIDE) for row in shown.to_pylist()]
    for text in report.channel_lines(out, lines):
        out.print(text, no_wrap=True, overflow="crop", crop=True)
    rest = channels.slice(shown.num_rows)
    if rest.num_rows:
        words = report.counted(rest["status"].to_pylist())
        report.say(out, f"and {rest.num_rows:,} more ({words}); --all")
    out.print()
    if not one_asset:
        assets = stored_status.by_asset(channels)
        for text in _asset_lines(out, assets.slice(0, None if everything else ASSETS)):
            out.print(text, no_wrap=True, overflow="crop", crop=True)
        if not everything and assets.num_rows > ASSETS:
            report.say(out, f"and {assets.num_rows - ASSETS:,} more assets; --all")
        out.print()
    for line in _summary(channels):
        report.say(out, line)


def _line(row: dict[str, Any], one_asset: bool, is_narrow: bool) -> report.Line:
    time = report.time_text(row["last_data"])
    return report.Line(
        name=row["channel"] if one_asset else f"{row['asset']} {row['channel']}",
        status=row["status"],
        verdict=row["verdict"],
        floor=row["floor"],
        hi=row["hi"],
        course=np.array(row["course"] or [], np.float64),
        time=time[5:] if is_narrow and isinstance(row["last_data"], dt.datetime) else time,
        remarks=row["remarks"],
        trend=_rise(row["trend"]),
    )


def _rise(trend: float | None) -> str:
    """Return a change of the indicator with its sign: +0.02, -0.31; 0 where it is below 0.005."""
    if trend is None:
        return "-"
    return "0" if abs(trend) < 0.005 else f"{trend:+.2f}"


def _asset_lines(out: Console, assets: pa.Table) -> Iterator[Text]:
    """Yield a line per asset, after a heading."""
    rows = assets.to_pylist()
    names = [report.printable(row["asset"]) for row in rows]
    worst = [report.printable(row["channel"]) for row in rows]
    free = out.width - (2 + 2 + 2 + 5 + 2 + 5 + 2 + 24)
    name_width = min(max([5, *map(cell_len, names)]), max(8, free // 2))
    worst_width = min(max([13, *map(cell_len, worst)]), max(8, free - name_width))
    yield Text(
        f"  {report.fit('asset', name_width)}  {report.fit('worst channel', worst_width)}     HI  "
        "trend  channels",
        style="bold",
    )
    for row, asset, channel in zip(rows, names, worst, strict=True):
        mark, style = report.MARKS.get(row["status"], (" ", ""))
        is_shown = row["status"] != "not assessed"
        said = f"{row['channels']:,}"
        if row["need_attention"]:
            said += f", {row['need_attention']:,} need attention"
        if row["silent"]:
            said += f", {row['silent']:,} silent"
        yield Text(
            f"{mark} {report.fit(asset, name_width)}  {report.fit(channel, worst_width)}  "
            f"{share(row['hi'] if is_shown else None):>5}  "
            f"{_rise(row['trend'] if is_shown else None):>5}  {said}",
            style,
        )


def _summary(channels: pa.Table) -> Iterator[str]:
    yield "channels: " + report.counted(channels["status"].to_pylist())
    silent = pc.sum(channels["silent"]).as_py()
    if silent:
        yield f"silent: {silent:,}"
    differing = pc.sum(pc.greater(channels["differing_contexts"], 0)).as_py()
    if differing:
        since = pc.min(channels["repair_from"]).as_py()
        yield (
            f"{differing:,} with samples that came later than lookback, or were taken away: gam score "
            f"--from {since.isoformat() if isinstance(since, dt.datetime) else since} mends them all"
        )
    changed = pc.sum(pc.not_equal(channels["calibration_rows_added"], 0)).as_py()
    if changed:
        yield f"{changed:,} with calibration data that changed; gam calibrate --again learns it anew"
    remarks = (remark for said in channels["remarks"].to_pylist() for remark in said)
    yield " ".join([*report.legend(remarks), "Trend: HI now less HI a window earlier."])
