"""Alarms without state tables: judgements, their limits, and episodes (alarms, 2 to 4).

This module owns the settings of alarms, the public calls of that form, and the order in which limits are
computed: statistics of calibration, drift of families, their replay, a height for each channel.
"""

import math
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeAlias

import pyarrow as pa

from gam_db.alarms.heights import LEAST, MOST, STATED_FROM, UNSTATED, Height, Rate, by_replay, by_table
from gam_db.arguments import public
from gam_db.clock import TimeKind, length
from gam_db.columns import COUNT, SHARE, WORD, columns, counts, table_of
from gam_db.errors import wrong
from gam_db.method.adding import add
from gam_db.method.alarms import FAR, NEAR, add_judgements, add_learnt_limits, add_replay
from gam_db.method.judgement import add_judged, add_standing
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.setting import COLUMNS, TEXT, Kind, check, declared, setting
from gam_db.study import Study, studied
from gam_db.study.running import Running
from gam_db.units import with_units

_JUDGED_BLOCKS = 8
_REPLAYED_CHANNELS, _REPLAYED_JUDGEMENTS = 5, 300
_ORDERED_BLOCKS, _DRIFTING_BLOCKS = 18, 40
#: Order ratios in thousandths: no alarm at all, no rate for a channel, and drift of a family.
_UNREPRESENTATIVE, _UNLIKE, _DRIFTING = 1500, 1100, 1050
_LARGEST_EXTENT = 3_000_000_000

#: Why a channel is not judged if its calibration is not a fair sample of what follows.
UNREPRESENTATIVE = "unrepresentative"

Row = dict[str, Any]


#: Something that runs steps: a study, or tables that a calibration stored.
Work: TypeAlias = Study | Running


@public
@declared
@dataclass(frozen=True)
class Alarms:
    """How often a healthy machine may alarm, and which channels are alike.

    Raises:
        ParameterError: a value is out of its range.
    """

    rate: str | None = setting(None, TEXT)
    family: Sequence[str] = setting((), Kind(COLUMNS.checked, list[str]))

    def __post_init__(self) -> None:
        check(self)
        object.__setattr__(self, "family", tuple(self.family))
        if self.rate is not None:
            Rate.of(self.rate)

    def rate_for(self, kind: TimeKind) -> str:
        """Return the requested rate, in words.

        Raises:
            ParameterError: the rate is in days, and the source counts time in integers.
        """
        if self.rate is None:
            return "0.5 per 1000 judgements" if kind.is_counter else "1 per month"
        if kind.is_counter and Rate.of(self.rate).days is not None:
            raise wrong("rate_in_days_on_a_counter", rate=self.rate)
        return self.rate


