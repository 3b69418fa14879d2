"""Steps that look for neighbours: the embedding, false nearest neighbours, Cao's quantities.

Exact neighbours are found box-assisted: the range is cut into boxes along at most five coordinates; a
neighbour nearer than the side of a box must lie in the box of its vector or beside it. Vectors without
one go on to larger boxes, and in the last round a box holds everything. Each round is a step, added
only as long as somebody says that vectors wait for it.

This module makes trees; it runs nothing.
"""

import itertools
import math
from collections.abc import Callable

from sqlglot import exp

from gam_db import template
from gam_db.method.adding import add
from gam_db.pipeline import Pipeline, filled, union_of
from gam_db.selection.search import Search

_BOXED = 5
"""Coordinates with boxes at most: each triples the boxes beside one, and holds fewer vectors in them."""
_FILLED = 3
"""Coordinates that a series is taken to fill, when the first boxes are made."""
_CROWD = 1
"""Vectors that the boxes of the first round would hold together, were they spread evenly. They crowd."""
ONE_BOX = 500
"""With so few samples at most, one round over all of them is cheaper than several."""
_LARGEST_NUMBER = 60
"""Bits for the number of a box: one word, with room for the boxes beside the range."""
_EVERYWHERE = 1e9
"""A distance beyond all between scaled vectors."""


def add_embedding(steps: Pipeline, search: Search) -> None:
    """Add vectors of m_max + 2 coordinates, as far as each sample has that many ahead of it."""
    add(steps, "selection/origins")
    previous = "origins"
    last = search.m_max + 1
    for k in range(1, last + 1):
        name = "embedded" if k == last else f"unfolded_{k}"
        carried = [exp.column(f"u_{j}") for j in range(k)]
        held = [exp.alias_(exp.column(f"u_{j}", table="held"), f"u_{j}") for j in range(k)]
        new = exp.alias_(template.fill("selection/ahead"), f"u_{k}")
        slots: dict[str, template.Slot] = {
            "coordinates": carried,
            "carried": held,
            "ahead": [new],
            "k": k,
        }
        add(steps, "selection/unfolded", slots, name, {"origins": previous, "points": "origins"})
        previous = name
    steps.small |= {"embedded"}


def add_dimensions(
    steps: Pipeline, search: Search, usable: int, is_waited_for: Callable[[str], bool]
) -> None:
    """Add false nearest neighbours and Cao's quantities for every dimension, and the choice of m.

    Args:
        steps: with the embedding.
        search: the options.
        usable: samples of the longest channel; the first boxes are made for as many.
        is_waited_for: asked after each round with the name of a step that counts who waits for the
            next; it may run the step, or say yes for all rounds there can be.
    """
    fates, growths = [], []
    for d in range(1, search.m_max + 2):
        _add_probes(steps, search, d)
        for metric in ("square", "largest"):
            if metric == "square" and d > search.m_max:
                continue  # E1 of the last dimension needs E of the next, and no more
            found = _add_search(steps, d, metric, usable, is_waited_for)
            followed = f"followed_{metric}_{d}"
            nexts = {
                "next_coordinate": exp.column(f"u_{d}", table="probe"),
                "next_of_neighbour": exp.column(f"u_{d}", table="other"),
            }
            tables = {"found": found, "probes": f"probes_{d}"}
            add(steps, "selection/followed", nexts, followed, tables)
            steps.small |= {followed}
            if metric == "square":
                name, path = f"false_neighbours_{d}", "selection/false_neighbours"
                fates.append(name)
            else:
                name, path = f"expansions_{d}", "selection/expansions"
                growths.append(name)
            add(steps, path, {"d": d}, name, {"followed": followed, "probes": f"probes_{d}"})
    for name, parts in (("false_neighbours", fates), ("expansions", growths)):
        steps.add(name, union_of(steps, parts), template.load(f"selection/{name}").comment)
    add(steps, "selection/cao", {"m_max": search.m_max})
    add(steps, "selection/dimensions", {"m_max": search.m_max})
    add(steps, "selection/unfoldings")
    steps.small |= {"dimensions", "unfoldings"}


