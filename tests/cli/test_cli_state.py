"""gam status and gam prune: what a user sees of the state, and the exit codes."""

import json
import re
import time
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from rich.cells import cell_len
from typer.testing import CliRunner, Result

import gam_db
from gam_db.cli import app
from gam_db.engines.duckdb.session import DuckSession
from gam_db.stored.schema import migrations
from gam_db.stored.schema.tables import StateTables
from stored_rows import STEP, Plant

NOW = time.time_ns() // 1000
WORN = {0: 10}
QUIET: dict[int, int] = {}
ODD = "prüf[bold]stand\n\x1b[31m 雪雪雪 'n' \"more\" and a long, long name"


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Every test works in a folder of its own, at a terminal of 80 columns."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")
    return tmp_path


def gam(*words: str) -> Result:
    """Run one command in this process."""
    return CliRunner().invoke(app, [*words])


@cache
def migrated() -> bytes:
    """A database file with state tables and no rows; making them takes longer than a test."""
    path = Path("empty.duckdb")
    with DuckSession(path, writable=True) as session:
        migrations.migrate(session, StateTables())
    return path.read_bytes()


def saved(plant: Plant, tables: StateTables | None = None) -> None:
    """A plant as plant.duckdb."""
    Path("plant.duckdb").write_bytes(migrated())
    with DuckSession("plant.duckdb", writable=True) as session:
        plant.write(session, tables or StateTables())


def some_plant(worn: dict[int, int] = WORN) -> Plant:
    """Two machines, the second with odd names; the first channel ends as said."""
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support(cells=range(3))
    for asset, channel, last in (("R1", "j1", worn), ("R1", "j2", QUIET), (ODD, ODD, {1: 1})):
        version = plant.version(plant.channel(monitor, asset, channel), learnt, start=NOW - 100 * STEP)
        plant.run(version, [QUIET, {0: 1}, last, last])
    return plant


def test_a_worn_channel_comes_first_and_asks_for_attention() -> None:
    saved(some_plant())
    short = gam("status", "--database", "plant.duckdb").stdout
    assert "above its limit" not in short
    assert "2 channels with further remarks: --all" in short
    result = gam("status", "--database", "plant.duckdb", "--all")
    assert result.exit_code == 2, result.output
    lines = result.stdout.splitlines()
    assert "monitor default: 3 of 3 channels watched, of 2 assets, newest data 20" in " ".join(lines[:2])
    assert " UTC" in " ".join(lines[:2])
    assert " since, UTC" in result.stdout, "it comes before when data ends, where there is no room"
    first = next(number for number, line in enumerate(lines) if line.startswith("! R1 j1"))
    assert lines[first].split()[:6] == ["!", "R1", "j1", "ready", "0.010", "1.00"]
    assert "+0.95" in lines[first]
    assert "▁▅█" in lines[first]
    assert any(line.startswith("- R1 j1: far above its limit of 0.050") for line in lines)
    place = next(number for number, line in enumerate(lines) if line.split()[:2] == ["machine", "above"])
    assert lines[place + 1].split()[:5] == ["!", "R1", "1", "of", "2"]
    assert lines[place + 1].split()[7] == "j1", "the first one, after day and time"
    assert "data problems" not in result.stdout
    assert "Trend: HI now minus HI a window earlier." in " ".join(result.stdout.split())


def test_nothing_of_note_is_fine() -> None:
    saved(some_plant(worn=QUIET))
    result = gam("status", "--database", "plant.duckdb", "--asset", "R?")
    assert result.exit_code == 0, result.output
    assert "channels: 2 ok" in result.stdout
    assert "  machine" not in result.stdout


