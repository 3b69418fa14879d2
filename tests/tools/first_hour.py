"""The first hour of a newcomer, walked: ``python tests/tools/first_hour.py > docs/first-hour.md``.

Commands and what they print stand on the page as they came, but for the folder and what a clock says.
"""

import contextlib
import csv
import datetime as dt
import io
import math
import os
import random
import shlex
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path

import pyarrow as pa
from pyarrow import parquet
from typer.testing import CliRunner

import tiny
from gam_db.cli import app

#: Runs a command, or Python where it is one with lines; returns what it printed and the exit code.
Run = Callable[[str], tuple[str, int]]

PLACE = "/home/you/plant"

_GERMAN = '--channel Messstelle --decimal , --null N/A --time-format "%d.%m.%Y %H:%M"'

#: What is said, what is typed, and the exit code.
STEPS = (
    (
        "A machine that wears out, simulated. The series is kept, so that you can try what you like "
        "on it.",
        "gam demo --out demo.parquet",
        0,
    ),
    (
        "Now data as plants write it: `pumpe.csv` has semicolons, decimal commas, dates as 31.12.2026 "
        "and `N/A` among numbers. What cannot be guessed is asked for.",
        "gam check pumpe.csv",
        1,
    ),
    ("With what it says, and how numbers and times are written:", f"gam check pumpe.csv {_GERMAN}", 0),
    (
        "The first two days were healthy. Calibration chooses delay, grid and window:",
        f'gam run pumpe.csv {_GERMAN} --calibration-duration "2 d"',
        2,
    ),
    (
        "Two robots, a Parquet file a day, in the folder `days`. Delay, grid and window are chosen "
        "from the data and written down with their reasons:",
        'gam init days/ --calibration-duration "3 d"',
        0,
    ),
    (
        "Calibration is frozen in a database; from here on SOURCE and settings are known.",
        "gam calibrate --database plant.duckdb",
        0,
    ),
    ("All that came since, now and every hour:", "gam score --database plant.duckdb", 2),
    (
        "How is every channel? One leaves health on the seventh day.",
        "gam status --database plant.duckdb --all",
        2,
    ),
    (
        "Which alarms are open? Exit code 2 says that somebody should look, so a scheduler can tell.",
        "gam alarms --database plant.duckdb",
        2,
    ),
    (
        "Why? The first two sentences say what happened and what to do next. Then come the judgements, "
        "the values at which the signal stands out, and the query that shows the rows.",
        "gam alarm 1 --database plant.duckdb",
        0,
    ),
    (
        "Somebody looks: the brake of j2 drags. The label keeps that: the next calibration leaves this "
        "time out.",
        'gam label 1 true_fault --note "brake of j2 drags" --database plant.duckdb',
        0,
    ),
    (
        "The report is one HTML file. It shows all machines, and of each signal its readings, its "
        "healthy states and its new states. [The page](report.md) explains it.",
        "gam report --database plant.duckdb --out report.html",
        0,
    ),
    (
        "The same in Python, of a data frame:",
        """\
import pandas
import gam_db

frame = pandas.read_parquet("days/")
parameters = gam_db.Parameters(bins=16, window=500)
health = gam_db.health_indicator(frame, parameters, gam_db.Calibration(duration="3 d"))
print(health.to_pandas().groupby(["asset", "channel"]).hi.last().round(3))
""",
        0,
    ),
)

HEAD = """\
# The first hour

This page leads from a checkout to a watched machine, its first alarm, the explanation of the alarm, a
label and a report. Every output is real: `python tests/tools/first_hour.py > docs/first-hour.md` runs
the commands and writes this page, and a test compares. [words.md](words.md) explains the words.

```console
$ git clone REPOSITORY gam-db && cd gam-db
$ python3 -m venv .venv && . .venv/bin/activate && pip install -e .
```
"""


def prepare(folder: Path) -> None:
    """Write what a plant has: a CSV file as a German spreadsheet saves it, and a folder of Parquet."""
    chance, start = random.Random(18), dt.datetime(2026, 3, 2)
    with (folder / "pumpe.csv").open("w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file, delimiter=";")
        rows.writerow(["Zeit", "Anlage", "Messstelle", "Wert"])
        for minute in range(6000):
            time = start + dt.timedelta(minutes=minute)
            for name, size in (("Druck", 4.0), ("Strom", 11.5)):
                value = size * (1 + 0.3 * math.sin(minute / 9) + chance.gauss(0, 0.02))
                value += 3 * (name == "Strom" and minute > 5000)
                text = "N/A" if minute % 1500 == 700 else f"{value:.3f}".replace(".", ",")
                rows.writerow([f"{time:%d.%m.%Y %H:%M}", "Pumpe 1", name, text])
    (folder / "days").mkdir()
    for day in range(8):
        found = []
        for minute in range(1440):
            time = start + dt.timedelta(days=day, minutes=minute)
            for robot in ("R1", "R2"):
                for joint, speed in (("j1", 7), ("j2", 11)):
                    wear = 1.3 if (robot, joint) == ("R2", "j2") and day >= 6 else 1.0
                    value = wear * (math.sin(minute / speed) + chance.gauss(0, 0.05))
                    found.append({"robot": robot, "joint": joint, "ts": time, "torque": value})
        parquet.write_table(
            pa.Table.from_pylist(found), folder / "days" / f"2026-03-{2 + day:02}.parquet"
        )


def walked(run: Run, folder: Path, steps: Sequence[tuple[str, str, int]] = STEPS) -> Iterator[str]:
    """Walk in a folder that is prepared, and yield the parts of the page.

    Raises:
        AssertionError: a command ended otherwise than it is said to.
    """
    for words, typed, expected in steps:
        printed, code = run(typed)
        assert code == expected, f"{typed}: {code}\n{printed}"
        text = printed.replace(str(folder.resolve()), PLACE).replace(str(folder), PLACE)
        text = "\n".join(line.rstrip() for line in text.rstrip().splitlines())
        shown = f"```console\n$ {typed}\n{text}"
        if "\n" in typed:
            shown = f"```python\n{typed}```\n\n```\n{text}"
        yield f"{words}\n\n{shown}\n```\n"


def in_this_process(typed: str) -> tuple[str, int]:
    """Run a command in this process."""
    if "\n" in typed:
        with contextlib.redirect_stdout(io.StringIO()) as said:
            exec(compile(typed, "walk", "exec"), {})
        return said.getvalue(), 0
    done = CliRunner().invoke(app, shlex.split(typed)[1:])
    return done.output, done.exit_code


@contextlib.contextmanager
def place() -> Iterator[Path]:
    """A prepared folder to walk in, at a terminal of 100 columns, with defaults as users have them."""
    before = Path.cwd(), dict(os.environ)
    with tempfile.TemporaryDirectory() as folder, tiny.as_delivered():
        prepare(Path(folder))
        os.chdir(folder)
        os.environ["COLUMNS"] = "100"
        try:
            yield Path(folder)
        finally:
            os.chdir(before[0])
            os.environ.clear()
            os.environ.update(before[1])


def page(parts: Iterable[str]) -> str:
    """Return the page of all parts."""
    return "\n".join([HEAD, *parts, TAIL])


TAIL = """\
## What comes next

- [Choose settings](settings.md): what to set, and what to read in the certificate.
- [Notify](notify.md): send new alarms by mail, to Microsoft Teams or to a webhook.
- [Runs on a schedule](schedule.md): run `gam score` every hour.
- [What it cannot see](limits.md): read this before you trust a quiet machine.
"""


if __name__ == "__main__":
    with place() as here:
        print(page(walked(in_this_process, here)), end="")
