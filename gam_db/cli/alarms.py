"""``gam alarms``, ``alarm``, ``label``, ``limits``, ``backtest``: episodes, labels and limits."""

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
from gam_db.cli.render import WORDS, Page, Section, Table, Verbatim, show, time_text
from gam_db.clock import TimeKind, time_of, zone
from gam_db.errors import ConfigurationError, printable, wrong
from gam_db.findings import Row
from gam_db.settings.calibration import Calibration
from gam_db.settings.setting import settings_of
from gam_db.stored.alarms import labels as stored
from gam_db.stored.alarms import limits as stored_limits
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
            show(Page(streamed, _messages(messages, newest, shown_in)), common)
            return
        rows, judged = stored.alarms(state, name).to_pylist(), stored.limits(state, name)
    urgent = any(row["needs_attention"] for row in rows)
    overview = {"episodes": rows, "limits": promised(judged), "needs_attention": urgent}

    def sections() -> Iterator[Section]:
        watched = any(row["reason"] is None or row["basis"] == "indicator" for row in judged)
        none = "no signal was ever raised" if watched else "no signal is watched, so none can be raised"
        count = number_of(len(rows), "episode") if rows else none
        yield f"{heading(settings)}: {count}"
        yield from limit_lines(judged)
        yield from _episodes(common.of(rows, _SHOWN), shown_in)
        yield from page.cut(rows, common.everything, most=_SHOWN)

    show(Page({**place(settings), **overview}, sections(), urgent), common)


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

    def sections() -> Iterator[Section]:
        if advice is not None:
            yield from (printable(advice.finding), printable(f"What to do next: {advice.advice}"), "")
        yield from (*_facts(episode_row, shown_in), "")
        judged = [{**row, "until": time_of(row["last_time"], kind)} for row in details["judgements"]]
        yield WORDS["alarm"]["judgements"].format(window=episode_row["window_length"] or 0)
        yield Table("judgements", judged, lambda row: "!" if row["is_open"] else " ", shown_in)
        if details["bands"]:
            yield WORDS["alarms"]["bands"]
            yield Table("bands", [{**row, "band": row} for row in details["bands"]])
        yield from _cells(details["cells"], kind, shown_in)
        if details["raw_rows"] is not None:
            yield WORDS["alarm"]["rows"]
            yield Verbatim(f"{details['raw_rows']};")
        yield Verbatim("\n".join(("", *_commands(episode_row))))

    show(Page({"monitor": name, **episode_row, **details}, sections()), common)


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
    show(Page(labelled, _label_lines(first, kind, rows, judged)), common)


def _label_lines(
    first: str, kind: str, rows: Sequence[Row], judged: Mapping[tuple[str, str], str | None]
) -> Iterator[str]:
    """Yield the labelled episodes, and what follows from the label."""
    texts = WORDS["label"]
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

    def sections() -> Iterator[Section]:
        yield from limit_lines(rows)
        name = page.name_in(common.of(rows))
        shown = [
            {**row, "name": name(row), "blocks": row["blocks"] or 0}
            | ({} if row["reason"] is None else {"height": None})
            for row in common.of(rows)
        ]
        yield Table("limits", shown, lambda row: " " if row["reason"] is None else "?")
        yield from page.cut(rows, common.everything)

    figures = {"monitor": settings.monitor.name, **promised(rows), "channels": rows}
    show(Page(figures, sections()), common)


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
    show(Page({**job.figures(), **backtested}, _backtest_lines(backtested)), common)


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
    """Yield the promise of some limits, and the channels without one."""
    promise = promised(rows)
    if promise["judged"]:
        bases = ", ".join(f"{count:,} by {basis}" for basis, count in sorted(promise["basis"].items()))
        line = f"target rate: {'; '.join(promise['asked'])} ({bases})"
        if promise["stated"] is not None:
            line += f"; stated rate: {1000 * promise['stated']:.3g} per 1,000 judgements"
        if often := promise["per_day"]:
            line += f", {often:.2g} a day" if often >= 1 else f", 1 in {1 / often:.2g} days"
            line += " of all channels"
        yield line
    if promise["basis"].get("none"):
        count = number_of(promise["basis"]["none"], "channel")
        yield f"{count} without a stated rate; they are judged all the same"
    for reason, count in sorted(promise["withheld"].items()):
        words = WORDS["no_limit"].get(reason, reason)
        yield f"{number_of(count, 'channel')} without a limit: {words}"
    if indicated := sum(row["basis"] == "indicator" for row in rows):
        yield f"{number_of(indicated, 'channel')} judged by the health indicator, without a stated rate"


