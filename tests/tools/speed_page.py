"""The tables of docs/speed.md: ``python tests/tools/speed_page.py [TABLE...]``, on a quiet machine.

Each table is what one ``gam benchmark`` command measures here and now, half an hour for all of them. It
takes the place of the one between its marks; the sentences around it are written by hand.
"""

import json
import re
import subprocess
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import postgres_server
from gam_db.lab.benchmark.incremental import SIDES
from gam_db.lab.benchmark.report import worthy

PAGE = Path(__file__).parents[2] / "docs" / "speed.md"

Figures = Mapping[str, Any]


def throughput(found: Figures) -> list[str]:
    """Return the table of gam-db beside floors and script, a row per case."""
    programs = {"gam": "gam-db", "floor_on_names": "floor on names", "floor_on_ids": "floor on ids"}
    programs["extract"] = "extract script"
    ratios = {
        "sql_over_floor_on_names": "gam-db / floor on names",
        "sql_over_floor": "gam-db / floor on ids",
        "extract_over_sql": "script / gam-db",
    }
    rows = [
        [
            f"by {case['order']}",
            str(case["threads"]),
            *(_used(case, program) for program in programs),
            *(_ratio(case, name) for name in ratios),
        ]
        for case in found["cases"]
    ]
    return _table(["stored", "threads", *programs.values(), *ratios.values()], rows)


def steps(found: Figures) -> list[str]:
    """Return the seconds of gam-db's steps on one thread, by the clock, a column per order of rows."""
    sides = {f"by {one['order']}": worthy(one["steps"]) for one in found["cases"] if one["threads"] == 1}
    return _steps(sides)


def engines(found: Figures) -> list[str]:
    """Return the table of other engines, and the seconds of their steps."""
    programs = ("gam", "extract", "floor")
    rows = [
        [
            _engine(case),
            *(_used(case, program) for program in programs),
            *(_ratio(case, name) for name in ("gam_over_floor", "extract_over_gam")),
        ]
        for case in found["cases"]
    ]
    lines = _table(["engine", *programs, "gam / floor", "extract / gam"], rows)
    return [*lines, "", *_steps({_engine(one): worthy(one["steps"]["gam"]) for one in found["cases"]})]


def stored(found: Figures) -> list[str]:
    """Return the table of the stored form beside exact ones."""
    rows = [
        [
            f"by {case['order']}",
            str(case["threads"]),
            *(_used(case, side) for side in ("stored", "exact", "exact_whole")),
            f"{case['seconds']['calibrate']['median']:.1f}, {case['seconds']['score']['median']:.1f}",
            f"{case['stored_over_exact']:.2f}",
            f"{case['stored_over_exact_whole']:.2f}",
        ]
        for case in found["cases"]
    ]
    sides = ["stored", "exact form", "exact form, whole", "calibrate, score by the clock"]
    return _table(["stored", "threads", *sides, "stored / exact", "stored / whole"], rows)


def hour(found: Figures) -> list[str]:
    """Return the table of an hour of new rows, and its ratios."""
    rows = []
    for side in SIDES:
        one = found["sides"][side]
        counted = (one.get(name) for name in ("rows_in_range", "rows_scanned"))
        cells = ("" if number is None else f"{number:,}" for number in counted)
        rows.append([side, _seconds(one["processor_seconds"], one["seconds"]), *cells])
    lines = _table(["side", "seconds", "rows in range", "rows scanned"], rows)
    told = {**found["ratios"], **found["gains"]}
    aims = dict.fromkeys(found["ratios"], f"at most {found['aim']}")
    aims |= {name: f"at least {aim}" for name, aim in found["gain_aims"].items()}
    ratios = [[name.replace("_", " "), f"{value:.2f}", aims[name]] for name, value in told.items()]
    return [*lines, "", *_table(["ratio", "", "aim"], ratios)]


def memory(found: Figures) -> list[str]:
    """Return what many rows take with little memory."""
    row = [
        f"{found['workload']['rows']:,}",
        found["memory_limit"],
        f"{found['processor_seconds']:.0f} ({found['seconds']:.0f})",
        f"{found['calibrate']:.0f}, {found['score']:.0f}",
        f"{found['peak_memory']:,.0f} MiB",
        str(found["groups"]),
        f"{found['state_bytes'] / 2**20:,.0f} MiB",
    ]
    names = ["rows", "memory_limit", "seconds", "calibrate, score by the clock", "peak of the process"]
    return _table([*names, "groups of channels", "state"], [row])


