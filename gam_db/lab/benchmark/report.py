"""The figures as text, for people."""

from collections.abc import Iterator
from typing import Any

from gam_db.lab.benchmark.workload import ORDERS

WORDS = {
    "gam": "gam-db",
    "floor_on_ids": "engine floor, integer ids",
    "floor_on_names": "engine floor, names",
    "extract": "extract script",
}

#: Steps and operators that take less than this share are added up.
WORTH_A_LINE = 0.02


def lines(figures: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on what :func:`~gam_db.lab.benchmark.measure.measure` returned."""
    work, versions = figures["workload"], figures["versions"]
    yield (
        f"{work['channels']} channels x {work['samples']:,} samples, simulated; calibration "
        f"{work['calibration']:.0%}, m = {work['m']}, tau = {work['tau']}, B = {work['bins']}, "
        f"W = {work['window']}, stride {work['stride']}"
    )
    used = ", ".join(f"{name} {number}" for name, number in versions.items())
    yield f"{used}; {figures['cores']} cores; {figures['date']}"
    yield from figures["meaning"]
    for case in figures["cases"]:
        yield ""
        yield from _case(case)


def _case(case: dict[str, Any]) -> Iterator[str]:
    threads = "1 thread" if case["threads"] == 1 else f"{case['threads']} threads"
    title = f"{ORDERS[case['order']]}, {threads} ({case['case']})"
    yield f"{title:40}{'processor':>10}{'seconds':>9}{'least':>9}{'most':>9}{'MiB':>8}"
    for program, seconds in case["seconds"].items():
        memory = case["peak_memory"][program]
        yield (
            f"  {WORDS[program]:38}"
            + f"{case['processor_seconds'][program]['min']:10.2f}"
            + "".join(f"{seconds[key]:9.2f}" for key in ("median", "min", "max"))
            + f"{memory['median']:8.0f}"
        )
    for name in ("sql_over_floor_on_names", "sql_over_floor", "extract_over_sql"):
        if case[name] is not None:
            yield f"  {name:38}{case[name]:10.2f}{case[f'{name}_by_clock']:9.2f}"
    if "rows" in case:
        share = "" if case["novel_share"] is None else f"; novel share {case['novel_share']:.1%}"
        counts = ", ".join(f"{rows:,} rows of {table}" for table, rows in case["rows"].items())
        yield f"  integers of gam-db and the script are equal: {counts}{share}"
    if "steps" in case:
        yield "  seconds by step of gam-db: " + ", ".join(
            f"{step} {seconds:.2f}" for step, seconds in worthy(case["steps"]).items()
        )
    if "operators" in case:
        yield from _operators(case["operators"])


def _operators(operators: list[dict[str, Any]]) -> Iterator[str]:
    yield f"  {'EXPLAIN ANALYZE: step':30}{'operator':28}{'seconds':>9}{'share':>8}{'rows':>14}"
    total = sum(operator["seconds"] for operator in operators)
    small = 0.0
    for operator in operators:
        if operator["seconds"] < WORTH_A_LINE * total:
            small += operator["seconds"]
            continue
        yield (
            f"  {operator['step']:30}{operator['operator']:28}{operator['seconds']:9.2f}"
            f"{operator['seconds'] / total:8.0%}{operator['rows']:14,}"
        )
    yield f"  {'all others':58}{small:9.2f}{small / total:8.0%}"


def worthy(seconds: dict[str, float]) -> dict[str, float]:
    """Return the steps worth a line, and what the others take together."""
    least = WORTH_A_LINE * sum(seconds.values())
    shown = {step: taken for step, taken in seconds.items() if taken >= least}
    return {**shown, "others": sum(seconds.values()) - sum(shown.values())}
