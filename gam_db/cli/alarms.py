"""``gam alarms``, ``alarm``, ``label``, ``limits``, ``backtest``: what is raised, what is said of it."""

import datetime as dt
import operator
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

from gam_db.alarms import UNREPRESENTATIVE, backtesting, figures
from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.job import heading, place, reading, state_of
from gam_db.cli.options import argument, option
from gam_db.clock import TimeKind, time_of, zone
from gam_db.errors import ConfigurationError, printable, wrong
from gam_db.findings import Row
from gam_db.settings.calibration import Calibration
from gam_db.settings.setting import settings_of
from gam_db.stored.alarms import limits as stored_limits
from gam_db.stored.alarms import told as stored
from gam_db.stored.state import kind_of

#: Episodes shown unless all are asked for.
_SHOWN = 20

_KINDS = ", ".join(stored.KINDS)
_MARKS = {"proving": "?", "open": "!", "high": "!"}
_RATES = ("stated", "seen", "lower", "upper", "resampled_lower", "resampled_upper")


@options.of_state(*options.STATE, *options.PAGE, "time_zone")
def alarms(
    settings: Settings,
    common: options.Common,
    new: bool = option("alarms.new", False),
    after: int = option("alarms.after", 0),
) -> None:
    """List alarms: which signals, since when, how sure.

    Episodes that opened right after calibration come first, then open ones. Exit code 2: an episode
    needs attention. With --new the exit code is 0.
    """
    shown_in, name = zone(common.time_zone), settings.monitor.name
    with state_of(settings) as state:
        if new:
            changes = stored.events(state, name, after).to_pylist()
            newest = max((row["seq"] for row in changes), default=after)
            messages = [row for row in changes if row["is_message"]]
            streamed: Row = {"monitor": name, "seq": newest, "messages": messages, "changes": changes}
            page.tell(streamed, lambda out: _show_messages(out, messages, newest, shown_in), common)
            return
        rows, judged = stored.alarms(state, name).to_pylist(), stored.limits(state, name)
    urgent = any(row["needs_attention"] for row in rows)
    overview = {"episodes": rows, "limits": promised(judged), "needs_attention": urgent}

    def show(out: page.Out) -> None:
        count = number_of(len(rows), "episode") if rows else "nothing was ever raised"
        page.say(out, f"{heading(settings)}: {count}")
        page.say(out, *limit_lines(judged))
        _show_episodes(out, common.of(rows, _SHOWN), shown_in)
        page.cut(out, rows, common.everything, most=_SHOWN)

    page.tell({**place(settings), **overview}, show, common, urgent=urgent)


@options.of_state(*options.STATE, "time_zone", "as_json", "quiet")
def alarm(settings: Settings, common: options.Common, episode: int = argument("alarm.episode")) -> None:
    """Explain one episode: its judgements and where the signal went."""
    shown_in, name = zone(common.time_zone), settings.monitor.name
    with state_of(settings) as state:
        kind = kind_of(state.monitor(name))
        rows = stored.alarms(state, name).to_pylist()
        counted = figures.with_figures(rows, figures.figures(state.rows, name))
        if (episode_row := next((row for row in counted if row["episode"] == episode), None)) is None:
            raise wrong("no_episode", episode=episode)
        advice = figures.advice_of(counted)[episode]
        details: Row = {
            "finding": None if advice is None else advice.finding,
            "advice": None if advice is None else advice.advice,
            "judgements": stored.judgements(state, episode_row),
            "bands": stored.bands(state, name, episode_row),
            "cells": stored.cells(state, name, episode_row),
            "raw_rows": stored.raw_rows(state, name, episode_row),
        }

    def show(out: page.Out) -> None:
        if advice is not None:
            page.say(out, printable(advice.finding), printable(f"What to do next: {advice.advice}"), "")
        page.say(out, *_facts(episode_row, shown_in), "")
        judged = [
            {**row, "until": time_of(row["last_time"], kind), "threshold": row["height"]}
            for row in details["judgements"]
        ]
        columns: dict[str, page.Cell] = {
            "judgement": "judgement_no",
            **page.when("until", "until", judged, shown_in),
            **{name: name for name in ("novel", "evidence", "threshold")},
        }
        page.table(out, judged, columns, lambda row: "!" if row["is_open"] else " ")
        page.say(out, page.WORDS["alarm"]["legend"].format(window=episode_row["window_length"] or 0))
        if details["bands"]:
            page.say(out, page.WORDS["alarms"]["bands"])
            page.table(out, details["bands"], _OF_BAND)
        _show_cells(out, details["cells"], kind, shown_in)
        if details["raw_rows"] is not None:
            page.say(out, page.WORDS["alarm"]["rows"])
            page.verbatim(out, f"{details['raw_rows']};")
        page.verbatim(out, "", *_commands(episode_row))

    page.tell({"monitor": name, **episode_row, **details}, show, common)


