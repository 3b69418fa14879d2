"""Mutants: does a test fail when one operator, constant or column of the SQL is another?

``mutants.txt`` lists the changes. Each is made in a copy of the tree in a temporary folder, never here,
and the tests of DuckDB run there until one fails. By hand, from the root of the checkout:

    python -m tests.guard.mutants                      all of them, in an hour or two
    python -m tests.guard.mutants stored/scoring/plan cert*    those of some files
    python -m tests.guard.mutants --processes 2        two at a time, in half of it
    python -m tests.guard.mutants --list               only show them

It ends with 1 if a mutant survives. A fingerprint of a text would catch them all and prove nothing, so
the guard's own tests are not among those that run, and nor is what only reads the SQL.
"""

import argparse
import contextlib
import fnmatch
import importlib
import math
import multiprocessing
import multiprocessing.connection
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import pytest

ROOT = Path(__file__).parents[2]
LIST = Path(__file__).with_name("mutants.txt")

#: The folders of ``sql/`` of which every file has a mutant.
FOLDERS = (
    *("source", "support", "embedding", "score", "health", "calibration", "certificate", "stored"),
    *("streams", "census", "rowids", "arrays", "judgement", "report", "alarms", "probe", "range"),
    *("automatic", "program", "script"),
)

#: Files of ``sql/`` -> the engine that runs them; DuckDB runs all others.
_RUN_BY = {
    "rowids/*": "sqlite",
    "census/novelty_set": "sqlite",
    "census/set_key": "sqlite",
    "arrays/*": "clickhouse",
    "stored/state/withdrawal": "clickhouse",
}

#: Seconds after which a run is stopped, if no others are asked for; at least three times as many as the
#: tests take with nothing changed. Of one that was stopped nothing is known: it counts as a survivor.
LONGEST = 600.0

#: Files of tests in the order in which they run, those of single files of SQL first; after a bracket,
#: only those of a file whose names hold a word.
_BY_HAND = ("test_method_by_hand", "test_stored_by_hand", "test_report_by_hand")
_METHOD = (
    "test_spec",
    "test_agreement",
    "test_streaming",
    "test_census",
    "test_collapsed",
    "test_wide",
)
_STORED = (
    *("test_falsified", "test_several_monitors", "test_checksums", "test_learnt", "test_pruning"),
    "test_outside_the_contract",
    *("test_cli_stored", "test_cli_state", "test_planning", "test_fleet", "test_visible", "test_faults"),
    *("test_status", "test_standing", "test_judged", "test_copying", "test_migrations"),
    *("test_migrate_and_drop", "test_check_notes", "test_onset", "test_cells", "test_report"),
    *("test_stored_alarms", "test_incremental"),
)

