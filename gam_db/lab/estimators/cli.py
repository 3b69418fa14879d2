"""What ``gam run --estimator`` prints: where every channel stands by another estimator.

This module owns how that looks. There is no verdict and no limit: those are made of the
certificate, which speaks of Discrete Support Estimation only.
"""

from collections.abc import Iterator, Sequence

from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.job import Job
from gam_db.cli.render import Column, Section, Table
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.lab.estimators.scoring import add_estimator, estimator_named

#: What ``gam run`` takes from here, by the entry point ``gam_db.estimators``.
__all__ = ["add_estimator", "estimator_named", "sections"]

_LEGEND = {
    "centroid": "distance to the centre of the calibration vectors, in ranges of calibration",
    "gmm": "negative log-likelihood under a mixture of Gaussians",
    "forest": "score of an Isolation Forest, 0 to 1",
    "ocsvm": "score of a one-class support vector machine, less its sum over the support vectors",
}

_COLUMNS = [
    Column("channel", "name"),
    Column("HI", "hi"),
    Column("last", "last", "time"),
]


def sections(
    job: Job, estimator: str, rows: Sequence[Row], everything: bool = False
) -> Iterator[Section]:
    """Yield a line per channel; *rows* are those of the step ``last_scores``."""
    yield f"{printable(job.name)}: {number_of(len(rows), 'channel')} by {estimator}"
    yield from job.lines()
    yield ""
    named = [
        {"name": f"{row['asset']} {row['channel']}", "last": row["last_time"]}
        | {"hi": None if row["hi"] is None else f"{row['hi']:.6g}"}
        for row in rows
    ]
    yield Table("scores", named if everything else named[: options.SHOWN], columns=_COLUMNS)
    yield from page.cut(rows, everything)
    yield ""
    if any(row["hi"] is None for row in rows):
        yield "-: less than a window of vectors scored, or too few calibration vectors to fit on."
    yield (
        f"HI: mean over the last window of the {_LEGEND[estimator]}. It has no limit of its own: "
        "compare it with the same channel's course."
    )
