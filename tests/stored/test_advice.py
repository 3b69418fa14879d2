"""What an episode says and what to do next: the row of figures and the sentence, by hand."""

from typing import Any

import pytest

import engines
import gam_db
import scripts
from by_hand import rows, step
from gam_db.alarms.advising import advise, promise, signs_of
from gam_db.alarms.figures import advice_of, figures, with_figures
from gam_db.stored.alarms import labels
from gam_db.stored.monitor import Monitor
from strategies import Row

pytestmark = pytest.mark.thorough

W = 20
SETTING: dict[str, Any] = {"tau": 1, "bins": 40, "window": W, "stride": 10, "target_floor": 0.9}
ALARMS = gam_db.Alarms("1 per 1000 judgements")

#: A window of calibration: 2, 4, 6, ... 40. Of 40 bins between 2 and 40 about every other one is
#: healthy; the odd values
#: lie in those between. The low value (rank 1 of 20) is 2, the middle one (rank 10) 20, the high one
#: (rank 19) 38.
CALM = [2.0 * (k + 1) for k in range(W)]
WINDOWS = 10


def raised_by(first: int, last: int) -> list[float]:
    """Return a calm window in which the values of some places are 1 higher, and novel."""
    return [value + (first <= place < last) for place, value in enumerate(CALM)]


HALF = [13.0] * 10 + CALM[10:]
GROWING = [raised_by(*ends) for ends in ((0, 2), (0, 4), (0, 8), (0, 10), (9, 19), (9, 19))]
SETTLING = [*GROWING[:4], GROWING[3], GROWING[3]]
FAR = [150.0] * 10 + CALM[10:]

#: What follows the ten calm windows, and the figures by hand: judgements, novel, onset_novel,
#: early_novel, highest_novel,
#: out_of_range, states, later_states. The first two make an episode of a step (evidence 1125 each,
#: the cap), and the
#: third opens those that grow, so judgements 1 to 5 or 2 to 5 are read again.
KINDS: dict[str, tuple[list[list[float]], tuple[int, ...], str, str]] = {
    "step": (
        [HALF] * 6,
        (6, 60, 10, 10, 10, 0, 1, 0),
        "It came in a step: 50 % of the vectors were novel when it began, at most 50 % in a judgement, "
        "100 % of them "
        "inside the calibrated range; it reaches few further states (0 of 1 first in its later half).",
        "Decide first: it opened right after calibration, so it is a fault (true_fault), or "
        "calibration was not a fair "
        "sample (false_alarm).",
    ),
    "growth": (
        GROWING,
        (6, 44, 2, 4, 10, 0, 19, 11),
        "It grew: 20 % of the vectors were novel when it began, later 50 % in a judgement, 100 % of "
        "them inside the "
        "calibrated range; it keeps reaching new states (11 of 19 first in its later half).",
        "Inspect it soon: it keeps changing.",
    ),
    "settling": (
        SETTLING,
        (6, 44, 2, 4, 10, 0, 10, 2),
        "It grew: 20 % of the vectors were novel when it began, later 50 % in a judgement, 100 % of "
        "them inside the "
        "calibrated range; it reaches few further states (2 of 10 first in its later half).",
        "Inspect it while it grows, and compare it with other machines of its kind.",
    ),
    "outside": (
        [FAR] * 6,
        (6, 60, 10, 10, 10, 60, 1, 0),
        "It came in a step: 50 % of the vectors were novel when it began, at most 50 % in a judgement, "
        "most of them "
        "(100 %) outside the calibrated range; it reaches few further states (0 of 1 first in its "
        "later half).",
        "Check whether such readings are possible at all; calibration contains none.",
    ),
    "tenth": (
        [[value / 10.0 for value in CALM]] * 6,
        (6, 84, 14, 14, 14, 54, 2, 0),
        "All readings are about a tenth of what they were (units, scaling or another sensor?), which "
        "explains 100 % of "
        "the novelty.",
        "Check the units, scaling and sensor of x; if the change is intended, calibrate again from "
        "then on.",
    ),
    "shifted": (
        [raised_by(0, 20)] * 6,
        (6, 120, 20, 20, 20, 6, 20, 0),
        "All readings lie about 1 higher, which explains 100 % of the novelty.",
        "Check the units, scaling and sensor of x; if the change is intended, calibrate again from "
        "then on.",
    ),
    "inverted": (
        [[84.0 - value for value in CALM]] * 6,
        (6, 120, 20, 20, 20, 120, 2, 0),
        "All readings are inverted, and then 84 higher (sign, scaling or another sensor?), which "
        "explains 100 % of "
        "the novelty.",
        "Check the units, scaling and sensor of x; if the change is intended, calibrate again from "
        "then on.",
    ),
    "frozen": (
        [[21.0] * W] * 6,
        (6, 120, 20, 20, 20, 0, 1, 0),
        "It came in a step: 100 % of the vectors were novel when it began, at most 100 % in a "
        "judgement, 100 % of them "
        "inside the calibrated range; it reaches few further states (0 of 1 first in its later half).",
        "Check what was changed on the machine, or which work it did, when it began.",
    ),
    "short": (
        [HALF] * 2,
        (2, 20, 10, 10, 10, 0, 1, 0),
        "It is too short to tell a step from growth: at most 50 % of a judgement's vectors were novel, "
        "100 % of them "
        "inside the calibrated range.",
        "Wait for its next judgements, or inspect it now if the machine must not stop.",
    ),
}

