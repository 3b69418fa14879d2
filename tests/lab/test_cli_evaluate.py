"""``gam evaluate``: what a user sees, and the exit codes."""

import json
from pathlib import Path
from typing import Any

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet
from rich.cells import cell_len
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app, options

OUTCOMES = """asset,channel,failed_at,healthy
robot 1,joint 1,2026-01-03 10:00:00,false
robot 2,joint 1,,false
robot 3,,,true
robot 9,,,true
"""


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    Path("outcomes.csv").write_text(OUTCOMES)
    parquet.write_table(plant(3), "health.parquet")
    return tmp_path


def plant(robots: int) -> pa.Table:
    """Two joints of each robot at bucket ends; joint 1 of the first two wears out, one is constant."""
    generator = np.random.default_rng(0)
    parts = []
    for robot in range(1, robots + 1):
        for joint in (1, 2):
            worn = joint == 1 and robot < 3
            rates = np.linspace(0.05, 0.4 if worn else 0.05, 80)
            novel = np.zeros(80, int) if (robot, joint) == (3, 2) else generator.binomial(100, rates)
            counts = np.convolve(novel, np.ones(10, int), "valid").tolist()
            table = {
                "asset": [f"robot {robot}"] * 80,
                "channel": [f"joint {joint}"] * 80,
                "bucket": range(80),
                "last_time": pa.array(
                    1767225600_000000 + np.arange(80) * 3600_000000, pa.timestamp("us")
                ),
                "novel_in_window": pa.array([None] * 9 + counts, pa.int64()),
                "hi": pa.array([None] * 9 + [count / 1000 for count in counts], pa.float64()),
            }
            parts.append(pa.table(table))
    return pa.concat_tables(parts)


def gam(*words: str | Path) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, [str(word) for word in words])


def test_the_table_can_be_read() -> None:
    result = gam("evaluate", "health.parquet", "--outcomes", "outcomes.csv", "--all")
    assert result.exit_code == 0, result.output
    lines = result.stdout.splitlines()
    assert max(map(cell_len, lines)) <= 80
    assert "2 failed, 2 of healthy assets, 2 not judged" in " ".join(lines)
    assert "not in the table: 1" in result.stdout
    rows = {line[2:17]: line for line in lines if line[2:].startswith("robot") and line[0] != "-"}
    assert rows["robot 1 joint 1"].split()[4:7] == ["failed", "50", "5"], "it ends with the failure"
    assert rows["robot 2 joint 1"].split()[7].startswith("+0.9")
    assert rows["robot 3 joint 1"].startswith("~"), "a healthy one is like chance"
    assert rows["robot 3 joint 2"].split()[-1] == "-"
    (remark,) = (line for line in lines if line.startswith("- robot 3 joint 2: "))
    assert "the indicator is constant" in remark
    for metric in ("Mon", "Corr", "Rob", "Prog", "Disc", "Trendability", "Global"):
        (line,) = (line for line in lines if line.split()[:1] == [metric] and line.startswith("  "))
        assert " to " in line


def test_without_outcomes_it_says_what_is_missing() -> None:
    result = gam("evaluate", "health.parquet", "--surrogates", "0")
    assert result.exit_code == 0, result.output
    assert "with further remarks: --all" in result.stdout
    assert result.stdout.count("needs --outcomes") == 3
    assert "chance" not in result.stdout.casefold()
    assert "outcome " not in result.stdout


def test_json_is_what_the_library_returns() -> None:
    options = ("--monotonicity", "sign", "--amplitude", "ends", "--ddof", "1", "--seed", "3")
    result = gam("evaluate", "health.parquet", "--outcomes", "outcomes.csv", "--json", *options)
    assert result.exit_code == 0, result.output
    told = json.loads(result.stdout)
    conventions = gam_db.Conventions(monotonicity="sign", amplitude="ends", ddof=1, seed=3)
    expected = gam_db.evaluate("health.parquet", "outcomes.csv", conventions=conventions)
    assert told["channels"] == expected.channels.to_pylist()
    assert told["summary"] == expected.summary.to_pylist()
    assert told["unmatched"] == 1


