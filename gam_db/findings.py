"""Findings: what the numbers of each channel say to the engineer, and whether they ask for attention.

This module owns the rule of attention and the remarks in plain words, for a recording just studied and
for what is stored of a monitor alike. It knows no terminal.

A channel needs attention in two cases:

* ``high``: its calibration is good (verdict ``ready``) and the last health indicator is above its
  *limit*, the largest of twice the floor, the highest block of calibration, and ``target_floor``: more
  than calibration ever showed, and more than the user is willing to call healthy.
* ``setup``: its calibration is not good enough to be watched (``too_fine``, ``needs_data``).

A channel that was constant in calibration, or has no calibration, cannot be assessed and never raises
an alarm. A recording as a whole needs attention if one of its channels does, or if none has any
calibration: then nothing is watched at all.
"""

import itertools
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.parameters import Parameters
from gam_db.study import Study

#: Every status, the most urgent first.
STATUSES = ("high", "setup", "waiting", "ok", "not assessed")

#: Those that ask for attention.
URGENT = STATUSES[:2]

#: A grid of fewer bins tells little but high from low, and fewer vectors than this fill none: then the
#: advice is a longer calibration, and not a coarser grid.
FEWEST_BINS = 5
FEW_VECTORS = 300

#: What the other columns of a support row say is a count or a share; these are read by name here.
Row = dict[str, Any]


@dataclass(frozen=True)
class Finding:
    """One channel.

    Attributes:
        asset, channel: its names.
        status: "high", "setup", "waiting" (less than a window is scored), "ok" or "not assessed".
        support: its row of the support: verdict, floor, counts.
        window: W, in vectors.
        limit: the health indicator above which it is high; None without a certificate.
        hi: the last health indicator, a share; None until a window is scored.
        time: the instant of the last full bucket as the source tells time; None if there is none.
        scored: vectors in full buckets, missing ones left out.
        course: the health indicator so far, oldest first; NaN until a window is scored.
        remarks: what is to be known, in plain words.
    """

    asset: str
    channel: str
    status: str
    support: Row
    window: int
    limit: float | None
    hi: float | None
    time: Any
    scored: int
    course: NDArray[np.float64]
    remarks: tuple[str, ...]

    @property
    def verdict(self) -> str:
        """The certificate's verdict."""
        return str(self.support["verdict"])

    @property
    def is_above(self) -> bool:
        """Tell whether the health indicator is above the limit, whatever the verdict."""
        return self.hi is not None and self.limit is not None and self.hi > self.limit

    @property
    def needs_attention(self) -> bool:
        """Tell whether somebody should look at it."""
        return self.status in URGENT

    def row(self) -> Row:
        """Return its row of the support, where ``hi`` is the end of a range, and what else is known."""
        return {
            **self.support,
            "status": self.status,
            "needs_attention": self.needs_attention,
            "limit": self.limit,
            "hi_now": self.hi,
            "window": self.window,
            "course": self.course,
            "scored": self.scored,
            "last_time": self.time,
            "remarks": self.remarks,
        }


@dataclass(frozen=True)
class Course:
    """What a channel showed since it is scored.

    Attributes:
        hi: (points,) the health indicator, oldest first; NaN until a window is scored.
        now: its last value; None until a window is scored.
        highest: its highest value; None until a window is scored.
        vectors: scored vectors in full buckets.
        novel, out_of_range: of those of the last window, or of as many as there are.
        has_moved: a vector was novel at some time.
        time: the instant of the last full bucket as the source tells time.
    """

    hi: NDArray[np.float64]
    now: float | None
    highest: float | None
    vectors: int
    novel: int
    out_of_range: int
    has_moved: bool
    time: Any


def findings(study: Study) -> list[Finding]:
    """Return the findings of a study, the most urgent first.

    Raises:
        UserError: the source cannot be used.
    """
    buckets = study.table("bucket_health")  # first: what it proves of the samples serves the rest
    support = study.table("support_summary").to_pylist()
    settings = {
        (row["asset"], row["channel"]): study.method.settings[row["settings_no"]]
        for row in study.table("channels").to_pylist()
    }
    courses = _courses(buckets, settings)
    found = []
    for row in support:
        name = (row["asset"], row["channel"])
        found.append(finding(row, settings[name], courses.get(name)))
    return sorted(found, key=urgency)


def finding(row: Row, setting: Parameters, course: Course | None) -> Finding:
    """Return the finding of one channel.

    Args:
        row: what was learnt of it, as in the support.
        setting: its parameters.
        course: what it showed; None while no bucket is full.
    """
    limit = limit_of(row["floor"], row["floor_max"], setting.target_floor)
    hi = None if course is None else course.now
    status = status_of(row["verdict"], hi, limit)
    return Finding(
        asset=row["asset"],
        channel=row["channel"],
        status=status,
        support=row,
        window=setting.window,
        limit=limit,
        hi=hi,
        time=None if course is None else course.time,
        scored=0 if course is None else course.vectors,
        course=np.empty(0) if course is None else course.hi,
        remarks=tuple(_remarks(row, setting, status, limit, course)),
    )


def limit_of(floor: float | None, floor_max: float | None, target_floor: float) -> float | None:
    """Return the health indicator above which a channel is high; None without a certificate."""
    if floor is None or floor_max is None:
        return None
    return max(2 * floor, floor_max, target_floor)


def status_of(verdict: str, hi: float | None, limit: float | None) -> str:
    """Return the status of a channel: its verdict, and its health indicator against the limit."""
    if verdict in ("constant", "no_data"):
        return "not assessed"
    if verdict != "ready":
        return "setup"
    if hi is None or limit is None:
        return "waiting"
    return "high" if hi > limit else "ok"