@options.of_state(*options.STATE, "as_json", "quiet")
def label(
    settings: Settings,
    common: options.Common,
    words: list[str] = argument("label.words", names=_KINDS),
    note: str | None = option("label.note"),
    until: str | None = option("label.until"),
    instead: bool = option("label.instead", False),
) -> None:
    """Label an episode, or an interval of a machine.

    A false alarm right after calibration means that calibration was not a fair sample: the channel is
    not judged until you calibrate it again.
    """
    if len(words) not in (2, 4):
        raise wrong("label_words", count=len(words))
    name, first, kind = settings.monitor.name, words[0], words[-1]
    of: Row = {"asset": first, "span": (words[1], words[2])} if len(words) == 4 else {}
    if not of:
        refusal = f"{first!r} is no number of an episode; for a machine give ASSET, two times and KIND."
        of["episode"] = _read(int, first, refusal)
    if until is not None:
        refusal = f"--until is {until!r}; write 2026-03-14 or 2026-03-14T18:00."
        of["until"] = _read(dt.datetime.fromisoformat, until, refusal)
    with state_of(settings, writable=True) as state:
        episodes = stored.label(state, name, kind, note=note, instead=instead, **of)
        rows = [row for row in stored.alarms(state, name).to_pylist() if row["episode"] in episodes]
        judged = {(row["asset"], row["channel"]): row["reason"] for row in stored.limits(state, name)}
    labelled = {"monitor": name, "kind": kind, "episodes": episodes}
    page.tell(labelled, lambda out: page.say(out, *_label_lines(first, kind, rows, judged)), common)


def _label_lines(
    first: str, kind: str, rows: Sequence[Row], judged: Mapping[tuple[str, str], str | None]
) -> Iterator[str]:
    """Yield what a label did: of which episodes it is said, and what follows."""
    texts = page.WORDS["label"]
    if not rows:
        yield texts["nothing"].format(asset=printable(first), kind=kind)
    for row in rows:
        name = printable(f"{row['asset']} {row['channel']}")
        is_off = judged[row["asset"], row["channel"]] == UNREPRESENTATIVE and kind == "false_alarm"
        what = texts["judged_no_more" if is_off else kind].format(until=row["label_until"] or "it ends")
        yield f"episode {row['episode']} ({name}, {row['status']}) is labelled {kind}: {what}"


@options.of_state(*options.ALARMS, *options.STATE, *options.PAGE)
def limits(
    settings: Settings,
    common: options.Common,
    again: bool = option("limits.again", False),
    reason: str | None = option("limits.reason"),
) -> None:
    """Show how each signal is judged, or why it is not.

    With --again it computes the limits again; earlier judgements stay.
    """
    if again != (reason is not None):
        raise ConfigurationError("--again and --reason go together: give the reason for new limits.")
    with state_of(settings, writable=again) as state:
        if reason is not None:
            with state.session.transaction():
                parameters, _ = settings.method()
                arguments = (settings.alarms, parameters, reason)
                stored_limits.make(state, settings.monitor.name, *arguments, lambda _: True)
        rows = stored.limits(state, settings.monitor.name)

    def show(out: page.Out) -> None:
        page.say(out, *limit_lines(rows))
        shown = common.of(rows)
        columns: dict[str, page.Cell] = {
            "channel": page.name_in(shown),
            "basis": "basis",
            "height": lambda row: row["height"] if row["reason"] is None else None,
            "blocks": lambda row: row["blocks"] or 0,
            "no limit, since": lambda row: row["reason"] or "",
        }
        left = ("basis", "no limit, since")
        page.table(out, shown, columns, lambda row: " " if row["reason"] is None else "?", left)
        page.cut(out, rows, common.everything)

    page.tell({"monitor": settings.monitor.name, **promised(rows), "channels": rows}, show, common)


