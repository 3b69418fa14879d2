"""What the indicator would show if the machine changed (both sides, section 2), for one set."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import OfSet, add, add_stacked
from gam_db.method.judgement import limit_of
from gam_db.method.programs import keyed, numbers
from gam_db.method.slots import code_in
from gam_db.method.vectors import add_earlier
from gam_db.settings.parameters import Parameters

#: Shifts, in hundredths of the usual width, and strokes, in tenths.
SHIFTS, STROKES = (1, 2, 5, 10, 20, 50), (5, 8, 12)

#: Speeds as fractions of the usual one. Pace 0 is the usual one, the next are these, the last frozen.
SPEEDS = ((3, 2), (2, 1), (2, 3))
FROZEN = len(SPEEDS) + 1


class Change(NamedTuple):
    """A change of a machine; the slots of ``probe/changes.sql``."""

    name: str
    pace: int = 0
    rung: int | None = None
    shift: float | None = None
    stroke: float | None = None


CHANGES = (
    *(
        Change(f"shift {sign}{part} %", rung=part, shift=float(f"{sign}{part}") / 100.0)
        for part in SHIFTS
        for sign in "+-"
    ),
    *(Change(f"stroke {tenths / 10:g}", stroke=tenths / 10.0) for tenths in STROKES),
    Change("frozen", FROZEN),
    *(Change(f"speed {p}/{q}", pace) for pace, (p, q) in enumerate(SPEEDS, start=1)),
)


def paces(m: int, tau: int) -> dict[int, list[int]]:
    """Return the delays of a vector at each pace; a pace at which two of them are equal is not there."""
    usual = [k * tau for k in range(m)]
    delays_by_pace = {0: usual, FROZEN: [0] * m}
    for pace, (p, q) in enumerate(SPEEDS, start=1):
        delays = [(2 * p * delay + q) // (2 * q) for delay in usual]
        if len(set(delays)) == len(delays):
            delays_by_pace[pace] = delays
    return delays_by_pace


def probed_delays(setting: Parameters) -> tuple[int, ...]:
    """Return the delays of all paces in ascending order; the first is 0."""
    return tuple(
        sorted({delay for delays in paces(setting.m, setting.tau).values() for delay in delays})
    )


def add_probe(set_steps: OfSet, samples: str = "samples") -> None:
    """Add the step *probe* of one set, after its certificate.

    Samples is the step of all samples of known channels, or of their readings where each instant occurs
    once.
    """
    setting = set_steps.setting
    set_steps.add("probe/taught_before")
    set_steps.add("probe/picked", {"picked": template.fill("probe/is_picked")})
    delays_by_pace, delays = paces(setting.m, setting.tau), probed_delays(setting)
    add_earlier(set_steps, "probe_", samples, delays[1:])
    set_steps.add("probe/usual")
    rows = [
        {"change_no": number, **slots_of(of, delays_by_pace)}
        for number, of in enumerate(CHANGES, start=1)
    ]
    add_stacked(set_steps.steps, "probe/changes", rows, set_steps.named("changes"))
    set_steps.add("probe/changed", changed_slots(set_steps, delays_by_pace))
    set_steps.add("probe/probe")
    limit = limit_of(exp.column("target_floor", table="scale"))
    tables = {"spread": "pool_spread"} if set_steps.method.pools else {}
    set_steps.add("probe/sight", {"hi_limit": limit}, tables=tables)


def changed_slots(
    set_steps: OfSet, delays_by_pace: Mapping[int, Sequence[int]]
) -> dict[str, template.Slot]:
    """Return the slots of probe/changed.sql, of the delays at each pace."""
    setting = set_steps.setting
    coordinates = [f"y_{k}" for k in range(setting.m)]
    return {
        "samples": [
            *(
                exp.alias_(_sample(setting, k, delays_by_pace), name)
                for k, name in enumerate(coordinates)
            ),
            *(exp.alias_(exp.column(of.name, table="vector"), of.name) for of in numbers(set_steps)),
        ],
        "codes": [
            *(
                exp.alias_(code_in(setting.grid, value=exp.column(name)), f"code_{k}")
                for k, name in enumerate(coordinates)
            ),
            *numbers(set_steps),
        ],
        **keyed(set_steps),
    }


def add_certified(steps: Pipeline, has_pools: bool, has_programs: bool = False) -> None:
    """Add the certificate of each channel of all sets, both sides of it: *certified*."""
    add(steps, "certificate/verdicts")
    slots: dict[str, template.Slot] = {
        name: template.fill(f"probe/{name}") for name in ("would_not_see", "blind_reason")
    }
    verdicts = "verdicts"
    if has_pools:
        add(steps, "certificate/vouched_verdicts")
        verdicts = "vouched_verdicts"
    vouched = (("vouched_by", "BIGINT"), ("taught_by", "VARCHAR"), ("member_floor", "DOUBLE"))
    slots["vouched"] = [
        exp.alias_(exp.column(name, table="learnt") if has_pools else exp.cast(exp.null(), of), name)
        for name, of in vouched
    ]
    if has_programs:
        carried = slots["vouched"] if has_pools else []
        add(steps, "program/program_verdicts", {"vouched": carried}, tables={"verdicts": verdicts})
        verdicts = "program_verdicts"
    add(steps, "certificate/certified", slots, tables={"verdicts": verdicts})


def _sample(setting: Parameters, k: int, delays: Mapping[int, Sequence[int]]) -> exp.Expr:
    """Return a coordinate of a vector after a change, of columns with the samples so many before."""
    of_delay = {pace: exp.column(f"x_{held[k]}", table="vector") for pace, held in delays.items()}
    usual = of_delay.pop(0)
    paced = exp.Case(default=usual)
    for pace, sample in of_delay.items():
        paced = paced.when(exp.column("pace", table="change").eq(pace), sample)
    return template.fill("probe/sample", {"usual": usual, "paced": paced})


def slots_of(of: Change, delays: Mapping[int, Sequence[int]]) -> dict[str, Any]:
    """Return the slots of probe/changes.sql, but for the number of the change."""
    slots = of._asdict()
    pace = of.pace if of.pace in delays else None
    name = template.text(slots.pop("name"))
    return {**slots, "change_name": name, "pace": pace}