@pytest.mark.parametrize("command", ["status", "prune"])
@pytest.mark.parametrize("columns", [80, 120])
def test_a_page_fits_its_terminal_whatever_the_names(
    command: str, columns: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", str(columns))
    saved(some_plant())
    result = gam(command, "--database", "plant.duckdb")
    assert result.exit_code in (0, 2), result.output
    assert max(cell_len(line) for line in result.stdout.splitlines()) <= columns
    assert "\x1b" not in result.stdout
    assert "[bold]" in result.stdout


def test_a_large_fleet_is_cut_unless_all_is_asked_for() -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support()
    for number in range(50):
        plant.version(plant.channel(monitor, f"R{number:02}", "j1"), learnt)
    saved(plant)
    short, long = (gam("status", "--database", "plant.duckdb", *more) for more in ((), ("--all",)))
    assert "and 10 more (10 less than a window scored yet); --all" in short.stdout
    assert "and 30 more machines; --all" in short.stdout
    assert short.stdout.count("R49") == 0
    assert long.stdout.count("R49") == 2


def test_what_is_wrong_with_the_data_is_summed_up() -> None:
    plant = some_plant(worn=QUIET)
    monitor = 1
    version = plant.version(
        plant.channel(monitor, "R3", "j1"), plant.support(), start=NOW - 300_000 * STEP
    )
    plant.run(version, [QUIET] * 4, calibration_readings=1001)
    plant.run(version, [QUIET], from_bucket=3, context_rows=5)
    saved(plant)
    result = gam("status", "--database", "plant.duckdb", "--all")
    said = " ".join(result.stdout.split())
    assert result.exit_code == 2, "a machine comes before data"
    assert "3 of 4 channels watched" in said
    assert "data problems: 3" in said
    assert "- late: R3 j1: at least 4 rows arrived later than lookback, after 20" in said
    assert "- calibration changed: R3 j1: 1 row entered the calibration of version 1" in said
    assert re.search(r"- silent: R3 j1: no row since 20\S+ \S+ UTC, 3.47 d behind the newest data", said)
    patient = gam("status", "--database", "plant.duckdb", "--park-after", "5 d")
    assert "silent" not in patient.stdout
    assert "4 of 4 channels watched" in " ".join(patient.stdout.split())
    calm = ("status", "--database", "plant.duckdb", "--asset", "R?", "--json")
    figures = json.loads(gam(*calm).stdout)
    assert [row["kind"] for row in figures["data_problems"]] == ["late", "calibration", "silent"]
    assert (figures["attention"], figures["watched"], figures["exit_code"]) == ([], 2, 4)
    alone = json.loads(gam("status", "--database", "plant.duckdb", "--json", "--asset", "R1").stdout)
    assert (alone["data_problems"], alone["exit_code"]) == ([], 0)


def test_times_are_those_of_the_plant_where_its_zone_is_said() -> None:
    """Of what is shown; figures for programs stay as they are."""
    plant = Plant()
    summer = 1_782_900_000_000_000  # 2026-07-01 10:00 UTC
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support(), start=summer)
    plant.run(version, [QUIET] * 3)
    saved(plant)
    asked = ("status", "--database", "plant.duckdb")
    here, there = (
        " ".join(gam(*asked, *more).stdout.split()) for more in ((), ("--time-zone", "Europe/Berlin"))
    )
    found = [re.search(r"newest data 2026-07-01 (\d\d):(\d\d) (\S+)", text) for text in (here, there)]
    (hour, minute, utc), (later, same, berlin) = (one.groups() for one in found if one is not None)
    assert (utc, berlin) == ("UTC", "Europe/Berlin")
    assert (int(later), same) == (int(hour) + 2, minute)
    assert "last, Europe/Berlin" in there
    assert f"from 2026-07-01 {later}" in there
    told = (gam(*asked, "--json", *more).stdout for more in ((), ("--time-zone", "Asia/Tokyo")))
    (first,), (second,) = (json.loads(text)["channels"] for text in told)
    assert first == second
    refused = gam(*asked, "--time-zone", "Mars")
    assert "There is no time zone 'Mars'" in refused.output


def test_a_fleet_that_sends_nothing_does_not_end_with_0() -> None:
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.run(version, [QUIET] * 3)
    saved(plant)
    result = gam("status", "--database", "plant.duckdb")
    said = " ".join(result.stdout.split())
    assert result.exit_code == 4
    assert "0 of 1 channel watched" in said
    assert (
        "no data: no rows arrive from 1 of 1 channel; the newest row is of 1970-01-01 00:00 UTC" in said
    )
    assert gam("status", "--database", "plant.duckdb", "--park-after", "none").exit_code == 0
    counting = Plant()
    version = counting.version(
        counting.channel(counting.monitor(time_kind="counter"), "R1", "j1"), counting.support()
    )
    counting.run(version, [QUIET] * 3)
    saved(counting)
    result = gam("status", "--database", "plant.duckdb", "--park-after", "5")
    assert result.exit_code == 0
    assert "newest data 29,000,000" in " ".join(result.stdout.split())


