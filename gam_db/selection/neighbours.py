"""Steps of the neighbour search: the embedding, false nearest neighbours, Cao's quantities.

Exact neighbours are found box-assisted: the range is cut into boxes along at most five coordinates; a
neighbour nearer than the side of a box must lie in the box of its vector or beside it. Vectors without
one go on to larger boxes, and in the last round a box holds everything. Each round is a step, added
only as long as somebody says that vectors wait for it.

This module makes trees; it runs nothing.
"""

import itertools
import math
from collections.abc import Callable, Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, union_of
from gam_db.method.adding import add, add_stacked
from gam_db.selection.search import Search

MOST_VECTORS = 2**15
"""Of more vectors of a channel, about so many take part."""
_BOXED = 5
"""Coordinates with boxes at most: each triples the boxes beside one, and holds fewer vectors in them."""
_FILLED = 2
"""Coordinates that a series is taken to fill, when the first boxes are made. Boxes too small cost a
quick round more; in boxes too large, where samples lie close together, all are compared with all."""
_COARSE = 5
"""From so many halvings on boxes grow step by step: the larger they are, the dearer one too large."""
BOX_CAPACITY = 500
"""With so few samples at most, one round over all of them is cheaper than several."""
_NUMBERED = 60
"""Bits for the number of a box: one word, with room for the boxes beside the range."""
_BITS = 24
"""Of a coordinate: it is an integer, in units of 2^-24 of the range."""
_SIDES = (("here", "seeking"), ("there", "pattern"))
_EVERYWHERE = 2**62
"""A squared distance beyond all between vectors."""

Waiting = Callable[[str], tuple[int, int]]
"""Asked with the name of a step like ``waiting.sql``: how many vectors sought, how many still do."""


def add_embedding(steps: Pipeline, search: Search, bins: int) -> None:
    """Add vectors of m_max + 2 coordinates, as far as each sample has that many ahead of it.

    The first m_max coordinates have codes of so many bins beside them.
    """
    add(steps, "selection/origins", {"code": template.fill("selection/bin_code", {"bins": bins})})
    previous = "origins"
    last = search.m_max + 1
    held = ["u_0", "c_0"]
    for k in range(1, last + 1):
        name = "embedded" if k == last else f"unfolded_{k}"
        new = ["u", "c"] if k < search.m_max else ["u"]
        slots: dict[str, template.Slot] = {
            "coordinates": [exp.column(column) for column in held],
            "carried": [exp.alias_(exp.column(column, table="held"), column) for column in held],
            "ahead": [
                exp.alias_(
                    template.fill(
                        "selection/ahead", {"later": exp.column(f"{column}_0", table="later")}
                    ),
                    f"{column}_{k}",
                )
                for column in new
            ],
            "k": k,
        }
        add(steps, "selection/unfolded", slots, name, {"origins": previous, "points": "origins"})
        previous = name
        held += [f"{column}_{k}" for column in new]
    steps.small |= {"embedded"}


def add_dimensions(steps: Pipeline, search: Search, usable: int, waiting: Waiting) -> None:
    """Add false nearest neighbours and Cao's quantities for every dimension, and the choice of m.

    The first boxes are made for the vectors of the longest channel that take part. What says how many
    wait is asked after each round with the name of the step that counts, and may run that step.
    """
    _add_draws(steps, search)
    fates, growths = [], []
    halvings = _BITS
    for d in range(1, search.m_max + 2):
        _add_probes(steps, search, d)
        neighbours, halvings = _add_search(steps, d, usable, halvings, waiting)
        for metric in ("square", "largest"):
            if metric == "square" and d > search.m_max:
                continue  # E1 of the last dimension needs E of the next, and no more
            followed = f"followed_{metric}_{d}"
            slots: dict[str, template.Slot] = {
                "next_coordinate": exp.column(f"u_{d}", table="probe"),
                "next_of_neighbour": exp.column(f"u_{d}", table="other"),
                "distance": exp.column(metric, table="pair"),
                "neighbour": exp.column(f"{metric}_place", table="pair"),
            }
            tables = {"neighbours": neighbours, "probes": f"probes_{d}"}
            add(steps, "selection/followed", slots, followed, tables)
            steps.small |= {followed}
            if metric == "square":
                name, path = f"false_neighbours_{d}", "selection/false_neighbours"
                fates.append(name)
            else:
                name, path = f"expansions_{d}", "selection/expansions"
                growths.append(name)
            add(steps, path, {"d": d}, name, {"followed": followed, "probes": f"probes_{d}"})
    for d in range(1, search.m_max + 2):
        add(steps, "selection/states", {"d": d}, f"states_{d}", {"patterns": f"patterns_{d}"})
    states = [f"states_{d}" for d in range(1, search.m_max + 2)]
    for name, parts in (("false_neighbours", fates), ("expansions", growths), ("states", states)):
        steps.add(name, union_of(steps, parts), template.load(f"selection/{name}").comment)
    add(steps, "selection/ambiguous")
    add(steps, "selection/cao", {"m_max": search.m_max})
    add(steps, "selection/dimensions", {"m_max": search.m_max})
    add(steps, "selection/unfoldings")
    steps.small |= {"dimensions", "unfoldings"}


def _add_draws(steps: Pipeline, search: Search) -> None:
    last, references = search.m_max + 1, search.references
    carried = [exp.column(f"u_{j}") for j in range(last + 1)]
    add(steps, "selection/sampled", {"carried": carried, "most": MOST_VECTORS})
    steps.small |= {"sampled"}
    add(steps, "selection/scattered", {"carried": carried, "seed": search.seed})
    add(steps, "selection/deepest", {"last": last, "references": references})
    add(steps, "selection/draws", {"carried": carried, "references": references})
    steps.small |= {"deepest", "draws"}


