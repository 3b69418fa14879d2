"""Sources that pause, or whose signals stand still, with instants taken for single: as the reference."""

from typing import Any

import pytest

import comparisons
import engines
import gam_db
import harness
from gam_db.engines.session import Session
from gam_db.method import census
from gam_db.study import Study
from harness import Answer, Row

pytestmark = pytest.mark.thorough

LENGTH = 150

#: Samples after which each asset pauses for a while: in calibration, at its end, in what is
#: scored, again before a vector is whole, and never.
PAUSES = {"a": (20, 22, 23, 59, 60, 61, 100, 131), "b": (45, 90), "c": (1, 148), "d": ()}

#: Tens of samples in which the signals of an asset do not move: in calibration, where scoring begins,
#: later on and at the end.
STILL = {"a": (1, 6, 12), "b": (4, 9), "c": (0, 5, 14), "d": ()}

#: name -> keyword arguments of Parameters and of Calibration
CASES: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "delays": (
        {"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5, "max_gap": 3},
        {"fraction": 0.4},
    ),
    "a longer vector": (
        {"m": 3, "tau": 4, "bins": 3, "window": 6, "max_gap": 2},
        {"fraction": 0.5},
    ),
    "a longer delay": (
        {"m": 2, "tau": 9, "bins": 3, "window": 6, "max_gap": 2},
        {"fraction": 0.5},
    ),
    "one coordinate": ({"m": 1, "bins": 5, "window": 12, "stride": 4, "max_gap": 2}, {"duration": 90}),
    "sets of which one has no end, and calibration that is cut": (
        {
            "m": 2,
            "bins": 4,
            "window": 8,
            "max_gap": 1_000,
            "overrides": [{"channel": "y", "m": 3, "max_gap": 3}],
        },
        {
            "fraction": 0.4,
            "exclude": [(9, 30), (41, 41)],
            "overrides": {"b": {"duration": 70, "score_from": 120}},
        },
    ),
}