COUNTED = (
    *("judgements", "novel", "onset_novel", "early_novel", "highest_novel"),
    *("out_of_range", "states", "later_states"),
)
MOVED = (
    "reread_vectors",
    "reread_novel",
    "move",
    "factor",
    "displacement",
    "regained",
    "lost",
    "explains",
)

#: What explains judgements 1 to 5 wholly.
MOVES: dict[str, tuple[Any, ...]] = {
    "tenth": (100, 70, "scale", 2.0 / 20.0, 0.0, 70, 0, 1),
    "shifted": (100, 100, "shift", 1.0, 1.0, 100, 0, 1),
    # Pairs rise, so that no shift explains that they fall. Of 199 newest values the low one (rank 10)
    # is 4, the high one
    # (rank 190) 40; of a window 44 and 80.
    "inverted": (100, 100, "mirror", -1.0, 84.0, 100, 0, 1),
    "frozen": (100, 100, "none", 1.0, 0.0, 0, 0, 0),
}


def of_pairs(kind: str) -> int:
    """Return how many samples a vector has: what is upside down shows in their order."""
    return 2 if kind == "inverted" else 1


def series(windows: list[list[float]]) -> list[float]:
    return [value for window in [CALM] * WINDOWS + windows for value in window]


def raised(session: Any, m: int, **channels: list[list[float]]) -> list[dict[str, Any]]:
    """Return the episodes of one machine with their figures, in order of their channels."""
    rows: list[Row] = [
        ("a", name, time, value)
        for name, windows in channels.items()
        for time, value in enumerate(series(windows))
    ]
    table = scripts.telemetry(session, rows)
    calibration = gam_db.Calibration(intervals=[(0, WINDOWS * W - 1)])
    asked = (gam_db.Source(table.name), gam_db.Parameters(**SETTING, m=m), calibration, ALARMS)
    monitor = Monitor(session, *asked, prefix=engines.fresh_name("state"))
    monitor.migrate()
    monitor.calibrate()
    monitor.score()
    found = labels.alarms(monitor.state, monitor.name).to_pylist()
    counted = with_figures(found, figures(monitor.state.rows, monitor.name))
    return sorted(counted, key=lambda row: str(row["channel"]))


@pytest.mark.parametrize("kind", KINDS)
def test_a_sentence_says_what_the_row_of_figures_says(kind: str) -> None:
    windows, counted, finding, advice = KINDS[kind]
    (row,) = raised(engines.session("duckdb"), of_pairs(kind), x=windows)
    assert tuple(row[name] for name in COUNTED) == counted
    assert row["explains"] == (kind in ("tenth", "shifted", "inverted"))
    if kind in MOVES:
        assert tuple(row[name] for name in MOVED) == MOVES[kind]
    said = advise([row])
    assert said.finding == finding
    assert row["status"] == "proving"
    assert said.advice == KINDS["step"][3]
    said = advise([{**row, "status": "open"}])
    expected = "Check what was changed on the machine, or which work it did, when it began."
    assert said.advice == (expected if kind == "step" else advice)


