"""The paper's figures, drawn from results: the first robots of the fleet that failed, none chosen."""

import functools
import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray

from gam_db.engines.duckdb.session import DuckSession
from gam_db.lab.estimators import DSE
from gam_db.lab.estimators.points import add_points, names_of
from gam_db.lab.reproduce import sensitivity
from gam_db.lab.reproduce.fleet import BINS, CALIBRATION, FULL, QUICK, Place, Plan, series
from gam_db.lab.reproduce.methods import METHODS, check_libraries
from gam_db.lab.reproduce.results import Figures, Results, Show
from gam_db.lab.reproduce.svg import BLACK, DARK, DASHES, GREY, LIGHT, Drawing, Plot, Point
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import Source
from gam_db.study import Study

SEED = 0
DIMENSIONS = (3, 6)
"""Embedding dimensions whose indicators are compared."""

_COLUMNS = 4
_PANEL = 150, 95
_READABLE = 118
"""The darkest grey, of 255, on which black words are read better than white ones."""

_POINTS = 250
"""Points of a course in a panel, at most about; it is no wider than 150."""

_EDGE = 140
_AZIMUTH, _ELEVATION = math.radians(-60), math.radians(25)
_SHARES = (0, 0.5, 1)

Drawn = Callable[[Plan, Sequence[str], Results, Show], Drawing]


def figures(
    numbers: Sequence[str],
    folder: Path,
    names: Sequence[str],
    quick: bool,
    results: Results,
    show: Show,
) -> list[Path]:
    """Draw figures, each as a file; what has no result yet is run.

    Args:
        numbers: out of FIGURES.
        folder: where the files go.
        names: methods whose indicators are compared.
        quick: from results of the quick form: no evidence.
        results: where results are kept.
        show: told what is at work.

    Raises:
        UserError: see its subclasses.
    """
    check_libraries(names)
    files = []
    for number in numbers:
        show(f"figure {number}")
        drawing = FIGURES[number](QUICK if quick else FULL, names, results, show)
        files.append(folder / f"figure-{number}.svg")
        drawing.write(files[-1])
    return files


def attractor(plan: Plan, names: Sequence[str], results: Results, show: Show) -> Drawing:
    """Draw the cells that a joint visits while it is healthy, and in its last window."""
    joint = _failed(plan, 0)
    settings = {
        "experiment": "attractor",
        "seed": SEED,
        "robot": joint.robot,
        "joint": joint.joint,
        "samples": plan.samples,
        "shift": plan.shift,
        "calibration_fraction": CALIBRATION,
        "m": plan.parameters.m,
        "tau": plan.parameters.tau,
        "bins": BINS,
        "window": plan.window,
    }
    visited = results.get(
        f"{plan.folder}/attractor-{SEED}", settings, functools.partial(_cells, plan, joint)
    )
    healthy, late = ({tuple(cell) for cell in visited[part]} for part in ("healthy", "late"))
    drawing = Drawing(760, 300, f"Attractor of {joint.asset}, {joint.channel}")
    panels: tuple[tuple[str, list[tuple[set[Any], str]]], ...] = (
        ("healthy (calibration)", [(healthy, DARK)]),
        (f"the last {plan.window:,} vectors", [(late, DARK)]),
        ("both; black: cells not in the support", [(healthy, LIGHT), (late - healthy, BLACK)]),
    )
    for number, (title, layers) in enumerate(panels):
        centre = 135 + 245 * number, 165
        drawing.text(centre[0], 24, title, "middle")
        _cube(drawing, centre)
        for cells, fill in layers:
            places = ([(number + 0.5) / BINS for number in cell] for cell in cells)
            drawing.dots((_seen(place, centre) for place in places), fill, 2)
    return drawing


def indicators(number: int, plan: Plan, names: Sequence[str], results: Results, show: Show) -> Drawing:
    """Draw the normalised indicators of a joint that failed, a panel for each method."""
    place = _failed(plan, number)
    by_name = series(plan, SEED, names, place, results, show)
    rows = math.ceil(len(names) / _COLUMNS)
    width, height = _PANEL
    title = f"Normalised indicators of {place.asset}, {place.channel}, which failed"
    drawing = Drawing(60 + _COLUMNS * (width + 30), 40 + rows * (height + 55), title)
    courses = {name: course for name, figures in by_name.items() if (course := _normalised(figures))}
    for place_no, name in enumerate(names):
        corner = 40 + place_no % _COLUMNS * (width + 30), 40 + place_no // _COLUMNS * (height + 55)
        plot = Plot(drawing, corner, _PANEL, (0, 1), (-0.03, 1.03))
        last = place_no >= len(names) - _COLUMNS
        plot.frame(_SHARES, _SHARES, "share of life" if last else "", title=METHODS[name].title)
        if DSE in courses and name != DSE:
            plot.line(courses[DSE], GREY, 1)
        if name in courses:
            plot.line(courses[name])
    return drawing


