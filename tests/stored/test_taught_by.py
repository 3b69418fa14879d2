"""Whose a pool's certificate is, in every form: who taught, and what that says of the other members.

The pools are those of tests/spec/pooling.txt, where the figures are worked out.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest
from pyarrow import parquet
from typer.testing import CliRunner

import engines
import gam_db
import harness
import scripts
from gam_db.cli import app
from gam_db.findings import findings
from gam_db.stored.monitor import Monitor
from gam_db.study import Study
from visible import visible

PARAMETERS: dict[str, Any] = {"m": 1, "tau": 1, "bins": 4, "window": 1, "range": "min_max"}

ONE = "not vouched: only a taught"
TWO = "judged by a and b; of itself nothing is known"
THREE = "judged by a, b and c; of itself nothing is known"

#: name -> values of each asset from time 1 on, calibration, target floor, and what each asset must have:
#: verdict, floor, by machine, limit, machines that vouch, who taught, in words.
POOLS: dict[str, tuple[Mapping[str, Sequence[float]], Any, float, dict[str, tuple[Any, ...]]]] = {
    "one teaches": (
        {"a": [0] * 4 + [4] * 4 + [0], "b": [2, 0], "c": [4]},
        {"fraction": 1.0, "overrides": {"a": {"intervals": [(1, 8)]}}},
        0.25,
        {
            "a": ("ready", 0.0, None, 0.25, None, "a", None),
            "b": ("not_vouched", None, None, None, 1, "a", ONE),
            "c": ("not_vouched", None, None, None, 1, "a", ONE),
        },
    ),
    "two teach": (
        {"a": [0] * 6 + [4] * 2, "b": [0] * 6 + [2] * 2, "c": [4, 1]},
        {"fraction": 1.0, "reference": ["a", "b"]},
        0.25,
        {
            "a": ("blind", 0.0, 0.25, 0.25, None, "a and b", None),
            "b": ("blind", 0.0, 0.25, 0.25, None, "a and b", None),
            "c": ("blind", 0.25, 0.25, 0.5, 2, "a and b", TWO),
        },
    ),
    "three teach": (
        {"a": [0] * 6 + [4] * 2, "b": [0] * 6 + [2] * 2, "c": [0] * 4 + [1], "d": [1] * 3, "e": [0]},
        {
            "fraction": 1.0,
            "overrides": {"c": {"duration": 3}, "e": None},
            "reference": ["a", "b"],
        },
        0.2,
        {
            **dict.fromkeys("abc", ("blind", 0.0, 1 / 6, 0.2, None, "a, b and c", None)),
            "d": ("blind", 1 / 6, 1 / 6, 1 / 3, 3, "a, b and c", THREE),
            "e": ("blind", 1 / 6, 1 / 6, 1 / 3, 3, "a, b and c", THREE),
        },
    ),
}

COLUMNS = ("verdict", "floor", "member_floor", "hi_limit", "vouched_by", "taught_by")


def made(name: str) -> tuple[list[Any], gam_db.Parameters, gam_db.Calibration]:
    """The rows of a pool, its parameters and its calibration."""
    values, calibration, target, _ = POOLS[name]
    rows = [
        (asset, "x", time, float(value))
        for asset, said in values.items()
        for time, value in enumerate(said, start=1)
    ]
    return rows, *harness.made(
        {**PARAMETERS, "target_floor": target}, {"pool": "channel", **calibration}
    )


def compare(name: str, rows: list[dict[str, Any]], columns: tuple[str, ...] = COLUMNS) -> None:
    """Compare what a form says of each asset."""
    expected = POOLS[name][3]
    assert {row["asset"] for row in rows} == set(expected)
    for row in rows:
        for column, value in zip(columns, expected[row["asset"]], strict=False):
            is_float = isinstance(value, float)
            assert row[column] == (pytest.approx(value) if is_float else value), (row["asset"], column)


@pytest.mark.parametrize("name", POOLS)
def test_every_form_says_who_taught(engine: str, name: str) -> None:
    rows, parameters, calibration = made(name)
    session = engines.session(engine)
    table = scripts.telemetry(session, rows)
    source, prefix = gam_db.Source(table.name), engines.fresh_name("state")
    compare(name, gam_db.support(source, parameters, calibration, session).to_pylist())
    exact = findings(Study(session, source, parameters, calibration))
    compare(name, exact)
    monitor = Monitor(session, source, parameters, calibration, prefix=prefix)
    monitor.migrate()
    compare(name, monitor.calibrate().to_pylist())
    monitor.score()
    stored = visible(monitor, f"SELECT asset, {', '.join(COLUMNS)}, vouching FROM gam_fleet")
    compare(name, stored, (*COLUMNS, "vouching"))
    status = monitor.status().to_pylist()
    compare(name, status)
    words = {row["asset"]: row["vouching"] for row in stored}
    for row in (*exact, *status):  # the sentence of the view and no other
        said = [one for one in row["remarks"] if one.startswith(("judged by", "not vouched"))]
        assert said == [words[row["asset"]]] * (words[row["asset"]] is not None)
    taught = visible(monitor, "SELECT DISTINCT taught_by FROM gam_health")
    assert {row["taught_by"] for row in taught} == {next(iter(POOLS[name][3].values()))[5]}
    assert monitor.check_state().num_rows == 0


@pytest.mark.parametrize(
    ("teachers", "first", "code"),
    [
        (["a"], "not watched: 2 of 3 channels, because only a taught; name more", 2),
        (["a", "b"], "judged by a and b: 1 of 3 channels; their own healthy states are unknown", 2),
        (["*"], "columns:", 2),
        (["A"], "nobody taught: this source has no machine A", 4),
    ],
)
def test_it_is_said_first(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, teachers: list[str], first: str, code: int
) -> None:
    """Of a blind pool: exit code 2, too, where all taught."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "200")
    rows, *_ = made("two teach")
    parquet.write_table(harness.arrow(rows), "fleet.parquet")
    method = ["--m=1", "--tau=1", "--bins=4", "--window=1", "--target-floor=0.25", "--least-vectors=1"]
    method += ["--calibration-fraction=1", "--pool=channel", *(f"--reference={one}" for one in teachers)]
    for command in (["run", "--no-out"], ["calibrate", "--database", "f.duckdb"]):
        result = CliRunner().invoke(app, [*command, "fleet.parquet", *method])
        lines = [line for line in result.stdout.splitlines() if not line.startswith("state tables")]
        assert lines[1].startswith(first), result.stdout
        assert result.exit_code == code


def test_a_monitor_is_calibrated_anew_where_another_machine_teaches() -> None:
    """The rule of a machine that is named no more is another one, and its pool learns as a whole."""
    rows, parameters, _ = made("two teach")
    session = engines.session("duckdb")
    source = gam_db.Source(scripts.telemetry(session, rows).name)
    prefix, said = engines.fresh_name("state"), []
    for reference in (["a", "b"], ["a", "b"], ["a"]):
        calibration = gam_db.Calibration(1.0, pool="channel", reference=reference)
        with Monitor(session, source, parameters, calibration, prefix=prefix) as monitor:
            monitor.migrate()
            said.append([row["reason"] for row in monitor.calibrate().to_pylist()])
    assert said == [["first calibration"] * 3, [], ["pool changed", "other settings", "pool changed"]]
