"""Random arrivals of random sources, inside the contract of the stored form.

A *history* is plain data: the rows that are there when calibration is frozen, then batches of rows that
arrive one after another, with what is done after each. Rows come late by up to ``lookback`` behind the
newest time of their channel that was read before, in any order, and some come again. Each channel has a
series, a lateness and a cut into batches of its own: a history of 100 channels is 100 cases.

Everything follows from one number: drawn value by value, hypothesis would spend its time on it.
"""

import random
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

from strategies import ASSETS, MISSING, Arguments, Row

CHANNELS = 100
LENGTH = 60

#: What a history is about -> parameters and calibration that go with it.
KINDS = ("short form", "pauses", "given start", "pools", "still samples")

#: What is done after a batch, as often as it stands here.
PLAIN = (*["score"] * 6, *["crash"] * 3, "full", "everything")

#: The same where all is in the mix; and with pruning, where no row comes too late.
MIXED = (*PLAIN, *["beside"] * 4, *["clock"] * 3, *["from"] * 2, "recalibrate", "hidden")
PRUNED = (*MIXED, *["prune"] * 3)

#: What a second writer does inside a run.
BESIDE = ("score", "full", "from", "everything", "recalibrate")


@dataclass
class Batch:
    """Rows that arrive together, and the runs that follow.

    Attributes:
        rows: that arrive.
        runs: what is done then, in order: "score", "full", "everything", or "crash": a run that is cut
            off when it announces its so-manieth step. In a mixed history also "from" a time; "clock":
            from now on it stands so many days ahead; "recalibrate"; "prune" to so much time; "hidden":
            what nobody sees is pruned; "beside full" and the like: that is done inside a run, at its
            so-manieth step.
    """

    rows: list[Row]
    runs: list[tuple[str, int]]


@dataclass
class History:
    """What arrives when.

    Attributes:
        parameters, calibration: keyword arguments.
        first: rows at the time of calibration.
        batches: what follows.
        lookback: how late a row may be.
        park_after: see :class:`gam_db.Monitor`.
        limit: most readings that a run works on at once.
        is_pruned: whether old buckets go in between; else, in a mixed history, rows come too late, and
            a repair follows.
        final: all rows, each once.
    """

    parameters: Arguments
    calibration: Arguments
    first: list[Row]
    lookback: int
    park_after: int | bool
    limit: int
    final: list[Row]
    is_pruned: bool = False
    batches: list[Batch] = field(default_factory=list)


def history(kind: str, seed: int, channels: int = CHANNELS, mixed: bool = False) -> History:
    """Return the history that a number stands for."""
    chance = random.Random(seed)
    parameters, calibration = settings(kind, chance)
    rows = [row for name in names(chance, channels) for row in series(chance, *name, parameters["bins"])]
    if "still_after" in parameters:
        rows = standing(chance, rows, parameters["still_after"])
    cut = chance.choice([20, 30, 40])
    starts: dict[tuple[str, str], int] = {}
    for row in rows:
        starts[row[:2]] = min(row[2], starts.get(row[:2], row[2]))
    first = [row for row in rows if row[2] <= max(cut, starts[row[:2]])]
    later = [row for row in rows if row[2] > max(cut, starts[row[:2]])]
    lookback = chance.choice([0, 1, 3, 7, 20])
    made = History(
        parameters,
        calibration,
        first,
        lookback,
        chance.choice([False, False, 5]),
        chance.choice([25 * channels, 10**6, 10**6]),
        rows,
    )
    made.is_pruned = mixed and chance.random() < 0.4
    kinds = PLAIN if not mixed else PRUNED if made.is_pruned else MIXED
    arrivals = Arrivals(chance, first, later, lookback, mixed and not made.is_pruned)
    made.batches.append(Batch([], runs(chance, kinds)))
    left = chance.randint(1, 5)
    while arrivals.pending or arrivals.late:
        left -= 1
        late = [("from", min(row[2] for row in arrivals.late))] if arrivals.late else []
        made.batches.append(Batch(arrivals.next(left <= 0), late + runs(chance, kinds)))
    made.batches.append(Batch([], [("everything", 0)]))
    return made


