"""The order of work: read fleets, ask the product at several rates, measure what stands beside."""

from collections.abc import Callable, Sequence
from typing import Any

import pyarrow as pa

from gam_db.alarms import Alarms
from gam_db.engines.duckdb.session import DuckSession
from gam_db.extras import needed
from gam_db.lab.benchmark.alarms import fleets
from gam_db.lab.benchmark.alarms.figures import counted, promise, wear
from gam_db.lab.benchmark.alarms.plan import CALIBRATION, DRIFTS, LONG_CALIBRATION, RATES, RIVALS, Plan
from gam_db.lab.benchmark.alarms.rivals import Windows, control, judged_scores, rate_of, scored, today
from gam_db.lab.benchmark.alarms.tables import Judged, Pool, Row, name_of
from gam_db.lab.simulate.fleet import Fleet
from gam_db.settings.source import Source

Listener = Callable[[str], None]


def measure(plan: Plan, show: Listener) -> dict[str, Any]:
    """Return the figures of a plan.

    Args:
        plan: what is measured.
        show: told what is at work, once for each fleet that is read.

    Returns:
        quick, seeds, samples, window, bins, calibration (its share); promise and wear (of each rate and
        form of family: form, and what :mod:`~gam_db.lab.benchmark.alarms.figures` returns); today;
        control; with everything also rivals, drift and shifts.
    """
    if plan.everything:
        needed("sklearn", "benchmark")
    figures: dict[str, Any] = {
        "quick": plan.is_quick,
        "seeds": list(plan.seeds),
        "samples": plan.samples,
        "window": plan.window,
        "bins": plan.parameters.bins,
        "calibration": CALIBRATION.fraction,
    }

    def on_file(fleet: Fleet, source: Source, read: fleets.Fleets) -> dict[str, pa.Table]:
        """Score some channels: those that wear, and the first joint of each other robot."""
        if not plan.everything or fleet.seed not in plan.rivalled:
            return {}
        some = [*read.wearing, *(name for name in read.calm if name[1].endswith("_j1"))]
        return {rival: scored(plan, rival, source, some) for rival in RIVALS}

    simulation = fleets.read(plan, map(plan.fleet, plan.seeds), CALIBRATION, show, on_file=on_file)
    with DuckSession() as session:
        pool = Pool(session, simulation.learnt)
        figures |= _promised(plan, pool, simulation)
    if plan.everything:
        figures["rivals"] = _rivals(plan, simulation)
        figures["drift"] = [_moved(plan, plan.window * windows, 0, show) for windows in DRIFTS]
        figures["shifts"] = _moved(plan, 0.0, plan.shift, show)
    return figures


def _rate_text(rate: float) -> str:
    return f"{rate:g} per 1000 judgements"


def _promised(plan: Plan, pool: Pool, simulation: fleets.Fleets) -> dict[str, Any]:
    windows = Windows(pool)
    forms: dict[str, Sequence[str]] = {
        "one family": ["*"],
        "a family per fleet": [f"f{seed}_*" for seed in plan.seeds],
        # The few channels of a robot are too few to be replayed.
        "by the table": [f"f{seed}_r{n}_*" for seed in plan.seeds for n in range(1, plan.robots + 1)],
    }
    promised, worn = [], []
    for form, families in forms.items():
        rates: list[str | None] = [*map(_rate_text, RATES)]
        for rate in [*rates, None] if form == "one family" else rates:
            judged = pool.judged(Alarms(rate=rate, family=families))
            promised.append({"form": form, **promise(judged, simulation.calm)})
            worn.append({"form": form, **wear(judged, simulation.wearing, windows.ends)})
    return {
        "promise": promised,
        "wear": worn,
        "today": today(pool, windows, plan.window, simulation.calm, simulation.wearing),
        "control": control(pool, windows, plan.window, simulation.calm, RATES[0] / 1000),
    }


def _rivals(plan: Plan, simulation: fleets.Fleets) -> list[Row]:
    """Return what estimators see on the fleets that they were asked of, at equal false alarms."""
    with DuckSession() as session:
        pool = Pool(session, simulation.learnt[: len(plan.rivalled)])
        windows = Windows(pool)
        tables = {name: [scores[name] for scores in simulation.outputs if scores] for name in RIVALS}
        scored_too = {name_of(row) for table in tables[RIVALS[0]] for row in table.to_pylist()}
        calm = simulation.calm & scored_too
        wearing = {
            name: simulation.wearing[name] for name in simulation.wearing.keys() & windows.ids.keys()
        }
        judged = pool.judged(Alarms(rate=_rate_text(RATES[0]), family=["*"]))
        its = counted([row for row in judged.counted if name_of(row) in calm])
        rows: list[Row] = [
            {
                "estimator": "dse",
                "height": None,
                "rate": rate_of(its["episodes"], its["judgements"]),
                "wear": wear(judged, wearing, windows.ends),
            }
        ]
        for name in RIVALS:
            rival_row = judged_scores(pool, windows, tables[name], calm, wearing, its["episodes"])
            rows.append({"estimator": name, **rival_row})
        return rows


def _moved(plan: Plan, wander: float, shift: int, show: Listener) -> Row:
    """Return promise of calm fleets that drift or change products, calibration included."""
    moved = (Fleet(seed, plan.samples, wander, shift) for seed in plan.extra)
    simulation = fleets.read(plan, moved, LONG_CALIBRATION, show, wearing=False)
    with DuckSession() as session:
        judged: Judged = Pool(session, simulation.learnt).judged(
            Alarms(rate=_rate_text(RATES[0]), family=["*"])
        )
    return {"windows": wander / plan.window, **promise(judged, simulation.calm)}