#: name -> the same, where samples count as still
HELD: dict[str, tuple[dict[str, Any], dict[str, Any]]] = {
    "still": (
        {"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5, "still_after": 4},
        {"fraction": 0.4},
    ),
    "still at once, and segments": (
        {"m": 2, "tau": 3, "bins": 5, "window": 9, "max_gap": 3, "still_after": 2},
        {"fraction": 0.4},
    ),
    "still, one coordinate": ({"m": 1, "bins": 5, "window": 12, "still_after": 10}, {"duration": 90}),
    "longer than anything stands": (
        {"m": 2, "bins": 4, "window": 8, "still_after": 12},
        {"fraction": 0.3},
    ),
    "still before a late interval": (
        {"m": 2, "bins": 4, "window": 8, "still_after": 5},
        {"intervals": [(26, 61), (90, 120)]},
    ),
    "sets of which one counts nothing as still, exclusions, a pool and a late start": (
        {
            "m": 2,
            "bins": 4,
            "window": 8,
            "still_after": 5,
            "overrides": [{"channel": "y", "m": 3, "max_gap": 3, "still_after": None}],
        },
        {
            "fraction": 0.4,
            "pool": "channel",
            "exclude": [(24, 30), (41, 41)],
            "overrides": {"b": {"duration": 70, "score_from": 120}, "c": None},
        },
    ),
}

#: The rows that have a second reading, at the same instant: of calibration, and the last one.
AGAIN = {"as long as a frame": (31,), "one coordinate": (-1,), "still": (180,)}


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cut short sources into as many slices as long ones."""
    monkeypatch.setattr(census, "IN_SLICE", 1)


def rows() -> list[Row]:
    """Channels by time that repeat a pattern, and later on less so; some samples of one are missing."""
    found = []
    for place in range(LENGTH):
        for number, (asset, pauses) in enumerate(PAUSES.items()):
            time = 2 * place + 7 * sum(place >= pause for pause in pauses)
            found += [(asset, channel, time, sample(asset + channel, number, place)) for channel in "xy"]
    return sorted(found, key=lambda row: (row[2], row[0]))


def sample(name: str, number: int, place: int) -> float | None:
    if place // 10 in STILL[name[0]]:
        return 1.75
    if name == "bx" and place % 23 in (5, 6):
        return None
    return float(place % (5 + number) if place < 90 or place % 7 else place % 11) - 0.25


def answers(
    session: Session, table: list[Row], method: tuple[Any, Any]
) -> tuple[dict[str, Answer], bool]:
    """Return what a study answers of all that it can be asked for, and whether on trust."""
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True)
        questions = ("health_at_buckets", "support", "certificate")
        found = {name: study.table(harness.STEPS[name]).to_pylist() for name in questions}
        is_trusting = study.form == "census"
        found["standing"] = standing(study)
        found["health_indicator"] = study.table("health_indicator").to_pylist()
        study.forget()
        looking = Study(session, gam_db.Source(lent.name), *method)
        assert found.pop("standing") == standing(looking)
        looking.forget()
    return found, is_trusting


@pytest.mark.parametrize("case", ["still", "still at once, and segments"])
@pytest.mark.parametrize("has_room", [True, False])
def test_what_stands_still_is_kept_where_it_has_room(
    case: str, has_room: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else it is told again for each step that asks; the integers are the same."""
    session, method = engines.session("duckdb"), harness.made(*HELD[case])
    if not has_room:
        monkeypatch.setattr(session, "rows_at_once", lambda: len(rows()) - 1)
    with session.lent(harness.arrow(rows())) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True)
        found = study.table("bucket_health").to_pylist()
        assert study.form == "census"
        for step in ("incomplete_moving_codes", "incomplete_vectors"):
            assert (step in study.running.tables) is has_room
        summary = study.table("support_summary").to_pylist()
        ends = standing(study)
        study.forget()
        looking = Study(session, gam_db.Source(lent.name), *method)
        assert ends == standing(looking)
        looking.forget()
    for question, answer in (("health_at_buckets", found), ("support", summary)):
        harness.assert_same(harness.by_reference(question, rows(), *method), answer, question)


def standing(study: Study) -> list[Any]:
    """Return the channels that stand still at their end, and since when."""
    rows = study.table("stillness").select(["channel_id", "still_since"]).to_pylist()
    return sorted((one["channel_id"], one["still_since"]) for one in rows if one["still_since"])


@pytest.mark.parametrize("case", [*CASES, *HELD])
def test_what_is_interrupted_is_as_in_the_reference_on_trust(engine: str, case: str) -> None:
    method = harness.made(*(CASES | HELD)[case])
    table = [*rows(), *((*rows()[number][:3], 7.5) for number in AGAIN.get(case, ()))]
    found, is_trusting = answers(engines.session(engine), table, method)
    assert is_trusting
    expected = harness.all_by_reference(table, *method)
    for question in harness.STEPS:
        harness.assert_same(expected[question], found[question], question)
    comparisons.compared(engine, "interrupted", table, *method)


@pytest.mark.parametrize("last", ["support", "health_at_buckets"])
def test_a_channel_without_a_range_is_counted_as_well(last: str) -> None:
    """Its vectors are none that are kept: nothing is scored of it, but some lack a sample."""
    table: list[Row] = [
        ("a", "x", time, None if time < 60 else float(time % 4)) for time in range(LENGTH)
    ]
    table += [("b", "x", time, float(time * time % 11) if time % 7 else None) for time in range(LENGTH)]
    method = harness.made(*HELD["still at once, and segments"])
    session = engines.session("duckdb")
    with session.lent(harness.arrow(table)) as lent:
        study = Study(session, gam_db.Source(lent.name), *method, short_cuts=True)
        for question in sorted(("support", "health_at_buckets"), key=last.__eq__):
            found = study.table(harness.STEPS[question]).to_pylist()
            harness.assert_same(harness.by_reference(question, table, *method), found, question)
        study.forget()
