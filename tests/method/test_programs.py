"""Programs (both sides, section 5): a cell is of a program, and some programs are not judged."""

from typing import Any

import pyarrow as pa
import pytest
from hypothesis import given, settings

import comparisons
import engines
import gam_db
import harness
import probe_reference
import reference
import scripts
from gam_db.engines import NAMES
from gam_db.errors import ParameterError, SourceError
from gam_db.export.script import FORMS
from gam_db.study import Study
from harness import Answer, ProgramRow
from program_cases import ProgramCase, program_cases

#: step -> the answer of the reference
STEPS = {
    "health_indicator": reference.health_indicator,
    "bucket_health": reference.buckets,
    "support_summary": reference.support,
    "certificate": reference.certificate,
    "program_summary": reference.programs,
    "probes": probe_reference.probes,
}


def found_on(
    engine: str, rows: list[ProgramRow], method: tuple[Any, Any], **said: Any
) -> dict[str, Answer]:
    """Return what an engine answers of rows with programs, by steps."""
    session = engines.session(engine)
    with session.lent(harness.arrow(rows)) as table:
        study = Study(session, gam_db.Source(table.name, program="program", **said), *method)
        try:
            return {step: study.table(step).to_pylist() for step in STEPS}
        finally:
            study.forget()


def test_random_cases_equal_the_reference(engine: str) -> None:
    @settings(max_examples=engines.examples(engine))
    @given(case=program_cases(12))
    def agrees(case: ProgramCase) -> None:
        rows, *told = case
        method = harness.made(*told)
        found = found_on(engine, rows, method)
        for step, expected in STEPS.items():
            harness.assert_same(expected(rows, *method), found[step], step)
        comparisons.compared(engine, "exact", rows, *method)

    agrees()


def as_texts(rows: list[ProgramRow]) -> list[ProgramRow]:
    """Return rows as a script takes them that does not see what its column of programs holds."""
    return [(*row[:4], None if row[4] is None else str(row[4])) for row in rows]


