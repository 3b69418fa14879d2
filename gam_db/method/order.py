"""The order of the steps, from readings to results."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import OfSet, add, join_sets
from gam_db.method.bits import Bits
from gam_db.method.calibration import add_calibration
from gam_db.method.census import (
    FLOWING,
    OPENING,
    Slicing,
    add_census,
    add_census_set,
    add_names,
    table_steps,
)
from gam_db.method.certificate import add_judgement, add_missing_vectors
from gam_db.method.delays import INCOMPLETE, Ways
from gam_db.method.judgement import add_stillness, limit_slots
from gam_db.method.probe import add_certified, add_probe
from gam_db.method.programs import add_judged_programs, add_program_summary
from gam_db.method.resolved import Method
from gam_db.method.scoring import (
    add_scored_groups,
    add_scoring,
    add_support_bits,
)
from gam_db.method.source import add_source
from gam_db.settings.source import TimeNode

#: Steps whose sets are put under one another.
_JOINED_HEALTH = ("window_counts",)
_JOINED_BUCKETS = ("bucket_counts", "novel_cells")
_JOINED_MEMBERS = ("member_sizes", "vouching")
_JOINED_CERTIFICATE = (
    *("bounds", "run_up", "cells", "blocks", "ladder", "learning", "spread", "finest", "outlook"),
    *("missing_vectors", "probe", "sight"),
)
_JOINED_PROGRAMS = ("programs", "judged_programs")


def pipeline(
    method: Method, readings: exp.Query, instant_of: TimeNode, bits: Bits | None = None
) -> Pipeline:
    """Return all steps of the method over the given readings.

    Args:
        method: what the user asked for.
        readings: the step *readings*.
        instant_of: turns integer time into what the source has, for the last steps.
        bits: for an engine that keeps a support as bits.

    The last steps are *health_indicator* (a row per scored vector), *bucket_health* (a row per full
    bucket), *novel_cells*, *support_summary* (a row per channel), *certificate* (a row per block) and
    *probes* (a row per channel and change).
    """
    steps = Pipeline(small=frozenset(method.small()))
    _add_readings(steps, readings)
    add_source(steps, method)
    numbers = range(len(method.settings))
    for number in numbers:
        set_steps = OfSet(steps, method, number)
        add_calibration(set_steps)
        add_support_bits(set_steps, bits)
        set_steps.add("score/run_up", {"span": set_steps.setting.reach})
        if method.programs is not None:  # which programs are judged follows from the certificate
            add_judgement(set_steps)
            add_judged_programs(set_steps)
        add_scoring(set_steps, bits)
        add_scored_groups(set_steps, ["numbered"])
        set_steps.add("health/bucket_counts")
        if method.programs is None:
            add_judgement(set_steps)
        add_probe(set_steps)
        add_missing_vectors(set_steps, "samples")
    join_sets(steps, method, (*_JOINED_HEALTH, *_JOINED_BUCKETS, *_certificate(method)))
    add_stillness(steps, method, "moving_codes")
    add_results(steps, instant_of, method)
    if method.programs is not None:
        add_program_summary(steps, method.programs, instant_of)
    return steps


def opening_pipeline(
    readings: exp.Query, slicing: Slicing | None = None, ways: Ways | None = None
) -> Pipeline:
    """Return the steps that come first, before the form of the others is known: up to *names*.

    Arguments as for :func:`pipeline` and :func:`trusting_pipeline`; without ``slicing`` the former.
    """
    steps = Pipeline(small=OPENING)
    _add_readings(steps, readings)
    add(steps, "census/extent")
    if slicing is None:
        add(steps, "source/names")
    else:
        add_names(steps, slicing, ways or Ways())
    return steps


def trusting_pipeline(
    method: Method,
    readings: exp.Query,
    instant_of: TimeNode,
    slicing: Slicing,
    bits: Bits | None = None,
    ways: Ways | None = None,
) -> Pipeline:
    """Return the steps that take it on trust that no instant occurs twice (:mod:`gam_db.method.census`).

    Arguments as for :func:`pipeline`; ``slicing`` is how the times of the readings are cut, ``ways``
    what engines do differently. Where samples come before calibration, *health_indicator* is not among
    the last steps.
    """
    ways = ways or Ways()
    steps = Pipeline(small=frozenset(method.small() - FLOWING | table_steps(method, ways)))
    _add_readings(steps, readings)
    add_census(steps, method, slicing, ways)
    for number in range(len(method.settings)):
        set_steps = OfSet(steps, method, number)
        add_census_set(set_steps, bits, ways)
    join_sets(steps, method, (*_JOINED_BUCKETS, *_certificate(method)))
    add_stillness(steps, method, f"{INCOMPLETE}moving_codes")
    if ways.is_cut:
        _add_summaries(steps, instant_of, method)
    else:
        join_sets(steps, method, _JOINED_HEALTH)
        add_results(steps, instant_of, method)
    return steps


def add_results(steps: Pipeline, instant_of: TimeNode, method: Method) -> None:
    """Add the last steps: names and instants instead of integers, and the only divisions."""
    add(steps, "health/health_indicator", {"time": instant_of(_counted("time"))})
    _add_summaries(steps, instant_of, method)


def _certificate(method: Method) -> tuple[str, ...]:
    """Return the steps of the certificate of which the rows of all sets are read."""
    ran = () if method.programs is None else _JOINED_PROGRAMS
    return (*_JOINED_CERTIFICATE, *(_JOINED_MEMBERS if method.pools else ()), *ran)


def _add_readings(steps: Pipeline, readings: exp.Query) -> None:
    steps.add("readings", readings, template.load("source/readings").comment)


def _add_summaries(steps: Pipeline, instant_of: TimeNode, method: Method) -> None:
    edges = {name: instant_of(_counted(name)) for name in ("first_time", "last_time")}
    add(steps, "health/bucket_health", edges)
    add_certified(steps, bool(method.pools), method.programs is not None)
    target = exp.column("target_floor", table="scale")
    add(steps, "judgement/limited", limit_slots(target))
    add(steps, "judgement/assessed")
    add(steps, "certificate/support_summary")
    add(steps, "certificate/certificate", edges)
    add(steps, "probe/probes")


def _counted(name: str) -> exp.Expr:
    return exp.column(name, table="counted")
