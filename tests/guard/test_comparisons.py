"""The count of comparisons counts distinct ones, over all processes, and notices that some are gone."""

import os
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

import comparisons
import gam_db

ROWS: list[Any] = [(asset, "x", time, time % 5 + 0.5) for asset in "ab" for time in range(9)]
OTHER: list[Any] = [("c", "x", time, time % 4 + 0.5) for time in range(9)]


@pytest.fixture
def found(monkeypatch: pytest.MonkeyPatch) -> comparisons.Found:
    """What the test compares, beside what this process has compared."""
    monkeypatch.setattr(comparisons, "FOUND", defaultdict(set))
    return comparisons.FOUND


def compare(
    rows: list[Any] = ROWS,
    form: str = "exact",
    first: list[Any] | None = None,
    calibration: gam_db.Calibration | None = None,
    **parameters: Any,
) -> None:
    said = gam_db.Parameters(**{"m": 2, **parameters})
    comparisons.compared("sqlite", form, rows, said, calibration or gam_db.Calibration(), first)


def count(found: comparisons.Found) -> int:
    return sum(map(len, found.values()))


def test_the_same_series_counts_once_whatever_its_name_and_order(found: comparisons.Found) -> None:
    compare()
    compare(ROWS[::-1])
    compare([("z", "y", *row[2:]) for row in ROWS[:9]])
    assert count(found) == 1
    compare([*ROWS, *OTHER])
    assert count(found) == 2


@pytest.mark.parametrize(
    "changed",
    [
        {"rows": [*ROWS[:17], ("b", "x", 8, None)]},
        {"rows": [*ROWS[:17], ("b", "x", 8, float("nan"))]},
        {"rows": [*ROWS[:17], ("b", "x", 9, 3.5)]},
        {"tau": 2},
        {"overrides": [gam_db.Override(asset="b", bins=7)]},
        {"calibration": gam_db.Calibration(fraction=0.3)},
        {"calibration": gam_db.Calibration(overrides={"b": None})},
        {"calibration": gam_db.Calibration(score_from=4)},
        {"form": "view"},
        {"first": ROWS[:5]},
    ],
)
def test_another_series_or_setting_counts(found: comparisons.Found, changed: dict[str, Any]) -> None:
    compare()
    compare(**changed)
    assert count(found) == 2


def test_a_pool_counts_by_what_it_learns_from(found: comparisons.Found) -> None:
    pooled = gam_db.Calibration(pool="channel")
    compare()
    compare(calibration=pooled)
    assert count(found) == 2, "the pool of two is another than one that is alone"
    compare([*ROWS, *OTHER], calibration=pooled)
    assert count(found) == 4, "a third member changes what the others are judged by"
    compare([*ROWS, *OTHER], calibration=gam_db.Calibration(pool=[["a", "b"], ["nobody"]]))
    assert count(found) == 5, "only the third, which is alone there"


def test_forms_and_engines_are_told_apart(found: comparisons.Found) -> None:
    compare()
    compare(form="view")
    comparisons.compared_recording("duckdb", "exact", "plant", "c8", "x")
    comparisons.compared_recording("duckdb", "exact", "plant", "c8", "y")
    assert comparisons.table(found) == [
        "             exact  view  all forms",
        "     duckdb      2                2",
        "     sqlite      1     1          2",
        "all engines                       4",
    ]
    assert comparisons.shortfalls(found, {"duckdb": 2, "sqlite": 2}) == []
    (said,) = comparisons.shortfalls(found, {"duckdb": 3, "sqlite": 1})
    assert said.startswith("duckdb: 2 comparisons")


def test_what_another_process_compared_is_taken_over(found: comparisons.Found) -> None:
    compare(OTHER)
    told: dict[str, Any] = {}
    config = SimpleNamespace(workeroutput=told)
    comparisons.pytest_sessionfinish(SimpleNamespace(config=config))  # type: ignore[arg-type]
    found.clear()
    compare(ROWS)
    comparisons.pytest_testnodedown(SimpleNamespace(workeroutput=told))
    comparisons.pytest_testnodedown(SimpleNamespace(workeroutput=told))
    comparisons.pytest_testnodedown(SimpleNamespace())  # one that died
    assert count(found) == 2


def suite(folder: Path, least: int, *words: str) -> tuple[int, str]:
    """Run a suite of two tests, which must compare so much; return its code and output."""
    tests = folder / "tests"
    tests.mkdir(exist_ok=True)
    (tests / "pytest.ini").write_text(
        f"[pytest]\ntestpaths = .\npythonpath = {os.pathsep.join(sys.path)}"
    )
    (tests / "conftest.py").write_text(
        "import pathlib\npytest_plugins = ['comparisons']\n"
        "def pytest_addoption(parser): parser.addoption('--engines', default='fast')\n"
        "def pytest_configure(config):\n"
        "    import comparisons\n"
        "    comparisons.FILE = pathlib.Path(__file__).with_name('least.txt')\n"
    )
    (tests / "least.txt").write_text(f"sqlite {least}\n")
    (tests / "test_two.py").write_text(
        "import comparisons\n"
        "def test_one(): comparisons.compared_recording('sqlite', 'exact', 'one')\n"
        "def test_two(): comparisons.compared_recording('sqlite', 'exact', 'two')\n"
    )
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-q", *words],
        cwd=tests,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)},
    )
    return done.returncode, done.stdout


def test_a_whole_run_that_compares_less_fails(tmp_path: Path) -> None:
    code, said = suite(tmp_path, 3, "--engines", "all", "-n", "2")
    assert code == 1
    assert "sqlite: 2 comparisons with the NumPy reference, and 3 were kept" in said
    assert "all engines 2" in " ".join(said.split())
    assert "2 passed" in said


def test_a_part_of_a_run_need_not_compare_all() -> None:
    """Only all tests on all engines are a whole run."""
    sources = pytest.Config.ArgsSource

    def is_whole(source: Any, engines: str, keyword: str) -> bool:
        options = {"--engines": engines, "keyword": keyword}
        config = SimpleNamespace(args_source=source, getoption=options.__getitem__)
        return comparisons.is_whole(config)  # type: ignore[arg-type]

    assert is_whole(sources.TESTPATHS, "all", "")
    assert not is_whole(sources.ARGS, "all", "")
    assert not is_whole(sources.TESTPATHS, "fast", "")
    assert not is_whole(sources.TESTPATHS, "all", "stored")