def test_scripts_equal_the_reference(engine: str) -> None:
    @settings(max_examples=max(engines.examples(engine) // 4, 1))
    @given(case=program_cases(12))
    def agrees(case: ProgramCase) -> None:
        rows, *told = case
        method = harness.made(*told)
        found = scripts.on(engine, rows, *method)
        texts = as_texts(rows)
        expected = {
            "health_indicator": reference.health_indicator(texts, *method),
            "support": reference.support(texts, *method),
            "certificate": reference.certificate(texts, *method),
        }
        of_exact = scripts.of_one_query(engine, method[0]), method[1]
        expected["exact"] = reference.health_indicator(texts, *of_exact)
        for question, answer in expected.items():
            harness.assert_same(answer, found[question], question)

    agrees()


def told(verdicts: Answer) -> list[tuple[Any, ...]]:
    """Return of each row of a summary what is counted by hand below."""
    names = ("program", "verdict", "vectors", "unvouched", "readings", "first_time", "last_time")
    return [tuple(row[name] for name in names) for row in verdicts]


#: Two levels, one bin each. Calibration is the first 16 samples, blocks are its eighths of two vectors.
#: "a" runs at 0 and "b" at 1; then a wrong level of "b", one that is right for "a"; then "c".
BY_HAND: list[ProgramRow] = [
    *(("m", "x", i, float(i // 4 % 2), "ab"[i // 4 % 2]) for i in range(16)),
    *(("m", "x", 16 + i, 1.0, "b") for i in range(2)),
    *(("m", "x", 18 + i, 0.0, "b") for i in range(2)),
    *(("m", "x", 20 + i, 0.0, "a") for i in range(2)),
    *(("m", "x", 22 + i, 5.0, "c") for i in range(3)),
    ("m", "x", 25, 5.0, None),
    ("m", "x", 26, 5.0, "a"),
]


def test_cells_of_programs_by_hand(engine: str) -> None:
    method = harness.made({"m": 1, "bins": 2, "window": 4, "stride": 2}, {"duration": 15})
    found = found_on(engine, BY_HAND, method)
    # A level of 0 is code 2, of 1 code 3, above is 4; R = 5, so "b" adds 5.
    singles = [(row["time"], row["cell_key"], row["novel"]) for row in found["health_indicator"]]
    assert singles == [
        *((16, 3 + 5, 0), (17, 3 + 5, 0), (18, 2 + 5, 1), (19, 2 + 5, 1)),
        *((20, 2, 0), (21, 2, 0), (26, 4, 1)),
    ]
    assert [row["hi"] for row in found["bucket_health"]] == [None, 0.5, 0.5]
    assert told(found["program_summary"]) == [
        ("a", "ready", 8, 0, 3, 20, 26),
        ("b", "ready", 8, 0, 4, 16, 19),
        ("c", "unknown", 0, 0, 3, 22, 24),
        (None, "unknown", 0, 0, 1, 25, 25),
    ]
    (support,) = found["support_summary"]
    assert (support["cells"], support["calibration_vectors"], support["floor"]) == (2, 16, 0.0)
    # Without the column the wrong level of "b" is a right one, and "c" is judged.
    session = engines.session(engine)
    with session.lent(harness.arrow(BY_HAND)) as table:
        plain = gam_db.health_indicator(gam_db.Source(table.name), *method, session).to_pylist()
    assert [row["novel"] for row in plain] == [0] * 6 + [1] * 5


def test_programs_with_too_few_vectors_by_hand(engine: str) -> None:
    """One with 3 vectors of 4 that it takes, and one of whose vectors one block vouches for most."""
    runs = [*"a" * 40, *"b" * 3, *"c" * 8, *"a" * 29]
    rows: list[ProgramRow] = [("m", "x", i, float(i % 2), run) for i, run in enumerate(runs)]
    rows += [("m", "x", 80 + i, float(i % 2), run) for i, run in enumerate("aabbccaa")]
    settings = {"m": 1, "bins": 2, "window": 10, "stride": 2, "least_vectors": 4, "target_floor": 0.3}
    found = found_on(engine, rows, harness.made(settings, {"duration": 79}))
    # Blocks of 10: "b" runs in block 4 alone; "c" from 43 to 50, its last vector at level 0 in block 5.
    assert told(found["program_summary"]) == [
        ("a", "ready", 69, 0, 4, 80, 87),
        ("b", "needs_data", 3, 3, 2, 82, 83),
        ("c", "needs_data", 8, 4, 2, 84, 85),
    ]
    assert [row["time"] for row in found["health_indicator"]] == [80, 81, 86, 87]


def test_the_newest_sample_says_the_program(engine: str) -> None:
    """A vector over a change of programs is of the later one; m = 2, two bins, R = 5."""
    rows: list[ProgramRow] = [("m", "x", i, float(i // 2 % 2), "ab"[i // 4 % 2]) for i in range(24)]
    found = found_on(engine, rows, harness.made({"m": 2, "bins": 2, "window": 4}, {"duration": 16}))
    assert [row["cell_key"] for row in found["health_indicator"]] == [
        *(2 + 2 * 5, 3 + 2 * 5, 3 + 3 * 5),  # 17 to 19 run "a"
        *(25 + 2 + 3 * 5, 25 + 2 + 2 * 5, 25 + 3 + 2 * 5, 25 + 3 + 3 * 5),  # 20 to 23 run "b"
    ]


def test_two_programs_of_one_instant_are_a_conflict(engine: str) -> None:
    """The least one counts, and one that is told beside one that is not; equal rows are no conflict."""
    rows: list[ProgramRow] = [("m", "x", i, float(i % 2), [9, 10][i // 4 % 2]) for i in range(32)]
    rows += [
        *(("m", "x", 20, 0.0, 10), ("m", "x", 20, 0.0, 9)),  # 20 ran 10: now both are told
        ("m", "x", 21, 1.0, None),  # no conflict
        ("m", "x", 22, 0.0, 10),  # nor is this
        ("m", "x", 23, 0.5, 9),  # one conflict, of values and programs
        ("m", "x", 24, None, 10),  # of a missing value; 24 ran 9
    ]
    method = harness.made({"m": 1, "bins": 2, "window": 2}, {"duration": 15})
    found = found_on(engine, rows, method)
    assert found["support_summary"][0]["conflicts"] == 3
    numbers = {row["time"]: row["cell_key"] // 5 for row in found["health_indicator"]}
    assert [numbers[time] for time in range(19, 26)] == [0, 0, 1, 1, 0, 0, 0]


@pytest.mark.parametrize(
    ("told", "numbered"),
    [(["a", "ä", "B", "b"], ["B", "a", "b", "ä"]), (["9", "10", "2"], ["10", "2", "9"])],
)
def test_texts_are_numbered_by_their_bytes(engine: str, told: list[str], numbered: list[str]) -> None:
    assert numbered_on(engine, told) == numbered


def test_whole_numbers_are_numbered_by_size(engine: str) -> None:
    assert numbered_on(engine, [100, 9, -3, -20, 10]) == ["-20", "-3", "9", "10", "100"]


def numbered_on(engine: str, programs: list[Any]) -> list[str]:
    """Return programs in the order in which an engine numbers those of calibration."""
    rows: list[ProgramRow] = [("m", "x", i, float(i % 2), of) for i, of in enumerate(programs * 8)]
    found = found_on(engine, rows, harness.made({"m": 1, "bins": 2, "window": 4}, {"fraction": 1.0}))
    return [row["program"] for row in found["program_summary"]]


def test_programs_that_keys_have_no_room_for_are_refused(engine: str) -> None:
    """R^m = 50,003^4, of which 2^63 - 1 holds one; a channel whose keys are small has room for all."""
    rows: list[ProgramRow] = [
        (asset, "x", i, float(i % 2), "abc"[i // 8 % 3]) for asset in ("m", "n") for i in range(60)
    ]
    settings: dict[str, Any] = {"m": 4, "bins": 50_000, "window": 2}
    with pytest.raises(ParameterError) as refused:
        found_on(engine, rows, harness.made(settings, {"fraction": 0.5}))
    assert str(refused.value) == (
        "Calibration contains 3 programs, but the keys of cells have room for only 1 with m = 4 "
        "and bins = "
        "50000; use fewer bins, a smaller m, or a column with fewer programs."
    )
    of_one = [row for row in rows if row[0] == "n" or row[4] == "a"]
    method = harness.made({**settings, "overrides": [{"asset": "n", "bins": 100}]}, {"duration": 40})
    found = found_on(engine, of_one, method)
    for step, expected in STEPS.items():
        harness.assert_same(expected(of_one, *method), found[step], step)


def test_keys_near_the_largest_are_right(engine: str) -> None:
    """Four programs fit 38,000^4 in bins; the keys of the last lie beyond 2^62."""
    rows: list[ProgramRow] = [
        ("m", "x", i, float(i * 7919 % 13), "abcd"[i // 20 % 4]) for i in range(400)
    ]
    method = harness.made({"m": 4, "bins": 38_000, "window": 20, "target_floor": 0.9}, {"fraction": 0.6})
    found = found_on(engine, rows, method)
    assert max(row["cell_key"] for row in found["health_indicator"]) > 2**62
    for step, expected in STEPS.items():
        harness.assert_same(expected(rows, *method), found[step], step)


def test_wide_sources_say_one_program_of_all_their_columns(engine: str) -> None:
    columns = [f"c{n}" for n in range(7)]  # as many as are read in one select where an engine can
    rows: list[ProgramRow] = [
        ("m", column, i, None if i % 17 == n else float((i * (n + 3)) % 5), "ab"[i // 9 % 2])
        for n, column in enumerate(columns)
        for i in range(90)
    ]
    table = pa.table(
        {
            "asset": ["m"] * 90,
            "time": pa.array(range(90), pa.int64()),
            "recipe": ["ab"[i // 9 % 2] for i in range(90)],
            **{
                column: pa.array([row[3] for row in rows if row[1] == column], pa.float64())
                for column in columns
            },
        }
    )
    method = harness.made({"m": 2, "bins": 3, "window": 6}, {"fraction": 0.5})
    session = engines.session(engine)
    for channels in (columns, columns[:2]):
        with session.lent(table) as lent:
            source = gam_db.WideSource(lent.name, tuple(channels), "asset", program="recipe")
            health = gam_db.health_indicator(source, *method, session).to_pylist()
            summary = gam_db.programs(source, *method, session).to_pylist()
        of_these = [row for row in rows if row[1] in channels]
        harness.assert_same(reference.health_indicator(of_these, *method), health)
        harness.assert_same(reference.programs(of_these, *method), summary)
    with session.lent(table) as lent:  # of columns that are not named, that of programs is none
        source = gam_db.WideSource(lent.name, None, "asset", program="recipe")
        assert gam_db.support(source, *method, session)["channel"].to_pylist() == columns


def test_settings_are_chosen_over_all_programs(engine: str) -> None:
    """Delay, bins and window are those without the column; the certificate is by programs."""
    rows: list[ProgramRow] = [
        ("m", "x", i, float(10 * abs(i % 44 - 22) + 7919 * i % 17), ["b", "a", None][i // 150 % 3])
        for i in range(1500)
    ]
    method = harness.made({"tau": "auto", "bins": "auto", "window": "auto"}, {"fraction": 0.6})
    found = found_on(engine, rows, method)
    for step, expected in STEPS.items():
        harness.assert_same(expected(rows, *method), found[step], step)
    (_, pool), *_ = reference.channels(rows, *method)
    (_, plain), *_ = reference.channels([row[:4] for row in rows], *method)
    assert pool.settings == plain.settings


@pytest.mark.parametrize("engine", NAMES)
def test_a_script_without_programs_speaks_of_none(engine: str) -> None:
    for form in FORMS:
        plain = gam_db.render(form, engine, gam_db.Source("telemetry", time_kind="counter"))
        assert "program" not in plain
        named = gam_db.Source("telemetry", time_kind="counter", program="recipe")
        assert "program_no" in gam_db.render(form, engine, named)


def test_programs_are_asked_of_a_source_that_names_the_column() -> None:
    session = engines.session("duckdb")
    with session.lent(harness.arrow(BY_HAND)) as table:
        with pytest.raises(SourceError, match="names no program column"):
            gam_db.programs(gam_db.Source(table.name), engine=session)
        with pytest.raises(SourceError, match="recipe"):
            gam_db.programs(gam_db.Source(table.name, program="recipe"), engine=session)