class Arrivals:
    """The rows that are still to come, batch by batch; but for ``late`` ones none comes too late."""

    def __init__(
        self,
        chance: random.Random,
        first: list[Row],
        later: list[Row],
        lookback: int,
        may_be_late: bool = False,
    ) -> None:
        self.chance, self.lookback, self.arrived = chance, lookback, list(first)
        self.may_be_late, self.late = may_be_late, list[Row]()
        self.pending: dict[tuple[str, str], list[Row]] = {}
        for row in sorted(later, key=lambda row: row[2]):
            self.pending.setdefault(row[:2], []).append(row)
        self.newest: dict[tuple[str, str], int] = {}
        for row in first:
            self.newest[row[:2]] = max(row[2], self.newest.get(row[:2], row[2]))

    def next(self, last: bool = False) -> list[Row]:
        """Return the rows of the next batch in any order, some old ones among them; in the last all."""
        chance, batch, self.late = self.chance, self.late, []
        share = chance.choice([0.3, 0.7, 1.0])
        for name, waiting in list(self.pending.items()):
            if not last and chance.random() < 0.2:
                continue  # silent for once
            some = max(3, int(share * len(waiting) * 2 * chance.random()))
            ahead = waiting if last else waiting[:some]
            end = max(self.newest[name], ahead[-1][2])
            kept_back = 0.0 if last else 0.3
            held = [
                row for row in ahead if row[2] >= end - self.lookback and chance.random() < kept_back
            ]
            come = [row for row in ahead if not any(row is one for one in held)]
            batch += come
            rest = held + waiting[len(ahead) :]
            self.newest[name] = max([self.newest[name], *(row[2] for row in come)])
            # What is left behind must not have become too late by what came.
            overdue = [row for row in rest if row[2] < self.newest[name] - self.lookback]
            if self.may_be_late and not last and chance.random() < 0.5:
                self.late += overdue
            else:
                batch += overdue
            left = [row for row in rest if not any(row is one for one in overdue)]
            self.pending[name] = sorted(left, key=lambda row: row[2])
            if not left:
                del self.pending[name]
        again = chance.sample(self.arrived, min(len(self.arrived), chance.choice([0, 0, 5, 40])))
        self.arrived += batch
        batch += again
        chance.shuffle(batch)
        return batch


def runs(chance: random.Random, kinds: Sequence[str]) -> list[tuple[str, int]]:
    """Return what is done after a batch; at times nothing."""
    chosen: list[tuple[str, int]] = []
    for _ in range(chance.choice([0, 1, 1, 1, 2])):
        what, number = chance.choice(kinds), chance.randint(1, 25)
        if what == "beside":
            what = f"beside {chance.choice(BESIDE)}"
        if what == "clock":
            number = chance.choice([-30, -1, 0, 0, 1, 400])
        chosen.append((what, number))
    return chosen


