"""The queries of docs/coming-from.md do what the page says."""

import re
import shlex
from pathlib import Path

import duckdb
import pytest
from typer.testing import CliRunner

from gam_db.cli import app

PAGE = (Path(__file__).parents[2] / "docs" / "coming-from.md").read_text(encoding="utf-8")
LONG, LABELS = re.findall(r"```sql\n(.*?)```", PAGE, re.DOTALL)


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_wide_files_become_a_long_table_that_gam_reads(place: Path) -> None:
    """A missing reading stays a row, and a sensor that one file lacks has none of another's."""
    for name, sensors in (("pump-1", "pressure,flow"), ("pump-2", "pressure,current")):
        rows = [f"2026-03-02 00:{n // 60:02}:{n % 60:02},{n % 44},{n % 7}" for n in range(3600)]
        rows[5] = "2026-03-02 00:00:05,,1"
        (place / f"{name}.csv").write_text("\n".join([f"Timestamp,{sensors}", *rows]), encoding="utf-8")
    duckdb.connect().execute(LONG)
    found = (
        duckdb.connect()
        .execute(
            "SELECT asset, channel, COUNT(*), COUNT(value), MIN(ts)::VARCHAR FROM 'telemetry.parquet' "
            "GROUP BY ALL ORDER BY ALL"
        )
        .fetchall()
    )
    assert found == [
        ("pump-1", "flow", 3600, 3600, "2026-03-02 00:00:00"),
        ("pump-1", "pressure", 3600, 3599, "2026-03-02 00:00:00"),
        ("pump-2", "current", 3600, 3600, "2026-03-02 00:00:00"),
        ("pump-2", "pressure", 3600, 3599, "2026-03-02 00:00:00"),
    ]
    done = CliRunner().invoke(app, ["check", "telemetry.parquet"])
    assert "columns: asset=asset channel=channel time=ts value=value" in done.output


def test_labels_become_commands_as_the_page_shows_them(place: Path) -> None:
    (place / "labels.csv").write_text(
        "StartTime,EndTime,Rating,Equipment\n"
        "2026-03-02 08:20:00,2026-03-02 11:40:00,ANOMALY,pump-1\n"
        "2026-03-03 08:20:00,2026-03-03 11:40:00,NEUTRAL,pump-1\n",
        encoding="utf-8",
    )
    ((command,),) = duckdb.connect().execute(LABELS).fetchall()
    (shown,) = re.findall(r"^gam label .*$", PAGE, re.MULTILINE)
    assert shlex.split(command) == [
        f"{word}:00" if "T" in word and ":" in word else word for word in shlex.split(shown)
    ]
