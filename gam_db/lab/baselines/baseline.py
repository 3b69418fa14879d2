"""The baselines by name, and how one is put in the place of an estimator of a study."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pyarrow as pa
from numpy.typing import NDArray
from sqlglot import exp

from gam_db.composing import template
from gam_db.errors import ParameterError, nearest
from gam_db.lab.baselines import nets
from gam_db.lab.baselines.training import BATCH, LEARNING_RATE, OnEpoch, Rows, scored, trained
from gam_db.lab.estimators.points import add_moving_average, add_points, names_of, point_of
from gam_db.method.adding import OfSet
from gam_db.study import Study


@dataclass(frozen=True)
class Baseline:
    """A net and one of its scores.

    Attributes:
        build: makes the net from the embedding dimension.
        score: which of its scores is meant.
        forecasts: whether it reads the vector one sample earlier, to forecast the newest sample.
    """

    build: Callable[[int], nets.Net]
    score: str = "error"
    forecasts: bool = False


@dataclass(frozen=True)
class Effort:
    """How long is trained; the paper says neither.

    Attributes:
        epochs: how often the calibration vectors are gone through.
        batch, learning_rate: as in every training; here to be written down.
    """

    epochs: int
    batch: int = BATCH
    learning_rate: float = LEARNING_RATE


Nets = dict[tuple[Any, ...], nets.Net]
"""Trained nets, by what made them."""


@dataclass(frozen=True)
class Learner:
    """Trains the net of a baseline, or takes one that was trained, and scores by it.

    Attributes:
        baseline: which net.
        m: samples that it reads.
        seed, effort, on_epoch, net_cache: see :func:`add_baseline`.
    """

    baseline: Baseline
    m: int
    seed: int
    effort: Effort
    on_epoch: OnEpoch
    net_cache: Nets | None

    def scores(self, of: tuple[int, ...], learnt: Rows, following: Rows) -> NDArray[np.float64]:
        """Return the scores of rows in units of their mean over the learnt ones.

        Args:
            of: tells these learnt rows from others under which nets are kept.
            learnt: rows of calibration.
            following: rows to be scored.
        """
        mark = (self.baseline.build, self.m, self.seed, self.effort, *of)
        net = None if self.net_cache is None else self.net_cache.get(mark)
        if net is None:
            effort = self.effort
            net = trained(
                self.baseline.build,
                self.m,
                learnt,
                effort.epochs,
                self.seed,
                self.on_epoch,
                effort.batch,
            )
            if self.net_cache is not None:
                self.net_cache[mark] = net
        scores = scored(net, self.baseline.score, following)
        # A net that learns well has errors far below the 2^-20 in which scores are summed.
        usual = float(scored(net, self.baseline.score, learnt).mean())
        return scores / usual if usual > 0 else scores


FULL, QUICK = Effort(20), Effort(2)

BASELINES: Mapping[str, Baseline] = {
    "ae": Baseline(nets.autoencoder),
    "vae_rec": Baseline(nets.variational, "reconstruction"),
    "vae_latent": Baseline(nets.variational, "latent"),
    "lstm": Baseline(nets.recurrent_forecast, forecasts=True),
    "lstm_ae": Baseline(nets.recurrent_autoencoder),
    "mlp": Baseline(nets.forecast, forecasts=True),
}


def add_baseline(
    study: Study,
    name: str,
    seed: int = 0,
    effort: Effort = FULL,
    on_epoch: OnEpoch = lambda epoch, loss: None,
    net_cache: Nets | None = None,
) -> None:
    """Train a baseline and add its steps to a study: ``score_health`` and ``score_bucket_health``.

    One net is trained per channel (or pool), on all of its calibration vectors in ranges of
    calibration; its scores are in units of their mean over calibration. A forecast is made from the
    vector one sample earlier; where there is none, because of a missing sample or a new segment, the
    vector is neither learnt nor scored by it.

    Args:
        study: of a source; it takes one baseline only.
        name: a key of :data:`BASELINES`.
        seed: of weights and batches.
        effort: how long is trained.
        on_epoch: called with the epochs done and the mean loss of the last one.
        net_cache: nets that were trained on the same calibration; a net that is there is not trained
            again, and one that is trained is put there. None keeps none.

    Raises:
        ParameterError: there is no such baseline.
        UserError: PyTorch is not installed.
    """
    if name not in BASELINES:
        raise ParameterError(f"There is no baseline {name!r}{nearest(str(name), BASELINES)}")
    baseline = BASELINES[name]
    nets.torch()
    for number, setting in enumerate(study.method.settings):
        add_points(study.steps, study.method, number)
        columns = names_of(study.method, number)
        if baseline.forecasts:
            columns = add_forecast_points(study, number)
        learnt, to_score = (
            _usable(study, number, step, columns, baseline.forecasts)
            for step in ("learnt_points", "scored_points")
        )
        supports = learnt["support_id"].to_numpy()
        parts = []
        for support in np.unique(supports).tolist():
            rows = _rows(learnt, columns, supports == support)
            of_support = to_score["support_id"].to_numpy() == support
            following = _rows(to_score, columns, of_support)
            learn = Learner(baseline, setting.m, seed, effort, on_epoch, net_cache)
            scores = learn.scores((number, support), rows, following)
            scored_rows = to_score.select(["channel_id", "time"]).filter(pa.array(of_support))
            parts.append(scored_rows.append_column("score", pa.array(scores)))
        empty = to_score.select(["channel_id", "time"]).slice(0, 0)
        parts.append(empty.append_column("score", pa.array([], pa.float64())))
        study.load(study.method.named("scores", number), pa.concat_tables(parts))
    add_moving_average(study.steps, study.method, study.instant_of)


def add_forecast_points(study: Study, number: int) -> list[str]:
    """Add the learnt and scored points with those a sample earlier; return what a net reads of them."""
    steps, method = study.steps, study.method
    names = names_of(method, number)
    earlier = {name: f"before_{k}" for k, name in enumerate(names)}
    lagged = [
        exp.alias_(
            template.fill("embedding/delayed", {"column": exp.column(name), "delay": 1}), earlier[name]
        )
        for name in names
    ]
    point = point_of(method, number)
    OfSet(steps, method, number).add("lab/baselines/before", {"point": point, "earlier": lagged})
    added = [*earlier.values(), "elapsed"]
    handed_on = [exp.alias_(exp.column(column, table="point"), column) for column in added]
    for step in ("learnt_points", "scored_points"):
        OfSet(steps, method, number).add(
            f"lab/estimators/{step}",
            {"point": [*point, *handed_on]},
            name=f"forecast_{step}",
            tables={"coordinates": "before"},
        )
    return [names[0], *earlier.values()]


def _usable(study: Study, number: int, step: str, columns: list[str], forecasts: bool) -> pa.Table:
    """Return the points of a step that a net can read."""
    table = study.table(study.method.named(f"forecast_{step}" if forecasts else step, number))
    is_usable = np.ones(table.num_rows, bool)
    for column in columns:
        is_usable &= ~np.isnan(table[column].fill_null(np.nan).to_numpy())
    gap = study.method.gaps[number]
    if forecasts and gap is not None:
        is_usable &= table["elapsed"].fill_null(gap + 1).to_numpy() <= gap
    usable_rows = table.filter(pa.array(is_usable))
    if step == "scored_points":
        return usable_rows
    # Batches are drawn by place, so the order must be the same in every run.
    return usable_rows.sort_by([("support_id", "ascending"), ("number", "ascending")])


def _rows(table: pa.Table, columns: list[str], mask: NDArray[np.bool_]) -> Rows:
    return np.column_stack([table[column].to_numpy()[mask] for column in columns])