def _add_probes(steps: Pipeline, search: Search, d: int) -> None:
    coordinates = [exp.column(f"u_{j}") for j in range(d + 1)]
    slots: dict[str, template.Slot] = {"d": d, "coordinates": coordinates[:d]}
    add(steps, "selection/patterns", slots, f"patterns_{d}")
    slots = {"d": d, "carried": coordinates, "theiler": search.theiler, "references": search.references}
    add(steps, "selection/probes", slots, f"probes_{d}")
    steps.small |= {f"patterns_{d}", f"probes_{d}"}


def _add_search(steps: Pipeline, d: int, usable: int, finest: int, waiting: Waiting) -> tuple[str, int]:
    """Add the rounds of one search; return the step with all neighbours, and the finest useful halvings.

    No more halvings are tried than were of use at the dimension before: with one coordinate more, no
    vector has a nearer neighbour.
    """
    boxed = sorted({j * (d - 1) // max(min(d, _BOXED) - 1, 1) for j in range(min(d, _BOXED))})
    bits = _NUMBERED // len(boxed)
    sought = f"unsettled_{d}"
    add(steps, "selection/unsettled", name=sought, tables={"probes": f"probes_{d}"})
    halvings = 0
    if usable > BOX_CAPACITY:  # a vector to a box, were they spread evenly
        spread = math.floor(math.log2(3 * usable ** (1 / min(d, _FILLED))))
        halvings = min(spread, _BITS, finest, bits - 1)
    of_use, everybody = None, 0
    nearest = []
    while True:
        size = f"{d}_{halvings}"
        _add_round(steps, d, halvings, bits, boxed, sought)
        sought = f"rounds_{size}"
        nearest.append(f"nearest_{size}")
        if not halvings:
            break
        add(steps, "selection/waiting", name=f"waiting_{size}", tables={"rounds": sought})
        seeking, still = waiting(f"waiting_{size}")
        everybody = everybody or seeking
        if of_use is None and 4 * (seeking - still) >= everybody:
            of_use = halvings
        if not still:
            break
        # With fewer coordinates larger steps make the boxes grow no faster; few found: they may.
        is_few = 10 * (seeking - still) < seeking and halvings > _COARSE
        halvings = max(halvings - max(4 - len(boxed), 1) - is_few, 0)
    steps.add(f"found_{d}", union_of(steps, nearest), template.load("selection/nearest").comment)
    return f"found_{d}", halvings if of_use is None else of_use


def _add_round(
    steps: Pipeline, d: int, halvings: int, bits: int, boxed: Sequence[int], sought: str
) -> None:
    """Add one round: distances in boxes whose side is the range, halved so often; 0 for one box."""
    size = f"{d}_{halvings}"
    side = 2 ** (_BITS - halvings)
    box = template.added(
        [
            template.fill(
                "selection/box_term",
                {
                    "coordinate": exp.column(f"u_{j}"),
                    "per_side": 1 / (side if halvings else 2 * side),
                    "weight": 2 ** (bits * place),
                },
            )
            for place, j in enumerate(boxed)
        ]
    )
    aways = [exp.column(f"away_{j}") for j in range(d)]
    slots: dict[str, template.Slot] = {
        "coordinates": [exp.column(f"u_{j}") for j in range(d)],
        "box": box,
        "aways": [_away(j) for j in range(d)],
        "square": template.added([exp.Mul(this=away, expression=away.copy()) for away in aways]),
        "largest": _largest(d),
    }
    shared = {
        "probes": f"probes_{d}",
        "patterns": f"patterns_{d}",
        "shifts": _shifts(steps, len(boxed) if halvings else 0, bits),
    }

    def measure(name: str, probed: str, settled: int) -> None:
        measured_slots = {**slots, "settled": settled}
        add(steps, "selection/measured", measured_slots, name, {**shared, "sought": probed})

    measure(f"measured_{size}", sought, settled=0)
    tables = {"unsettled": sought, "measured": f"measured_{size}"}
    reach = side**2 if halvings else _EVERYWHERE
    add(steps, "selection/rounds", {"reach": reach}, f"rounds_{size}", tables)
    measure(f"reached_{size}", f"rounds_{size}", settled=1)
    tables = {"rounds": f"rounds_{size}", "measured": f"reached_{size}"}
    add(steps, "selection/nearest", name=f"nearest_{size}", tables=tables)
    steps.small |= {f"rounds_{size}", f"nearest_{size}"}


def _shifts(steps: Pipeline, coordinates: int, bits: int) -> str:
    """Return the step of the ways from a box to itself and to those beside it."""
    name = f"shifts_{coordinates}"
    if name not in steps.steps:
        rows = [
            {"shift": sum(aside * 2 ** (bits * place) for place, aside in enumerate(asides))}
            for asides in itertools.product((-1, 0, 1), repeat=coordinates)
        ]
        add_stacked(steps, "selection/shifts", rows, name)
        steps.small |= {name}
    return name


def _away(j: int) -> exp.Expr:
    sides = {name: exp.column(f"u_{j}", table=of) for name, of in _SIDES}
    return exp.alias_(template.fill("selection/away", sides), f"away_{j}")


def _largest(d: int) -> exp.Expr:
    """Return the distance in the maximum norm: the first of the coordinates that no other exceeds."""
    if d == 1:
        return exp.column("away_0")
    cases = []
    for j in range(d):
        no_less = [
            exp.GTE(this=exp.column(f"away_{j}"), expression=exp.column(f"away_{other}"))
            for other in range(d)
            if other != j
        ]
        cases.append(exp.If(this=exp.and_(*no_less), true=exp.column(f"away_{j}")))
    return exp.Case(ifs=cases)
