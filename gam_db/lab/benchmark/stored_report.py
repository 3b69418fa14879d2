"""The figures of the stored form as text, for people."""

from collections.abc import Iterator, Mapping
from typing import Any

from gam_db.lab.benchmark.incremental import RATIOS
from gam_db.lab.benchmark.report import worthy
from gam_db.lab.benchmark.workload import ORDERS

_SPREAD = ("median", "min", "max")


def incremental_lines(figures: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on what ``measure_incremental`` returned."""
    work = figures["workload"]
    small, large = work["rows"]
    yield (
        f"{work['new_rows']:,} new rows of {work['channels']} channels after {small:,} and after "
        f"{large:,} rows; {_method(work)}; lookback {work['lookback_ticks']:,} s, park after "
        f"{work['park_after_ticks']:,} s"
    )
    yield from _circumstances(figures)
    yield ""
    yield _title("side") + f"{'in range':>12}{'scanned':>12}"
    for side, row in figures["sides"].items():
        yield (
            _row(side, row["seconds"], row["processor_seconds"], row["peak_memory"])
            + "".join(f"{row.get(name, 0):12,}" for name in ("rows_in_range", "rows_scanned"))
        )
    for name in RATIOS:
        yield f"  {name:26}{figures['ratios'][name]:10.3f}  (aim: {figures['aim']})"
    for name, gain in figures["gains"].items():
        yield f"  {name:26}{gain:10.3f}  (aim: at least {figures['gain_aims'][name]})"
    for side, row in figures["sides"].items():
        if row["steps"]:
            yield f"  seconds by step, {side}: {_steps(row['steps'])}"


def memory_lines(figures: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on what ``measure_memory`` returned."""
    work = figures["workload"]
    yield (
        f"{work['rows']:,} rows of {work['channels']} channels ({work['source_bytes'] / 2**20:,.0f} "
        f"MiB) from nothing; {_method(work)}; memory_limit {figures['memory_limit']}"
    )
    yield from _circumstances(figures)
    yield ""
    yield (
        f"  {figures['seconds']:,.1f} s, {figures['rows_per_second']:,} rows/s; {figures['groups']} "
        f"groups of channels; peak memory {figures['peak_memory']:,.0f} MiB; {figures['buckets']:,} "
        f"buckets; state {figures['state_bytes'] / 2**20:,.0f} MiB"
    )
    for name in ("calibrate", "score"):
        yield f"  {name} {figures[name]:.1f} s by step: {_steps(figures[f'{name}_steps'])}"


def engines_lines(figures: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on what ``measure_engines`` returned."""
    work = figures["workload"]
    yield (
        f"{work['channels']} channels x {work['samples']:,} samples, simulated; calibration "
        f"{work['calibration']:.0%}, {_method(work)}"
    )
    yield from _circumstances(figures)
    for case in figures["cases"]:
        yield ""
        yield _title(case["engine"])
        for program, seconds in case["seconds"].items():
            yield _row(
                program, seconds, case["processor_seconds"][program], case["peak_memory"][program]
            )
        for name in ("gam_over_floor", "extract_over_gam"):
            yield f"  {name:26}{case[name]:10.3f}{case[f'{name}_by_clock']:9.3f}"
        for program, steps in case["steps"].items():
            yield f"  seconds by step, {program}: {_steps(steps)}"


def stored_lines(figures: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on what ``measure_stored`` returned."""
    work = figures["workload"]
    yield (
        f"{work['channels']} channels x {work['samples']:,} samples, simulated; calibration "
        f"{work['calibration']:.0%}, {_method(work)}"
    )
    yield from _circumstances(figures)
    for case in figures["cases"]:
        yield ""
        threads = "1 thread" if case["threads"] == 1 else f"{case['threads']} threads"
        yield _title(f"{ORDERS[case['order']]}, {threads}")
        for name, seconds in case["seconds"].items():
            used = case["processor_seconds"].get(name)
            yield _row(name.replace("_", ", "), seconds, used, case["peak_memory"].get(name))
        whole = f"{case['stored_over_exact_whole']:10.3f}"
        yield f"  {'stored over exact, whole':26}{whole}  (aim: {figures['aim']})"
        yield f"  {'stored over exact':26}{case['stored_over_exact']:10.3f}"
        yield f"  integers of both forms are equal: {case['buckets']:,} buckets"
        for name in ("calibrate", "score"):
            yield f"  seconds by step, {name}: {_steps(case[f'{name}_steps'])}"


def _circumstances(figures: dict[str, Any]) -> Iterator[str]:
    used = ", ".join(f"{name} {number}" for name, number in figures["versions"].items())
    yield f"{used}; {figures['cores']} cores; {figures['date']}"
    yield from figures["meaning"]


def _method(work: Mapping[str, Any]) -> str:
    return (
        f"m = {work['m']}, tau = {work['tau']}, B = {work['bins']}, W = {work['window']}, stride "
        f"{work['stride']}"
    )


def _title(first: str) -> str:
    return f"{first:28}{'processor':>10}{'seconds':>9}{'least':>9}{'most':>9}{'MiB':>8}"


def _row(
    name: str,
    seconds: Mapping[str, float],
    processor: Mapping[str, float] | None,
    memory: Mapping[str, float] | None,
) -> str:
    row = f"  {name:26}" + (f"{processor['min']:10.2f}" if processor else " " * 10)
    row += "".join(f"{seconds[key]:9.2f}" for key in _SPREAD)
    return row if memory is None else f"{row}{memory['median']:8.0f}"


def _steps(seconds: dict[str, float]) -> str:
    return ", ".join(f"{step} {taken:.2f}" for step, taken in worthy(seconds).items())
