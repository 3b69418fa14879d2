"""Findings: the numbers of each channel in plain words for engineers.

``sql/judgement/`` decides which channels are high and need attention. This module owns the remarks,
both for a recording that was just studied and for a stored monitor. It prints nothing.
"""

import datetime as dt
import itertools
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db import data
from gam_db.alarms import Alarms, add_status
from gam_db.clock import TimeKind, shown_instant, shown_length, time_of
from gam_db.errors import printable
from gam_db.settings.parameters import Parameters
from gam_db.study import Study

#: How channels are sorted: the most urgent first.
ORDER = (
    ("urgency", "descending"),
    ("hi", "descending"),
    ("asset", "ascending"),
    ("channel", "ascending"),
)

#: A grid of fewer bins tells high from low and little else, so the advice is a longer calibration.
FEWEST_BINS = 5

_SHORTCOMINGS = data.table("gam_db", "findings.toml")

#: The beginning of the remark that every channel with a probe has.
SEES = "sees "

#: The changes other than shifts that a channel may show, in words.
_CHANGES = {
    "sees_half_stroke": "half a stroke",
    "sees_frozen": "a frozen sensor",
    "sees_faster": "1.5 times as fast",
    "sees_slower": "two thirds as fast",
}

#: Columns of intermediate results.
_INNER = ("behind", "still_tick", "has_limit", "raised", "asks", "sure", "since_tick")

#: A row of results, by the names of its columns.
Row = dict[str, Any]


@dataclass(frozen=True)
class Course:
    """The scores of a channel over time."""

    hi: NDArray[np.float64]  # (points,) the health indicator, oldest first; NaN until a window is scored
    highest: float | None  # its highest value; None until a window is scored
    vectors: int  # scored vectors in full buckets
    novel: int  # novel, out_of_range: of those of the last window, or of as many as there are
    out_of_range: int
    has_moved: bool  # whether any vector was novel
    since: Any = None  # the instant at which the first point begins, in times of the source
    time: Any = None  # that of the last full bucket


def findings(study: Study, alarms: Alarms | None = None, longest: int | None = None) -> list[Row]:
    """Return the findings on each channel, the most urgent first.

    A row holds the calibration of the channel (*support_summary*), its status (*standing*) as of its
    newest window, what :func:`finding` adds, and its end: ``silent`` and ``still_since``. A silent
    channel ends more than *longest* steps of the clock before the newest data.

    Raises:
        UserError: the source cannot be used, or the rate does not fit its time.
    """
    alarms = alarms or Alarms()
    kind = study.method.kind
    alarms.rate_for(kind)  # a rate that does not fit is refused before all is read
    buckets = study.table("bucket_health")  # first: what it proves of the samples serves the rest
    supports = {(row["asset"], row["channel"]): row for row in study.rows("support_summary")}
    settings = {
        (row["asset"], row["channel"]): study.method.settings[row["settings_no"]]
        for row in study.rows("channels")
    }
    courses = _courses(buckets, settings)
    ends = {(row["asset"], row["channel"]): row["latest"] for row in study.rows("names")}
    newest = max((end for end in ends.values() if end is not None), default=None)
    add_status(study, alarms)
    finding_rows = []
    for row in study.table("standing").sort_by(list(ORDER)).to_pylist():
        name = (row["asset"], row["channel"])
        setting, course, since = settings[name], courses.get(name), row["still_tick"]
        row = {"bins": setting.grid, **supports[name], **row, **ended(ends[name], newest, longest)}
        finding_row = finding(row, setting.span, setting.window, course)
        finding_row["remarks"] += [*at_end(row, since, kind), *_of_episode(row)]
        still = None if since is None else time_of(since, kind)
        if isinstance(still, dt.datetime) and not kind.has_zone:
            still = still.replace(tzinfo=None)  # as the source tells time
        finding_row |= {"still_since": still, "last_time": None if course is None else course.time}
        finding_rows.append({key: value for key, value in finding_row.items() if key not in _INNER})
    return finding_rows


def ended(end: int | None, newest: int | None, longest: int | None) -> Row:
    """Return how far a channel ends before the newest data (``behind``), and whether it is ``silent``.

    Its end is None if it never had data; *longest* is as for :func:`findings`.
    """
    behind = None if end is None or newest is None else newest - end
    return {"behind": behind, "silent": longest is not None and (behind is None or behind > longest)}


def at_end(row: Row, still_since: int | None, kind: TimeKind) -> list[str]:
    """Return the remarks on a signal that is silent, by :func:`ended`, or stands still."""
    remarks = []
    if row["silent"] and row["behind"] is None:
        remarks.append("silent: it never had data")
    elif row["silent"]:
        remarks.append(f"silent: {shown_length(row['behind'], kind)} behind the newest data")
    return remarks + standing(still_since, kind)


