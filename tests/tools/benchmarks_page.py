"""The tables of docs/benchmarks.md: ``GAM_TEST_DATA=FOLDER python tests/tools/benchmarks_page.py``.

Each recording is learnt and scored by the commands that the page shows; then gam evaluate compares its
indicator, its alarms and a moving z-score with the labels.
"""

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import duckdb

from gam_db.checking.words import spoken
from gam_db.clock import TimeKind

_TOOLS = Path(__file__).parent
_GAM = (sys.executable, "-c", "from gam_db.cli import main; main()")


@dataclass(frozen=True)
class Recording:
    """A recording, and the words of its commands."""

    folder: str
    title: str
    time: str
    init: tuple[str, ...]
    events: tuple[str, ...]
    margins: tuple[str, ...] = ()
    where: str = "TRUE"
    per_second: int | None = None

    @property
    def choice(self) -> list[str]:
        """The words of gam evaluate that choose events and margins."""
        return [word for event in self.events for word in ("--event", event)] + list(self.margins)


#: The signals that measure what fails: events of a robot arm load its joints, a seal holds pressure, and
#: FS1 is the flow of the pump.
_JOINTS = "channel LIKE 'Current%' OR channel LIKE 'Speed%'"
_PRESSURES = "channel LIKE 'PG%'"
_FLOW = "channel = 'FS1'"
RECORDINGS = {
    "cobot": Recording(
        "ur3_cobot",
        "UR3 cobot: protective stops and lost grips",
        "epoch_us(ts)",
        ("--where", _JOINTS),
        (),
        ("--after", "2 min"),
        _JOINTS,
    ),
    "bearings": Recording(
        "femto_bearings",
        "Bearings: end of life",
        "t",
        ("--max-gap", "2560"),
        ("end_of_life",),
        ("--before", "46080000"),
        per_second=25_600,
    ),
    "plant": Recording(
        "production_plant",
        "Production plant: end of life",
        "t",
        ("--max-gap", "1"),
        ("end_of_life",),
        ("--before", "3000"),
    ),
    "actuators": Recording(
        "hydraulic_actuators",
        "Hydraulic actuators: a defect seal",
        "t",
        (
            *("--where", _PRESSURES, "--max-gap", "1"),
            *("--pool", "channel", "--reference", "Act_1", "--reference", "Act_2"),
        ),
        ("seal_defect",),
        where=_PRESSURES,
    ),
    "rig": Recording(
        "hydraulic_rig",
        "Hydraulic rig: pump leakage",
        "t",
        (
            *("--where", _FLOW, "--score-from", "0"),
            *("--calibrate", "998400/1004399", "--calibrate", "1053600/1054199"),
        ),
        ("pump_leak=1", "pump_leak=2"),
        per_second=10,
        where=_FLOW,
    ),
}

#: An alarm is raised when the judgement that opens its episode ends, and continues while it is open.
ALARMS = """
CREATE VIEW alarm AS
SELECT
  asset,
  channel,
  make_timestamp(judgement.last_time) AS first_time,
  judgement.last_time AS first_tick,
  CASE WHEN status <> 'open' THEN episode.last_time END AS last_time,
  CASE WHEN status <> 'open' THEN episode.last_tick END AS last_tick
FROM gam_alarm AS episode
JOIN gam_visible_judgement AS judgement
  ON judgement.version_id = episode.version_id AND judgement_no = first_judgement
WHERE episode.status <> 'withdrawn'
"""


def _gam(*words: str) -> dict[str, Any]:
    """Run a command in this folder and return its figures."""
    command = [*_GAM, *words, "--json"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode not in (0, 2, 4):
        raise SystemExit(f"{' '.join(words)}: {done.stderr}")
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def scored(recording: Recording, data: Path) -> None:
    """Learn and score a recording in this folder, and make the alarms and the moving z-score."""
    source = str(data / recording.folder / "series.parquet")
    begun = [*_GAM, "init", source, *recording.init]
    subprocess.run(begun, check=False, capture_output=True)
    for command in ("calibrate", "score"):
        _gam(command, "--database", "plant.duckdb")
    with duckdb.connect("plant.duckdb") as connection:
        connection.execute(ALARMS)
        connection.execute(
            f"CREATE VIEW reading AS SELECT asset, channel, {recording.time} AS time, value "
            f"FROM '{source}' WHERE value IS NOT NULL AND ({recording.where})"
        )
        query = (_TOOLS / "moving_z_score.sql").read_text()
        connection.execute(f"CREATE TABLE z_score AS {query}")


def rates(recording: Recording, data: Path) -> Iterator[tuple[str, dict[str, Any], str]]:
    """Yield what is compared, its rates over all machines, and the unit of its lead."""
    labels = ("--labels", str(data / recording.folder / "labels.parquet"), *recording.choice)
    database = ("--database", "plant.duckdb")
    for name, words in (
        ("alarms of gam-db", ("gam_health", "--alarms", "alarm")),
        ("indicator above its limit", ("gam_health",)),
        ("moving z-score", ("z_score",)),
        ("always raised", ("gam_health", "--limit", "-1")),
    ):
        found = _gam("evaluate", *words, *database, *labels)
        (total,) = (row for row in found["rates"] if row["asset"] is None)
        yield name, total, found["unit"]


def lead(row: dict[str, Any], unit: str, recording: Recording) -> str:
    """Return the lead of the middle label in a unit that suits it."""
    if row["lead_time"] is None:
        return "-"
    length, kind = abs(row["lead_time"]), TimeKind.COUNTER if unit == "steps" else TimeKind.TIMESTAMP
    if recording.per_second:
        length, kind = 1_000_000 * length // recording.per_second, TimeKind.TIMESTAMP
    steps = " steps" if kind.is_counter else ""
    return f"{'-' * (row['lead_time'] < 0)}{spoken(length, kind)}{steps}"


def table(recording: Recording, data: Path) -> list[str]:
    """Return the lines of the table of a recording."""
    lines = [
        "| raised by | labels raised | lead | F1 | F1 by chance | false alarms | missed |",
        "|---|---|---|---|---|---|---|",
    ]
    with tempfile.TemporaryDirectory() as folder:
        before = Path.cwd()
        os.chdir(folder)
        try:
            scored(recording, data)
            for name, row, unit in rates(recording, data):
                figures = ("f1", "f1_chance", "false_alarm_rate", "missed_alarm_rate")
                shown = " | ".join("-" if row[of] is None else f"{row[of]:.3f}" for of in figures)
                raised = f"{row['labels_raised']:,} of {row['labels']:,}"
                lines.append(f"| {name} | {raised} | {lead(row, unit, recording)} | {shown} |")
        finally:
            os.chdir(before)
    return lines


if __name__ == "__main__":
    folder_of_data = Path(os.environ["GAM_TEST_DATA"]).resolve()
    for key in sys.argv[1:] or RECORDINGS:
        print(f"## {RECORDINGS[key].title}\n", *table(RECORDINGS[key], folder_of_data), "", sep="\n")
