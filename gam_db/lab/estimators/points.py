"""The steps that every estimator shares: points before the scores, the moving average after them."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline
from gam_db.method.adding import OfSet, add, join_sets
from gam_db.method.resolved import Method
from gam_db.settings.source import TimeNode

#: Running sums stay below 2^62: two of them are added.
_CAPACITY = 2**62


def names_of(method: Method, number: int, letter: str = "x") -> list[str]:
    """Return what the coordinates of the points of one set are called, the newest sample first."""
    return [f"{letter}_{k}" for k in range(method.settings[number].m)]


def point_of(method: Method, number: int, table: str = "point") -> list[exp.Expr]:
    """Return the coordinates of a point as columns that are handed on."""
    return [exp.alias_(exp.column(x, table=table), x) for x in names_of(method, number)]


def add_points(steps: Pipeline, method: Method, number: int) -> None:
    """Add the learnt and the scored vectors of one set as points."""
    setting = method.settings[number]
    delayed = [
        exp.alias_(
            template.fill("embedding/delayed", {"column": exp.column("x_0"), "delay": k * setting.tau}),
            f"x_{k}",
        )
        for k in range(1, setting.m)
    ]
    normalised = template.fill("lab/estimators/normalised")
    OfSet(steps, method, number).add(
        "lab/estimators/coordinates",
        {"normalised": normalised, "delayed": delayed},
    )
    point = point_of(method, number)
    OfSet(steps, method, number).add("lab/estimators/learnt_points", {"point": point})
    OfSet(steps, method, number).add("lab/estimators/learnt_counts")
    OfSet(steps, method, number).add("lab/estimators/scored_points", {"point": point})
    # Calibration is read to be counted, drawn from and averaged; scores to be written and shown.
    steps.small |= {method.named(name, number) for name in ("learnt_points", "learnt_counts", "scores")}


def add_moving_average(steps: Pipeline, method: Method, instant_of: TimeNode) -> None:
    """Add Eq. 2 over the scores of all sets, and the last steps, with instants as in the source."""
    for number, setting in enumerate(method.settings):
        slots: dict[str, template.Slot] = {"window": setting.window}
        units = {**slots, "most": _CAPACITY // setting.window}
        OfSet(steps, method, number).add("lab/estimators/score_units", units)
        sums = {**slots, "stride": setting.bucket_length}
        OfSet(steps, method, number).add("lab/estimators/moving_sums", sums)
    join_sets(steps, method, ("moving_sums",))
    time = instant_of(exp.column("time", table="counted"))
    add(steps, "lab/estimators/score_health", {"time": time})
    add(steps, "lab/estimators/score_bucket_health", {"time": time})
    latest = instant_of(exp.column("time", table="latest"))
    add(steps, "lab/estimators/last_scores", {"time": latest})


def squared_distance(method: Method, number: int, place: str) -> exp.Expr:
    """Return d^2 between a point of ``vector`` and the columns ``place``_0, ... of ``fitted``."""
    pairs = zip(names_of(method, number), names_of(method, number, place), strict=True)
    apart = [
        template.fill(
            "lab/estimators/apart",
            {"coordinate": exp.column(x, table="vector"), "place": exp.column(other, table="fitted")},
        )
        for x, other in pairs
    ]
    return template.added(
        [template.fill("lab/estimators/squared", {"difference": difference}) for difference in apart]
    )
