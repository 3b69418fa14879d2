"""Machines that make several products in shifts: false alarms and wear, with and without the column."""

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from gam_db.alarms import Alarms
from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.benchmark.alarms import fleets
from gam_db.lab.benchmark.alarms.figures import wear
from gam_db.lab.benchmark.alarms.plan import CALIBRATION, RATES, Plan
from gam_db.lab.benchmark.alarms.report import of_rate, of_wear
from gam_db.lab.benchmark.alarms.rivals import Windows, rate_of, today
from gam_db.lab.benchmark.alarms.tables import Learnt, Pool, Row, learnt, name_of
from gam_db.lab.simulate.fleet import Fleet
from gam_db.settings.source import Source

_BUCKETS, _SUMMARY = "bucket_counts", "program_summary"
_ARMS = ("without", "with")


def measure(plan: Plan, products: int, shift: int, show: Callable[[str], None]) -> dict[str, Any]:
    """Return the figures of robots that make several products, read in two ways.

    Args:
        plan: which robots, joints and parameters.
        products: of each robot.
        shift: samples of a shift with one product.
        show: called with the fleet that is at work.

    Returns:
        seeds, samples, products, shift (samples), window, bins, calibration (its share), and for
        ``without`` and ``with`` the column: channels (calm ones), limitless (of these, by reason),
        vectors (judged ones of calm and wearing channels, whole buckets), judgements, episodes, alarmed
        (calm channels with an episode), seen, lower, upper (episodes per judgement), wear, today (the
        limit of the health indicator: rate and wear). ``unjudged`` is how many vectors the column took
        from the judgements, ``programs`` how many programs of a channel have which verdict.
    """
    simulated = [Fleet(seed, plan.samples, shift=shift, products=products) for seed in plan.seeds]

    def on_file(fleet: Fleet, source: Source, read: fleets.Fleets) -> Learnt:
        named = replace(source, program="product")
        return learnt(named, plan.parameters, CALIBRATION, (_BUCKETS, _SUMMARY))

    line = fleets.read(plan, simulated, CALIBRATION, show, on_file=on_file, more=(_BUCKETS,))
    arms = dict(zip(_ARMS, (line.learnt, line.outputs), strict=True))
    figures: dict[str, Any] = {name: _judged(plan, tables, line) for name, tables in arms.items()}
    verdicts = Counter(
        verdict for fleet in line.outputs for verdict in fleet.tables[_SUMMARY]["verdict"].to_pylist()
    )
    return {
        "seeds": list(plan.seeds),
        "samples": plan.samples,
        "products": products,
        "shift": shift,
        "window": plan.window,
        "bins": plan.parameters.bins,
        "calibration": CALIBRATION.fraction,
        **figures,
        "unjudged": figures["without"]["vectors"] - figures["with"]["vectors"],
        "programs": dict(verdicts),
    }


def _judged(plan: Plan, tables: list[Learnt], line: fleets.Fleets) -> Row:
    with DuckSession() as session:
        pool = Pool(session, tables)
        judged = pool.judged(Alarms(rate=f"{RATES[0]:g} per 1000 judgements", family=["*"]))
        windows = Windows(pool)
        calm = [row for row in judged.counted if name_of(row) in line.calm]
        episodes, judgements = (sum(row[name] for row in calm) for name in ("episodes", "judgements"))
        withheld = Counter(row["reason"] for row in judged.limits if name_of(row) in line.calm)
        return {
            "channels": sum(withheld.values()),
            "limitless": {reason: count for reason, count in withheld.items() if reason is not None},
            "vectors": plan.parameters.bucket_length
            * sum(fleet.tables[_BUCKETS].num_rows for fleet in tables),
            "alarmed": sum(row["episodes"] > 0 for row in calm),
            **rate_of(episodes, judgements),
            "wear": wear(judged, line.wearing, windows.ends),
            "today": today(pool, windows, plan.window, line.calm, line.wearing),
        }


def lines(figures: Mapping[str, Any]) -> Iterator[str]:
    """Yield the lines of a report on the figures of :func:`measure`."""
    seeds = ", ".join(map(str, figures["seeds"]))
    yield (
        f"Fleets {seeds}: {figures['products']} products in shifts of {figures['shift']:,} samples, "
        f"{figures['samples']:,} samples, W = {figures['window']:,}, B = {figures['bins']},"
    )
    yield (
        f"still_after 25, calibration {figures['calibration']:.0%}, asked {RATES[0]:g} per 1,000; "
        "false alarms per 1,000 judgements of calm channels, 95 % interval by Poisson"
    )
    for name in _ARMS:
        arm = figures[name]
        why = ", ".join(f"{reason} {count:,}" for reason, count in sorted(arm["limitless"].items()))
        yield ""
        yield f"{name} the column: {arm['vectors']:,} vectors judged"
        yield (
            f"  calm: {of_rate(arm)}; an episode on {arm['alarmed']:,} of {arm['channels']:,} channels, "
            f"no limit: {why or 'none'}"
        )
        yield f"  wear: {of_wear(arm['wear'])}"
        yield f"  twice the floor: {of_rate(arm['today']['rate'])}; {of_wear(arm['today']['wear'])}"
    yield ""
    counts = sorted(figures["programs"].items())
    programs = "programs: " + ", ".join(f"{verdict} {count:,}" for verdict, count in counts)
    share = figures["unjudged"] / figures["without"]["vectors"]
    yield f"not judged with the column: {figures['unjudged']:,} vectors ({share:.1%}); {programs}"
