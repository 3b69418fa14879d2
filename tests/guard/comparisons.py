"""What answers were compared with the NumPy reference: distinct (series, settings), form and engine.

Whatever compares an answer of an engine with the reference says so by :func:`compared`, or by
:func:`compared_recording` where the reference counted a whole recording. As a plugin of pytest this
module gathers what the processes of a run compared, prints how much that was, and fails a whole run that
compared less than ``comparisons.txt`` says.
"""

import hashlib
import struct
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

import reference

FILE = Path(__file__).with_name("comparisons.txt")

#: Bytes that tell a comparison from all others.
_SIZE = 8

#: (engine, form) -> what was compared in this process, and in those that have told it
Found = dict[tuple[str, str], set[bytes]]
FOUND: Found = defaultdict(set)


def compared(
    engine: str,
    form: str,
    rows: reference.Rows,
    parameters: Any,
    calibration: Any,
    first: reference.Rows | None = None,
) -> None:
    """Note that every channel of a source was compared with the reference.

    Args:
        engine: that answered.
        form: "exact", "view", "stored", "dbt", or what else has the same integers.
        rows: of the source.
        parameters: as the reference takes them.
        calibration: the same.
        first: the rows that calibration saw, where they are not all.
    """
    FOUND[engine, form].update(_marks(rows, parameters, calibration, first))


def compared_recording(engine: str, form: str, *said: str) -> None:
    """Note that a series of a recording was compared, told by its name and settings."""
    FOUND[engine, form].add(_digest(repr(said).encode()))


def _marks(
    rows: reference.Rows,
    parameters: Any,
    calibration: Any,
    first: reference.Rows | None,
) -> Iterator[bytes]:
    """Yield what tells each channel: its series, what applies to it, and what its pool learnt from."""
    final = _series(rows)
    learnt = final if first is None else _series(first)
    groups = reference.groups_of(calibration)
    channels: list[tuple[bytes, Any]] = []
    pools: dict[Any, list[bytes]] = defaultdict(list)
    for (asset, name), series in learnt.items():
        settings = reference.settings_of(parameters, asset, name)
        own = _rule(reference.rule_of(calibration, asset))
        number = next(
            (n for n, g in enumerate(groups) if any(reference.glob(p, asset) for p in g)), None
        )
        pool = (asset, name) if number is None else (number, name, settings)
        pools[pool].append(_digest(series + repr(own).encode()))
        seen = series if first is None else series + b"/" + final.get((asset, name), b"")
        channels.append((seen + repr((settings, own)).encode(), pool))
    for said, pool in channels:
        yield _digest(said + b"".join(sorted(pools[pool])))


def _rule(rule: Any) -> Any:
    if rule is None:
        return None
    return rule.fraction, rule.duration, rule.intervals, tuple(rule.exclude), rule.score_from


def _series(rows: reference.Rows) -> Mapping[tuple[str, str], bytes]:
    """Return the times and values of each channel, whatever the order of their rows."""
    found: dict[tuple[str, str], list[bytes]] = defaultdict(list)
    for asset, name, time, value, *program in rows:
        packed = struct.pack("<q", time) if value is None else struct.pack("<qd", time, value)
        packed += b"".join(repr(one).encode() for one in program)
        found[asset, name].append(packed)
    return {name: b",".join(sorted(packed)) for name, packed in found.items()}


def _digest(said: bytes) -> bytes:
    return hashlib.blake2b(said, digest_size=_SIZE).digest()


def floors() -> dict[str, int]:
    """Return how many comparisons a whole run makes on each engine at least."""
    lines = [line.split() for line in FILE.read_text(encoding="utf-8").splitlines()]
    return {engine: int(number) for engine, number in lines}


def table(found: Found) -> list[str]:
    """Return lines with the number of comparisons by engine and form, and in all."""
    forms = sorted({form for _, form in found})
    engines = sorted({engine for engine, _ in found})
    rows = [["", *forms, "all forms"]]
    for engine in engines:
        counts = [len(found.get((engine, form), ())) for form in forms]
        rows.append([engine, *(str(count or "") for count in counts), str(sum(counts))])
    rows.append(["all engines", *[""] * len(forms), str(sum(map(len, found.values())))])
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    return [
        "  ".join(f"{cell:>{width}}" for cell, width in zip(row, widths, strict=True)).rstrip()
        for row in rows
    ]


def shortfalls(found: Found, least: Mapping[str, int]) -> list[str]:
    """Return a sentence for each engine on which less was compared than there must be."""
    counts: dict[str, int] = defaultdict(int)
    for (engine, _), marks in found.items():
        counts[engine] += len(marks)
    return [
        f"{engine}: {counts[engine]} comparisons with the NumPy reference, and {number} were kept in "
        f"{FILE.name}: some are gone that must not go."
        for engine, number in least.items()
        if counts[engine] < number
    ]


def is_whole(config: pytest.Config) -> bool:
    """Tell whether a run is asked for all tests on all engines, with the recordings."""
    from_settings = config.args_source is pytest.Config.ArgsSource.TESTPATHS
    asked: str = config.getoption("--engines")
    return from_settings and asked == "all" and not config.getoption("keyword")


# What pytest calls


def pytest_sessionfinish(session: pytest.Session) -> None:
    """In a process of its own, tell what was compared; at the end of all, look whether it is enough."""
    told = getattr(session.config, "workeroutput", None)
    if told is not None:
        told["comparisons"] = [(*key, b"".join(marks)) for key, marks in FOUND.items()]
    elif is_whole(session.config) and session.exitstatus == 0 and shortfalls(FOUND, floors()):
        session.exitstatus = pytest.ExitCode.TESTS_FAILED


@pytest.hookimpl(optionalhook=True)
def pytest_testnodedown(node: Any) -> None:
    """Take over what another process compared."""
    for engine, form, marks in getattr(node, "workeroutput", {}).get("comparisons", []):
        parts = (marks[at : at + _SIZE] for at in range(0, len(marks), _SIZE))
        FOUND[engine, form].update(parts)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter, config: pytest.Config) -> None:
    """Print how much was compared, and what is missing."""
    if not FOUND:
        return
    terminalreporter.section("distinct comparisons with the NumPy reference")
    for line in table(FOUND):
        terminalreporter.line(line)
    for line in shortfalls(FOUND, floors()) if is_whole(config) else ():
        terminalreporter.line(line, red=True)