def _add_probes(steps: Pipeline, search: Search, d: int) -> None:
    coordinates = [exp.column(f"u_{j}") for j in range(d + 1)]
    slots: dict[str, template.Slot] = {"d": d, "coordinates": coordinates[:d]}
    add(steps, "selection/patterns", slots, f"patterns_{d}")
    slots = {
        "d": d,
        "carried": coordinates,
        "theiler": search.theiler,
        "seed": search.seed,
        "references": search.references,
    }
    add(steps, "selection/probes", slots, f"probes_{d}")
    steps.small |= {f"patterns_{d}", f"probes_{d}"}


def _add_search(
    steps: Pipeline, d: int, metric: str, usable: int, is_waited_for: Callable[[str], bool]
) -> str:
    """Add the rounds of one search and return the step with all neighbours found."""
    mark = f"{metric}_{d}"
    boxed = sorted({j * (d - 1) // max(min(d, _BOXED) - 1, 1) for j in range(min(d, _BOXED))})
    waiting = f"unsettled_{mark}"
    add(steps, "selection/unsettled", name=waiting, tables={"probes": f"probes_{d}"})
    nearest = []
    for halvings in _sizes(usable, len(boxed)):
        size = f"{mark}_{halvings}"
        weights = [(2**halvings + 3) ** j for j in range(len(boxed))]
        _add_shifts(steps, f"shifts_{size}", weights)
        box = template.added(
            [
                template.fill(
                    "selection/box_term",
                    {"coordinate": exp.column(f"u_{j}"), "boxes": 2**halvings, "weight": weight},
                )
                for j, weight in zip(boxed, weights, strict=True)
            ]
        )
        add(
            steps,
            "selection/measured",
            {
                "coordinates": [exp.column(f"u_{j}") for j in range(d)],
                "box": box,
                "aways": [_away(j) for j in range(d)],
                "distance": _square(d) if metric == "square" else _largest(d),
            },
            f"measured_{size}",
            {
                "probes": f"probes_{d}",
                "patterns": f"patterns_{d}",
                "unsettled": waiting,
                "shifts": f"shifts_{size}",
            },
        )
        side = 0.5**halvings
        reach = _EVERYWHERE if not halvings else side**2 if metric == "square" else side
        measured = {"measured": f"measured_{size}"}
        add(
            steps,
            "selection/rounds",
            {"reach": reach},
            f"rounds_{size}",
            {"unsettled": waiting, **measured},
        )
        waiting = f"rounds_{size}"
        add(
            steps,
            "selection/nearest",
            name=f"nearest_{size}",
            tables={"rounds": waiting, **measured},
        )
        nearest.append(f"nearest_{size}")
        steps.small |= {waiting, f"nearest_{size}"}
        if halvings:
            add(steps, "selection/waiting", name=f"waiting_{size}", tables={"rounds": waiting})
            if not is_waited_for(f"waiting_{size}"):
                break
    steps.add(f"found_{mark}", union_of(steps, nearest), template.load("selection/nearest").comment)
    return f"found_{mark}"


def _add_shifts(steps: Pipeline, name: str, weights: list[int]) -> None:
    steps_aside = itertools.product((-1, 0, 1), repeat=len(weights))
    rows = [
        filled(
            "selection/shifts",
            {"shift": sum(aside * weight for aside, weight in zip(each, weights, strict=True))},
        )
        for each in steps_aside
    ]
    steps.add(name, exp.union(*rows, distinct=False), template.load("selection/shifts").comment)
    steps.small |= {name}


def _sizes(usable: int, coordinates: int) -> list[int]:
    """Return how often the range is halved into boxes, round by round, ending with no halving."""
    if usable <= ONE_BOX:
        return [0]
    filled = min(coordinates, _FILLED)
    along = 3 * (usable / _CROWD) ** (1 / filled)
    first = min(_LARGEST_NUMBER // coordinates, max(0, math.floor(math.log2(along))))
    # With fewer coordinates a step of one halving makes the boxes grow more slowly.
    return sorted({*range(first, 0, filled - _FILLED - 1), 0}, reverse=True)


def _away(j: int) -> exp.Expr:
    sides = {
        "here": exp.column(f"u_{j}", table="seeking"),
        "there": exp.column(f"u_{j}", table="pattern"),
    }
    return exp.alias_(template.fill("selection/away", sides), f"away_{j}")


def _square(d: int) -> exp.Expr:
    """Return the squared Euclidean distance."""
    aways = [exp.column(f"away_{j}") for j in range(d)]
    return template.added([exp.Mul(this=away, expression=away.copy()) for away in aways])


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
