"""``gam alarms``, ``alarm``, ``label`` and ``limits``: what is raised, and what is said of it.

This module owns the commands and their pages; :mod:`gam_db.stored.alarms` does the work.
"""

import datetime as dt
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Annotated, Any

import typer
from rich.console import Console

from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.clock import TimeKind, told_time, zone
from gam_db.config import Settings
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, printable
from gam_db.findings import Row
from gam_db.stored import alarms as stored
from gam_db.stored import limits as made
from gam_db.stored import migrations
from gam_db.stored.state import State, kind_of

#: Episodes shown unless all are asked for.
_SHOWN = 20

_MARKS = {"proving": "?", "open": "!"}


@options.taking(*options.STATE, source=False, state=True)
def alarms(
    settings: Settings,
    new: Annotated[
        bool, typer.Option("--new", help="Print the changes instead, one by one: for a notifier.")
    ] = False,
    after: Annotated[
        int, typer.Option(metavar="SEQ", help="With --new: only those after this one; 0 for all.")
    ] = 0,
    everything: options.All = False,
    time_zone: options.TimeZone = "UTC",
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Say which signals are raised: since when, how sure, and what to decide.

    Episodes that opened right after calibration come first, then those that are open. Exit code 2: one
    of them needs attention. With --new it is 0, whatever is printed.
    """
    shown_in = zone(time_zone)
    with options.opened(settings, writable=False) as session:
        state = _state(session, settings)
        if new:
            changes = stored.events(state, settings.monitor.name, after).to_pylist()
            newest = max((row["seq"] for row in changes), default=after)
            figures = {"monitor": settings.monitor.name, "seq": newest, "changes": changes}
            page.tell(
                Exit.FINE, figures, lambda out: _show_changes(out, changes, shown_in), as_json, quiet
            )
            return
        episodes = stored.alarms(state, settings.monitor.name)
        judged = stored.limits(state, settings.monitor.name)
    rows = episodes.to_pylist()
    urgent = any(row["needs_attention"] for row in rows)
    figures = {
        "database": settings.source.shown_database,
        "monitor": settings.monitor.name,
        "episodes": episodes,
        "limits": dict(promised(judged)),
        "needs_attention": urgent,
    }

    def show(out: Console) -> None:
        where = f"{settings.source.shown_database}, monitor {settings.monitor.name}"
        told = "nothing was ever raised" if not rows else number_of(len(rows), "episode")
        page.say(out, f"{printable(where)}: {told}")
        for line in said_of(judged):
            page.say(out, line)
        _show_episodes(out, rows if everything else rows[:_SHOWN], shown_in)
        if not everything and len(rows) > _SHOWN:
            page.say(out, f"and {len(rows) - _SHOWN:,} more; --all")

    page.tell(Exit.ATTENTION if urgent else Exit.FINE, figures, show, as_json, quiet)


@options.taking(*options.STATE, source=False, state=True)
def alarm(
    settings: Settings,
    episode: Annotated[int, typer.Argument(metavar="ID", help="Number of the episode.")],
    time_zone: options.TimeZone = "UTC",
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Say all that is known of one episode: its judgements, and where the signal went."""
    shown_in = zone(time_zone)
    with options.opened(settings, writable=False) as session:
        state = _state(session, settings)
        kind = kind_of(state.monitor(settings.monitor.name))
        rows = stored.alarms(state, settings.monitor.name).to_pylist()
        found = next((row for row in rows if row["episode"] == episode), None)
        if found is None:
            raise ConfigurationError(
                f"There is no episode {episode}; gam alarms --all shows those that there are."
            )
        judged = stored.judgements(state, found)
        told: Row = {
            "bands": stored.bands(state, settings.monitor.name, found),
            "cells": stored.cells(state, settings.monitor.name, found),
            "raw_rows": stored.raw_rows(state, settings.monitor.name, found),
        }
    figures = {"monitor": settings.monitor.name, **found, "judgements": judged, **told}

    def show(out: Console) -> None:
        _show_episodes(out, [found], shown_in)
        ends = [told_time(row["last_time"], kind) for row in judged]
        page.table(
            out,
            {
                "judgement": [f"{row['judgement_no']:,}" for row in judged],
                page.in_zone("until", ends, shown_in): [page.time_text(end, shown_in) for end in ends],
                "novel": [f"{row['novel']:,}" for row in judged],
                "evidence": [f"{row['evidence']:,}" for row in judged],
                "height": [f"{row['height']:,}" for row in judged],
            },
            ["!" if row["is_open"] else " " for row in judged],
        )
        _show_bands(out, told["bands"])
        _show_cells(out, told["cells"], kind, shown_in)
        if told["raw_rows"] is not None:
            page.say(out, "its rows in the source:")
            page.say(out, printable(told["raw_rows"]))

    page.tell(Exit.FINE, figures, show, as_json, quiet)


@options.taking(*options.STATE, source=False, state=True)
def label(
    settings: Settings,
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="ID KIND | ASSET FROM TO KIND",
            help=f"An episode, or a machine and a time; and one of {', '.join(stored.KINDS)}.",
        ),
    ],
    note: Annotated[str | None, typer.Option(help="What else there is to say.")] = None,
    until: Annotated[
        str | None, typer.Option(metavar="TIME", help="When an acknowledgement or a snooze ends (UTC).")
    ] = None,
    instead: Annotated[
        bool, typer.Option("--instead", help="Replace another decision on the same episode.")
    ] = False,
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Keep what is known of an episode, or of a machine in an interval of time.

    A false alarm right after calibration says that calibration was no fair sample: its channel is judged
    no more until it is calibrated again.
    """
    if len(words) not in (2, 4):
        raise ConfigurationError(
            f"gam label takes ID KIND or ASSET, two times and KIND, not {len(words)} words: gam label 3 "
            "true_fault, or gam label robot_7 2026-03-01 2026-03-02 maintenance."
        )
    episode = _number(words[0]) if len(words) == 2 else None
    about = (None, None) if len(words) == 2 else (words[0], (words[1], words[2]))
    with options.opened(settings) as session:
        state = _state(session, settings)
        asset, span = about
        end = None if until is None else _end(until)
        said = (words[-1], episode, asset, span, note, end, instead)
        found = stored.label(state, settings.monitor.name, *said)
    figures = {"monitor": settings.monitor.name, "kind": words[-1], "episodes": found}
    told = ", ".join(map(str, found)) or "none yet"
    page.tell(Exit.FINE, figures, lambda out: page.say(out, f"episodes: {told}"), as_json, quiet)


@options.taking(*options.ALARMS, *options.STATE, source=False, state=True)
def limits(
    settings: Settings,
    again: Annotated[
        bool, typer.Option("--again", help="Make them anew, for the judgements to come.")
    ] = False,
    reason: Annotated[str | None, typer.Option(help="With --again: why; it is kept with them.")] = None,
    everything: options.All = False,
    as_json: options.Json = False,
    quiet: options.Quiet = False,
) -> None:
    """Say by what each channel is judged, or why it is not.

    What was judged stays as it is.
    """
    if again != (reason is not None):
        raise ConfigurationError("--again and --reason go together: say why limits are made anew.")
    with options.opened(settings, writable=again) as session:
        state = _state(session, settings)
        if reason is not None:
            with session.transaction():
                made.make(state, settings.monitor.name, settings.alarms, reason, lambda _: True)
        rows = stored.limits(state, settings.monitor.name)
    figures = {"monitor": settings.monitor.name, **promised(rows), "channels": rows}

    def show(out: Console) -> None:
        for line in said_of(rows):
            page.say(out, line)
        shown = rows if everything else rows[: options.SHOWN]
        page.table(
            out,
            {
                "channel": page.names_of(shown),
                "basis": [row["basis"] or "-" for row in shown],
                "height": ["-" if row["height"] is None else f"{row['height']:,}" for row in shown],
                "blocks": [f"{row['blocks'] or 0:,}" for row in shown],
                "no limit, since": [row["reason"] or "" for row in shown],
            },
            [" " if row["reason"] is None else "?" for row in shown],
            ("basis", "no limit, since"),
        )
        if len(shown) < len(rows):
            page.say(out, f"and {len(rows) - len(shown):,} more; --all")

    page.tell(Exit.FINE, figures, show, as_json, quiet)


def promised(rows: Sequence[Row]) -> Row:
    """Return what the limits of some channels promise, all together.

    Keys: asked, judged and withheld (channels with a limit, and reason -> channels without), basis
    (channels each), stated (mean, per judgement; None where none can be stated), per_day (alarms of all
    channels with a stated rate; None on a counter).
    """
    judged = [row for row in rows if row["reason"] is None]
    stated = [row for row in judged if row["stated_rate"] is not None]
    days = [row["judgements_per_day"] for row in stated]
    rates = [row["stated_rate"] for row in stated]
    return {
        "asked": sorted({row["asked"] for row in judged}),
        "judged": len(judged),
        "withheld": dict(Counter(row["reason"] for row in rows if row["reason"] is not None)),
        "basis": dict(Counter(row["basis"] for row in judged)),
        "stated": sum(rates) / len(rates) if rates else None,
        "per_day": None
        if not rates or None in days
        else sum(rate * day for rate, day in zip(rates, days, strict=True)),
    }


def said_of(rows: Sequence[Row]) -> Iterator[str]:
    """Yield what is to be said of the limits of some channels."""
    told = promised(rows)
    if told["judged"]:
        bases = ", ".join(f"{count:,} by {basis}" for basis, count in sorted(told["basis"].items()))
        line = f"asked: {'; '.join(told['asked'])} ({bases})"
        if told["stated"] is not None:
            line += f"; can be stated: {1000 * told['stated']:.3g} per 1,000 judgements"
        if told["per_day"]:
            line += f", {_often(told['per_day'])} of all channels"
        yield line
    if told["basis"].get("none"):
        count = number_of(told["basis"]["none"], "channel")
        yield f"{count} of which no rate can be stated; they are judged all the same"
    for reason, count in sorted(told["withheld"].items()):
        yield f"{number_of(count, 'channel')} without a limit: {reason}"


def _often(per_day: float) -> str:
    return f"{per_day:.2g} a day" if per_day >= 1 else f"1 in {1 / per_day:.2g} days"


def _state(session: Session, settings: Settings) -> State:
    migrations.require(session, settings.monitor.tables)
    return State(session, settings.monitor.tables)


def _number(text: str) -> int:
    try:
        return int(text)
    except ValueError as error:
        raise ConfigurationError(
            f"{text!r} is no number of an episode; of a machine say ASSET, two times and KIND."
        ) from error


def _end(text: str) -> dt.datetime:
    try:
        return dt.datetime.fromisoformat(text)
    except ValueError as error:
        raise ConfigurationError(
            f"--until is {text!r}; write 2026-03-14 or 2026-03-14T18:00."
        ) from error


def _show_episodes(out: Console, rows: Sequence[Row], shown_in: dt.tzinfo) -> None:
    if not rows:
        return

    def rate(row: Row) -> str:
        stated: Any = row["stated_rate"]
        return row["basis"] or "-" if stated is None else f"{row['basis']}, {1000 * stated:.3g}"

    page.table(
        out,
        {
            "episode": [f"{row['episode']}" for row in rows],
            "channel": page.names_of(rows),
            "status": [row["status"] for row in rows],
            page.in_zone("since", [row["since"] for row in rows], shown_in): [
                page.time_text(row["since"], shown_in) for row in rows
            ],
            "sure": [f"{row['sure']:.1f}" for row in rows],
            "basis, per 1,000": [rate(row) for row in rows],
            "open of machine": [f"{row['signals_open']:,}" for row in rows],
            "label": [row["label"] or "" for row in rows],
        },
        [_MARKS.get(row["status"], "!") if row["needs_attention"] else " " for row in rows],
        ("channel", "status", "basis, per 1,000", "label"),
    )
    for row in {row["group"]: row for row in rows if row["signals_together"] > 1}.values():
        page.say(
            out,
            f"{printable(row['asset'])}: {row['signals_together']} signals of this machine within 2 "
            f"judgements, from episode {row['group']} on",
        )
    if any(row["status"] == "proving" for row in rows):
        page.say(
            out,
            "proving: either calibration was no fair sample, or something changed right after it; gam "
            "label ID true_fault or false_alarm decides",
        )


def _show_bands(out: Console, rows: Sequence[Row]) -> None:
    if rows:
        page.say(out, "where it stands out (first five judgements, by the newest sample of a vector):")
        page.table(
            out,
            {
                "value": [_interval(row) for row in rows],
                "novel": [f"{row['novel']:,}" for row in rows],
                "vectors": [f"{row['visits']:,}" for row in rows],
                "more than in calibration": [f"{row['excess']:,.1f}" for row in rows],
            },
            [" "] * len(rows),
        )


def _show_cells(out: Console, rows: Sequence[Row], kind: TimeKind, shown_in: dt.tzinfo) -> None:
    if rows:
        times = {
            name: [told_time(row[f"{name}_tick"], kind) for row in rows] for name in ("first", "last")
        }
        before = ", ".join(str(axis["samples_before"]) for axis in rows[0]["axes"])
        page.say(out, f"where it went instead (values {before} samples before; bins from the healthy):")
        page.table(
            out,
            {
                "vectors": [f"{row['visits']:,}" for row in rows],
                **{
                    page.in_zone(name, ticks, shown_in): [page.time_text(one, shown_in) for one in ticks]
                    for name, ticks in times.items()
                },
                "values": [" | ".join(map(_interval, row["axes"])) for row in rows],
                "bins": [" ".join(f"{axis['displacement']:+d}" for axis in row["axes"]) for row in rows],
            },
            [" "] * len(rows),
            ("values", "bins"),
        )


def _interval(row: Row) -> str:
    ends = [row[name] for name in ("value_from", "value_to")]
    if row["place"] == "within":
        return " to ".join(f"{end:.4g}" for end in ends)
    return f"{row['place']} {next(end for end in ends if end is not None):.4g}"


def _show_changes(out: Console, rows: Sequence[Row], shown_in: dt.tzinfo) -> None:
    for row in rows:
        name = printable(f"{row['asset']} {row['channel']}")
        when = page.time_text(row["noticed_at"], shown_in, named=True)
        page.say(out, f"{row['seq']}  {when}  episode {row['episode_id']} {row['what']}: {name}")