@public
def judgements(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the judgements of each channel that is judged: full windows that do not overlap.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: of the method; default :class:`Parameters`.
        calibration: the healthy part; default the first fifth of each channel.
        alarms: the requested rate and the families; default :class:`Alarms`.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open connection.

    Returns:
        One row per judgement, ordered: asset, channel, judgement (from 0), first_time, last_time (of its
        vectors, as in the source), novel (of W vectors), root (of that, in thousandths), reference,
        height, evidence (likewise), is_open (0 or 1), last_zero (the latest judgement that an onset
        cannot lie before: without evidence, or open before this one; NULL if there was none).

    Raises:
        UserError: see its subclasses; the message says what to correct.
    """
    with studied(source, parameters, calibration, engine) as study:
        return _judged(study, alarms, "judgements")


@public
def episodes(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the episodes: when channels were raised, and their onsets.

    Arguments and errors as in :func:`judgements`.

    Returns:
        One row per episode, ordered: asset, channel, episode (from 1 in its channel), onset (the
        judgement in which its evidence left 0), first_judgement and last_judgement (the open ones),
        onset_time, first_time, last_time, evidence (the highest), height (1 where its indicator opened
        it, as its judgements have no limit), is_open (1 if it continues), is_proving (1 if it opened
        within as many judgements as calibration has blocks, so that either calibration was not a
        fair sample or something changed right after it).
    """
    with studied(source, parameters, calibration, engine) as study:
        return _judged(study, alarms, "episodes")


@public
def limits(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    engine: Any = None,
) -> pa.Table:
    """Return the limit of each channel, or why it has none (alarms, sections 2 and 3).

    Arguments and errors as in :func:`judgements`.

    Returns:
        One row per channel, ordered: asset, channel, family (from 0), blocks (of calibration, of a
        window or more), g, centre, spread, reference, height, cap (in thousandths of a root), quarters
        (the height in quarters of a spread), basis (replay, extrapolated, table, drifting or none;
        indicator where there is no limit and the health indicator judges, with a height of 1),
        order_ratio (in thousandths, NULL with fewer than 18 blocks), judgements_per_day (NULL on a
        counter), rate (requested, per judgement), stated_rate (that the height is for, at least 0.5 per
        1,000; NULL where none can be stated), reason (why there is no limit: then centre, spread,
        quarters and rates are NULL, and without the indicator all that follows from one is).
    """
    with studied(source, parameters, calibration, engine) as study:
        rows = limits_of(study, alarms or Alarms())
        return with_units(table_of(rows, _LIMITS), study.method.kind)


def _judged(study: Study, alarms: Alarms | None, step: str) -> pa.Table:
    judge(study, limits_of(study, alarms or Alarms()))
    return with_units(study.table(step), study.method.kind)


def judge(study: Study, rows: Sequence[Row]) -> list[Row]:
    """Add judgements by limits, as :func:`limits_of` returns them; return the limits that judge.

    A channel without a limit of judgements is judged by its indicator, where that has a limit.
    """
    judging = [row for row in rows if row["reason"] is None or row.get("basis") == "indicator"]
    frozen = [{**row, "blocks": 0} if row["reason"] is not None else row for row in judging]
    study.load("frozen_limits", table_of(frozen, FROZEN))
    add_judgements(study.steps, study.method, study.instant_of)
    return frozen


def add_status(study: Study, alarms: Alarms) -> None:
    """Add the step *standing*: the status of each channel, by its episodes or else by its indicator.

    Raises:
        ParameterError: the rate is in days, and the source counts time in integers.
    """
    rows = limits_of(study, alarms)
    judge(study, rows)
    study.load("limit_reasons", table_of(rows, _REASONS))
    add(study.steps, "judgement/raised")
    add_judged(study.steps, "raised")
    add_standing(study.steps)
    add(study.steps, "judgement/machines", name="ranked_machines", tables={"signals": "standing"})


def limits_of(study: Study, alarms: Alarms) -> list[Row]:
    """Return the limits of all channels of a study, as :func:`limits` does, with their channel_id.

    Raises:
        ParameterError: the rate is in days, and the source counts time in integers.
    """
    alarms.rate_for(study.method.kind)
    add_learnt_limits(study.steps, study.method, alarms.family)
    return chosen_limits(study, alarms, study.method.kind)


def chosen_limits(work: Work, alarms: Alarms, kind: TimeKind) -> list[Row]:
    """Return the limits of all channels of the step *learnt_limits*, with the heights chosen for them.

    Raises:
        ParameterError: as :meth:`Alarms.rate_for`.
    """
    rate = Rate.of(alarms.rate_for(kind))
    learnt = {(row["channel_id"], row["g"]): row for row in work.rows("learnt_limits")}
    near = [row for (_, g), row in sorted(learnt.items()) if g == NEAR]
    for row in near:
        assess(row, day_of(kind))
    members = [row for row in near if row["reason"] is None]
    ratios: dict[int, list[int]] = defaultdict(list)
    for row in members:
        if row["order_ratio"] is not None:
            ratios[row["family_no"]].append(row["order_ratio"])
    drifting = {
        family
        for family, order_ratios in ratios.items()
        if sum(order_ratios) > _DRIFTING * len(order_ratios)
    }
    for row in members:
        row |= _based(row, row["family_no"] in drifting)
        row |= {name: learnt[row["channel_id"], row["g"]][name] for name in ("centre", "spread")}
    total = math.fsum(row["judgements_per_day"] or 0.0 for row in members)
    for row in members:
        row["rate"] = rate.per_judgement(row["judgements_per_day"], total)
    replayed, counted = _replayed(work, members)
    for row in members:
        family = row["family_no"]
        height = Height(UNSTATED, "none")
        if row["basis"] != "none":
            height = by_table(row["rate"], row["blocks"])
            if family in replayed:
                height = by_replay(row["rate"], replayed[family], counted[family])
            height = Height(height.quarters, row["basis"] or height.basis)
        row |= high(row, height)
    for row in near:
        row["family"] = row["family_no"]
        if row["reason"] is not None:
            row |= {"centre": None, "spread": None}
            if row["hi_limit"] is not None and row["reason"] != UNREPRESENTATIVE:
                row |= indicated(row["hi_limit"], row["window_length"])
    return near


def indicated(hi_limit: float, window: int) -> Row:
    """Return the limit of a channel that is judged by its indicator, for lack of a limit of judgements.

    A window with more than hi_limit W novel vectors is raised, and opens an episode at once: no other
    limit has the height 1. No rate can be stated.
    """
    count = math.floor(hi_limit * window)
    count += (count + 1) / window <= hi_limit
    count -= count / window > hi_limit
    root = math.floor(math.sqrt(1_000_000 * count + 375_000))
    return {"reference": root, "height": 1, "cap": 1, "basis": "indicator"}


def day_of(kind: TimeKind) -> int | None:
    """Return the length of a day in the unit of time; None if the source counts time."""
    return None if kind.is_counter else length("1 d", kind, "a day")


def assess(row: Row, day: int | None) -> None:
    """Add the judgements per day, and the reason for no limit, to a row of *learnt_limits*."""
    row["judgements_per_day"] = None
    if day is not None and row["calibration_length"]:
        in_all = row["window_length"] * row["calibration_length"]
        row["judgements_per_day"] = float(row["vectors"] * day / in_all)
    row["reason"] = _reason(row, day)
    row["order_ratio"] = row["order_ratio"] if row["blocks"] >= _ORDERED_BLOCKS else None


def _reason(row: Row, day: int | None) -> str | None:
    if row["limit_reason"] is not None:
        return str(row["limit_reason"])
    if row["blocks"] < _JUDGED_BLOCKS:
        return f"calibration shorter than {_JUDGED_BLOCKS} windows"
    if row["blocks"] * row["extent"] > _LARGEST_EXTENT:
        return "counts of calibration too far apart"
    if row["blocks"] >= _ORDERED_BLOCKS and row["order_ratio"] > _UNREPRESENTATIVE:
        return UNREPRESENTATIVE
    if day is not None and row["judgements_per_day"] is None:
        return "calibration has no length"
    return None


def _based(row: Row, drifting: bool) -> Row:
    """Return g of a channel, and its basis if that does not depend on the height."""
    if drifting:
        is_long = row["blocks"] >= _DRIFTING_BLOCKS
        return {"g": FAR if is_long else NEAR, "basis": "drifting" if is_long else "none"}
    is_unlike = row["order_ratio"] is not None and row["order_ratio"] > _UNLIKE
    return {"g": NEAR, "basis": "none" if is_unlike else None}


def _replayed(work: Work, members: Sequence[Row]) -> tuple[dict[int, int], Mapping[int, dict[int, int]]]:
    """Return the judgements of each family that can be replayed, and its episodes by height."""
    families: dict[int, list[Row]] = defaultdict(list)
    for row in members:
        if row["basis"] != "none":
            families[row["family_no"]].append(row)
    enough = {
        family: judged
        for family, rows in families.items()
        if len(rows) >= _REPLAYED_CHANNELS
        and (judged := sum(row["blocks"] for row in rows)) >= _REPLAYED_JUDGEMENTS
    }
    counted: dict[int, dict[int, int]] = defaultdict(dict)
    if enough:
        wanted = [
            {name: row[name] for name in ("channel_id", "family_no", "g")}
            for family in enough
            for row in families[family]
        ]
        work.load("members", table_of(wanted, _MEMBERS))
        heights = [{"quarters": quarters} for quarters in range(LEAST, MOST + 1)]
        work.load("heights", table_of(heights, counts("quarters")))
        add_replay(work.steps)
        for row in work.rows("counted_replay"):
            counted[row["family_no"]][row["quarters"]] = row["episodes"]
    return enough, counted


def high(row: Row, height: Height) -> Row:
    """Return the columns that follow from a height, and from the centre, spread and rate of a limit."""
    scaled = (height.quarters * row["spread"] + 3) // 4
    return {
        "reference": row["centre"] + row["spread"],
        "height": scaled,
        "cap": (scaled + 1) // 2,
        "quarters": height.quarters,
        "basis": height.basis,
        "stated_rate": None if height.basis == "none" else max(row["rate"], STATED_FROM),
    }


_REASONS = columns((WORD, "asset channel reason"))
_MEMBERS = counts("channel_id family_no g")
FROZEN = counts("channel_id blocks reference height cap")
LIMIT = (
    (COUNT, "family blocks g centre spread reference height cap quarters"),
    (WORD, "basis"),
    (COUNT, "order_ratio"),
    (SHARE, "judgements_per_day rate stated_rate"),
    (WORD, "reason"),
)
_LIMITS = columns((WORD, "asset channel"), *LIMIT)
