"""Settings that calibration chooses: delay and window of siblings, bins of each (both sides, section 4).

This module owns the choice. The scores by which it is made are those of :mod:`gam_db.method.automatic`.
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

from gam_db.columns import COUNT, SHARE, columns, name_of, table_of
from gam_db.engines.session import Row
from gam_db.method.adding import OfSet, add
from gam_db.method.automatic import DELAYS, STRETCH, add_taught_samples, rungs, scoring
from gam_db.settings.parameters import Override, Parameters
from gam_db.settings.patterns import grouped
from gam_db.settings.setting import settings_of
from gam_db.study.running import Running

MOST_SIBLINGS = 16
"""Siblings of one name at most whose delays are compared."""

THINNED = ((2, 1), (4, 2), (8, 4))
"""Of so many siblings at most one in so many vectors is picked of those that a probe picks; of more
siblings one in 8. What is seen is a mean over siblings, and for each of them over changes."""

WITHIN = 50
"""Thousandths of a score in which a smaller delay, or a finer grid, counts as good as the best."""

_USUAL_M = 3
"""The dimension that may fall where nothing passes; another one was chosen by the user."""

Scores = dict[int, dict[int, dict[int, int]]]
"""Unit -> delay -> level of the grid -> score."""


@dataclass
class Siblings:
    """Channels that share delay and window.

    Attributes:
        name: of the channels; empty for those whose name no other channel has.
        setting: as the user gave it.
        channels: rows of *channels* with what *bounds* has of each.
        scores: delay -> mean score of the channels that were looked at.
        lower: dimension below the given one -> channels whose calibration is too short for more.
    """

    name: str
    setting: Parameters
    channels: list[Row]
    tau: int = 1
    window: int = 0
    scores: dict[int, int] = field(default_factory=dict)
    lower: dict[int, int] = field(default_factory=dict)

    @property
    def thinning(self) -> int:
        """One in how many vectors is picked of those that a probe picks."""
        return next((thinning for most, thinning in THINNED if len(self.channels) <= most), 8)

    @property
    def units(self) -> dict[int, list[Row]]:
        """The channels by the support that they fill."""
        units: dict[int, list[Row]] = {}
        for row in self.channels:
            units.setdefault(row["support_id"], []).append(row)
        return units


def window_of(samples: Iterable[int]) -> int:
    """Return the window of siblings with so many calibration samples: a twentieth of their median."""
    window = _lower_median(samples) // 20
    return max(window - window % 100 if window >= 200 else window, 20)


def window_for(window: int, samples: Iterable[int], stride: int | None) -> int:
    """Return the window of one support: halved until its calibration has eight of them."""
    median = _lower_median(samples)
    while window > 1 and median < 8 * window:
        window //= 2
    return window if stride is None else max(window - window % stride, stride)


def delay_of(scores: Sequence[Mapping[int, int]]) -> tuple[int, dict[int, int]]:
    """Return the delay that siblings share, and their mean score for each delay.

    Args:
        scores: of each sibling: delay -> best score of a grid that passes there.
    """
    passing = sorted({delay for of in scores for delay in of})
    sums = {delay: sum(of.get(delay, 0) for of in scores) for delay in passing}
    most = max(sums.values(), default=0)
    best = next((delay for delay in passing if sums[delay] >= most - WITHIN * len(scores)), DELAYS[0])
    return best, {delay: total // len(scores) for delay, total in sums.items()}


def level_of(scores: Mapping[int, int]) -> int:
    """Return the finest level that is as good as the best."""
    most = max(scores.values())
    return min(level for level, score in scores.items() if score >= most - WITHIN)


class Choosing:
    """The choice for the channels of a study under the finest grids.

    Args:
        running: steps with *bounds*, *channels* and *taught_samples* of each set; see :func:`choose`.
        sets: what the step *taught_samples* of each set is called.
    """

    def __init__(self, running: Running, sets: Sequence[str]) -> None:
        self.running, self.sets = running, sets

    def scores(
        self,
        setting: Parameters,
        of_set: int,
        m: int,
        learners: Sequence[Row],
        has_probe: bool = True,
    ) -> Scores:
        """Return the scores of learners; 0 without a probe.

        Args:
            setting: as the user gave it.
            of_set: number of the set.
            m: the dimension.
            learners: rows with channel_id, unit_id, delay, window_length, is_cut and the range.
            has_probe: whether scores are asked for, or only what passes.
        """
        samples = Counter[tuple[int, int]]()
        for row in learners:
            samples[row["unit_id"], row["delay"]] += row["calibration_samples"]
        least = setting.least_vectors
        learners = [row for row in learners if samples[row["unit_id"], row["delay"]] >= least]
        if not learners:
            return {}
        delays = sorted({row["delay"] for row in learners})
        closed = replace(setting.closed(), m=m)
        usual = 1 if "tau" in setting.open_settings else closed.tau
        steps = scoring(closed, rungs(setting), delays, usual)
        rows = []
        for row in learners:
            number = delays.index(row["delay"])
            ids = {name: row[of] * len(DELAYS) + number for name, of in _IDS}
            rows.append({**row, "delay_no": number, **ids})
        session, scores = self.running.session, Scores()
        with session.lent(table_of(rows, _LEARNERS)) as lent:
            taught = self.running.tables[self.sets[of_set]]
            tables = {"taught_samples": taught, "learners": lent}
            if not any(row["is_cut"] for row in learners):
                tables["sampled"] = taught
            with Running(session, steps, tables, self.running.on_step) as work:
                for row in work.rows("scores" if has_probe else "passing"):
                    unit, number = divmod(row["support_id"], len(DELAYS))
                    of_unit = scores.setdefault(unit, {}).setdefault(delays[number], {})
                    of_unit[row["level"]] = row.get("score", 0)
        return scores

    def settle(self, families: Sequence[Siblings], of_set: int) -> dict[int, dict[str, int]]:
        """Choose settings for siblings with the same settings; return the choice for each unit."""
        setting, m = families[0].setting, families[0].setting.m
        is_open = {name: name in setting.open_settings for name in ("tau", "bins", "window")}
        windows: dict[int, int] = {}
        units: dict[int, tuple[Siblings, list[Row]]] = {}
        for family in families:
            family.window = window_of(_taught(family.channels)) if is_open["window"] else setting.window
            for unit, members in family.units.items():
                windows[unit], counts = family.window, _taught(members)
                if is_open["window"] and counts:
                    windows[unit] = window_for(family.window, counts, setting.stride)
                if _varies(members[0]):
                    units[unit] = family, members
        chosen = {unit: {"window": window} for unit, window in windows.items() if is_open["window"]}
        if not (is_open["tau"] or is_open["bins"]):
            return chosen
        early: Scores = {}
        if is_open["tau"]:
            early = self._choose_delays(families, of_set, windows)
        else:
            for family in families:
                family.tau = setting.tau
        scores, wanted, whole = Scores(), [], set[int]()
        for unit, (family, members) in units.items():
            if len(members) == 1 and unit in early and _is_whole(members[0], windows[unit]):
                whole.add(unit)
                scores[unit] = early[unit]
            else:
                wanted += _learners(family, members, unit, [family.tau], windows[unit])
        scores |= self.scores(setting, of_set, m, wanted)
        smaller = []
        for unit, (family, members) in units.items():
            if not scores.get(unit, {}).get(family.tau) and unit not in whole:
                before = [delay for delay in DELAYS if delay < family.tau] * is_open["tau"]
                smaller += _learners(family, members, unit, before, windows[unit])
        for unit, unit_scores in self.scores(setting, of_set, m, smaller).items():
            scores[unit] = {**scores.get(unit, {}), **unit_scores}
        grids, failing = rungs(setting), []
        for unit, (family, _) in units.items():
            usable = [delay for delay in scores.get(unit, {}) if delay <= family.tau]
            if usable:
                level = level_of(scores[unit][max(usable)])
                self._take(chosen, unit, setting, tau=max(usable), bins=grids[level])
            else:
                failing.append(unit)
        lower = range(m - 1, 0, -1) if m == _USUAL_M and is_open["tau"] else ()
        for less in lower:
            wanted = [row for at in failing for row in _learners(*units[at], at, [1], windows[at])]
            passing = self.scores(setting, of_set, less, wanted, has_probe=False)
            for unit, unit_scores in passing.items():
                self._take(chosen, unit, setting, m=less, tau=1, bins=grids[min(unit_scores[1])])
                family, members = units[unit]
                family.lower[less] = family.lower.get(less, 0) + len(members)
            failing = [unit for unit in failing if unit not in passing]
        usual = Counter(of["bins"] for of in chosen.values() if "bins" in of)
        commonest = max(usual, key=lambda bins: (usual[bins], bins), default=grids[-1])
        for family in families:
            for unit in family.units:
                bins = grids[-1] if unit in units else commonest
                if unit not in units or unit in failing:
                    self._take(chosen, unit, setting, tau=family.tau, bins=bins)
        return chosen

    def _choose_delays(
        self, families: Sequence[Siblings], of_set: int, windows: Mapping[int, int]
    ) -> Scores:
        """Choose the delay of each family; return the scores of the examined channels."""
        setting = families[0].setting
        delays = DELAYS if setting.m > 1 else DELAYS[:1]
        looked: dict[int, list[int]] = {}
        learners: list[Row] = []
        for family in families:
            varying = [row for row in family.channels if _varies(row) and row["calibration_samples"]]
            for row in looked_at(varying):
                taken = min(row["calibration_samples"], 4 * STRETCH)
                window = max(min(windows[row["support_id"]], taken // 16), 1)
                looked.setdefault(id(family), []).append(row["channel_id"])
                learners += _learners(family, [row], row["channel_id"], delays, window, is_cut=1)
        scores = self.scores(setting, of_set, setting.m, learners)
        for family in families:
            if members := looked.get(id(family)):
                best = [
                    {delay: max(of.values()) for delay, of in scores.get(member, {}).items()}
                    for member in members
                ]
                family.tau, family.scores = delay_of(best)
        return {channel: scores.get(channel, {}) for of in looked.values() for channel in of}

    def _take(self, chosen: dict[int, dict[str, int]], unit: int, of: Parameters, **values: int) -> None:
        """Store the choice for a unit, as far as its settings are open; a dimension counts as open."""
        is_open = ("m", *of.open_settings)
        chosen.setdefault(unit, {}).update({k: value for k, value in values.items() if k in is_open})


_IDS = (("learner_id", "channel_id"), ("support_id", "unit_id"))

_COLLAPSED = columns((COUNT, "channel_id time"), (SHARE, "value"), (COUNT, "conflict"))

_LEARNERS = columns(
    (COUNT, "channel_id unit_id learner_id support_id delay_no window_length is_cut thinning"),
    (COUNT, "by_machine"),
    (SHARE, "calibrated_lo calibrated_hi"),
)


def looked_at(siblings: Sequence[Row]) -> list[Row]:
    """Return the siblings to examine: at most 16, evenly spread by asset in binary order."""
    ordered = sorted(siblings, key=lambda row: (row["asset"].encode(), row["channel"].encode()))
    if len(ordered) <= MOST_SIBLINGS:
        return ordered
    return [ordered[i * len(ordered) // MOST_SIBLINGS] for i in range(MOST_SIBLINGS)]


def choose(
    running: Running, sets: Sequence[OfSet], parameters: Parameters
) -> tuple[Parameters, list[Siblings]]:
    """Return parameters with what calibration chooses, one override per pattern; and the siblings.

    Args:
        running: the steps of a study under the finest grids, at work.
        sets: its sets.
        parameters: the parameters as the user gave them.
    """
    if not running.largest("timeline", "repeats"):
        running.load("collapsed", table_of([], _COLLAPSED))  # else it is looked for in every reading
    running.keep("limits")
    add(running.steps, "automatic/taught_readings")
    running.put("samples", running.query("taught_readings"))
    bounds = {row["channel_id"]: row for row in running.rows("bounds")}
    channels = [{**bounds[row["channel_id"]], **row} for row in running.rows("channels")]
    settings = {name_of(row): parameters.of(*name_of(row)) for row in channels}
    families = _families(channels, settings)
    step_names: dict[int, str] = {}
    for number, of_set in enumerate(sets):
        if any(row["settings_no"] == number for of in families for row in of.channels):
            add_taught_samples(of_set)
            running.keep(name := of_set.named("taught_samples"))
            step_names[number] = name
    choosing = Choosing(running, [step_names.get(number, "") for number in range(len(sets))])
    chosen: dict[int, dict[str, int]] = {}
    together: dict[Any, list[Siblings]] = {}
    for family in families:
        together.setdefault((family.setting, family.channels[0]["settings_no"]), []).append(family)
    for (_, number), alike in together.items():
        chosen |= choosing.settle(alike, number)
    chosen_settings = {
        name_of(row): settings[name_of(row)].closed(**chosen.get(row["support_id"], {}))
        for row in channels
    }
    rules, everything = grouped(chosen_settings), ("*", "*")
    general = next((setting for pattern, setting in rules if pattern == everything), parameters.finest())
    overrides = [
        Override(*pattern, **{key: getattr(setting, key) for key in settings_of(Parameters)})
        for pattern, setting in rules
        if pattern != everything
    ]
    return replace(general, overrides=overrides), families


def _families(channels: Sequence[Row], settings: Mapping[Any, Parameters]) -> list[Siblings]:
    """Return channels with open settings by name; those that have a name alone are siblings, too."""
    by_setting: dict[Any, Siblings] = {}
    for row in channels:
        setting = settings[name_of(row)]
        if setting.open_settings:
            key = setting, row["channel"]
            by_setting.setdefault(key, Siblings(row["channel"], setting, [])).channels.append(row)
    families: list[Siblings] = []
    alone: dict[Parameters, Siblings] = {}
    for family in by_setting.values():
        if len(family.channels) > 1:
            families.append(family)
            continue
        together = alone.setdefault(family.setting, Siblings("", family.setting, []))
        together.channels += family.channels
    return [*sorted(families, key=lambda family: family.name), *alone.values()]


def _learners(
    of: Siblings, members: Sequence[Row], unit: int, delays: Iterable[int], window: int, is_cut: int = 0
) -> list[Row]:
    figures = {"unit_id": unit, "window_length": window, "is_cut": is_cut, "thinning": of.thinning}
    # Members that taught nothing are judged by leaving out whole machines (both sides, section 6).
    figures["by_machine"] = int(1 < len(_taught(members)) < len(members))
    return [{**row, **figures, "delay": delay} for row in members for delay in delays]


def _varies(row: Row) -> bool:
    """Tell whether the calibration of a support has values that differ."""
    return row["calibrated_lo"] is not None and bool(row["calibrated_lo"] < row["calibrated_hi"])


def _is_whole(row: Row, window: int) -> bool:
    """Tell whether all blocks of a channel's calibration that count were examined."""
    samples = row["calibration_samples"]
    return bool(samples <= 4 * STRETCH and window <= samples // 16)


def _taught(channels: Sequence[Row]) -> list[int]:
    """Return how many calibration samples channels have, those without any left aside."""
    return [row["calibration_samples"] for row in channels if row["calibration_samples"]]


def _lower_median(counts: Iterable[int]) -> int:
    ordered = sorted(counts)
    return ordered[(len(ordered) - 1) // 2] if ordered else 0
