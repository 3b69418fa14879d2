"""What alarms are measured beside: today's limit, a control without care, and other estimators."""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.alarms.backtesting import poisson_ends
from gam_db.lab.benchmark.alarms.figures import shares
from gam_db.lab.benchmark.alarms.plan import CALIBRATION, Plan
from gam_db.lab.benchmark.alarms.tables import Name, Pool, Row, name_of
from gam_db.lab.estimators import scores_at_buckets
from gam_db.settings.calibration import Calibration
from gam_db.settings.source import Source

_DRAWN = 50_000  # windows by which the control's limit is found
_MORE = 1.5  # times the floor, at which the control is to alarm
_HEIGHTS = range(1, 121)  # quarters of a spread
_FEWEST = 3  # windows that have a spread
_FAR = 10**6  # thousandths of a spread

Floats = NDArray[np.float64]
Ends = Mapping[tuple[Name, int], int]
Wearing = Mapping[Name, Mapping[str, Any]]


class Windows:
    """The judged windows of a pool, by channel.

    Attributes:
        names: channel_id -> its name; ids: the other way.
        novel: channel_id -> novel vectors of each judgement, from judgement 0.
        ends: name and judgement -> when it ends.
        begins: name -> when judgement 0 begins.
    """

    def __init__(self, pool: Pool) -> None:
        self.names = {row["channel_id"]: name_of(row) for row in pool.tables["channels"].to_pylist()}
        rows = pool.tables["judged_windows"].sort_by(
            [("channel_id", "ascending"), ("judgement_no", "ascending")]
        )
        self.ids = {name: channel for channel, name in self.names.items()}
        self.novel: dict[int, list[int]] = {}
        self.ends: dict[tuple[Name, int], int] = {}
        self.begins: dict[Name, int] = {}
        for row in rows.to_pylist():
            self.novel.setdefault(row["channel_id"], []).append(row["novel"])
            name = self.names[row["channel_id"]]
            self.ends[name, row["judgement_no"]] = row["last_time"]
            self.begins.setdefault(name, row["first_time"])


def today(pool: Pool, windows: Windows, window: int, calm: set[Name], wearing: Wearing) -> Row:
    """Return what the limit of the health indicator does: a window is above it, or is not."""
    limits = {row["channel_id"]: row["hi_limit"] for row in pool.tables["limited"].to_pylist()}
    judged = {channel: novel for channel, novel in windows.novel.items() if limits[channel] is not None}
    merged = pool.merged(
        [
            (channel, number)
            for channel, novel in judged.items()
            for number, count in enumerate(novel)
            if count / window > limits[channel]
        ]
    )
    opened: dict[Name, list[int]] = {}
    for row in merged:
        name = windows.names[row["channel_id"]]
        opened.setdefault(name, []).append(windows.ends[name, row["first_judgement"]])
    episodes = sum(len(times) for name, times in opened.items() if name in calm)
    judgements = sum(len(novel) for channel, novel in judged.items() if windows.names[channel] in calm)
    return {"rate": rate_of(episodes, judgements), "wear": shares(opened, wearing)}


def control(pool: Pool, windows: Windows, window: int, calm: set[Name], rate: float) -> Row:
    """Return how often a plain Bernoulli CUSUM opens that takes the floor for the truth.

    Each vector is novel with the probability p0 = floor, independently, or 1.5 p0 when it is to alarm;
    the limit is the one at which such draws alarm at the stated rate. After an alarm it begins anew;
    alarms with fewer than 10 judgements between them are one episode.
    """
    floors = {row["channel_id"]: row for row in pool.tables["limited"].to_pylist()}
    chance = np.random.default_rng(0)
    alarms: list[tuple[int, int]] = []
    judgements = 0
    for channel, novel in sorted(windows.novel.items()):
        row = floors[channel]
        if windows.names[channel] not in calm or row["hi_limit"] is None:
            continue
        p0 = min(max(row["floor"], 1 / row["vectors"]), 0.4)
        drawn = _steps(chance.binomial(window, p0, _DRAWN), window, p0)
        limit = np.sort(_peaks(drawn))[::-1][int(rate * _DRAWN)]
        total = 0.0
        for number, step in enumerate(_steps(np.array(novel), window, p0)):
            total = max(0.0, total + step)
            if total >= limit:
                alarms.append((channel, number))
                total = 0.0
        judgements += len(novel)
    return {"stated": rate, **rate_of(len(pool.merged(alarms)), judgements)}