def parameters(plan: Plan, names: Sequence[str], results: Results, show: Show) -> Drawing:
    """Draw Global over m and tau: the darker, the higher."""
    cells = sensitivity.sensitivity(sensitivity.FLEET, plan.quick, results, show)
    scores = {(cell.m, cell.tau): cell.global_score for cell in cells}
    low, high = min(scores.values()), max(scores.values())
    dimensions, delays = sensitivity.DIMENSIONS, sensitivity.DELAYS
    width, height = 74, 40
    drawing = Drawing(90 + width * len(delays), 90 + height * len(dimensions), "Global over m and tau")
    for row, m in enumerate(reversed(dimensions)):
        y = 20 + height * row
        drawing.text(56, y + height / 2 + 4, f"m = {m}", "end", DARK)
        for column, tau in enumerate(delays):
            x = 66 + width * column
            share = (scores[m, tau] - low) / (high - low) if high > low else 0.0
            grey = round(255 - 175 * share)
            drawing.box(x, y, width, height, f"#{grey:02x}{grey:02x}{grey:02x}", "#ffffff")
            ink = BLACK if grey > _READABLE else "#ffffff"
            drawing.text(x + width / 2, y + height / 2 + 4, f"{scores[m, tau]:.3f}", "middle", ink)
    below = 20 + height * len(dimensions)
    for column, tau in enumerate(delays):
        drawing.text(66 + width * (column + 0.5), below + 18, f"tau = {tau}", "middle", DARK)
    drawing.text(66, below + 44, "Global of DSE; dark: high", fill=DARK, size=11)
    return drawing


def dimensions(plan: Plan, names: Sequence[str], results: Results, show: Show) -> Drawing:
    """Draw the indicator of a joint that failed, by DSE at m = 3 and at m = 6."""
    place = _failed(plan, 0)
    drawing = Drawing(620, 300, f"Indicator of {place.asset}, {place.channel}, at m = 3 and m = 6")
    plot = Plot(drawing, (55, 25), (470, 220), (0, 1), (0, 1))
    plot.frame((0, 0.25, 0.5, 0.75, 1), (0, 0.25, 0.5, 0.75, 1), "share of life", "health indicator")
    for m, dash in zip(DIMENSIONS, DASHES, strict=False):
        chosen = Parameters.paper(m=m, bins=BINS, window=plan.window)
        other = None if chosen == plan.parameters else chosen
        course = _course(series(plan, SEED, [DSE], place, results, show, other)[DSE])
        plot.line(course, dash=dash, width=1.5)
        x, y = plot.at(*course[-1])
        drawing.text(x + 6, y + 4, f"m = {m}")
    return drawing


FIGURES: Mapping[str, Drawn] = {
    "2": attractor,
    "3": functools.partial(indicators, 0),
    "4": functools.partial(indicators, 1),
    "5": parameters,
    "6": dimensions,
}


def _failed(plan: Plan, number: int) -> Place:
    """Return the joint of the robot that is the first, or second, of those that failed."""
    return plan.places(SEED)[number]


def _cells(plan: Plan, place: Place) -> Figures:
    """Return the cells of calibration and of the last window, as the places of their bins."""
    readings = plan.fleet(SEED).joint(place.robot, place.joint).readings
    with DuckSession() as session:
        study = Study(session, Source(readings), plan.parameters, Calibration(fraction=CALIBRATION))
        add_points(study.steps, study.method, 0)
        names = names_of(study.method, 0)
        healthy, scored = (
            study.table(study.method.named(step, 0)) for step in ("learnt_points", "scored_points")
        )
    late = scored.sort_by("time").slice(max(0, len(scored) - plan.window))
    return {
        "healthy": _visited(healthy, names, BINS),
        "late": _visited(late, names, BINS),
    }


def _visited(points: pa.Table, names: Sequence[str], bins: int) -> list[list[int]]:
    values = np.column_stack([points[name].to_numpy() for name in names])
    values = values[~np.isnan(values).any(axis=1)]
    # The highest value of calibration belongs to the last bin; what lies outside keeps its place.
    numbers = np.where(values == 1.0, bins - 1, np.floor(values * bins)).astype(np.int64)
    rows: list[list[int]] = np.unique(numbers, axis=0).tolist()
    return rows


def _seen(place: Sequence[float], centre: Point) -> Point:
    """Return where a point of the range of calibration, of edges from 0 to 1, is seen.

    It is looked at from aside and above: along its diagonal all states at rest would be one.
    """
    x, y, z = (number - 0.5 for number in place)
    across = y * math.cos(_AZIMUTH) - x * math.sin(_AZIMUTH)
    deep = x * math.cos(_AZIMUTH) + y * math.sin(_AZIMUTH)
    up = z * math.cos(_ELEVATION) - deep * math.sin(_ELEVATION)
    return centre[0] + _EDGE * across, centre[1] - _EDGE * up


def _cube(drawing: Drawing, centre: Point) -> None:
    """Draw the edges of the range of calibration, with the names of its axes."""
    for start in itertools.product((0, 1), repeat=3):
        for axis in range(3):
            end = [1 if number == axis else coordinate for number, coordinate in enumerate(start)]
            if end != list(start):
                drawing.line([_seen(start, centre), _seen(end, centre)], LIGHT)
    labels = (
        ((0.5, 0, 0), "x(t)", 0, 16),
        ((1, 0.5, 0), "x(t-1)", 22, 10),
        ((0, 0, 0.5), "x(t-2)", -22, 0),
    )
    for place, words, aside, below in labels:
        across, down = _seen(place, centre)
        drawing.text(across + aside, down + below, words, "middle", DARK, 10)


def _course(figures: Figures) -> list[Point]:
    """Return the values of an indicator that are there, over the share of the life so far."""
    values: list[float | None] = figures["hi"]
    life = CALIBRATION + (1 - CALIBRATION) * (np.arange(len(values)) + 1) / max(len(values), 1)
    return [(float(x), y) for x, y in zip(life, values, strict=True) if y is not None]


def _normalised(figures: Figures) -> list[Point]:
    course = _course(figures)
    heights: NDArray[np.float64] = np.array([y for _, y in course])
    if not len(heights) or heights.max() == heights.min():
        return []
    heights = (heights - heights.min()) / (heights.max() - heights.min())
    thinned = [(x, float(y)) for (x, _), y in zip(course, heights, strict=True)]
    return thinned[:: max(1, len(thinned) // _POINTS)]
