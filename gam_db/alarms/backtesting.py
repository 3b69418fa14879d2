"""Backtest: how often the limits raise a machine that is known to be healthy (alarms, section 3).

This module owns the public call of that name, the seen rate, and how sure it is.
"""

from collections import Counter
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gam_db.alarms import Alarms, Row, judge, limits_of
from gam_db.arguments import public
from gam_db.clock import Instant
from gam_db.errors import ParameterError, wrong
from gam_db.method.alarms import add_backtested
from gam_db.settings.calibration import Calibration, closed, merge
from gam_db.settings.parameters import Parameters
from gam_db.study import studied

_LEFT, _RIGHT = 0.025, 0.975
_DRAWS = 2000


@public
def backtest(
    source: Any,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    alarms: Alarms | None = None,
    healthy: Sequence[tuple[Instant, Instant]] | None = None,
    engine: Any = None,
) -> Row:
    """Return how often healthy channels would have been raised, beside how often that is stated.

    Limits are made of calibration; what follows it is judged by them, as it would have been.

    Args:
        source: as in :func:`gam_db.health_indicator`.
        parameters: of the method; default :class:`Parameters`.
        calibration: the healthy part that limits are made of; default the first fifth.
        alarms: the asked rate and the families; default :class:`Alarms`.
        healthy: closed intervals of time after calibration in which nothing was wrong; None for all of
            it. A judgement counts if it lies in one of them whole.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open connection.

    Returns:
        Figures, rates per judgement: asked (the text); stated (mean over the judgements of channels with
        a stated rate; None without any); seen, lower, upper (95 % by Poisson); resampled_lower,
        resampled_upper (95 %, channels drawn again 2,000 times: hits of one channel come in runs);
        judgements, episodes, channels, judged (channels with a limit); basis (of channels, judgements
        and episodes each); order_ratio (mean over channels that have one, in thousandths);
        per_day_stated, per_day_seen (alarms a day of all judged channels; None on a counter); withheld
        (reason -> channels without a limit); by_channel (asset, channel, judgements, episodes).

    Raises:
        ParameterError: no judgement lies in the healthy time, or an interval is none.
        UserError: see its subclasses; the message says what to correct.
    """
    alarms = alarms or Alarms()
    with studied(source, parameters, calibration, engine) as study:
        rows = limits_of(study, alarms)
        frozen = judge(study, [row for row in rows if row["reason"] is None])
        add_backtested(study.steps, merge(closed("healthy", healthy or (), study.method.kind)))
        backtested = study.rows("backtested")
    if not frozen:
        why = "; ".join(f"{count:,}: {reason}" for reason, count in sorted(_withheld(rows).items()))
        raise ParameterError(f"There is no judgement to count, because no channel has a limit ({why}).")
    if not backtested:
        raise wrong("healthy_holds_no_window")
    return figures(alarms.rate_for(study.method.kind), rows, backtested)


def figures(rate_text: str, rows: Sequence[Row], backtested: list[Row]) -> Row:
    """Return what :func:`backtest` does, of limits (``limits_of``) and the rows of *backtested*."""
    limit_of = {(row["asset"], row["channel"]): row for row in rows}
    mine = [limit_of[row["asset"], row["channel"]] for row in backtested]
    judged = np.array([row["judgements"] for row in backtested], np.float64)
    raised = np.array([row["episodes"] for row in backtested], np.float64)
    episodes, judgements = int(raised.sum()), int(judged.sum())
    lower, upper = poisson_ends(episodes)
    drawn = _drawn(raised, judged)
    pairs = [
        (limit["stated_rate"], row["judgements"]) for limit, row in zip(mine, backtested, strict=True)
    ]
    stated = [(rate * count, count) for rate, count in pairs if rate is not None]
    mean = sum(number for number, _ in stated) / sum(number for _, number in stated) if stated else None
    days = [row["judgements_per_day"] for row in mine]
    a_day = None if None in days else float(sum(days))
    ratios = [row["order_ratio"] for row in mine if row["order_ratio"] is not None]
    bases: dict[str, Row] = {}
    for limit, row in zip(mine, backtested, strict=True):
        counted = bases.setdefault(limit["basis"], {"channels": 0, "judgements": 0, "episodes": 0})
        for name in counted:
            counted[name] += row.get(name, 1)  # a row is a channel
    return {
        "asked": rate_text,
        "stated": mean,
        "seen": episodes / judgements,
        "lower": lower / judgements,
        "upper": upper / judgements,
        "resampled_lower": float(np.quantile(drawn, _LEFT)),
        "resampled_upper": float(np.quantile(drawn, _RIGHT)),
        "judgements": judgements,
        "episodes": episodes,
        "channels": len(rows),
        "judged": len(backtested),
        "basis": bases,
        "order_ratio": sum(ratios) / len(ratios) if ratios else None,
        "per_day_stated": None if a_day is None or mean is None else mean * a_day,
        "per_day_seen": None if a_day is None else episodes / judgements * a_day,
        "withheld": _withheld(rows),
        "by_channel": backtested,
    }


def _withheld(rows: Sequence[Row]) -> dict[str, int]:
    return dict(Counter(row["reason"] for row in rows if row["reason"] is not None))


def poisson_ends(count: int) -> tuple[float, float]:
    """Return the ends of the exact 95 % interval of a Poisson mean of which ``count`` was seen.

    Source: Garwood, Fiducial limits for the Poisson distribution, Biometrika 28 (1936).
    """
    lower = 0.0 if count == 0 else _mean_where(count - 1, _RIGHT)
    return lower, _mean_where(count, _LEFT)


def _mean_where(count: int, share: float) -> float:
    """Return the mean at which at most ``count`` are seen with a probability; by halving."""
    seen = np.arange(count + 1)
    factorials = np.concatenate(([0.0], np.cumsum(np.log(seen[1:]))))
    low, high = 0.0, count + 10 * (count + 1) ** 0.5 + 10
    for _ in range(100):
        middle = (low + high) / 2
        at_most = float(np.exp(seen * np.log(middle) - middle - factorials).sum())
        low, high = (middle, high) if at_most > share else (low, middle)
    return low


def _drawn(raised: NDArray[np.float64], judged: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the rates of channels that were drawn again and again, the same ones every time."""
    chance = np.random.default_rng(0)
    rates = np.empty(_DRAWS)
    for number in range(_DRAWS):
        drawn = chance.integers(0, len(judged), len(judged))
        rates[number] = raised[drawn].sum() / judged[drawn].sum()
    return rates