@options.taking(*options.READ, *options.ALARMS, "as_json", "quiet", "threads")
def backtest(
    settings: Settings, common: options.Common, healthy: list[str] | None = option("backtest.healthy")
) -> None:
    """Count false alarms after calibration, where nothing was wrong.

    It computes limits from the calibration of SOURCE for the target rate, and judges every full window
    after calibration. The page compares the counted rate, with its confidence interval, with the stated
    rate.
    """
    spans = settings_of(Calibration)["intervals"].takes.read("--healthy", healthy) if healthy else None
    with reading(settings, common) as (session, job, _):
        method = (job.parameters, job.calibration)
        backtested = backtesting.backtest(job.guess.source, *method, settings.alarms, spans, session)
    page.tell(
        {**job.figures(), **backtested}, lambda out: page.say(out, *_backtest_lines(backtested)), common
    )


def promised(rows: Sequence[Row]) -> Row:
    """Return what the limits of some channels promise, all together.

    Keys: asked, judged and withheld (channels with a limit, and reason -> channels without), basis
    (channels each), stated (mean, per judgement; None where none can be stated), per_day (alarms of all
    channels with a stated rate; None on a counter).
    """
    judged = [row for row in rows if row["reason"] is None]
    stated = [row for row in judged if row["stated_rate"] is not None]
    days, rates = ([row[of] for row in stated] for of in ("judgements_per_day", "stated_rate"))
    has_days = rates and None not in days
    return {
        "asked": sorted({row["asked"] for row in judged}),
        "judged": len(judged),
        "withheld": dict(Counter(row["reason"] for row in rows if row["reason"] is not None)),
        "basis": dict(Counter(row["basis"] for row in judged)),
        "stated": sum(rates) / len(rates) if rates else None,
        "per_day": sum(map(operator.mul, rates, days)) if has_days else None,
    }


def limit_lines(rows: Sequence[Row]) -> Iterator[str]:
    """Yield what is to be said of the limits of some channels."""
    promise = promised(rows)
    if promise["judged"]:
        bases = ", ".join(f"{count:,} by {basis}" for basis, count in sorted(promise["basis"].items()))
        line = f"asked: {'; '.join(promise['asked'])} ({bases})"
        if promise["stated"] is not None:
            line += f"; can be stated: {1000 * promise['stated']:.3g} per 1,000 judgements"
        if often := promise["per_day"]:
            line += f", {often:.2g} a day" if often >= 1 else f", 1 in {1 / often:.2g} days"
            line += " of all channels"
        yield line
    if promise["basis"].get("none"):
        count = number_of(promise["basis"]["none"], "channel")
        yield f"{count} of which no rate can be stated; they are judged all the same"
    for reason, count in sorted(promise["withheld"].items()):
        yield f"{number_of(count, 'channel')} without a limit: {reason}"
    if indicated := sum(row["basis"] == "indicator" for row in rows):
        yield f"{number_of(indicated, 'channel')} judged by the health indicator: no rate can be stated"


def _backtest_lines(backtested: Row) -> Iterator[str]:
    """Yield what is said of the figures, a sentence a line; rates are per 1,000 judgements."""
    texts = page.WORDS["backtest"]
    rates = {name: 1000 * backtested[name] for name in _RATES if backtested[name] is not None}
    yield texts["counted"].format(**backtested)
    yield texts["stated"].format(**backtested | rates) if "stated" in rates else "no rate can be stated"
    yield texts["seen"].format(**backtested | rates)
    if backtested["per_day_seen"] is not None:
        a_day = backtested["per_day_stated"]
        yield texts["a_day"].format(**backtested) + ("" if a_day is None else f", {a_day:.3g} stated")
    for basis, counts in sorted(backtested["basis"].items()):
        yield texts["basis"].format(basis=basis, **counts)
    for reason, count in sorted(backtested["withheld"].items()):
        yield f"without a limit: {count:,} ({reason})"
    raised = [row for row in backtested["by_channel"] if row["episodes"]]
    for row in sorted(raised, key=lambda row: -row["episodes"])[:5]:
        name = " / ".join(filter(None, (row["asset"], row["channel"])))
        yield f"raised: {name}: {row['episodes']:,} in {row['judgements']:,} judgements"


def _read(kind: Callable[[str], Any], text: str, refusal: str) -> Any:
    try:
        return kind(text)
    except ValueError as error:
        raise ConfigurationError(refusal) from error


