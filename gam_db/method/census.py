"""The census: the steps for a source of which each instant is expected once.

Where calibration ends, its range and the run-up are read off counts by slice of time, and a slice or
two of samples; nothing is sorted for them. Every vector carries the mark of what would prove that
wrong: *learnable* and what buckets are counted from hold ``doubled``. For methods that it
:func:`serves`.
"""

from dataclasses import dataclass

from sqlglot import exp

from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import OfSet, add
from gam_db.method.bits import Bits
from gam_db.method.calibration import add_learnt
from gam_db.method.certificate import add_judgement, add_missing_vectors
from gam_db.method.delays import (
    CALIBRATION,
    COMPLETE,
    INCOMPLETE,
    STORED,
    Ways,
    add_delays,
    add_stored,
)
from gam_db.method.delays import SET_STEPS as BODY_STEPS
from gam_db.method.probe import add_probe
from gam_db.method.programs import identified_slots
from gam_db.method.ranges import add_bounds
from gam_db.method.resolved import Method
from gam_db.method.scoring import (
    add_incomplete,
    add_novelty,
    add_running,
    add_scored_groups,
    add_support_bits,
    number_of,
)
from gam_db.method.source import add_channels, add_intervals, add_rules

#: Slices of the time range at most: the samples of a slice or two are read again, which of evenly spaced
#: ones are few, and still more slices save nothing that can be measured.
SLICES = 32

#: Rows of the census at most, be there ever so many channels.
MOST_ROWS = 1_000_000

#: Readings of a slice of one channel at least: a group of few costs more than it saves to read.
IN_SLICE = 32

#: Its own steps that are kept, up to what *names* are read off, and in all.
OPENING = frozenset(("slices", *(step for steps in STORED.values() for step in steps)))
TABLE_STEPS = OPENING | {"edges", "edge_samples", "conflicts"}

#: Small steps that are read once or are constants here: a table of each would cost more.
FLOWING = frozenset(("rules", "declared", "series", "calibrated"))

#: The readings of each range, to be bounded by whoever knows it: no optimizer finds that by itself.
EDGES, TAUGHT, SCORED = "edge_readings", "taught_readings", "scored_readings"