def test_tables_of_a_database() -> None:
    connection = duckdb.connect("plant.duckdb")
    connection.execute("CREATE TABLE hi AS SELECT * FROM 'health.parquet'")
    connection.execute("CREATE TABLE fate AS SELECT * FROM 'outcomes.csv'")
    connection.close()
    words: list[Any] = ["--surrogates", "0", "--samples", "0", "--json"]
    found = gam("evaluate", "hi", "--outcomes", "fate", "--database", "plant.duckdb", *words)
    files = gam("evaluate", "health.parquet", "--outcomes", "outcomes.csv", *words)
    assert json.loads(found.stdout)["channels"] == json.loads(files.stdout)["channels"]


def test_many_channels_are_cut_unless_all_are_asked_for() -> None:
    parquet.write_table(plant(30), "fleet.parquet")
    few, all_of_them = (
        gam("evaluate", "fleet.parquet", "--surrogates", "0", "--samples", "0", *words).stdout
        for words in ((), ("--all",))
    )
    assert f"and {60 - options.SHOWN} more; --all" in few
    assert "robot 30 joint 2" not in few
    assert "robot 30 joint 2" in all_of_them


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (("nothing",), "HEALTH is 'nothing', which is no Parquet"),
        (("health.parquet", "--outcomes", "fate"), "--outcomes is 'fate'"),
        (("gone.parquet",), "gone.parquet cannot be read"),
        (("outcomes.csv",), "no column 'hi'"),
        (("health.parquet", "--outcomes", "health.parquet"), "need a column 'failed_at'"),
        (("health.parquet", "--confidence", "95"), "confidence is 95"),
    ],
)
def test_what_the_user_can_mend_is_told(words: tuple[str, ...], says: str) -> None:
    result = gam("evaluate", *words)
    assert result.exit_code == 1
    assert says in " ".join(result.stderr.split())
    assert result.stdout == ""


def test_of_a_row_per_vector_the_bucket_ends_are_taken() -> None:
    random = np.random.default_rng(4)
    series = pa.table(
        {"time": np.arange(4000), "value": np.sin(np.arange(4000) / 9) + random.random(4000)}
    )
    source = gam_db.Source(series, asset=None, channel=None)
    parameters = gam_db.Parameters(m=2, bins=12, window=150)
    vectors = gam_db.health_indicator(source, parameters)
    parquet.write_table(vectors, "vectors.parquet")
    parquet.write_table(gam_db.health_at_buckets(source, parameters), "buckets.parquet")
    words = ("--json", "--surrogates", "2", "--samples", "0")
    by_vector, by_bucket, every, coarse = (
        json.loads(gam("evaluate", name, *words, *more).stdout)
        for name, more in (
            ("vectors.parquet", ()),
            ("buckets.parquet", ()),
            ("vectors.parquet", ("--stride", "1")),
            ("vectors.parquet", ("--stride", "75")),
        )
    )
    assert [one["stride"] for one in (by_vector, by_bucket, every, coarse)] == [50, 1, 1, 75]
    (one,), (other,) = by_vector["channels"], by_bucket["channels"]
    assert one == other
    assert one["mon_chance"] is not None
    assert every["channels"][0]["k"] == sum(hi is not None for hi in vectors["hi"].to_pylist())
    assert coarse["channels"][0]["independent_windows"] == one["independent_windows"]
    said = " ".join(gam("evaluate", "vectors.parquet", "--samples", "0").stdout.split())
    assert "at the end of each bucket of 50 are taken" in said
    doubled = pa.concat_tables([vectors, vectors.slice(7, 1)])
    parquet.write_table(doubled, "doubled.parquet")
    assert gam("evaluate", "doubled.parquet").exit_code == 1
