"""What would be seen if the machine changed (both sides, section 2): golden figures, on every engine."""

from typing import Any

import duckdb
import pytest
from hypothesis import given, settings

import engines
import gam_db
import harness
import probe_reference
import reference
from gam_db.findings import findings
from gam_db.study import Study, naming
from harness import Row
from strategies import Case, cases

#: asset -> its delay, whether its blocks differ, how many vectors are picked, and how many of them are
#: novel after each change; at other speeds both integers
GOLDEN: dict[str, tuple[int, int, int, list[int], list[Any]]] = {
    "alike, tau 1": (
        *(1, 0, 1000),
        [38, 31, 85, 76, 65, 59, 125, 125, 205, 210, 471, 484, 42, 70, 304, 187],
        [(332, 999), (635, 999), (None, None)],
    ),
    "alike, tau 5": (
        *(5, 0, 999),
        [53, 45, 127, 120, 285, 274, 473, 470, 562, 559, 829, 823, 999, 718, 653, 999],
        [(930, 997), (996, 996), (845, 999)],
    ),
    "rising, tau 1": (
        *(1, 1, 1000),
        [2, 1, 5, 4, 22, 22, 76, 75, 167, 170, 435, 434, 0, 2, 198, 21],
        [(308, 999), (640, 999), (None, None)],
    ),
    "rising, tau 5": (
        *(5, 1, 999),
        [10, 5, 18, 14, 83, 72, 312, 301, 532, 525, 799, 794, 999, 445, 526, 999],
        [(898, 997), (996, 996), (637, 999)],
    ),
}

NAMES = [
    *(f"shift {sign}{part} %" for part in (1, 2, 5, 10, 20, 50) for sign in "+-"),
    *("stroke 0.5", "stroke 0.8", "stroke 1.2", "frozen", "speed 3/2", "speed 2/1", "speed 2/3"),
]