def settings(kind: str, chance: random.Random) -> tuple[Arguments, Arguments]:
    """Return random keyword arguments of Parameters and Calibration that suit a kind of history."""
    window = chance.choice([1, 2, 4, 6, 8, 12])
    parameters: Arguments = {
        "m": chance.choice([1, 2, 2, 3, 4]),
        "tau": chance.choice([1, 2, 3]),
        "bins": chance.choice([2, 3, 4, 6, 50_000]),
        "window": window,
        "stride": chance.choice([n for n in range(1, window + 1) if window % n == 0]),
        "max_gap": chance.choice([1, 2, 4]) if kind == "pauses" else None,
    }
    calibration: Arguments = {"fraction": chance.choice([0.3, 0.5, 0.8])}
    if kind == "pauses" or chance.random() < 0.3:
        calibration = {"duration": chance.choice([0, 12, 25, 80])}
    if kind == "given start":
        calibration = {
            "intervals": [(0, chance.choice([9, 15])), (chance.choice([12, 18]), 28)],
            "exclude": chance.choice([[], [(4, 6)], [(25, 30)]]),
            "score_from": chance.choice([None, 5, 20, 33, 45]),
        }
    if kind == "still samples":
        parameters |= {
            "still_after": chance.choice([2, 3, 6, 15]),
            "max_gap": chance.choice([None, None, 2]),
        }
        if chance.random() < 0.3:
            calibration = {"intervals": [(6, 15), (18, 28)], "score_from": chance.choice([None, 20, 33])}
    if kind == "pools":
        calibration |= {"pool": chance.choice(["channel", [["a*", "b%"], ["m_1*"]]])}
        calibration["overrides"] = {"m_1*": None}
        parameters["overrides"] = [{"asset": "m_2*", "channel": "x", "tau": 2, "window": 4, "stride": 2}]
    return parameters, calibration


def names(chance: random.Random, channels: int) -> list[tuple[str, str]]:
    """Return the names of the channels, some of which look like patterns."""
    assets = [*ASSETS, *(f"m_{number}" for number in range(10, 50))]
    both = [(asset, channel) for asset in assets for channel in ("x", "X", "y*")]
    return chance.sample(both, channels)


def standing(chance: random.Random, rows: list[Row], after: int) -> list[Row]:
    """Return the rows of channels that stand still now and then, some until the end."""
    held: dict[tuple[str, str], list[tuple[int, int, float | None]]] = {}
    for asset, channel, *_ in rows:
        if (asset, channel) not in held:
            starts = [chance.randrange(LENGTH) for _ in range(chance.choice([0, 1, 1, 2]))]
            lengths = [
                chance.choice([after - 1, after, after + 2, 2 * after + 5, LENGTH]) for _ in starts
            ]
            values = [chance.choice([None, value]) for *_, value in chance.sample(rows, len(starts))]
            held[asset, channel] = list(zip(starts, lengths, values, strict=True))
    made = []
    for asset, channel, time, value in rows:
        for start, length, constant in held[asset, channel]:
            if start <= time < start + length:
                value = 0.25 if constant is None else constant
        made.append((asset, channel, time, value))
    return made


def series(chance: random.Random, asset: str, channel: str, bins: int) -> list[Row]:
    """Return the rows of one channel: a pattern, then something else, gaps, damage and doubles."""
    length = chance.choice([LENGTH, 50, 40, 40, 12, 1])
    lo, width = chance.choice([(0.0, 1.0), (-1.0, 0.7), (0.1, 1e-3), (-1e300, 3e150), (2.0, 0.0)])
    levels = [lo + width * (k / (2 * bins)) for k in range(2 * min(bins, 8) + 1)] + [lo + width]
    pattern = [chance.choice(levels) for _ in range(chance.randint(2, 5))]
    values: list[float | None] = [pattern[i % len(pattern)] for i in range(length)]
    for i in range(chance.choice([length // 2, length]), length, chance.randint(1, 4)):
        values[i] = chance.choice(levels)
    damage: list[Any] = [*levels, *MISSING, lo - 1.0, lo + 2 * width + 1.0, 0.0, -0.0]
    for _ in range(chance.choice([0, 0, 3, 8])):
        values[chance.randrange(length)] = chance.choice(damage)
    time, rows = chance.choice([0, 1, -7, 5]), []
    pauses = {chance.randrange(length): chance.choice([2, 3, 9]) for _ in range(chance.choice([0, 2]))}
    for i, value in enumerate(values):
        time += pauses.get(i, 1)
        rows.append((asset, channel, time, value))
    for _ in range(chance.choice([0, 0, 4])):
        asset, channel, time, value = chance.choice(rows)
        rows.append((asset, channel, time, chance.choice([value, chance.choice(damage), None])))
    return rows