def test_json_says_the_same() -> None:
    saved(some_plant())
    result = gam("status", "--database", "plant.duckdb", "--json")
    assert result.exit_code == 2
    figures: dict[str, Any] = json.loads(result.stdout)
    assert figures["channels"][0]["asset"] == "R1"
    assert {ODD} < {channel["channel"] for channel in figures["channels"]}
    assert figures["channels"][0]["course"] == [None, 0.05, 0.55, 1.0]
    assert figures["machines"][0]["need_attention"] == 1
    assert (figures["exit_code"], figures["watched"], figures["data_problems"]) == (2, 3, [])
    assert figures["attention"][0]["channel"] == "j1"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("status",), "Name the database that holds the state"),
        (("status", "--database", "nowhere.duckdb"), "There is no database file nowhere.duckdb"),
        (("status", "--database", "plant.duckdb", "--name", "dafault"), "did you mean 'default'?"),
        (("status", "--database", "plant.duckdb", "--prefix", "x_"), "no state tables x_*"),
        (("status", "--database", "plant.duckdb", "--asset", "r1"), "No asset of this monitor"),
        (("status", "--database", "plant.duckdb", "--park-after", "long"), "park_after is 'long'"),
        (("prune", "--database", "nowhere.duckdb"), "There is no database file nowhere.duckdb"),
        (("prune", "--database", "plant.duckdb", "--keep", "long"), "keep is 'long'"),
        (("prune", "--database", "plant.duckdb", "--keep-versions", "-1"), "keep-versions"),
    ],
)
def test_what_the_user_can_mend_is_said_in_one_line(words: tuple[str, ...], said: str) -> None:
    saved(some_plant())
    result = gam(*words)
    assert result.exit_code == 1, result.output
    assert said in result.stderr
    assert not Path("nowhere.duckdb").exists()


def test_a_monitor_without_channels_says_what_to_do() -> None:
    plant = Plant()
    plant.monitor()
    saved(plant)
    result = gam("status", "--database", "plant.duckdb")
    assert result.exit_code == 4
    assert "gam calibrate" in result.stdout
    assert gam("prune", "--database", "plant.duckdb").exit_code == 0


def test_pruning_tells_what_goes_and_reads_the_settings_file() -> None:
    plant = Plant()
    monitor, learnt = plant.monitor(), plant.support(cells=range(1200))
    version = plant.version(plant.channel(monitor, "R1", "j1"), learnt)
    plant.run(version, [{1: 1}] * 30)
    plant.run(version, [{1: 1}] * 2, from_bucket=28)
    saved(plant, StateTables(prefix="my_"))
    Path("gam.toml").write_text(
        '[source]\ndatabase = "plant.duckdb"\n[monitor]\nprefix = "my_"\nlookback = 0\nkeep = "95 s"\n'
    )
    tried, done = gam("prune", "--dry-run"), gam("prune")
    assert (tried.exit_code, done.exit_code) == (0, 0), done.output
    assert "would delete: 22 rows of buckets, 22 rows of novel cells" in tried.stdout
    assert "deleted: 22 rows of buckets, 22 rows of novel cells" in done.stdout
    (line,) = (line for line in done.stdout.splitlines() if line.startswith("  R1 j1"))
    assert line.split() == ["R1", "j1", "10", "of", "32", "10", "of", "32", "2", "1,200"]
    assert "nothing to delete" in gam("prune").stdout
    figures = json.loads(gam("prune", "--keep-novel", "0", "--json").stdout)
    (channel,) = figures["channels"]
    assert (channel["novel_rows"], channel["novel_rows_after"]) == (10, 1)


def test_a_monitor_prunes_by_its_own_settings() -> None:
    plant = Plant()
    version = plant.version(plant.channel(plant.monitor(), "R1", "j1"), plant.support())
    plant.run(version, [QUIET] * 30)
    saved(plant)
    source = gam_db.Source("plant.parquet")
    with gam_db.Monitor("plant.duckdb", source, lookback=0, keep="95 s") as monitor:
        kept = monitor.prune(dry_run=True)["bucket_rows_after"].to_pylist()
        assert monitor.prune(keep="1 d", dry_run=True)["bucket_rows_after"].to_pylist() == [30]
    assert kept[0] < 30
    with pytest.raises(gam_db.UserError, match="keep is True"):
        gam_db.Monitor("plant.duckdb", source, keep=True)