def _backtest_lines(backtested: Row) -> Iterator[str]:
    """Yield the page of a backtest; rates are per 1,000 judgements."""
    texts = WORDS["backtest"]
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


def _episodes(rows: Sequence[Row], shown_in: dt.tzinfo) -> Iterator[Section]:
    def rate(row: Row) -> str:
        stated: Any = row["stated_rate"]
        return row["basis"] if stated is None else f"{row['basis']}, {1000 * stated:.3g}"

    def mark(row: Row) -> str:
        return _MARKS.get(row["status"], "!") if row["needs_attention"] else " "

    name = page.name_in(rows)
    shown = [{**row, "name": name(row), "rate": rate(row)} for row in rows]
    yield Table("episodes", shown, mark, shown_in)
    for row in {row["incident"]: row for row in rows if row["signals_together"] > 1}.values():
        yield WORDS["alarms"]["together"].format(machine=printable(row["asset"]), **row)


def _facts(row: Row, shown_in: dt.tzinfo) -> Iterator[str]:
    """Yield an episode, its evidence and its label, a line each."""
    words = WORDS["alarm"]
    since, last = (time_text(row[edge], shown_in, named=True) for edge in ("since", "last_time"))
    names = printable(" / ".join((row["asset"], row["channel"])))
    yield words["episode"].format(**row | {"names": names, "since": since, "last_time": last})
    basis = f"basis {row['basis']}"
    if row["stated_rate"] is not None:
        basis += f", stated rate {1000 * row['stated_rate']:.3g} per 1,000 judgements"
    yield words["evidence" if row["sure"] is not None else "indicator"].format(**row | {"basis": basis})
    label = "none yet" if row["label"] is None else row["label"]
    until = "" if row["label_until"] is None else f" until {time_text(row['label_until'], shown_in)}"
    note = "" if row["note"] is None else f" ({row['note']})"
    yield printable(f"feedback: {label}{until}{note}")


def _commands(row: Row) -> Iterator[str]:
    """Yield the commands that fit an episode."""
    words = WORDS["commands"]
    yield words["title"]
    if row["status"] not in ("merged", "withdrawn"):
        yield words["label" if row["label"] is None else "instead"].format(**row)
    if row["explains"] or row["label"] in ("false_alarm", "new_program"):
        yield words["calibrate"]
    yield words["limits"]


def _cells(cells: Sequence[Row], kind: TimeKind, shown_in: dt.tzinfo) -> Iterator[Section]:
    if not cells:
        return
    before = ", ".join(str(axis["samples_before"]) for axis in cells[0]["axes"])
    yield f"where it went instead (values {before} samples before):"
    shown = [
        {**row, **{edge: time_of(row[f"{edge}_tick"], kind) for edge in ("first", "last")}}
        | {"displacements": " ".join(f"{axis['displacement']:+d}" for axis in row["axes"])}
        for row in cells
    ]
    yield Table("cells", shown, zone=shown_in)


def _messages(rows: Sequence[Row], newest: int, shown_in: dt.tzinfo) -> Iterator[str]:
    """Yield one line per message, each behind the newest change that was stored by then."""
    for row in rows:
        name = printable(f"{row['asset']} {row['channel']}")
        when = time_text(row["noticed_at"], shown_in, named=True)
        others = row["signals_together"] - 1
        beside = f" and {number_of(others, 'other signal')}" if others > 0 else ""
        by = ", by its indicator: no rate can be stated" if row["basis"] == "indicator" else ""
        yield f"{row['seq']}  {when}  episode {row['episode_id']} {row['what']}: {name}{beside}{by}"
    if rows and newest > rows[-1]["seq"]:
        yield f"the newest change is {newest}"
