"""``gam backtest``: how often the limits would have raised a machine that was healthy.

This module owns the command and its page. What figures mean is said by :func:`gam_db.backtest`.
"""

from gam_db.backtesting import backtest as tested
from gam_db.calibration import Calibration
from gam_db.cli import options, page
from gam_db.cli.exits import Exit
from gam_db.cli.job import reading
from gam_db.cli.options import option
from gam_db.config import Settings
from gam_db.findings import Row
from gam_db.setting import settings_of


@options.taking(*options.READ, *options.ALARMS, "as_json", "quiet", "threads")
def backtest(
    settings: Settings,
    common: options.Common,
    healthy: list[str] | None = option(
        None,
        *("FROM/TO", "When nothing was wrong (repeatable); default all that follows calibration."),
        "Alarms",
    ),
) -> None:
    """Count how often the limits raise what follows calibration, where nothing was wrong.

    Limits are made of the calibration of SOURCE for the asked rate; every full window after it is
    judged. What is seen is set beside what is stated, with how sure it is.
    """
    spans = settings_of(Calibration)["intervals"].takes.read("--healthy", healthy) if healthy else None
    with reading(settings, common) as (session, job, _):
        method = (job.parameters, job.calibration)
        found = tested(job.guess.source, *method, settings.alarms, spans, session)
    page.tell(Exit.FINE, {**job.figures(), **found}, lambda out: page.say(out, *lines(found)), common)


def lines(found: Row) -> list[str]:
    """Return what is said of the figures, a sentence a line."""
    judged = f"{found['judged']:,} of {found['channels']:,} channels have a limit"
    stated = (
        "no rate can be stated"
        if found["stated"] is None
        else f"stated: {_rate(found['stated'])} (asked: {found['asked']})"
    )
    said = [
        f"{judged}; {found['judgements']:,} judgements, {found['episodes']:,} episodes",
        stated,
        f"seen: {_rate(found['seen'])}; 95 %: {_between(found, 'lower', 'upper')} by Poisson, "
        f"{_between(found, 'resampled_lower', 'resampled_upper')} by channels drawn again",
    ]
    if found["per_day_seen"] is not None:
        a_day = found["per_day_stated"]
        said.append(
            f"alarms a day of these {found['judged']:,} channels: {found['per_day_seen']:.3g} seen"
            + ("" if a_day is None else f", {a_day:.3g} stated")
        )
    said += [
        f"basis {basis}: {one['channels']:,} channels, {one['judgements']:,} judgements, "
        f"{one['episodes']:,} episodes"
        for basis, one in sorted(found["basis"].items())
    ]
    said += [
        f"without a limit: {count:,} ({reason})" for reason, count in sorted(found["withheld"].items())
    ]
    raised = [row for row in found["by_channel"] if row["episodes"]]
    for row in sorted(raised, key=lambda row: -row["episodes"])[:5]:
        name = " / ".join(filter(None, (row["asset"], row["channel"])))
        said.append(f"raised: {name}: {row['episodes']:,} in {row['judgements']:,} judgements")
    return said


def _between(found: Row, lower: str, upper: str) -> str:
    return f"{_bare(found[lower])} to {_bare(found[upper])}"


def _rate(per_judgement: float) -> str:
    return f"{_bare(per_judgement)} per 1,000 judgements"


def _bare(per_judgement: float) -> str:
    return f"{1000 * per_judgement:.2f}"
