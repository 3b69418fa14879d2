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

_RATES = ("stated", "seen", "lower", "upper", "resampled_lower", "resampled_upper")


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
    said = page.WORDS["backtest"]
    rates = {name: 1000 * found[name] for name in _RATES if found[name] is not None}
    yield said["counted"].format(**found)
    yield said["stated"].format(**found | rates) if "stated" in rates else "no rate can be stated"
    yield said["seen"].format(**found | rates)
    if found["per_day_seen"] is not None:
        a_day = found["per_day_stated"]
        yield said["a_day"].format(**found) + ("" if a_day is None else f", {a_day:.3g} stated")
    for basis, one in sorted(found["basis"].items()):
        yield said["basis"].format(basis=basis, **one)
    for reason, count in sorted(found["withheld"].items()):
        yield f"without a limit: {count:,} ({reason})"
    raised = [row for row in found["by_channel"] if row["episodes"]]
    for row in sorted(raised, key=lambda row: -row["episodes"])[:5]:
        name = " / ".join(filter(None, (row["asset"], row["channel"])))
        yield f"raised: {name}: {row['episodes']:,} in {row['judgements']:,} judgements"
