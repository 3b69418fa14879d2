"""The HTML page of a monitor for people: the content of its tables in one file.

This module owns the settings of the page, its queries, the order of signals, and the file.
"""

import base64
import datetime as dt
import hashlib
import html
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gam_db.alarms import figures
from gam_db.alarms.advising import Advice, promise
from gam_db.clock import SECOND, Length, TimeKind, aware, length, zone
from gam_db.composing import template
from gam_db.data import put
from gam_db.data import text as text_of
from gam_db.errors import ConfigurationError, UserError, unwritable, wrong
from gam_db.findings import Row, by_channel
from gam_db.report import details
from gam_db.report.details import Reads
from gam_db.report.packing import in_script, packed, strip, tick
from gam_db.settings.parameters import pattern_matches
from gam_db.settings.setting import COLUMNS, COUNT, FLAG, LENGTH, TEXT, Kind, check, declared, setting
from gam_db.settings.source import AnySource
from gam_db.study.running import Listener, unheard
from gam_db.version import __version__

__all__ = ["Wishes", "page", "write"]

#: A signal is new if its onset is within a day of the newest data, or within its last three windows.
DAY = 86_400 * SECOND

#: Columns of a page, fewer above MANY signals; with more than MOST signals a page is refused.
ALL_COLUMNS, FEW_COLUMNS, MANY, MOST = 240, 120, 10_000, 40_000

#: Most episodes of a page, and the fields of each, with their names in the view.
MOST_ALARMS = 2000
_OF_ALARM = {name: name for name in ("status", "label", "note", "evidence", "height")}
_OF_ALARM |= {"id": "episode_id", "proving": "is_proving"}

#: The fields of each machine, with their names in the view.
_OF_MACHINE = {name: name for name in ("asset", "signals", "watched", "judged", "above", "together")}
_OF_MACHINE |= {"notJudged": "not_judged", "notWatched": "not_watched", "first": "first_channel"}
_OF_MACHINE |= {"strongest": "strongest_channel", "strength": "strength"}

#: The fields of each data problem.
_OF_PROBLEM = ("kind", "asset", "channel", "sentence", "advice")

#: A slot of the HTML frame.
_PLACE = re.compile(r"\{\{([a-z-]+)\}\}")


def _instant(name: str, moment: Any) -> dt.datetime:
    try:
        return aware(moment if isinstance(moment, dt.datetime) else dt.datetime.fromisoformat(moment))
    except (TypeError, ValueError):
        raise wrong("no_moment", name=name, given=moment) from None


#: An error names the option, or the keyword.
_INSTANT = Kind(lambda _, name, moment: _instant(name, moment), read=_instant)


@declared
@dataclass(frozen=True)
class Wishes:
    """The settings of the page.

    Raises:
        ConfigurationError: there is no such time zone, or another value cannot be used.
    """

    title: str = setting("Fleet health", TEXT)
    details: int = setting(24, COUNT, least=0)
    signals: Sequence[str] = setting((), replace(COLUMNS, option=list[str]))
    since: Length | None = setting(None, LENGTH)
    time_zone: str = setting("UTC", TEXT)
    raw: bool = setting(True, replace(FLAG, read=lambda *_: False))
    asset: str = setting("*", TEXT)
    made: dt.datetime | None = setting(None, _INSTANT)

    def __post_init__(self) -> None:
        check(self, ConfigurationError)
        zone(self.time_zone)


@dataclass(frozen=True)
class Lacking:
    """How many signals are watched (None where that is not known), and the problems of the data.

    A problem has kind, asset, channel, sentence and advice; see :meth:`gam_db.Monitor.data_problems`.
    """

    watched: int | None = None
    problems: Sequence[Row] = ()


