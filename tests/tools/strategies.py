"""Random small cases for agreement tests: a source, its parameters and its calibration.

Everything is plain data, so nothing of gam_db is needed here. ``cases()`` gives a triple:

    rows         list of (asset, channel, time, value), in no order, doubled and conflicting at will
    parameters   keyword arguments; "overrides" is a list of dicts with "asset", "channel" and the
                 fields they change
    calibration  keyword arguments; "overrides" maps an asset pattern to such arguments, or to None

A series repeats a short pattern of few values and is then damaged here and there: so cells recur,
and most cases have something to learn and something to score. Each follows from one number: drawn value
by value, hypothesis would spend its time on twenty of them. Target floors are odd numbers on purpose: on
a round one the mean of some shares may fall exactly, and engines add in other orders.
"""

import random
from typing import Any

from hypothesis import strategies as st

Row = tuple[str, str, int, float | None]
Arguments = dict[str, Any]
Case = tuple[list[Row], Arguments, Arguments]

# Names that are wildcards to LIKE or GLOB, or equal to one another when case is not heeded.
ASSETS = ["a1", "A1", "a_1", "[a]1", "b%"]
CHANNELS = ["x", "X", "y*", "y_"]
ASSET_PATTERNS = ["*", "?1", "a*", "a?1", "A1", "[a]*", "b%", "a_1", "nobody"]
CHANNEL_PATTERNS = ["*", "?", "x", "y*"]

MISSING = [None, float("nan"), float("inf"), float("-inf"), 1e301, -1.1e300]
TARGETS = [0.0, 0.0513, 0.2113, 0.4871, 0.9]
MOST = 60  # samples of a series, and so about the last time


def often(usual: list[Any], rare: list[Any]) -> st.SearchStrategy[Any]:
    """Values of which the usual ones come four times as often as the rare ones."""
    return st.sampled_from(usual * 4 * len(rare) + rare * len(usual))


