"""What ``gam run --estimator`` prints: where every channel stands by another estimator.

This module owns how that looks, and its JSON. There is no verdict and no limit: those are made of the
certificate, which speaks of Discrete Support Estimation only.
"""

from collections.abc import Mapping, Sequence
from typing import Any

from rich.console import Console
from rich.text import Text

from gam_db.cli.figures import asked, plain
from gam_db.cli.report import SHOWN, Job, columns_line, fit, method_line, printable, say, time_text
from gam_db.lab.estimators.scoring import add_estimator, estimator_named

#: What ``gam run`` takes from here, by the entry point ``gam_db.estimators``.
__all__ = ["add_estimator", "estimator_named", "score_figures", "show_scores"]

_LEGEND = {
    "centroid": "distance to the centre of the calibration vectors, in ranges of calibration",
    "gmm": "negative log-likelihood under a mixture of Gaussians",
    "forest": "score of an Isolation Forest, 0 to 1",
    "ocsvm": "score of a one-class support vector machine, less its sum over the support vectors",
}

Row = Mapping[str, Any]


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
    say(out, f"{printable(job.name)}: {len(rows):,} channel{'s' * (len(rows) != 1)} by {estimator}")
    say(out, columns_line(job.guess))
    say(out, method_line(job.parameters, job.calibration))
    out.print()
    shown = rows if everything else rows[:SHOWN]
    names = [printable(f"{row['asset']} {row['channel']}") for row in shown]
    width = min(max(7, *map(len, names)), max(12, out.width - 40))
    out.print(Text(f"  {fit('channel', width)}  {'HI':>12}  last", style="bold"), no_wrap=True)
    for name, row in zip(names, shown, strict=True):
        hi = "-" if row["hi"] is None else f"{row['hi']:.6g}"
        out.print(
            Text(f"  {fit(name, width)}  {hi:>12}  {time_text(row['last_time'])}"),
            no_wrap=True,
            overflow="crop",
        )
    if len(rows) > len(shown):
        say(out, f"and {len(rows) - len(shown)} more; --all")
    out.print()
    if any(row["hi"] is None for row in rows):
        say(out, "-: less than a window of vectors scored, or too few calibration vectors to fit on.")
    say(
        out,
        f"HI: mean over the last window of the {_LEGEND[estimator]}. It has no limit of its own: "
        "compare it with the same channel's course.",
    )


def score_figures(
    job: Job, estimator: str, rows: Sequence[Row], written: Sequence[str]
) -> dict[str, Any]:
    """Return the same as one object that JSON can hold.

    Args:
        job: what was asked.
        estimator: its name.
        rows: those of the step ``last_scores``.
        written: files and tables that were written.
    """
    channels = [
        {("hi_now" if name == "hi" else name): value for name, value in row.items()} for row in rows
    ]
    return {
        **asked(job),
        "estimator": estimator,
        "channels": plain(channels),
        "written": list(written),
        "exit_code": 0,
    }
