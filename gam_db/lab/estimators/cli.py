"""What ``gam run --estimator`` prints: where every channel stands by another estimator.

This module owns how that looks. There is no verdict and no limit: those are made of the
certificate, which speaks of Discrete Support Estimation only.
"""

from collections.abc import Sequence

from rich.console import Console

from gam_db.checking.words import number_of
from gam_db.cli import options, page
from gam_db.cli.job import Job
from gam_db.errors import printable
from gam_db.findings import Row
from gam_db.lab.estimators.scoring import add_estimator, estimator_named

#: What ``gam run`` takes from here, by the entry point ``gam_db.estimators``.
__all__ = ["add_estimator", "estimator_named", "show_scores"]

_LEGEND = {
    "centroid": "distance to the centre of the calibration vectors, in ranges of calibration",
    "gmm": "negative log-likelihood under a mixture of Gaussians",
    "forest": "score of an Isolation Forest, 0 to 1",
    "ocsvm": "score of a one-class support vector machine, less its sum over the support vectors",
}


def show_scores(
    out: Console, job: Job, estimator: str, rows: Sequence[Row], everything: bool = False
) -> None:
    """Print a line per channel.

    Args:
        out: where to.
        job: for the heading.
        estimator: its name.
        rows: those of the step ``last_scores``.
        everything: show every channel, however many there are.
    """
    page.say(out, f"{printable(job.name)}: {number_of(len(rows), 'channel')} by {estimator}")
    page.say(out, *job.lines())
    out.print()
    shown = rows if everything else rows[: options.SHOWN]
    columns: dict[str, page.Cell] = {
        "channel": lambda row: f"{row['asset']} {row['channel']}",
        "HI": lambda row: None if row["hi"] is None else f"{row['hi']:.6g}",
        "last": lambda row: page.time_text(row["last_time"]),
    }
    page.table(out, shown, columns)
    page.cut(out, rows, everything)
    out.print()
    if any(row["hi"] is None for row in rows):
        page.say(
            out, "-: less than a window of vectors scored, or too few calibration vectors to fit on."
        )
    page.say(
        out,
        f"HI: mean over the last window of the {_LEGEND[estimator]}. It has no limit of its own: "
        "compare it with the same channel's course.",
    )
