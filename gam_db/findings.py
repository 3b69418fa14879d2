"""Findings: what the numbers of each channel say to the engineer, and whether they ask for attention.

This module owns the rule of attention and the remarks in plain words. It knows no terminal.

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
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.parameters import Parameters
from gam_db.study import Study

#: Every status, the most urgent first.
STATUSES = ("high", "setup", "waiting", "ok", "not assessed")

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
        course: the health indicator at the end of each bucket; NaN until a window is scored.
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
        return self.status in ("high", "setup")


def findings(study: Study) -> list[Finding]:
    """Return the findings of a study, the most urgent first.

    Raises:
        UserError: the source cannot be used.
    """
    support = study.table("support_summary").to_pylist()
    courses = _courses(study.table("bucket_health"))
    settings = {
        (row["asset"], row["channel"]): study.method.settings[row["settings_no"]]
        for row in study.table("channels").to_pylist()
    }
    found = []
    for row in support:
        name = (row["asset"], row["channel"])
        found.append(_finding(row, settings[name], courses.get(name)))
    return sorted(found, key=_urgency)


def need_attention(found: Sequence[Finding]) -> bool:
    """Tell whether a recording needs attention; see the module."""
    return any(one.needs_attention for one in found) or all(one.verdict == "no_data" for one in found)


@dataclass(frozen=True)
class _Course:
    hi: NDArray[np.float64]
    novel: NDArray[np.int64]
    out_of_range: NDArray[np.int64]
    last_time: Any


def _courses(buckets: pa.Table) -> dict[tuple[str, str], _Course]:
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
    return {
        (buckets["asset"][start].as_py(), buckets["channel"][start].as_py()): _Course(
            hi[start:end],
            novel[start:end],
            out_of_range[start:end],
            buckets["last_time"][end - 1].as_py(),
        )
        for start, end in itertools.pairwise(edges)
    }


def _finding(row: Row, setting: Parameters, course: _Course | None) -> Finding:
    limit = None
    if row["floor"] is not None:
        limit = max(2 * row["floor"], row["floor_max"], setting.target_floor)
    hi = None
    if course is not None and not np.isnan(course.hi[-1]):
        hi = float(course.hi[-1])
    scored = 0 if course is None else len(course.hi) * setting.bucket_length
    status = _status(row["verdict"], hi, limit)
    return Finding(
        asset=row["asset"],
        channel=row["channel"],
        status=status,
        support=row,
        window=setting.window,
        limit=limit,
        hi=hi,
        time=None if course is None else course.last_time,
        scored=scored,
        course=np.empty(0) if course is None else course.hi,
        remarks=tuple(_remarks(row, setting, status, hi, limit, scored, course)),
    )


def _status(verdict: str, hi: float | None, limit: float | None) -> str:
    if verdict in ("constant", "no_data"):
        return "not assessed"
    if verdict != "ready":
        return "setup"
    if hi is None or limit is None:
        return "waiting"
    return "high" if hi > limit else "ok"


def _remarks(
    row: Row,
    setting: Parameters,
    status: str,
    hi: float | None,
    limit: float | None,
    scored: int,
    course: _Course | None,
) -> list[str]:
    remarks = []
    verdict = row["verdict"]
    if verdict == "constant":
        remarks.append(f"was constant in calibration{_moved(course)}: not assessable")
    elif verdict == "no_data" and row["lo"] is None:
        remarks.append("no usable sample in calibration: not assessable")
    elif verdict == "no_data":
        remarks.append(
            f"calibration holds no run of {setting.span + 1:,} samples without gap or missing value: "
            "not assessable"
        )
    elif verdict == "too_fine":
        remarks.append(f"grid too fine for its calibration, {row['finest_bins']:,} bins would pass")
    elif verdict == "needs_data":
        remarks.append(f"calibration too short, {_more(row['vectors_needed'])}")
    if status != "not assessed":
        if hi is None:
            remarks.append(f"HI not yet available: {scored:,} of {setting.window:,} vectors scored")
        elif limit is not None and hi > limit:
            remarks.append(f"above its limit of {share(limit)}{_out_of_range(course, setting)}")
        elif limit is not None and course is not None and np.nanmax(course.hi) > limit:
            remarks.append(f"below its limit of {share(limit)} now, was up to {_highest(course)}")
    if row["missing_vectors"]:
        remarks.append(f"{row['missing_vectors']:,} vectors incomplete")
    if row["conflicts"]:
        remarks.append(f"{row['conflicts']:,} instants with different values, the smallest taken")
    return remarks


def share(value: float | None) -> str:
    """Return a share as an engineer reads it: 0.017, 0.88; a dash where there is none."""
    if value is None:
        return "-"
    return f"{value:.3f}" if value < 0.1 else f"{value:.2f}"


def _moved(course: _Course | None) -> str:
    return " and has moved since" if course is not None and course.novel.any() else ""


def _highest(course: _Course) -> str:
    return share(float(np.nanmax(course.hi)))


def _more(vectors_needed: int | None) -> str:
    if vectors_needed is None:
        return "how much more it takes cannot be told yet"
    return f"it takes about {vectors_needed:,} more vectors"


def _out_of_range(course: _Course | None, setting: Parameters) -> str:
    """Tell whether values left the calibrated range, which any threshold would see, or their order."""
    if course is None:
        return ""
    buckets = setting.window // setting.bucket_length
    novel = int(course.novel[-buckets:].sum())
    outside = int(course.out_of_range[-buckets:].sum())
    if not novel:
        return ""
    return f", {100 * outside / novel:.0f} % of the novel vectors out of range"


def _urgency(one: Finding) -> tuple[int, bool, float, str, str]:
    return (
        STATUSES.index(one.status),
        not one.is_above,
        -(one.hi if one.hi is not None else -1.0),
        one.asset,
        one.channel,
    )