_HOURS = ("--rows", "21600000,25000000", "--channels", "300", "--repeat", "3", "--threads", "1")

#: Table -> what measures it, after ``gam benchmark``, and what is made of the figures.
TABLES: Mapping[str, tuple[Sequence[str], Sequence[Callable[[Figures], list[str]]]]] = {
    "throughput": ((), (throughput, steps)),
    "engines": (("engines", "clickhouse", "POSTGRES", "sqlite", "spark"), (engines,)),
    "stored": (("stored",), (stored,)),
    "histories": (("incremental", "--repeat", "3"), (hour,)),
    "hour": (("incremental", *_HOURS), (hour,)),
    "memory": (("memory",), (memory,)),
}


def written(page: str, table: str, lines: Iterable[str]) -> str:
    """Return the page with other lines between the marks of a table.

    Raises:
        ValueError: its marks do not stand there once.
    """
    begin, end = f"<!-- {table} -->\n", f"<!-- end of {table} -->"
    pattern = re.compile(f"{re.escape(begin)}.*?{re.escape(end)}", re.DOTALL)
    if len(pattern.findall(page)) != 1:
        raise ValueError(f"docs/speed.md has not the marks of {table} once.")
    return pattern.sub(lambda _: "\n".join([begin, *lines, "", end]), page)


def measured(table: str) -> list[str]:
    """Measure what a table shows, and return its lines."""
    words, made = TABLES[table]
    words = [_server() if one == "POSTGRES" else one for one in words]
    command = [str(Path(sys.executable).with_name("gam")), "benchmark", *words, "--json"]
    found = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
    lines = [line for make in made for line in ("", *make(found))][1:]
    return [*lines, "", _circumstances(found, table)]


def _server() -> str:
    """Return the address of a server that translates long queries, as PostgreSQL does unless told."""
    return postgres_server.server().url + "?options=-c%20jit%3Don"


def _circumstances(found: Figures, table: str) -> str:
    words = " ".join(("gam benchmark", *TABLES[table][0])).replace("POSTGRES", "postgresql://...")
    used = ", ".join(
        f"{name} {number}" for name, number in found["versions"].items() if name != "gam_db"
    )
    repeated = f"least of {found['repeat']} runs" if found.get("repeat", 1) > 1 else "one run"
    return f"`{words}`: {repeated}; {used}; {found['cores']} cores; {found['date']}."


def _engine(case: Figures) -> str:
    return str(case["engine"]).partition(":")[0]


def _used(case: Figures, program: str) -> str:
    memory = case["peak_memory"][program]["median"]
    seconds = _seconds(case["processor_seconds"][program], case["seconds"][program])
    return f"{seconds}, {memory:,.0f} MiB"


def _seconds(processor: Figures, clock: Figures) -> str:
    return f"{processor['min']:.2f} ({clock['median']:.2f})"


def _ratio(case: Figures, name: str) -> str:
    return f"{case[name]:.2f} ({case[f'{name}_by_clock']:.2f})"


def _steps(sides: Mapping[str, Mapping[str, float]]) -> list[str]:
    names = dict.fromkeys(name for of in sides.values() for name in of if name != "others")
    rows = [
        [name, *(f"{of[name]:.2f}" if name in of else "" for of in sides.values())]
        for name in (*names, "others")
    ]
    return _table(["step", *sides], rows)


def _table(names: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    return ["| " + " | ".join(cells) + " |" for cells in (names, ["---"] * len(names), *rows)]


def main(words: Sequence[str]) -> None:
    """Measure tables, all of them if none is named, and write each as soon as it is there."""
    for table in words or TABLES:
        lines = measured(table)
        PAGE.write_text(written(PAGE.read_text(encoding="utf-8"), table, lines), encoding="utf-8")
        print(f"{table}: written", flush=True)


if __name__ == "__main__":
    main(sys.argv[1:])