def urgency(one: Finding) -> tuple[int, bool, float, str, str]:
    """Return what findings are sorted by, the most urgent first."""
    return (
        STATUSES.index(one.status),
        not one.is_above,
        -(one.hi if one.hi is not None else -1.0),
        one.asset,
        one.channel,
    )


def need_attention(found: Sequence[Finding]) -> bool:
    """Tell whether a recording needs attention; see the module."""
    return any_needs_attention((one.status, one.verdict) for one in found)


def any_needs_attention(channels: Iterable[tuple[str, str]]) -> bool:
    """Tell the same from the statuses and verdicts of all channels."""
    known = set(channels)
    return any(status in URGENT for status, _ in known) or {verdict for _, verdict in known} <= {
        "no_data"
    }


def _courses(
    buckets: pa.Table, settings: Mapping[tuple[str, str], Parameters]
) -> dict[tuple[str, str], Course]:
    """Cut the buckets, which come in order, into one course per channel."""
    if not buckets.num_rows:
        return {}
    names = [buckets[role].combine_chunks().dictionary_encode() for role in ("asset", "channel")]
    codes = [np.asarray(name.indices) for name in names]
    changed = (np.diff(codes[0]) != 0) | (np.diff(codes[1]) != 0)
    edges = [0, *(np.flatnonzero(changed) + 1).tolist(), buckets.num_rows]
    hi = buckets["hi"].to_numpy()
    novel = buckets["novel"].to_numpy()
    out_of_range = buckets["out_of_range"].to_numpy()
    courses = {}
    for start, end in itertools.pairwise(edges):
        name = (buckets["asset"][start].as_py(), buckets["channel"][start].as_py())
        setting = settings[name]
        window = slice(max(start, end - setting.window // setting.bucket_length), end)
        course = hi[start:end]
        is_complete = not np.isnan(course[-1])
        courses[name] = Course(
            hi=course,
            now=float(course[-1]) if is_complete else None,
            highest=float(np.nanmax(course)) if is_complete else None,
            vectors=len(course) * setting.bucket_length,
            novel=int(novel[window].sum()),
            out_of_range=int(out_of_range[window].sum()),
            has_moved=bool(novel[start:end].any()),
            time=buckets["last_time"][end - 1].as_py(),
        )
    return courses


def _remarks(
    row: Row, setting: Parameters, status: str, limit: float | None, course: Course | None
) -> list[str]:
    has_moved = course is not None and course.has_moved
    remarks = shortcomings(row, setting.span, has_moved)
    hi = None if course is None else course.now
    if status != "not assessed":
        if course is None or hi is None:
            scored = 0 if course is None else course.vectors
            remarks.append(f"HI not yet available: {scored:,} of {setting.window:,} vectors scored")
        elif limit is not None and hi > limit:
            remarks.append(f"above its limit of {share(limit)}{_out_of_range(course)}")
        elif limit is not None and course.highest is not None and course.highest > limit:
            remarks.append(f"below its limit of {share(limit)} now, was up to {share(course.highest)}")
    if row.get("missing_vectors"):
        remarks.append(f"{row['missing_vectors']:,} vectors incomplete")
    if row.get("conflicts"):
        remarks.append(f"{row['conflicts']:,} instants with different values, the smallest taken")
    return remarks


def shortcomings(row: Row, span: int, has_moved: bool = False) -> list[str]:
    """Return why a channel cannot be watched, and what would help; nothing for a good calibration.

    Args:
        row: what was learnt of it: verdict, lo, finest_bins, vectors_needed, and calibration_vectors
            where they are known.
        span: samples between the oldest and the newest of a vector.
        has_moved: a vector was novel since.
    """
    verdict = row["verdict"]
    if verdict == "constant":
        return [f"was constant in calibration{' and has moved since' * has_moved}: not assessable"]
    if verdict == "no_data" and row["lo"] is None:
        return ["no usable sample in calibration: not assessable"]
    if verdict == "no_data":
        return [
            f"calibration holds no run of {span + 1:,} samples without gap or missing value: "
            "not assessable"
        ]
    if is_short(row):
        return [
            f"too little calibration for a grid of use: calibrate longer, {_more(row['vectors_needed'])}"
        ]
    if verdict == "too_fine":
        return [f"grid too fine for its calibration, {row['finest_bins']:,} bins would pass"]
    if verdict == "needs_data":
        return [f"calibration too short, {_more(row['vectors_needed'])}"]
    return []


def is_short(row: Row) -> bool:
    """Tell whether a coarser grid would pass that shows nothing: only a longer calibration helps.

    Args:
        row: as in :func:`shortcomings`.
    """
    vectors = row.get("calibration_vectors")
    is_few = vectors is not None and vectors < FEW_VECTORS
    return bool(row["verdict"] == "too_fine" and (is_few or row["finest_bins"] < FEWEST_BINS))


def share(value: float | None) -> str:
    """Return a share as an engineer reads it: 0.017, 0.88; a dash where there is none."""
    if value is None:
        return "-"
    return f"{value:.3f}" if value < 0.1 else f"{value:.2f}"


def _more(vectors_needed: int | None) -> str:
    if vectors_needed is None:
        return "how much more it takes cannot be told yet"
    return f"it takes about {vectors_needed:,} more vectors"


def _out_of_range(course: Course) -> str:
    """Tell whether values left the calibrated range, which any threshold would see, or their order."""
    if not course.novel:
        return ""
    return f", {100 * course.out_of_range / course.novel:.0f} % of the novel vectors out of range"