def standing(still_since: int | None, kind: TimeKind) -> list[str]:
    """Return the remark on a signal that stands still since an instant; none for None."""
    if still_since is None:
        return []
    return [f"stands still since {shown_instant(still_since, kind)}{'' if kind.is_counter else ' UTC'}"]


def finding(row: Row, span: int, window: int, course: Course | None) -> Row:
    """Return the row of a channel with its course and remarks.

    Args:
        row: its calibration and its status.
        span: samples between the oldest and the newest of a vector.
        window: W, in vectors.
        course: its scores over time; None while no bucket is full.

    Returns:
        The row, and ``window``; ``course``, (points,) the health indicator so far, oldest first, NaN
        until a window is scored; ``course_from``, when it begins; ``scored``, vectors in full buckets;
        ``remarks``, a list of texts.
    """
    return {
        **row,
        "needs_attention": bool(row["needs_attention"]),
        "window": window,
        "course": np.empty(0) if course is None else course.hi,
        "course_from": None if course is None else course.since,
        "scored": 0 if course is None else course.vectors,
        "remarks": _remarks(row, span, window, course),
    }


def is_blind(row: Row) -> bool:
    """Tell whether a channel would show no shift of its machine, for any status."""
    return bool(row["verdict"] == "blind")


def need_attention(rows: Iterable[Row]) -> bool:
    """Tell whether a channel needs attention."""
    return any(row["needs_attention"] for row in rows)


def lack_data(rows: Iterable[Row]) -> bool:
    """Tell whether a channel lacks data for calibration, or no channel can be judged."""
    verdicts = {row["verdict"] for row in rows}
    return "no_data" in verdicts or verdicts <= {"constant"}


def by_channel(rows: pa.Table) -> dict[tuple[str, str], slice]:
    """Return the slice of the rows of each channel; rows of a channel must be adjacent."""
    if not rows.num_rows:
        return {}
    names = [rows[role].combine_chunks().dictionary_encode() for role in ("asset", "channel")]
    asset, channel = (np.asarray(name.indices) for name in names)
    changed = (np.diff(asset) != 0) | (np.diff(channel) != 0)
    edges = [0, *(np.flatnonzero(changed) + 1).tolist(), rows.num_rows]
    return {
        (rows["asset"][start].as_py(), rows["channel"][start].as_py()): slice(start, end)
        for start, end in itertools.pairwise(edges)
    }