def _show_episodes(out: page.Out, rows: Sequence[Row], shown_in: dt.tzinfo) -> None:
    if not rows:
        return

    def rate(row: Row) -> str | None:
        stated: Any = row["stated_rate"]
        return row["basis"] if stated is None else f"{row['basis']}, {1000 * stated:.3g}"

    def mark(row: Row) -> str:
        return _MARKS.get(row["status"], "!") if row["needs_attention"] else " "

    columns: dict[str, page.Cell] = {
        "episode": lambda row: str(row["episode"]),
        "channel": page.name_in(rows),
        "status": "status",
        **page.when("since", "since", rows, shown_in),
        "sure": lambda row: None if row["sure"] is None else f"{row['sure']:.1f}",
        "basis, per 1,000": rate,
        "open of machine": "signals_open",
        "label": lambda row: row["label"] or "",
    }
    page.table(out, rows, columns, mark, ("channel", "status", "basis, per 1,000", "label"))
    for row in {row["incident"]: row for row in rows if row["signals_together"] > 1}.values():
        machine = printable(row["asset"])
        page.say(out, page.WORDS["alarms"]["together"].format(machine=machine, **row))
    if any(row["status"] == "proving" for row in rows):
        page.say(out, page.WORDS["alarms"]["proving"])


def _facts(row: Row, shown_in: dt.tzinfo) -> Iterator[str]:
    """Yield what an episode is, how sure, and what people said of it, a line each."""
    words = page.WORDS["alarm"]
    since, last = (page.time_text(row[edge], shown_in, named=True) for edge in ("since", "last_time"))
    names = printable(" / ".join((row["asset"], row["channel"])))
    yield words["episode"].format(**row | {"names": names, "since": since, "last_time": last})
    basis = f"basis {row['basis']}"
    if row["stated_rate"] is not None:
        basis += f", stated rate {1000 * row['stated_rate']:.3g} per 1,000 judgements"
    yield words["evidence" if row["sure"] is not None else "indicator"].format(**row | {"basis": basis})
    label = "none yet" if row["label"] is None else row["label"]
    until = (
        "" if row["label_until"] is None else f" until {page.time_text(row['label_until'], shown_in)}"
    )
    note = "" if row["note"] is None else f" ({row['note']})"
    yield printable(f"feedback: {label}{until}{note}")


def _commands(row: Row) -> Iterator[str]:
    """Yield the commands that fit an episode."""
    words = page.WORDS["commands"]
    yield words["title"]
    if row["status"] not in ("merged", "withdrawn"):
        yield words["label" if row["label"] is None else "instead"].format(**row)
    if row["explains"] or row["label"] in ("false_alarm", "new_program"):
        yield words["calibrate"]
    yield words["limits"]


def _show_cells(out: page.Out, cells: Sequence[Row], kind: TimeKind, shown_in: dt.tzinfo) -> None:
    if cells:
        before = ", ".join(str(axis["samples_before"]) for axis in cells[0]["axes"])
        page.say(out, f"where it went instead (values {before} samples before; bins from the healthy):")
        edges = ("first", "last")
        rows = [row | {edge: time_of(row[f"{edge}_tick"], kind) for edge in edges} for row in cells]
        has_programs = any(row["program"] is not None for row in rows)
        programs: dict[str, page.Cell] = {"program": "program"} if has_programs else {}
        columns: dict[str, page.Cell] = {
            **programs,
            "vectors": "visits",
            **page.when("first", "first", rows, shown_in),
            **page.when("last", "last", rows, shown_in),
            "values": lambda row: " | ".join(map(_interval, row["axes"])),
            "bins": lambda row: " ".join(f"{axis['displacement']:+d}" for axis in row["axes"]),
        }
        page.table(out, rows, columns, left=("program", "values", "bins"))


def _interval(row: Row) -> str:
    ends = [row[name] for name in ("value_from", "value_to")]
    if row["place"] == "within":
        return " to ".join(f"{end:.4g}" for end in ends)
    return f"{row['place']} {next(end for end in ends if end is not None):.4g}"


#: What is told of a band of values.
_OF_BAND: Mapping[str, page.Cell] = {
    "value": _interval,
    "novel": "novel",
    "vectors": "visits",
    "more than in calibration": lambda row: f"{row['excess']:,.1f}",
}


def _show_messages(out: page.Out, rows: Sequence[Row], newest: int, shown_in: dt.tzinfo) -> None:
    """Print one line per message, each behind the newest change that is known by then."""
    for row in rows:
        name = printable(f"{row['asset']} {row['channel']}")
        when = page.time_text(row["noticed_at"], shown_in, named=True)
        others = row["signals_together"] - 1
        beside = f" and {number_of(others, 'other signal')}" if others > 0 else ""
        by = ", by its indicator: no rate can be stated" if row["basis"] == "indicator" else ""
        line = f"episode {row['episode_id']} {row['what']}: {name}{beside}{by}"
        page.say(out, f"{row['seq']}  {when}  {line}")
    if rows and newest > rows[-1]["seq"]:
        page.say(out, f"the newest change is {newest}")