def test_signals_that_opened_together_are_said_together() -> None:
    rows = raised(engines.session("duckdb"), 1, x=[HALF] * 6, y=[HALF] * 6, z=[FAR] * 6)
    assert [(row["channel"], row["signals_together"]) for row in rows] == [("x", 3), ("y", 3), ("z", 3)]
    alone = KINDS["step"][2][0].lower() + KINDS["step"][2][1:]
    start = "3 signals of this machine opened at the same time; the strongest, x: "
    assert advise(rows).finding == f"{start}{alone}"
    later = [rows[0], {**rows[1], "opened": rows[1]["opened"] + W}]
    assert advise(later).finding.startswith("2 signals of this machine opened within two judgements; ")
    lone = "One of 3 signals of this machine that opened within two judgements: "
    assert advise(rows[:1]).finding == f"{lone}{alone}"
    still = [{**row, "status": "open"} for row in rows]
    share = (
        "Check first what these signals have in common, and what was changed on the machine when "
        "they opened."
    )
    assert advise(still).advice == advise(still[:1]).advice == share
    assert advice_of(rows) == {row["episode"]: advise(rows) for row in rows}


def test_what_was_pruned_is_not_made_up() -> None:
    (row,) = raised(engines.session("duckdb"), 1, x=[HALF] * 6)
    counted = dict.fromkeys((*COUNTED, *MOVED))
    assert tuple(signs_of({**row, **counted})) == ("pruned", None, None, False)
    said = advise([{**row, **counted, "status": "open"}])
    assert said == (
        "The record of its beginning is no longer stored.",
        "Check its rows in the source, if they are still there.",
    )
    assert advice_of([{**row, "status": "withdrawn", "incident": None}]) == {row["episode"]: None}


def test_engines_agree_on_the_figures(engine: str) -> None:
    session = engines.session(engine)
    kinds = {"x": "growth", "y": "tenth", "z": "shifted"}
    rows = raised(session, 1, **{name: KINDS[kind][0] for name, kind in kinds.items()})
    rows += raised(session, 2, x=KINDS["inverted"][0])
    for row, kind in zip(rows, [*kinds.values(), "inverted"], strict=True):
        assert tuple(row[name] for name in COUNTED) == KINDS[kind][1]
        if kind in MOVES:
            assert tuple(row[name] for name in MOVED) == MOVES[kind]


def test_what_the_stated_rate_means() -> None:
    """Of channel 1, limit 2 is for judgements from 3 on, limit 1 made three of them."""
    names = "version_id limit_no from_judgement asked stated_rate reason"
    limits = rows(
        names,
        (1, 1, 0, "1 per month", 0.001, None),
        (1, 2, 3, "1 per week", 0.1, None),
        (2, 1, 0, "1 per month", None, "calibration too short"),
        (3, 1, 0, "1 per month", None, None),
        (4, 1, 0, "1 per month", 0.5, None),
    )
    judgements = [(version, number) for version in (1, 3, 4) for number in range(8)]
    found = step(
        "report/promises",
        {"monitor": "gam"},
        stored_monitor=rows("monitor_id name", (1, "gam"), (2, "other")),
        stored_channel=rows(
            "channel_id monitor_id asset channel",
            *((1, 1, "a", "x"), (2, 1, "b", "x"), (3, 1, "c", "x"), (4, 2, "a", "x")),
        ),
        stored_version=rows("version_id channel_id", *((number, number) for number in (1, 2, 3, 4))),
        stored_limit=limits,
        stored_visible_judgement=rows("version_id judgement_no", *judgements),
    )
    assert found == [
        ("a", "x", "1 per month", 0.001, 3),
        ("a", "x", "1 per week", 0.1, 5),
        ("c", "x", "1 per month", None, 8),
    ]
    columns = ("asset", "channel", "asked", "stated_rate", "judgements")
    held = [dict(zip(columns, row, strict=True)) for row in found]
    # 3 x 0.001 + 5 x 0.1 = 0.503 of 8 judgements: 62.9 per 1,000.
    stated = "Requested: 1 per month; 1 per week. Stated: 62.9 false alarms per 1,000 judgements "
    assert promise(held, 4) == (
        f"{stated}(8 judgements so far); a healthy fleet would have raised about one of these 4 "
        "in this time."
    )
    assert promise(held[:1], 4) == (
        "Requested: 1 per month. Stated: 1 false alarms per 1,000 judgements (3 judgements so far); a "
        "healthy fleet would have raised none of these 4 in this time."
    )
    many = promise([{**held[1], "judgements": 34}], 9)
    assert many is not None
    assert many.endswith("a healthy fleet would have raised about 3 of these 9 in this time.")
    assert promise(held[2:], 1) == "Requested: 1 per month. No rate can be stated."
    assert promise([], 3) is promise(held, 0) is None