def write(
    state: Reads,
    source: AnySource | None,
    kind: TimeKind,
    monitor: str,
    path: str | Path,
    wishes: Wishes | None = None,
    on_step: Listener = unheard,
    lacking: Lacking = Lacking(),
) -> Row:
    """Write the page of a monitor as one self-contained HTML file; replace an existing file.

    Without a source of its telemetry, the page has no raw readings. It shows data problems apart from
    the states of machines.

    Returns:
        Figures: path, bytes, machines, signals, details, above, new, and raw: why the page has no raw
        readings, or None.

    Raises:
        UserError: there is no such monitor, the patterns match no signal, or the file cannot be written.
    """
    wishes = wishes or Wishes()
    path = Path(path)
    on_step("reading the tables")
    signals = _signals(state, monitor, wishes)
    courses = _ranked(signals, _courses(state, monitor, signals), kind)
    first, last = _frame(signals, courses, kind, wishes)
    picked = details.chosen(signals, wishes.details, wishes.signals)
    raw = None
    why: str | None = "left out" if not wishes.raw else "the source is not known"
    if wishes.raw and source is not None and picked:
        on_step("reading raw readings of the signals in detail")
        try:
            theirs = [courses[row["place"]] for row in picked]
            raw, why = details.read(state.session, source, picked, theirs, last), None
        except UserError as error:
            why = f"the source could not be read: {str(error).partition(';')[0]}"
    on_step("writing the page")
    columns = ALL_COLUMNS if len(signals) <= MANY else FEW_COLUMNS
    rows = []
    for row, course in zip(signals, courses, strict=True):
        spans, learnt = (course["first"], course["last"], course["hi"]), None
        if row["learnt_from"] is not None and row["calibration_end"] is not None:
            learnt = row["learnt_from"], row["calibration_end"]
        rows.append(strip(spans, row["hi_limit"], learnt, (first, last, columns)))
    shown, grown = {}, details.growth(state, monitor, picked)
    cells = details.cells(state, picked, wishes.raw)
    for number, row in enumerate(picked):
        mine = None if raw is None else (raw[0][number], raw[1][number])
        detail = details.detail(state, row, courses[row["place"]], mine)
        detail["growth"] = grown[row["asset"], row["channel"]]
        shown[row["place"]] = detail | cells[row["version_id"]]
    machines = _machines(state, monitor, signals)
    place_of = {row["asset"]: number for number, row in enumerate(machines)}
    summaries = [details.summary(row, wishes.raw) for row in signals]
    moment = wishes.made or dt.datetime.now(dt.UTC)
    data = {
        "version": __version__,
        "title": wishes.title,
        "monitor": monitor,
        "made": int(moment.timestamp() * SECOND),
        "zone": wishes.time_zone,
        "counter": kind.is_counter,
        "first": tick(first),
        "last": tick(last),
        "columns": columns,
        "noRaw": why,
        "validity": _validity(state, monitor),
        "machines": {name: [row[name] for row in machines] for name in machines[0]},
        "machine": [place_of[row["asset"]] for row in signals],
        "signals": {name: [summary[name] for summary in summaries] for name in summaries[0]},
        "alarms": _alarms(state, monitor, signals),
        "promise": _promise(state, monitor, signals),
        "watched": lacking.watched,
        "problems": {name: [row[name] for row in lacking.problems] for name in _OF_PROBLEM},
        "strips": packed(np.array(rows).reshape(-1), "u1"),
        "details": {str(place): detail for place, detail in sorted(shown.items())},
    }
    text = page(data, wishes.title).encode()
    try:
        put(path, text)
    except OSError as error:
        raise unwritable(path, error) from error
    return {
        "path": str(path),
        "bytes": len(text),
        "machines": len(machines),
        "signals": len(signals),
        "details": len(shown),
        "above": sum(row["is_above"] == 1 for row in signals),
        "new": sum(row["is_new"] for row in signals),
        "raw": why,
    }


def page(data: Row, title: str, script: str | None = None) -> str:
    """Return the HTML file around the data; its policy allows only its own script and style.

    Another script may be given than that which comes with gam-db.
    """
    script = script or text_of("gam_db.report", "page/page.js")
    script = script.strip().replace("</script", "<\\/script")
    style = text_of("gam_db.report", "page/page.css").strip()
    frame = text_of("gam_db.report", "page/page.html")
    filled = {
        "title": html.escape(title),
        "script-hash": _hash(script),
        "style-hash": _hash(style),
        "style": style,
        "data": in_script(data),
        "script": script,
    }
    # In one pass: a machine may be called like a place.
    return _PLACE.sub(lambda place: filled[place[1]], frame)


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _signals(state: Reads, monitor: str, wishes: Wishes) -> list[Row]:
    rows = state.rows("report/signals", {"monitor": template.text(monitor)})
    rows = [row for row in rows if pattern_matches(wishes.asset, row["asset"])]
    if not rows:
        raise wrong("nothing_to_report", monitor=monitor, asset=wishes.asset)
    if len(rows) > MOST:
        raise wrong("too_many_to_report", count=len(rows), most=MOST)
    return rows


def _ranked(
    signals: list[Row], courses: Sequence[dict[str, NDArray[Any]]], kind: TimeKind
) -> list[dict[str, NDArray[Any]]]:
    """Put the signals in order, the most urgent first, and return their courses in that order."""
    newest = max((row["data_tick"] for row in signals if row["data_tick"] is not None), default=None)
    for row in signals:
        limit, hi = row["hi_limit"], row["hi"]
        is_above = row["is_above"] == 1
        far = max((hi or 0.0) - limit, 0.0) / max(1 - limit, 1e-9) if is_above else 0.0
        row["is_new"] = is_above and _is_new(row, courses[row["place"]], kind, newest)
        row["urgency"] = (
            3 * row["is_new"]
            + is_above
            + far
            + 0.5 * row["is_rising"]
            - (row["is_above"] is None or row["status"] == "labelled")
        )
    signals.sort(key=lambda row: (-row["urgency"], -(row["hi"] or 0.0), row["asset"], row["channel"]))
    ordered = [courses[row["place"]] for row in signals]
    for place, row in enumerate(signals):
        row["place"] = place
    return ordered