#: Files of ``sql/`` -> the tests that are about them and so are tried first.
_ABOUT = {
    "source/names": "test_learnt",
    **dict.fromkeys(("stored/monitor/failing", "stored/monitor/unlisted"), "test_run_sql_ends"),
    "stored/monitor/*": "test_run_sql",
    "stored/alarms/pending_runs": "test_run_sql",
    "streams/*": "test_streaming",
    "script/*": "test_spec[script]",
    "stored/*program*": "test_program_histories",
    "source/unpivoted": "test_wide",
    "source/misfits": "test_files",
    "source/misfit_count": "test_files",
    "source/ahead": "test_ahead",
    "health/jumps": "test_data_problems",
    **{f"source/{name}": "test_local_time" for name in ("shown_*", "undated")},
    "source/valid*": "test_valid_when",
    "source/*_term": "test_written",
    **{f"census/{name}": "test_collapsed" for name in ("*conflicts", "repeat*")},
    "source/collapsed_readings": "test_collapsed",
    "stored/scoring/collapsed": "test_first_runs",
    "certificate/present_codes": "test_interrupted",
    "census/held_vectors": "test_interrupted",
    "health/running": "test_census",
    "score/straddling": "test_agreement",
    "census/*": "test_census",
    "rowids/*": "test_census",
    "arrays/s*": "test_clickhouse[piece or widest",
    "arrays/*": "test_census",
    **{
        f"certificate/{name}": "test_probe"
        for name in ("certified", "member_*", "vouch*", "pool_spread")
    },
    "streams/probed": "test_probe",
    "streams/calibration_value": "test_probe",
    "*/range_counts": "test_range",
    "certificate/*": "test_spec[certificate",
    "embedding/context": "test_incremental[still",
    "embedding/radix": "test_first_runs",
    "embedding/moving_codes": "test_spec[still",
    "embedding/still_so_far": "test_incremental[still",
    "embedding/moving_*": "test_incremental[still",
    "health/novel_cells": "test_incremental[short",
    "stored/scoring/bounds": "test_outside_the_contract",
    "stored/scoring/channels": "test_outside_the_contract",
    **{f"stored/*/{name}": "test_clocks_and_replays" for name in ("plan", "seen")},
    **{f"stored/*/{name}": "test_incremental[still" for name in ("still*", "no_stillness")},
    **dict.fromkeys(("census/trusted_timeline", "stored/scoring/restart"), "test_incremental[short"),
    "stored/scoring/run_up": "test_incremental[pauses",
    "stored/*/rep*": "test_check_state",
    "stored/state/withdrawal": "test_clickhouse_writers",
    **{f"streams/{name}": "test_naming" for name in ("names", "spread", "in_order")},
    "streams/glance": "test_naming",
    "stored/scoring/pla[n]": "test_incremental[still",
    "stored/pruning/expired_unplaced": "test_clocks_and_replays",
    "judgement/standing": "test_standing",
    "judgement/*": "test_judged",
    "report/*": "test_report",
    "stored/checking/inconsistent_bands": "test_falsified",
    **{
        f"stored/*/{name}": "test_stored_alarms"
        for name in (
            *(
                "buffered_rows",
                "extent_rows",
                "calibration_buffered",
                "limit_*",
                "judged_*",
                "judgement_rows",
            ),
            *("open_judgements", "raised_episodes", "episode_records", "staying_judgements"),
            *("alarm_rows", "event_rows", "labels", "next_judgement", "raised_judgements"),
            *(
                "recorded_judgements",
                "recorded_limits",
                "inconsistent_judgements",
                "episode_history",
            ),
        )
    },
    **{
        f"stored/*/{name}": "test_explained"
        for name in (
            *(
                "band_rows",
                "banded",
                "uncounted",
                "raised_versions",
                "alarm_bands",
                "alarm_cells",
                "expired_band_visits",
            ),
        )
    },
    **{
        f"stored/alarms/{name}": "test_advice"
        for name in (
            *("reread", "reread_usual", "moves", "unmoved", "moved", "move_counts"),
            *("alarm_figures", "alarm_moves"),
        )
    },
    "report/promises": "test_advice",
    "alarms/band": "test_explained",
    "alarms/bands": "test_explained",
    "alarms/within": "test_backtest",
    "alarms/backtested": "test_backtest",
    "alarms/*": "test_alarms",
    "stored/calibrating/ladder_rows": "test_cells",
    "stored/calibrating/probe_rows": "test_probe",
    "automatic/*": "test_automatic",
    "probe/*": "test_probe",
    "range/*": "test_range",
    "program/*": "test_programs",
    "source/conflicting": "test_programs",
    "stored/pruning/expired_*": "test_pruning",
    "stored/pruning/bucket_ages": "test_pruning",
    "stored/pruning/horizons": "test_pruning",
    "stored/pruning/pruned_versions": "test_pruning",
    "stored/pruning/state_sizes": "test_pruning",
    "stored/state/course": "test_status",
    **{
        f"stored/state/{name}": "test_data_problems"
        for name in ("bucket_ends", "data_problems", "differing_contexts", "last_data")
    },
    "stored/state/left_out_rows": "test_data_problems",
    "stored/state/watched": "test_data_problems",
    "stored/state/status_rows": "test_status",
    "stored/state/active": "test_cli_stored",
    "stored/state/validity": "test_valid_when",
    "stored/state/monitor_channels": "test_cli_stored",
    "stored/scoring/last_reads": "test_planning",
    "stored/calibrating/wanted_names": "test_planning",
    "stored/state/health_rows": "test_cli_stored",
    "stored/state/doubled": "test_two_writers",
    "stored/state/last_numbers": "test_cli_stored",
    "stored/state/migration_record": "test_migrations",
}