def series(chance: random.Random, bins: int) -> list[tuple[int, float | None]]:
    """The rows of one channel: a pattern repeated over time, then gaps, damage and doubles."""
    length = chance.choice([MOST, 50, 40] * 3 + [30, 12, 3, 1])
    lo = chance.choice([0.0, -1.0, 0.1] * 3 + [-0.0, -1e300])
    width = chance.choice([1.0, 0.7, 1e-3] * 3 + [3e150, 0.0])  # 0: a constant channel
    # Levels on the edges of bins and inside them, as doubles come out of just this arithmetic.
    levels = [lo + width * (k / (2 * bins)) for k in range(2 * min(bins, 8) + 1)] + [lo + width]
    pattern = [chance.choice(levels) for _ in range(chance.randint(2, 5))]
    values: list[float | None] = [pattern[i % len(pattern)] for i in range(length)]
    drift = chance.choice([length, length // 2, 2 * length // 3])
    for i in range(drift, length, chance.randint(1, 4)):  # later on, something else
        values[i] = chance.choice(levels)
    outside = [lo - 1.0, lo + 2 * width + 1.0, -0.0, 0.0, 1e300]

    def damage() -> float | None:
        kinds: list[list[Any]] = [levels, MISSING, outside]
        found: float | None = chance.choice(chance.choice(kinds))
        return found

    def position() -> int:
        return chance.randrange(length)

    def times(most: int) -> range:
        return range(chance.randint(0, most))

    for _ in times(6):
        values[position()] = damage()
    steps = {position(): chance.choice([2, 3, 4, 9]) for _ in times(4)}
    time, rows = chance.choice([0, 1, -7, 5]), []
    for i, value in enumerate(values):
        time += steps.get(i, 1)
        rows.append((time, value))
    # A conflict, more often than not.
    rows += [(rows[position()][0], chance.choice([damage(), None])) for _ in times(4)]
    rows += [rows[position()] for _ in times(2)]
    return rows


@st.composite
def window_and_stride(draw: st.DrawFn, optional: bool) -> Arguments:
    """A window with a stride that divides it, or (if optional) leaves it to the default."""
    window = draw(st.sampled_from([4, 1, 2, 3, 5, 6, 8, 10, 12]))
    strides: list[int | None] = [d for d in range(1, window + 1) if window % d == 0]
    return {"window": window, "stride": draw(st.sampled_from([None] * optional + strides))}


@st.composite
def parameters(draw: st.DrawFn) -> Arguments:
    """Keyword arguments for Parameters: small, with up to two overrides of some fields."""
    fields: dict[str, st.SearchStrategy[Any]] = {
        "m": st.sampled_from([2, 3, 1, 4]),
        "tau": st.integers(1, 3),
        # 50,000 makes keys that do not fit in 32 bits, nor for m = 4 in a double's 53.
        "bins": often([4, 2, 3, 5, 6, 7, 8], [1, 100, 50_000]),
        "max_gap": st.sampled_from([3, 4, 2, 1]),
        "still_after": often([None], [2, 3]),
        "target_floor": st.sampled_from(TARGETS),
        "least_vectors": often([1], [4, 12, 40]),
        "range": often(["robust"], ["min_max"]),
    }
    answer = {name: draw(strategy) for name, strategy in fields.items()}
    answer |= draw(window_and_stride(optional=True))
    if draw(st.booleans()):
        answer["max_gap"] = None
    answer["overrides"] = []
    for _ in range(draw(often([0], [1, 2]))):
        changed = draw(st.sets(st.sampled_from(sorted(fields)), max_size=2))
        override = {name: draw(fields[name]) for name in sorted(changed)}
        if not override or draw(st.booleans()):
            override |= draw(window_and_stride(optional=False))
        names = {"asset": draw(st.sampled_from(ASSET_PATTERNS))}
        names["channel"] = draw(st.sampled_from(CHANNEL_PATTERNS))
        answer["overrides"].append(names | override)
    return answer


def intervals(most: int, longest: int) -> st.SearchStrategy[list[tuple[int, int]]]:
    """Closed intervals of time in any order; they may touch, overlap or hold no sample."""
    piece = st.tuples(st.integers(-3, MOST), st.integers(0, longest))
    return st.lists(piece.map(lambda p: (p[0], p[0] + p[1])), max_size=most)


@st.composite
def calibration_of_one(draw: st.DrawFn) -> Arguments:
    """One of fraction, duration and intervals, with exclusions and a start of scoring at times."""
    answer: Arguments = {"fraction": None, "duration": None, "intervals": None}
    kind = draw(st.sampled_from(["fraction", "duration", "intervals"]))
    if kind == "fraction":
        answer[kind] = draw(often([0.5, 0.3, 0.7, 0.29, 0.6], [0.01, 1.0]))
    elif kind == "duration":
        answer[kind] = draw(often(list(range(15, 41)), [0, 1, 2, 7, 60, 80]))
    else:
        early = st.tuples(st.integers(-3, 6), st.integers(20, 35))
        answer[kind] = draw(st.one_of(early.map(lambda p: [p]), intervals(most=3, longest=30)))
    answer["exclude"] = draw(intervals(most=2, longest=6)) if draw(often([False], [True])) else []
    answer["score_from"] = draw(often([None], list(range(-3, MOST))))
    return answer


@st.composite
def calibrations(draw: st.DrawFn) -> Arguments:
    """Keyword arguments for Calibration, with overrides by asset and pools at times."""
    answer = draw(calibration_of_one())
    patterns = draw(often([[]], [[p] for p in ASSET_PATTERNS] + [["?1", "*"], ["A1", "a*"]]))
    answer["overrides"] = {}
    for pattern in patterns:
        without = draw(st.booleans())
        answer["overrides"][pattern] = None if without else draw(calibration_of_one())
    pools = ["channel", [["?1"], ["*"]], [["[a]*", "A?"], ["a*", "b%"]], [["a_1", "a1"]]]
    answer["pool"] = draw(st.one_of(st.none(), st.sampled_from(pools)))
    references = [["*"], ["?1"], ["nobody"], ["a1", "b%"]]
    answer["reference"] = [] if answer["pool"] is None else draw(often([[]], references))
    return answer


@st.composite
def cases(draw: st.DrawFn, most: int = 5) -> Case:
    """A source of ``most`` series or a few less, its parameters and its calibration."""
    chosen, calibration = draw(parameters()), draw(calibrations())
    chance = random.Random(draw(st.integers(0, 2**32 - 1)))
    names = [(asset, channel) for channel in CHANNELS for asset in ASSETS]
    rows: list[Row] = []
    for asset, channel in chance.sample(names, draw(st.integers(max(most - 3, 1), most))):
        rows += [(asset, channel, *reading) for reading in series(chance, chosen["bins"])]
    chance.shuffle(rows)
    return rows, chosen, calibration