def _steps(novel: NDArray[np.int64], window: int, p0: float) -> Floats:
    """Return the logarithm of how much likelier each count is under more novelty than the floor."""
    hit, miss = np.log(_MORE), np.log((1 - _MORE * p0) / (1 - p0))
    return np.asarray(novel * hit + (window - novel) * miss)


def _peaks(steps: Floats) -> Floats:
    """Return how high each excursion of a CUSUM above 0 comes."""
    summed = np.cumsum(steps)
    evidence = summed - np.minimum(np.minimum.accumulate(summed), 0)
    starts = np.concatenate([[0], np.flatnonzero(evidence == 0) + 1])
    return np.maximum.reduceat(np.append(evidence, 0.0), starts)


def rate_of(episodes: int, judgements: int) -> Row:
    """Return how often something opened, per judgement, with its 95 % interval by Poisson."""
    ends = (None, None) if judgements == 0 else poisson_ends(episodes)
    rates = zip(("seen", "lower", "upper"), (episodes, *ends), strict=True)
    return {
        **{
            name: value / judgements if judgements and value is not None else None
            for name, value in rates
        },
        "episodes": episodes,
        "judgements": judgements,
    }


def scored(plan: Plan, rival: str, source: Source, names: Sequence[Name]) -> pa.Table:
    """Return an estimator's mean score over each window of some channels: asset, channel, last_time, hi.

    It learns of the first half of calibration, so that its windows of the second half are scored as
    those that follow.
    """
    fraction = CALIBRATION.fraction
    assert fraction is not None
    some = replace(source, where=exp.column("channel").isin(*(channel for _, channel in names)))
    half = Calibration(fraction=fraction / 2)
    rows = scores_at_buckets(some, plan.parameters, half, estimator=rival, sample=plan.sample)
    per_window = plan.window // plan.parameters.bucket_length
    return rows.filter(pa.array((rows["bucket"].to_numpy() + 1) % per_window == 0))


def judged_scores(
    pool: Pool,
    windows: Windows,
    tables: Sequence[pa.Table],
    calm: set[Name],
    wearing: Wearing,
    episodes: int,
) -> Row:
    """Return what an estimator sees at a height at which it opens on calm channels as often as DSE.

    Centre and spread are those of its windows in calibration.

    Args:
        pool: of the fleets.
        windows: of the pool.
        tables: what :func:`scored` made of each fleet.
        calm: the channels that nothing happens to.
        wearing: the joints that wear.
        episodes: realised by Discrete Support Estimation on the same calm channels.
    """
    ids = windows.ids
    ended: dict[Name, list[tuple[int, float]]] = {}
    for table in tables:
        times = table["last_time"].cast(pa.int64()).to_pylist()
        for row, time in zip(table.to_pylist(), times, strict=True):
            ended.setdefault(name_of(row), []).append((time, row["hi"]))
    roots: list[Row] = []
    closed: dict[tuple[int, int], int] = {}
    for name, its in ended.items():
        begin = windows.begins.get(name)
        learnt = np.array([hi for time, hi in its if begin is not None and time < begin])
        if len(learnt) < _FEWEST:
            continue
        centre, spread = learnt.mean(), max(learnt.std(ddof=1), 1e-9)
        # The window in which calibration ends belongs to neither.
        for number, (time, hi) in enumerate(its[len(learnt) + 1 :]):
            root = int(np.clip(np.floor(1000 * (hi - centre) / spread), -_FAR, _FAR))
            row = {"channel_id": ids[name], "family_no": 0, "block": number, "blocks": 0, "root": root}
            roots.append(row)
            closed[ids[name], number] = time
    opened = pool.replayed(pa.Table.from_pylist(roots), list(_HEIGHTS)).to_pylist()
    false = dict.fromkeys(_HEIGHTS, 0)
    for row in opened:
        false[row["limit_no"]] += windows.names[row["channel_id"]] in calm
    height = next((quarters for quarters in _HEIGHTS if false[quarters] <= episodes), _HEIGHTS[-1])
    seen: dict[Name, list[int]] = {}
    for row in opened:
        if row["limit_no"] == height:
            time = closed[row["channel_id"], row["first_judgement"]]
            seen.setdefault(windows.names[row["channel_id"]], []).append(time)
    judgements = sum(windows.names[row["channel_id"]] in calm for row in roots)
    return {
        "height": height / 4,
        "rate": rate_of(false[height], judgements),
        "wear": shares(seen, wearing),
    }