#: What is copied: enough to run the tests.
_COPIED = ("gam_db", "sql", "migrations", "tests", "docs", "README.md", "pyproject.toml", "CHANGELOG.md")


#: How pytest is run; what was loaded before cannot be rewritten, which is of no concern here.
_WORDS = (
    *("-x", "-q", "-n", "0", "-p", "no:cacheprovider"),
    *("-W", "ignore::pytest.PytestAssertRewriteWarning"),
)


@dataclass(frozen=True)
class Mutant:
    """One change of one file: ``before``, which stands there once, becomes ``after``."""

    file: str
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.file}: {self.before} -> {self.after}"

    def changed(self, text: str) -> str:
        """Return the text of the file with the change made.

        Raises:
            ValueError: what is to be changed does not stand there once.
        """
        lines = text.splitlines(keepends=True)
        head = next(number for number, line in enumerate(lines) if not line.startswith("--"))
        query = "".join(lines[head:])
        if query.count(self.before) != 1:
            raise ValueError(f"{self}: stands there {query.count(self.before)} times, not once")
        return "".join(lines[:head]) + query.replace(self.before, self.after)


@dataclass(frozen=True)
class Outcome:
    """What became of a mutant: the test that caught it, None if it survived."""

    mutant: Mutant | None
    caught_by: str | None
    seconds: float


def listed(file: Path = LIST) -> list[Mutant]:
    """Return the mutants of the list."""
    found = []
    for line in file.read_text(encoding="utf-8").splitlines():
        if line and not line.startswith("#"):
            name, change = line.split(": ", 1)
            before, after = change.split(" -> ")
            found.append(Mutant(name, before, after))
    return found


def tests_of(mutant: Mutant | None) -> list[str]:
    """Return which tests may catch it, file by file, those that most likely do first."""
    if mutant is None:
        return [*_BY_HAND, *_METHOD, *_STORED]
    first = [name for glob, name in _ABOUT.items() if fnmatch.fnmatch(mutant.file, glob)]
    after = _STORED if mutant.file.startswith("stored/") else (*_METHOD, *_STORED)
    return list(dict.fromkeys([*_BY_HAND, *first, *after]))


