"""``gam backtest``: how often the limits would have raised a machine that was healthy."""

from collections.abc import Iterator

from gam_db.alarms.backtesting import backtest as tested
from gam_db.cli import options, page
from gam_db.cli.config import Settings
from gam_db.cli.job import reading
from gam_db.cli.options import option
from gam_db.findings import Row
from gam_db.settings.calibration import Calibration
from gam_db.settings.setting import settings_of


@options.taking(*options.READ, *options.ALARMS, "as_json", "quiet", "threads")
def backtest(
    settings: Settings,
    common: options.Common,
    healthy: list[str] | None = option("backtest.healthy"),
) -> None:
    """Count how often the limits raise what follows calibration, where nothing was wrong.

    Limits are made of the calibration of SOURCE for the asked rate; every full window after it is
    judged. What is seen is set beside what is stated, with how sure it is.
    """
    spans = settings_of(Calibration)["intervals"].takes.read("--healthy", healthy) if healthy else None
    with reading(settings, common) as (session, job, _):
        method = (job.parameters, job.calibration)
        found = tested(job.guess.source, *method, settings.alarms, spans, session)
    page.tell({**job.figures(), **found}, lambda out: page.say(out, *lines(found)), common)


def lines(found: Row) -> Iterator[str]:
    """Yield what is said of the figures, a sentence a line; rates are per 1,000 judgements."""

    def rate(name: str) -> str:
        return f"{1000 * found[name]:.2f}"

    yield (
        f"{found['judged']:,} of {found['channels']:,} channels have a limit; "
        f"{found['judgements']:,} judgements, {found['episodes']:,} episodes"
    )
    if found["stated"] is None:
        yield "no rate can be stated"
    else:
        yield f"stated: {rate('stated')} per 1,000 judgements (asked: {found['asked']})"
    yield (
        f"seen: {rate('seen')} per 1,000 judgements; 95 %: {rate('lower')} to {rate('upper')} by "
        f"Poisson, {rate('resampled_lower')} to {rate('resampled_upper')} by channels drawn again"
    )
    if found["per_day_seen"] is not None:
        a_day = found["per_day_stated"]
        yield (
            f"alarms a day of these {found['judged']:,} channels: {found['per_day_seen']:.3g} seen"
            + ("" if a_day is None else f", {a_day:.3g} stated")
        )
    for basis, one in sorted(found["basis"].items()):
        yield (
            f"basis {basis}: {one['channels']:,} channels, {one['judgements']:,} judgements, "
            f"{one['episodes']:,} episodes"
        )
    for reason, count in sorted(found["withheld"].items()):
        yield f"without a limit: {count:,} ({reason})"
    raised = [row for row in found["by_channel"] if row["episodes"]]
    for row in sorted(raised, key=lambda row: -row["episodes"])[:5]:
        name = " / ".join(filter(None, (row["asset"], row["channel"])))
        yield f"raised: {name}: {row['episodes']:,} in {row['judgements']:,} judgements"