def _courses(
    buckets: pa.Table, settings: Mapping[tuple[str, str], Parameters]
) -> dict[tuple[str, str], Course]:
    """Cut the buckets, which come in order, into one course per channel."""
    hi, novel, out_of_range = (
        buckets[name].to_numpy(zero_copy_only=False) for name in ("hi", "novel", "out_of_range")
    )
    courses = {}
    for name, mine in by_channel(buckets).items():
        setting, start, end = settings[name], mine.start, mine.stop
        window = slice(max(start, end - setting.window // setting.bucket_length), end)
        course = hi[mine]
        is_complete = not np.isnan(course[-1])
        courses[name] = Course(
            hi=course,
            highest=float(np.nanmax(course)) if is_complete else None,
            vectors=len(course) * setting.bucket_length,
            novel=int(novel[window].sum()),
            out_of_range=int(out_of_range[window].sum()),
            has_moved=bool(novel[mine].any()),
            since=buckets["first_time"][start].as_py(),
            time=buckets["last_time"][end - 1].as_py(),
        )
    return courses


def _remarks(row: Row, span: int, window: int, course: Course | None) -> list[str]:
    remarks = [*vouching(row), *shortcomings(row, span, course is not None and course.has_moved)]
    hi, limit = row["hi"], row["hi_limit"]
    if row["status"] != "not assessed":
        if course is None or hi is None:
            scored = 0 if course is None else course.vectors
            remarks.append(f"HI not yet available: {scored:,} of {window:,} vectors scored")
        elif limit is not None and hi > limit:
            so_far = ", without an episode so far" if row["is_above"] != 1 else ""
            if row["status"] == "labelled":
                so_far = f", labelled {row['label']}"
            far = "far " * bool(row["is_far_above"])
            left = ""  # the calibrated range, which any threshold would see
            if course.novel:
                part = 100 * course.out_of_range / course.novel
                left = f", {part:.0f} % of the novel vectors out of range"
            remarks.append(f"{far}above its limit of {share(limit)}{left}{so_far}")
        elif limit is not None and course.highest is not None and course.highest > limit:
            remarks.append(f"below its limit of {share(limit)} now, was up to {share(course.highest)}")
    remarks += [*sight(row), *dropped(row)]
    if row.get("missing_vectors"):
        remarks.append(f"{row['missing_vectors']:,} vectors incomplete")
    if row.get("conflicts"):
        remarks.append(f"{row['conflicts']:,} instants with different values, the smallest taken")
    return remarks


def _of_episode(row: Row) -> list[str]:
    if row["episode"] is None:
        return []
    over = "" if row["is_open"] else ", over"
    proving = ", right after calibration: calibration was not a fair sample, or something changed"
    onset = row["onset"]
    since = f"{onset:,}" if isinstance(onset, int) else f"{onset:%Y-%m-%d %H:%M} UTC"
    return [f"episode since {since}{over}{proving * (row['status'] == 'proving')}"]


def shortcomings(row: Row, span: int, has_moved: bool = False) -> list[str]:
    """Return why a channel cannot be watched, and what would help; empty for a good calibration.

    *row* has verdict, calibrated_lo, finest_bins and vectors_needed; *span* counts the samples between
    the oldest and the newest of a vector; *has_moved* tells whether a vector was novel since.
    """
    shortcoming = row["verdict"]
    if row.get("limit_reason") == "unrepresentative":
        shortcoming = "unrepresentative"
    elif shortcoming == "no_data" and row["calibrated_lo"] is None:
        shortcoming = "no_sample"
    elif is_short(row):
        shortcoming = "short"
    elif shortcoming == "blind":
        shortcoming = f"blind_{row['blind_reason']}"
    more, needed = "it needs more vectors, but how many is not known yet", row["vectors_needed"]
    if needed is not None:
        more = f"it needs about {needed:,} more vectors"
    words = {"run": span + 1, "bins": row["finest_bins"], "more": more}
    if shortcoming == "blind_range":
        lo, hi = row["calibrated_lo"], row["calibrated_hi"]
        part = 100 * (row["usual_high"] - row["usual_low"]) / (hi - lo)
        words |= {"lo": lo, "hi": hi, "part": f"{part:.2g}"}
    moved = " and has moved since" * has_moved
    return (
        [_SHORTCOMINGS[shortcoming].format(moved=moved, **words)] if shortcoming in _SHORTCOMINGS else []
    )


def vouching(row: Row) -> list[str]:
    """Return whose calibration judges a channel of a pool; empty for a channel without a pool.

    *row* has vouched_by, taught_by, floor and member_floor (both sides, section 6).
    """
    teachers, floor = printable(row["taught_by"] or ""), row["member_floor"]
    if row["vouched_by"] == 1:
        return [f"not vouched: only {teachers} taught"]
    if row["vouched_by"] is not None:
        return [f"judged by {teachers}; of itself nothing is known"]
    return (
        []
        if floor is None
        else [f"taught by {teachers}; floor by leaving one machine out {share(floor)}"]
    )


def sight(row: Row) -> list[str]:
    """Return which changes of the machine a channel would show, and which it would not.

    *row* has the columns of :func:`gam_db.support` on them (both sides, section 3).
    """
    seen = [] if row["sees"] is None else [f"shifts of {row['sees']} % of its usual range"]
    seen += [words for name, words in _CHANGES.items() if row[name]]
    remarks = [f"{SEES}{', '.join(seen)}"] if seen else []
    if row["would_not_see"]:
        is_ok = "ok; " if row.get("status") == "ok" else ""
        remarks.append(f"{is_ok}would not see {row['would_not_see']}")
    return remarks


def dropped(row: Row) -> list[str]:
    """Return which calibration samples were left out of a channel's range; empty if none.

    *row* has the columns of :func:`gam_db.support` on its range.
    """
    parts = []
    for side, value, words in (
        ("dropped_below", "lowest_dropped", "down to"),
        ("dropped_above", "highest_dropped", "up to"),
    ):
        if count := row[side]:
            of = "reading of" if count == 1 else f"readings {words}"
            parts.append(f"{count:,} {of} {row[value]:g}")
    if not parts:
        return []
    lo, hi = row["calibrated_lo"], row["calibrated_hi"]
    return [f"{' and '.join(parts)} left out of the range {lo:g} to {hi:g}"]


def is_short(row: Row) -> bool:
    """Tell whether only a grid too coarse to be useful would pass, so only longer calibration helps."""
    return bool(row["verdict"] == "too_fine" and row["finest_bins"] < FEWEST_BINS)


def share(value: float | None) -> str:
    """Return a share for engineers: 0.017, 0.88; a dash for None."""
    if value is None:
        return "-"
    return f"{value:.3f}" if value < 0.1 else f"{value:.2f}"