class Watch:
    """A plugin of pytest that remembers the first thing that failed."""

    def __init__(self) -> None:
        self.failed: str | None = None

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Remember a test."""
        if report.failed and self.failed is None:
            self.failed = report.nodeid

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        """Remember a file that cannot be collected."""
        if report.failed and self.failed is None:
            self.failed = report.nodeid


def copied(folder: Path) -> None:
    """Copy what the tests need of the tree into a folder."""
    for name in _COPIED:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name)
        else:
            shutil.copy2(ROOT / name, folder / name)


def run(mutant: Mutant | None, folder: Path, told: Connection) -> None:
    """Make the change in the copy in a folder, run the tests there, and tell which one failed."""
    os.chdir(folder)
    sys.path[:] = [str(folder), *(path for path in sys.path if Path(path or ".").resolve() != ROOT)]
    if mutant is not None:
        path = folder / "sql" / f"{mutant.file}.sql"
        path.write_text(mutant.changed(path.read_text(encoding="utf-8")), encoding="utf-8")
    template: Any = importlib.import_module("gam_db.composing.template")
    assert template.sql_folder() == folder / "sql", "the tests would not run the copy"
    files = {path.stem: str(path) for path in sorted((folder / "tests").rglob("test_*.py"))}
    watch = Watch()
    changed = "" if mutant is None else mutant.file
    engine = next((one for glob, one in _RUN_BY.items() if fnmatch.fnmatch(changed, glob)), "")
    # Its files lie in its folder: a disk that a test mounted there when it was stopped hinders no other.
    words = [*_WORDS, "--engines", engine or "duckdb", "--basetemp", str(folder / "temporary")]
    with (folder / "output.txt").open("w") as output, contextlib.redirect_stdout(output):
        for name in tests_of(mutant):  # one after another: collecting them all takes longer than most
            file, _, word = name.partition("[")
            code = pytest.main([*words, files[file], "-k", word], plugins=[watch])
            if code != 0:
                break
    if code == 0 or watch.failed is not None:
        told.send(watch.failed)


def outcomes(
    mutants: Sequence[Mutant | None], processes: int, longest: float = LONGEST
) -> Iterator[Outcome]:
    """Yield what becomes of each mutant, in the order in which they are done; None is no change."""
    # What takes long to load is loaded once; nothing of gam_db or its tests may be.
    for name in ("duckdb", "hypothesis", "numpy", "pyarrow", "sqlglot", "typer"):
        __import__(name)
    context = multiprocessing.get_context("fork")
    waiting = list(reversed(mutants))
    running: dict[int, tuple[Any, Mutant | None, Connection, Path, float]] = {}
    while waiting or running:
        while waiting and len(running) < processes:
            mutant = waiting.pop()
            folder = Path(tempfile.mkdtemp(prefix="gam-mutant-")).resolve()
            copied(folder)
            ours, theirs = context.Pipe(duplex=False)
            process = context.Process(target=run, args=(mutant, folder, theirs))
            process.start()
            theirs.close()
            running[process.sentinel] = (process, mutant, ours, folder, time.monotonic())
        multiprocessing.connection.wait(list(running), timeout=5)
        for sentinel, (process, mutant, ours, folder, began) in list(running.items()):
            seconds = time.monotonic() - began
            if process.is_alive() and seconds < longest:
                continue
            was_stopped = process.is_alive()
            process.kill()
            process.join()
            caught = None if was_stopped else _told(ours, process.exitcode, folder)
            shutil.rmtree(folder, ignore_errors=True)
            del running[sentinel]
            yield Outcome(mutant, caught, seconds)


def _told(ours: Connection, code: int, folder: Path) -> str | None:
    """Return what a process told: the test that failed, or None; one that crashed was caught.

    Raises:
        RuntimeError: it ended by itself and told nothing, so that nothing was tested.
    """
    with ours, contextlib.suppress(EOFError):
        if ours.poll():
            answer: str | None = ours.recv()
            return answer
    if code < 0:
        return f"its end by signal {-code}"
    raise RuntimeError(f"pytest tested nothing: see {folder / 'output.txt'}")


def main(words: Sequence[str] | None = None) -> int:
    """Run what is asked for; return 0 if every mutant was caught."""
    parser = argparse.ArgumentParser(prog="python -m tests.guard.mutants")
    parser.add_argument("files", nargs="*", default=["*"], help="patterns of files, such as stored/*")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--list", action="store_true", help="only show them")
    parser.add_argument("--trust", action="store_true", help="that the tests pass with nothing changed")
    parser.add_argument("--longest", type=float, default=LONGEST, help="seconds for one of them")
    said = parser.parse_args(words)
    chosen = [one for one in listed() if any(fnmatch.fnmatch(one.file, glob) for glob in said.files)]
    if not chosen:
        parser.error(f"no mutant is of a file like {' or '.join(said.files)}; --list shows them all")
    if said.list:
        print("\n".join(map(str, chosen)))
        return 0
    survivors: list[Mutant] = []
    longest = said.longest
    for found in [] if said.trust else outcomes([None], 1, math.inf):
        longest = max(longest, 3 * found.seconds)
        if found.caught_by is not None:
            print(f"The tests fail with nothing changed: {found.caught_by}.")
            return 2
    for found in outcomes(chosen, said.processes, longest):
        alive = "SURVIVED" if found.seconds < longest else "STOPPED before any test failed"
        fate = f"caught by {found.caught_by}" if found.caught_by else alive
        print(f"{found.seconds:.0f} s  {found.mutant}: {fate}", flush=True)
        if found.mutant is not None and found.caught_by is None:
            survivors.append(found.mutant)
    print(f"{len(chosen) - len(survivors)} of {len(chosen)} mutants were caught.")
    print("\n".join(f"survived: {one}" for one in survivors))
    return 1 if survivors else 0


if __name__ == "__main__":
    sys.exit(main())
