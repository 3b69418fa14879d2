"""Choosing parameters once more, in plain NumPy and from the definitions (method, section 8).

Shares no code with gam_db: neighbours by comparing everything with everything, sums in Python integers.
Input is one channel, ordered: its values (NaN where missing), the run each sample belongs to, whether
it is a sample of calibration was decided before.
"""

import math
from collections import Counter
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from reference import without_strays

Row = dict[str, Any]
Floats = NDArray[np.float64]
Places = list[tuple[int, int]]


@dataclass(frozen=True)
class Asked:
    """What is asked for."""

    tau: int | None = None
    tau_max: int = 100
    m_max: int = 6
    theiler: int | None = None
    references: int = 2000
    seed: int = 0
    most: int = 2**17
    most_vectors: int = 2**16


def runs_of(times: list[int], calibrating: list[bool], max_gap: int | None) -> list[int]:
    """The run of each calibration sample: a break or a sample outside calibration ends one."""
    runs, run, open_run = [], 0, False
    for i, (time, inside) in enumerate(zip(times, calibrating, strict=True)):
        if i and max_gap is not None and time - times[i - 1] > max_gap:
            open_run = False
        if inside and not open_run:
            run += 1
        open_run = inside
        if inside:
            runs.append(run)
    return runs


class Channel:
    """One channel: its curves and what follows from them."""

    def __init__(self, values: Floats, runs: list[int], asked: Asked) -> None:
        self.asked = asked
        self.runs = np.array(runs, dtype=np.int64)
        self.samples = len(values)
        kept = values[~np.isnan(values)].tolist()
        kept = without_strays(kept)[0] if kept else kept
        lo, hi = (min(kept), max(kept)) if kept else (0.0, 0.0)
        known = (values >= lo) & (values <= hi) if kept else np.zeros(len(values), bool)
        values = np.where(known, values, np.nan)
        self.scaled = (values - lo) / (hi - lo) if hi > lo else np.full(len(values), np.nan)
        self.usable = int((~np.isnan(self.scaled)).sum())
        self.levels = [
            0 if not k else 1 if math.isnan(u) else min(1 + math.floor(u * 16384), 16384)
            for u, k in zip(self.scaled.tolist(), known.tolist(), strict=True)
        ]
        self.longest = min(asked.tau_max, self.samples // 10)
        self.lags = [self._lag(lag) for lag in range(self.longest + 1)]
        self.lags = [row for row in self.lags if row]
        self.cycles = [row for scale in self._scales() for row in self._echoes(scale)]

    # Along time

    def _pairs(self, levels: list[int], runs: Any, lag: int) -> list[tuple[int, int]]:
        return [
            (levels[i], levels[i - lag])
            for i in range(lag, len(levels))
            if levels[i] > 0 and levels[i - lag] > 0 and runs[i] == runs[i - lag]
            if self._is_taken(i - lag + 1)
        ]

    def _is_taken(self, place: int, scale: int = 1, most: int | None = None) -> bool:
        """Of a long channel about so many places, spread by the golden section."""
        return place * 40503 % 65536 / 65536 < (most or self.asked.most) * scale / self.samples

    def _lag(self, lag: int) -> Row:
        pairs = self._pairs(self.levels, self.runs, lag)
        if not pairs:
            return {}
        joint = Counter(((a - 1) // 1024, (b - 1) // 1024) for a, b in pairs)
        now = Counter((a - 1) // 1024 for a, _ in pairs)
        then = Counter((b - 1) // 1024 for _, b in pairs)
        n = len(pairs)
        units = sum(
            math.floor(count * math.log(count * n / (now[a] * then[b])) * 2**24 + 0.5)
            for (a, b), count in joint.items()
        )
        information = units / 2**24 / n
        freedom = (len(now) - 1) * (len(then) - 1)
        return {
            "delay": lag,
            "n_pairs": n,
            "occupied": len(joint),
            "ami": information,
            "ami_corrected": information - (len(joint) - len(now) - len(then) + 1) / (2 * n),
            "acf": _correlation(pairs),
            "informative": int(2 * n * information > freedom + 2 * math.sqrt(10 * freedom) + 20),
        }

    def _scales(self) -> list[tuple[int, list[int], Places]]:
        scales = [(1, self.levels, self.runs.tolist(), list(range(1, self.samples + 1)))]
        while self.samples // (2 * scales[-1][0]) >= 300:
            scale, levels, runs, places = scales[-1]
            halves: dict[tuple[int, int], list[int]] = {}
            for level, run, place in zip(levels, runs, places, strict=True):
                halves.setdefault((run, place // 2), []).append(level)
            coarse = [
                math.floor(sum(two) / sum(level > 0 for level in two) + 0.5) if any(two) else 0
                for two in halves.values()
            ]
            scales.append((2 * scale, coarse, [r for r, _ in halves], [p for _, p in halves]))
        return [
            (scale, levels, list(zip(runs, places, strict=True)))
            for scale, levels, runs, places in scales
        ]

    def _echoes(self, of_scale: tuple[int, list[int], Places]) -> list[Row]:
        scale, levels, places = of_scale
        found = {place: level for level, place in zip(levels, places, strict=True) if level > 0}
        rows = []
        for lag in range(min(max(self.longest, 100), self.samples - 1) + 1):
            pairs = [
                (found[run, place + lag], level)
                for (run, place), level in found.items()
                if (run, place + lag) in found and self._is_taken(place, scale)
            ]
            if pairs:
                acf = _correlation(pairs)
                rows.append({"scale": scale, "delay": lag * scale, "n_pairs": len(pairs), "acf": acf})
        return rows

    # Choices along time

    def delays(self) -> Row:
        """Tau by each rule, and the one that applies."""
        curve = self.lags
        informative = {row["delay"]: row["informative"] for row in curve}
        minimum = None
        for before, at, after in zip(curve, curve[1:], curve[2:], strict=False):
            reached = informative[1] if at["delay"] == 1 else before["informative"]
            if before["ami"] > at["ami"] <= after["ami"] and reached and minimum is None:
                minimum = at["delay"]
        acf = [
            (row["delay"], row["acf"]) for row in curve if row["delay"] > 0 and row["acf"] is not None
        ]
        below = next((lag for lag, r in acf if r < 1 / math.e), None)
        zero = next((lag for lag, r in acf if r <= 0), None)
        rules = {"first_minimum": minimum, "acf_1e": below, "acf_zero": zero}
        rule = next((name for name, lag in rules.items() if lag is not None), "none")
        if not informative.get(1):
            rule = "none"
        if self.asked.tau is not None:
            rule, rules = "given", {**rules, "given": self.asked.tau}
        chosen = rules.get(rule)
        return {
            "tau": chosen,
            "tau_rule": rule,
            "ami_minimum": minimum,
            "acf_1e": below,
            "acf_zero": zero,
        }

    def cycle(self) -> int | None:
        """The length of a cycle: the first high peak on the finest scale that has one."""
        for scale in sorted({row["scale"] for row in self.cycles}):
            curve = [row for row in self.cycles if row["scale"] == scale]
            peaks = []
            for i in range(1, len(curve) - 1):
                before, at, after = (row["acf"] for row in curve[i - 1 : i + 2])
                if None in (before, at, after):
                    continue
                crossed = any(row["acf"] is not None and row["acf"] <= 0 for row in curve[: i + 2])
                if crossed and before < at >= after and 5 * curve[i]["delay"] <= self.samples:
                    peaks.append((curve[i]["delay"], at))
            if peaks and max(r for _, r in peaks) >= 0.5:
                highest = max(r for _, r in peaks)
                return int(min(lag for lag, r in peaks if r >= 0.9 * highest))
        return None

    # Neighbours

    def dimensions(self) -> list[Row]:
        """False neighbours and Cao's quantities by dimension."""
        delays = self.delays()
        tau = delays["tau"] or 1
        memory = delays["acf_1e"] or self.longest
        deviation = float(np.nanstd(self.scaled)) if self.usable else 0.0
        units = self._units()
        rows: list[Row] = []
        grown: dict[int, tuple[float, float]] = {}
        for d in range(1, self.asked.m_max + 2):
            where = [
                i
                for i in range(self.samples - d * tau)
                if self._known(i, d, tau) and self._is_taken(i + 1, most=self.asked.most_vectors)
            ]
            if not where:
                continue
            vectors = np.array([[units[i + k * tau] for k in range(d + 1)] for i in where])
            places = np.array(where) + 1
            nearby = max((d - 1) * tau, memory) if self.asked.theiler is None else self.asked.theiler
            false, skipped, ratios, partings, followed = 0, 0, [], [], 0
            chosen = sorted(
                range(len(where)), key=lambda j: (self._scattered(int(places[j])), places[j])
            )
            chosen = chosen[: self.asked.references]
            for j in chosen:
                away = np.abs(vectors[:, :d] - vectors[j, :d])
                squares = away[:, 0] * away[:, 0]
                for k in range(1, d):
                    squares = squares + away[:, k] * away[:, k]
                neighbour, twin = _nearest(squares, places, places[j], nearby)
                if neighbour is not None:
                    followed += 1
                    skipped += twin
                    parting = int(abs(vectors[j, d] - vectors[neighbour, d]))
                    square = int(squares[neighbour])
                    false += bool(
                        parting > 15 * math.sqrt(square)
                        or math.sqrt(square + parting * parting) > 2 * deviation * 2**24
                    )
                largest = away.max(axis=1)
                neighbour, _ = _nearest(largest, places, places[j], nearby)
                if neighbour is not None:
                    parting = int(abs(vectors[j, d] - vectors[neighbour, d]))
                    ratios.append(max(1.0, parting / int(largest[neighbour])))
                    partings.append(parting / 2**24)
            rows.append(
                {
                    "m": d,
                    "reference_vectors": len(chosen),
                    "neighbours": followed,
                    "skipped": skipped,
                    "false_neighbours": false,
                    "false_share": false / followed if followed else None,
                }
            )
            if ratios:
                grown[d] = (float(np.mean(ratios)), float(np.mean(partings)))
        for row in rows:
            here, there = grown.get(row["m"]), grown.get(row["m"] + 1)
            row["e1"] = there[0] / here[0] if here and there else None
            row["e2"] = there[1] / here[1] if here and there and here[1] > 0 else None
        return [row for row in rows if row["m"] <= self.asked.m_max]

    def _units(self) -> list[int]:
        """Coordinates in whole units of 2^-24 of the range: nearer than that is rounding.

        Rhodes and Morari (Physical Review E 55, 1997, 6162): the more samples, the more often the
        nearest neighbour is one that only noise parts, be it as small as that of rounding, and its
        distance decides. 24 bits are the finest converters' and those of a 32-bit float.
        """
        return [0 if math.isnan(u) else math.floor(u * 2**24 + 0.5) for u in self.scaled.tolist()]

    def _known(self, i: int, d: int, tau: int) -> bool:
        ahead = [i + k * tau for k in range(d + 1)]
        return all(self.runs[j] == self.runs[i] and not math.isnan(self.scaled[j]) for j in ahead)

    def _scattered(self, place: int) -> int:
        prime = 2**31 - 1
        mixed = (place * 48271 + self.asked.seed) % prime
        return (mixed * mixed + place) % prime


def _nearest(
    distances: NDArray[np.int64], places: NDArray[np.int64], place: int, nearby: int
) -> tuple[int | None, int]:
    """The nearest vector outside the window that is not at zero distance, and whether one was.

    Of several it is the earliest of those before the window, else the latest after it.
    """
    outside = np.abs(places - place) > nearby
    twin = int((outside & (distances == 0)).any())
    possible = outside & (distances > 0)
    if not possible.any():
        return None, twin
    best = np.flatnonzero(possible & (distances == distances[possible].min()))
    early = best[places[best] < place]
    return int(early[0] if len(early) else best[-1]), twin


def _correlation(pairs: list[tuple[int, int]]) -> float | None:
    n = len(pairs)
    a, b = [x - 8192 for x, _ in pairs], [y - 8192 for _, y in pairs]
    covariance = n * sum(x * y for x, y in zip(a, b, strict=True)) - sum(a) * sum(b)
    variances = [n * sum(x * x for x in side) - sum(side) ** 2 for side in (a, b)]
    if not all(variances):
        return None
    return covariance / (math.sqrt(variances[0]) * math.sqrt(variances[1]))
