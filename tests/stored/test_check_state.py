"""``gam check --state``: what is printed, what is recorded, and what ``gam status`` says of it."""

import json
from functools import cache
from pathlib import Path

import duckdb
import pytest
from typer.testing import CliRunner, Result

import small_plant
from gam_db.cli import app, check
from gam_db.errors import EngineError
from visible import put


@cache
def begun() -> bytes:
    """A database file with a state in order; making it takes longer than a test."""
    with duckdb.connect("begun.duckdb") as connection:
        small_plant.begin(connection)
    return Path("begun.duckdb").read_bytes()


@pytest.fixture
def plant(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A file with a state in order, in a folder of its own."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    Path("plant.duckdb").write_bytes(begun())
    return tmp_path / "plant.duckdb"


def gam(*words: str) -> Result:
    return CliRunner().invoke(app, [*words, "--database", "plant.duckdb"])


def changed(statement: str) -> None:
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute(statement).fetchall()


def said(result: Result) -> str:
    return " ".join(result.stdout.split())


def test_a_check_is_recorded_and_told_by_status(plant: Path) -> None:
    never = gam("status")
    assert "the state was never compared with its source; run gam check --state" in said(never)
    assert json.loads(gam("status", "--json").stdout)["proved"] is None
    sound = gam("check", "--state")
    assert sound.exit_code == 0, sound.output
    assert (
        "monitor default: 4 channels, 92 buckets: stored results agree with the rows that the source "
        "still holds and the last run had to score, and with the frozen calibration" in said(sound)
    )
    assert "a x: scored: rows after 199 came since the last run; gam score scores them" in said(sound)
    assert "s ago: no difference, as far as its rows were still there (gam check --state)" in said(
        gam("status")
    )
    changed("UPDATE gam_state_bucket SET novel_in_window = novel_in_window + 1 WHERE bucket_no = 9")
    wrong = gam("check", "--state")
    assert wrong.exit_code == 2, wrong.output
    assert "4 of 4 channels differ" in said(wrong)
    assert "a x: version 1: buckets: windows that are not the sum of their buckets (1), from" in said(
        wrong
    )
    assert "gam score --from" in said(wrong)
    assert "in a way that scoring does not repair" not in said(wrong)
    told = json.loads(gam("status", "--json").stdout)["proved"]
    assert (told["channels"], told["versions"], told["buckets"]) == (4, 4, 92)
    assert told["differences"] == 8, "the buckets of each channel, by themselves and by the source"
    assert "8 differences (gam check --state)" in said(gam("status"))


def test_damage_says_what_to_do(plant: Path) -> None:
    changed("UPDATE gam_state_bounds SET floor = floor / 2, cells = cells + 1 WHERE support_id = 1")
    changed("INSERT INTO gam_state_run SELECT * REPLACE (77 AS version_id) FROM gam_state_run LIMIT 1")
    result = gam("check", "--state", "--json")
    figures = json.loads(result.stdout)
    assert (result.exit_code, figures["recorded"]) == (2, True)
    parts = {(row["asset"], row["part"]) for row in figures["differences"]}
    assert {("a", "frozen"), ("a", "versions"), (None, "tables")} <= parts
    text = said(gam("check", "--state"))
    assert "a x: version 1: frozen: changed since calibration froze it: its integers (1)" in text
    assert "tables: rows of gam_state_run whose version is not there (1)" in text
    assert "1 of 4 channels differ" in text
    assert "restore them from a copy of the database; or make new versions with gam calibrate" in text
    refused = gam("score")
    assert refused.exit_code == 1
    assert "gam does not score with it. Restore the tables" in " ".join(refused.stderr.split())


def test_what_cannot_be_recorded_is_checked_all_the_same(
    plant: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refusing(*_: object) -> None:
        raise EngineError("The database is open for reading only.")

    monkeypatch.setattr(check, "keep", refusing)
    result = gam("check", "--state")
    assert result.exit_code == 0, result.output
    assert "the time of this check could not be recorded: The database is open" in said(result)
    figures = json.loads(gam("check", "--state", "--json").stdout)
    assert figures["recorded"] is False


def test_what_a_clock_ahead_recorded_is_not_told(plant: Path) -> None:
    changed("INSERT INTO gam_state_proof VALUES (1, 9000000000000000, 'state', 4, 4, 92, 0)")
    assert "never compared with its source" in said(gam("status"))


def test_rows_that_came_are_left_to_the_next_run(plant: Path) -> None:
    """The newest buckets are compared as long as nothing came; then they are the next run's."""
    with duckdb.connect("plant.duckdb") as connection:
        newest = "bucket_no = (SELECT MAX(bucket_no) FROM gam_state_bucket)"
        connection.execute(
            f"UPDATE gam_state_bucket SET samples = samples + 1 WHERE {newest}"
        ).fetchall()
    wrong = gam("check", "--state")
    assert wrong.exit_code == 2, wrong.output
    with duckdb.connect("plant.duckdb") as connection:
        put(connection, [(asset, "x", 198, 1.0) for asset in "abcd"])
    left = gam("check", "--state")
    assert left.exit_code == 0, left.output
    assert gam("score").exit_code in (0, 2)  # 2: a channel needs attention
    assert gam("check", "--state").exit_code == 0


def test_a_version_of_which_no_bucket_is_left_is_in_order() -> None:
    """A run over it that found nothing new began to read where one of its buckets had ended."""
    with duckdb.connect() as connection:
        small_plant.begin(connection)
        made = small_plant.monitor(connection)
        made.score()
        made.score()
        made.calibrate(again=True)
        put(connection, small_plant.readings(small_plant.LENGTH, small_plant.LENGTH + 90))
        made.score()
        made.prune(keep=20)
        left = connection.execute(
            "SELECT COUNT(*) FROM gam_state_bucket WHERE version_id = 1"
        ).fetchall()
        assert left == [(0,)]
        assert made.check_state().num_rows == 0