@dataclass(frozen=True)
class Slicing:
    """How times are cut into slices: the earliest time of all, and the width of a slice."""

    origin: int
    width: int

    @classmethod
    def of(cls, earliest: int, latest: int, slices: int = SLICES) -> "Slicing":
        """Return so many slices of a range of time."""
        return cls(earliest, (latest - earliest) // slices + 1)


def slices_for(readings: int, channels: int) -> int:
    """Return how many slices serve so many channels that have so many readings in all."""
    return max(1, min(SLICES, MOST_ROWS // channels, readings // (IN_SLICE * channels)))


#: Of a source that a body keeps, which cuts it by the number of samples.
UNCUT = Slicing(0, 1)


def serves(method: Method) -> bool:
    """Tell whether no declared calibration is scored."""
    return all(
        rule.score_from is None or rule.declared_end is None or rule.score_from > rule.declared_end
        for rule in method.rules
    )


def add_census(steps: Pipeline, method: Method, slicing: Slicing, ways: Ways) -> None:
    """Add what speaks of whole channels, up to the range of calibration (method, sections 2 and 4)."""
    add_names(steps, slicing, ways)
    add_rules(steps, method)
    add_channels(steps, method)
    reach = max(1, *(setting.reach for setting in method.settings))
    add(steps, "census/cuts")
    add(steps, "census/edges", {"reach": reach})
    if ways.delays is not None:
        add(steps, f"{ways.delays}/edge_samples")
    else:
        _add_readings(steps, EDGES)
        add(
            steps,
            "source/identified",
            identified_slots(exp.true(), False),
            "near_edges",
            {"readings": EDGES},
        )
        add(steps, "census/edge_samples")
    file = "conflicts" if ways.is_collapsed else "no_conflicts"
    add(steps, f"census/{file}", name="conflicts")
    add(steps, "census/series")
    add_intervals(steps)
    add(steps, "census/calibrated")
    if ways.delays is None or ways.is_cut:
        _add_readings(steps, TAUGHT)
    add(steps, "source/identified", identified_slots(exp.true(), False))


def add_names(steps: Pipeline, slicing: Slicing, ways: Ways) -> None:
    """Add the counts by slice, and the names that follow from them."""
    if ways.delays is not None:
        add_stored(steps, ways)
    else:
        add(steps, "census/slices", {"origin": slicing.origin, "width": slicing.width})
    add(steps, "census/names")


def add_census_set(set_steps: OfSet, bits: Bits | None, ways: Ways) -> None:
    """Add support, buckets and certificate of one set, after :func:`add_census`."""
    add_bounds(set_steps, ways.delays or "census", TAUGHT)
    set_steps.add("score/run_up", {"span": set_steps.setting.reach}, tables={"samples": "edge_samples"})
    # Where segments end or samples stand still, vectors are numbered as where samples are missing.
    is_broken = not set_steps.method.is_unbroken(set_steps.number)
    complete = exp.Literal.number(0) if is_broken else exp.column("complete", table="reached")
    set_steps.add("census/scale", {"complete": complete})
    scored = set_steps.named(SCORED)
    if ways.delays is not None:
        for name in BODY_STEPS[ways.delays]:  # what a body keeps for each set
            set_steps.add(f"{ways.delays}/{name}")
    else:
        _add_readings(set_steps.steps, scored)
    add_delays(set_steps, CALIBRATION, ways, TAUGHT, bits is not None)
    add_learnt(
        set_steps, exp.column("calibration_vector").eq(1) if ways.is_cut else exp.true(), "doubled"
    )
    if ways.taught == "taught":
        set_steps.add("census/taught")
    set_steps.add("support/support", tables={"learnable": ways.taught})
    add_support_bits(set_steps, bits)
    parts = []
    if not is_broken:
        add_delays(set_steps, COMPLETE, ways, scored, bits is not None)
        add_trusted_novelty(set_steps, bits, ways.by_sets)
        parts.append(f"{COMPLETE}novelty")
    if is_broken or ways.has_missing:
        add_delays(set_steps, INCOMPLETE, ways, scored, bits is not None)
        add_incomplete(set_steps, ["doubled"], bits, ways.by_sets)
        parts.append(f"{INCOMPLETE}numbered")
    add_scored_groups(set_steps, parts, trusting=True, counted=ways.counted)
    set_steps.add("health/bucket_counts")
    if not ways.is_cut:
        add_running(set_steps, parts)
        set_steps.add("health/window_counts")
    add_judgement(set_steps)
    add_probe(set_steps, "identified")
    if ways.has_room and is_broken:
        set_steps.add("census/held_vectors")
        set_steps.add("certificate/missing_vectors", tables={"vectors": "held_vectors"})
    else:
        add_missing_vectors(set_steps, "identified")


def add_trusted_novelty(set_steps: OfSet, bits: Bits | None, by_sets: bool = False) -> None:
    """Add Eq. 4 of channels without missing samples, right over their vectors, with their marks."""
    doubled = exp.alias_(exp.column("doubled", table="vector"), "doubled")
    add_novelty(
        set_steps, [number_of(set_steps.setting.span), doubled], bits, COMPLETE, "vectors", by_sets
    )


def table_steps(method: Method, ways: Ways) -> set[str]:
    """Return the steps of the census that are kept beside those of every form."""
    steps = [ways.taught, "scale", *BODY_STEPS.get(ways.delays or "", ())]
    if ways.has_room:
        scored_steps = ("moving_codes", "vectors")
        steps += [f"{CALIBRATION}vectors", *(f"{INCOMPLETE}{step}" for step in scored_steps)]
    return {
        method.named(step, number) for step in steps for number in range(len(method.settings))
    } | TABLE_STEPS


def _add_readings(steps: Pipeline, name: str) -> None:
    """Add the readings of a range of time."""
    columns = steps.steps["readings"].query.named_selects
    steps.add(name, union_of(steps, ["readings"], columns), "Readings: those of a range of time.")