def stroke(place: int, rise: int = 0) -> float:
    """A stroke of 44 samples with some noise that repeats, and a drift where there is one."""
    return float(10 * abs(place % 44 - 22) + 7919 * place % 17 + rise * (place // 400))


def test_golden_figures(engine: str) -> None:
    rows: list[Row] = [
        (name, "x", i, stroke(i, rise)) for name, (_, rise, *_) in GOLDEN.items() for i in range(6000)
    ]
    overrides = [{"asset": name, "tau": tau} for name, (tau, *_) in GOLDEN.items()]
    method = harness.made(
        {"m": 3, "bins": 16, "window": 500, "range": "min_max", "overrides": overrides},
        {"fraction": 1.0},
    )
    session = engines.session(engine)
    with session.lent(harness.arrow(rows)) as table:
        found = gam_db.probe(gam_db.Source(table.name), *method, session).to_pylist()
    for name, (_, _, picked, alone, speeds) in GOLDEN.items():
        told = [(row["novel"], row["vectors"]) for row in found if row["asset"] == name]
        assert told == [*((novel, picked) for novel in alone), *speeds]
        assert [row["change_name"] for row in found if row["asset"] == name] == NAMES


def damaged() -> tuple[list[Row], Any, Any]:
    """Missing samples, two segments, a dropped sample, samples that stand still, a pool; m = 2."""
    rows: list[Row] = []
    for asset in ("a", "b", "c"):
        for i in range(900):
            value: float | None = stroke(i, int(asset == "b"))
            value = None if i % 97 == 13 else 1e9 if i == 500 else 40.0 if 300 < i < 320 else value
            rows.append((asset, "x", i + 50 * (i > 410), value))
    settings = {"m": 2, "tau": 4, "bins": 12, "window": 60, "max_gap": 10, "still_after": 9}
    overrides = [{"asset": "c", "m": 1}]
    calibration = {"fraction": 0.8, "exclude": [(200, 210)], "pool": [["a", "b"]]}
    return rows, *harness.made({**settings, "overrides": overrides}, calibration)


#: Of the pool of a and b, as the reference counts: vectors and novel.
DAMAGED = {
    "shift +5 %": (671, 25),
    "stroke 0.5": (671, 113),
    "frozen": (671, 486),
    "speed 3/2": (656, 18),
}


def test_missing_samples_segments_and_pools(engine: str) -> None:
    rows, parameters, calibration = damaged()
    method = parameters, calibration
    session = engines.session(engine)
    with session.lent(harness.arrow(rows)) as table:
        found = gam_db.probe(gam_db.Source(table.name), *method, session).to_pylist()
    harness.assert_same(probe_reference.probes(rows, *method), found)
    told = {row["change_name"]: (row["vectors"], row["novel"]) for row in found if row["asset"] == "a"}
    assert {name: told[name] for name in DAMAGED} == DAMAGED


def test_random_sources(engine: str) -> None:
    @settings(max_examples=max(engines.examples(engine) // 4, 1))
    @given(case=cases(8))
    def agrees(case: Case) -> None:
        rows, parameters, calibration = case
        method = harness.made(parameters, calibration)
        session = engines.session(engine)
        with session.lent(harness.arrow(rows)) as table:
            study = Study(session, gam_db.Source(table.name), *method)
            found = study.table("probes").to_pylist()
            study.forget()
        harness.assert_same(probe_reference.probes(rows, *method), found)

    agrees()


@pytest.mark.parametrize("body", ["census", "streams"])
def test_each_body_probes_the_same(body: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in {"STREAMED_FROM": 1, "EVERY": 8, "GLANCE": 100}.items():
        monkeypatch.setattr(naming, name, value)
    rows: list[Row] = [(asset, "x", i, stroke(i, 1)) for asset in "ab" for i in range(600)]
    method = harness.made({"m": 3, "tau": 2, "bins": 9, "window": 50}, {"fraction": 0.5})
    session = engines.session("duckdb")
    with session.lent(harness.arrow(rows if body == "streams" else rows[::2] + rows[1::2])) as table:
        study = Study(session, gam_db.Source(table.name), *method, short_cuts=True)
        assert study.table("bucket_health").num_rows
        harness.assert_same(probe_reference.probes(rows, *method), study.table("probes").to_pylist())
        assert study.form == body
        study.forget()


def test_it_is_kept_and_checked() -> None:
    rows: list[Row] = [("a", "x", i, stroke(i, 1)) for i in range(900)]
    method = harness.made({"m": 2, "tau": 3, "bins": 9, "window": 50}, {"fraction": 0.8})
    with duckdb.connect() as connection:
        telemetry = harness.arrow(rows)  # noqa: F841
        connection.execute("CREATE TABLE telemetry AS FROM telemetry")
        monitor = gam_db.Monitor(connection, gam_db.Source("telemetry"), *method)
        monitor.migrate()
        monitor.calibrate()
        kept = connection.execute(
            "SELECT change_name, vectors, novel FROM gam_probe ORDER BY change_no"
        ).fetchall()
        expected = probe_reference.probes(rows, *method)
        assert kept == [(row["change_name"], row["vectors"], row["novel"]) for row in expected]
        taught = sorted(stroke(i, 1) for i in range(3, 720))  # all 717 vectors are picked
        usual = connection.execute(
            "SELECT usual_low, usual_middle, usual_high FROM gam_state_bounds"
        ).fetchall()
        assert usual == [(taught[(717 + 19) // 20 - 1], taught[359 - 1], taught[717 - 717 // 20 - 1])]
        assert monitor.check_state().num_rows == 0
        connection.execute("UPDATE gam_probe SET novel = novel + 1 WHERE change_no = 4")
        (wrong,) = monitor.check_state().to_pylist()
        assert (wrong["part"], wrong["differing"]) == ("calibration", 1)


def members(teaching: int) -> tuple[list[Row], Any, Any]:
    """Return a pool of four machines, a little different from each other, of which so many taught."""
    rows: list[Row] = [
        (f"m{asset}", "x", i, stroke(i) + 25.0 * asset) for asset in range(4) for i in range(900)
    ]
    reference = [f"m{asset}" for asset in range(teaching)]
    calibration = gam_db.Calibration(intervals=[(0, 599)], pool=[["m*"]], reference=reference)
    return rows, gam_db.Parameters(m=2, tau=3, bins=8, window=60, target_floor=0.2), calibration


@pytest.mark.parametrize("teaching", [1, 2, 4])
def test_members_that_taught_nothing(engine: str, teaching: int) -> None:
    rows, parameters, calibration = members(teaching)
    method = parameters, calibration
    session = engines.session(engine)
    with session.lent(harness.arrow(rows)) as table:
        found = gam_db.support(gam_db.Source(table.name), *method, session).to_pylist()
    harness.assert_same(reference.support(rows, *method), found)
    teachers = {1: "m0", 2: "m0 and m1", 4: "m0, m1 and 2 more"}[teaching]
    assert {row["taught_by"] for row in found} == {teachers}
    counts = [None] * teaching + [teaching] * (4 - teaching)
    assert [row["vouched_by"] for row in found] == counts
    if teaching == 1:
        assert {(row["verdict"], row["hi_limit"]) for row in found[1:]} == {("not_vouched", None)}
        assert {row["member_floor"] for row in found} == {None}
    else:
        (member_floor,) = {row["member_floor"] for row in found}
        assert member_floor > found[0]["floor"]
    if teaching == 2:
        assert found[2]["floor"] == member_floor


@pytest.mark.parametrize("teaching", [1, 2])
def test_the_state_keeps_what_others_say(teaching: int) -> None:
    rows, parameters, calibration = members(teaching)
    method = parameters, calibration
    expected = reference.support(rows, *method)
    with duckdb.connect() as connection:
        telemetry = harness.arrow(rows)  # noqa: F841
        connection.execute("CREATE TABLE telemetry AS FROM telemetry")
        monitor = gam_db.Monitor(connection, gam_db.Source("telemetry"), *method)
        monitor.migrate()
        monitor.calibrate()
        names = "verdict, floor, floor_max, finest_bins, vectors_needed, hi_limit, sees"
        names += ", vouched_by, taught_by, member_floor"
        kept = connection.execute(f"SELECT {names} FROM gam_fleet ORDER BY asset").fetchall()
        assert kept == [
            tuple(
                value if isinstance(value := row[name], str) else pytest.approx(value)
                for name in names.split(", ")
            )
            for row in expected
        ]
        assert monitor.check_state().num_rows == 0


def spiked(i: int) -> float:
    """One reading of 9999 in calibration; later the machine goes from 50 to 110."""
    return 9999.0 if i == 77 else 110.0 if i >= 6000 else 50.0 + stroke(i) / 80


#: A machine that changes after 6,000 samples, by asset, and what of it may not be seen, in words.
SITUATIONS: dict[str, tuple[Any, str]] = {
    "one reading of 9999": (spiked, "nothing"),
    "frozen": (lambda i: stroke(min(i, 6000)), "a frozen sensor"),
    "30 % of its stroke": (lambda i: stroke(i) if i < 6000 else 118 + 0.3 * (stroke(i) - 118), "stroke"),
    "another speed": (lambda i: stroke(i if i < 6000 else 2 * i), "speed"),
}


@pytest.mark.parametrize("settings", [{"tau": 1, "bins": "auto"}, {"tau": 1, "bins": 128}, {"tau": 11}])
def test_a_fault_raises_its_machine_or_the_verdict_warns(settings: dict[str, Any]) -> None:
    rows: list[Row] = [
        (name, "x", i, value(i)) for name, (value, _) in SITUATIONS.items() for i in range(9000)
    ]
    method = harness.made({"m": 3, "bins": 32, "window": 500, **settings}, {"fraction": 2 / 3})
    session = engines.session("duckdb")
    with session.lent(harness.arrow(rows)) as table:
        found = findings(Study(session, gam_db.Source(table.name), *method))
    assert len(found) == len(SITUATIONS)
    for row in found:
        unseen = row["would_not_see"] or ""
        warned = row["verdict"] == "blind" or SITUATIONS[row["asset"]][1] in unseen
        assert row["is_above"] == 1 or warned, row