def _is_new(row: Row, course: dict[str, NDArray[Any]], kind: TimeKind, newest: int | None) -> bool:
    if row["since_tick"] is None or row["at_least"] or newest is None:
        return False
    if not kind.is_counter and row["since_tick"] > newest - DAY:
        return True
    buckets = max(1, 3 * row["window_length"] // row["stride"])  # an onset lies before the opening
    return bool(row["since_tick"] >= course["first"][-buckets:][0])


def _machines(state: Reads, monitor: str, signals: Sequence[Row]) -> list[Row]:
    """Return the machines of the signals, the most urgent first."""
    shown = {row["asset"] for row in signals}
    return [
        {
            **{name: row[of] for name, of in _OF_MACHINE.items()},
            "since": tick(row["since_tick"]),
            "at": tick(row["data_tick"]),
        }
        for row in state.rows("report/machines", {"monitor": template.text(monitor)})
        if row["asset"] in shown
    ]


def _validity(state: Reads, monitor: str) -> Row | None:
    """Return how many readings the newest run checked by valid_when, and how many did not meet it."""
    rows = state.rows("stored/state/validity", {"monitor": template.text(monitor)})
    return rows[0] if rows else None


def _alarms(state: Reads, monitor: str, signals: Sequence[Row]) -> dict[str, list[Any]]:
    """Return the episodes of the signals in columns, open ones first, then the newest."""
    place = {(row["asset"], row["channel"]): row["place"] for row in signals}
    rows = _episodes(state, monitor, signals)[:MOST_ALARMS]
    raised = state.rows("stored/alarms/alarm_rows", {"monitor": template.text(monitor)})
    counted = figures.with_figures(raised, figures.figures(state.rows, monitor))
    advice = figures.advice_of(counted)
    advices = [advice[row["episode_id"]] or Advice("", "") for row in rows]
    return {
        "signal": [place[row["asset"], row["channel"]] for row in rows],
        **{name: [row[of] for row in rows] for name, of in _OF_ALARM.items()},
        **{name: [tick(row[f"{name}_tick"]) for row in rows] for name in ("since", "last")},
        "finding": [words.finding for words in advices],
        "advice": [words.advice for words in advices],
    }


def _episodes(state: Reads, monitor: str, signals: Sequence[Row]) -> list[Row]:
    """Return the episodes of the signals, without those that were merged into another."""
    named = {(row["asset"], row["channel"]) for row in signals}
    rows = state.rows("report/alarms", {"monitor": template.text(monitor)})
    return [row for row in rows if (row["asset"], row["channel"]) in named]


def _promise(state: Reads, monitor: str, signals: Sequence[Row]) -> str | None:
    """Return what the stated rate means for the episodes of the signals, in a sentence."""
    named = {(row["asset"], row["channel"]) for row in signals}
    rows = state.rows("report/promises", {"monitor": template.text(monitor)})
    rows = [row for row in rows if (row["asset"], row["channel"]) in named]
    raised = _episodes(state, monitor, signals)
    return promise(rows, sum(row["status"] != "withdrawn" for row in raised))


def _courses(state: Reads, monitor: str, signals: Sequence[Row]) -> list[dict[str, NDArray[Any]]]:
    rows = state.fetch("report/course", {"monitor": template.text(monitor)})
    places, nowhere = by_channel(rows), slice(0, 0)
    names = {"first": "first_tick", "last": "last_tick", "novel": "novel", "outside": "out_of_range"}
    column = {short: rows[name].to_numpy() for short, name in names.items()}
    column["hi"] = rows["hi"].to_numpy(zero_copy_only=False).astype(np.float64)
    courses = []
    for place, row in enumerate(signals):
        mine = places.get((row["asset"], row["channel"]), nowhere)
        row["place"], row["bucket_count"] = place, mine.stop - mine.start
        courses.append({name: values[mine] for name, values in column.items()})
    return courses


def _frame(
    signals: Sequence[Row], courses: Sequence[Any], kind: TimeKind, wishes: Wishes
) -> tuple[int, int]:
    """Return the first and the last instant that strips show."""

    def instants(name: str) -> list[int]:
        return [row[name] for row in signals if row[name] is not None]

    seen = [course for course in courses if len(course["first"])]
    begins = instants("learnt_from") + [int(course["first"][0]) for course in seen]
    ends = instants("data_tick") + [int(course["last"][-1]) for course in seen]
    last = max(ends or instants("calibration_end"), default=0)
    first = min(begins, default=last - 1)
    if wishes.since is not None:
        first = max(first, last - length(wishes.since, kind, "since"))
    return min(first, last - 1), last
