"""Baselines that read a long context instead of a delay vector: the paper's table of long windows.

A context is a row of consecutive samples of a channel that ends at a scored vector. The paper does not
say which contexts are learnt and scored: here one of every ten that end at a calibration vector is
learnt, and the one at the end of each bucket is scored, for all vectors of that bucket. A missing sample
is taken for the one before it.
"""

import functools
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pyarrow as pa
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from gam_db.lab.baselines import nets
from gam_db.lab.baselines.baseline import Baseline, Effort, Learner, Nets
from gam_db.lab.baselines.training import OnEpoch, Rows
from gam_db.lab.estimators.points import add_moving_average, add_points
from gam_db.study import Study

EVERY = 10
"""Calibration vectors from one learnt context to the next."""

LONG_FULL, LONG_QUICK = Effort(20, batch=32), Effort(2, batch=32)


@dataclass(frozen=True)
class Long:
    """A baseline that reads a context.

    Attributes:
        baseline: the net and its score.
        length: samples of the context; None for as many as the window has vectors.
    """

    baseline: Baseline
    length: int | None = None


_autoencoder = functools.partial(nets.autoencoder, latent=nets.LONG_LATENT)
_variational = functools.partial(nets.variational, latent=nets.LONG_LATENT)
_RECURRENT = 200

LONG: Mapping[str, Long] = {
    "long_cnn_ae": Long(Baseline(nets.convolutional)),
    "long_vae_rec": Long(Baseline(_variational, "reconstruction")),
    "long_vae_latent": Long(Baseline(_variational, "latent")),
    "long_lstm_ae": Long(Baseline(nets.recurrent_autoencoder), _RECURRENT),
    "long_lstm": Long(Baseline(nets.recurrent_forecast, forecasts=True), _RECURRENT),
    "long_ae": Long(Baseline(_autoencoder)),
    "long_mlp": Long(Baseline(nets.forecast, forecasts=True)),
    "long_transformer": Long(Baseline(nets.transformer)),
}


def add_long(
    study: Study,
    name: str,
    seed: int,
    effort: Effort,
    on_epoch: OnEpoch = lambda epoch, loss: None,
    net_cache: Nets | None = None,
) -> None:
    """Train a baseline of long contexts and add its steps to a study, as ``add_baseline`` does.

    A net is trained for each channel. A channel whose calibration is shorter than a context has no
    scores.

    Args:
        study: of a source, with one set of parameters.
        name: a key of :data:`LONG`.
        seed: of weights and batches.
        effort: how long is trained.
        on_epoch: called with the epochs done and the mean loss of the last one.
        net_cache: nets by what made them, see :func:`gam_db.lab.baselines.add_baseline`.

    Raises:
        UserError: PyTorch is not installed.
    """
    nets.torch()
    method, (setting,) = study.method, study.method.settings
    long = LONG[name]
    length = long.length or setting.window
    add_points(study.steps, method, 0)
    samples, learnable, scored = (
        study.table(method.named(step, 0)).sort_by([("channel_id", "ascending"), ("time", "ascending")])
        for step in ("coordinates", "learnable", "scored_points")
    )
    parts = [scored.select(["channel_id", "time"]).slice(0, 0).append_column("score", _floats([]))]
    for channel in np.unique(samples["channel_id"].to_numpy()).tolist():
        times, values = _filled(_of(samples, channel))
        width = length + long.baseline.forecasts
        if len(values) < width:
            continue
        # Newest sample first, as the rows of every net.
        contexts = sliding_window_view(values, width)[:, ::-1]

        def ending_at(instants: NDArray[np.int64]) -> Rows:
            places = np.searchsorted(times, instants) - (width - 1)  # noqa: B023
            return np.asarray(contexts[places[places >= 0]])  # noqa: B023

        learnt = ending_at(_of(learnable, channel)["time"].to_numpy()[EVERY - 1 :: EVERY])
        scored_rows = _of(scored, channel)
        instants = scored_rows["time"].to_numpy()
        if not len(learnt) or not len(instants):
            continue
        ends = np.append(instants[setting.bucket_length - 1 :: setting.bucket_length], instants[-1])
        learn = Learner(long.baseline, length, seed, effort, on_epoch, net_cache)
        scores = learn.scores((channel,), learnt, ending_at(ends))
        of_each = scores[np.arange(len(instants)) // setting.bucket_length]
        parts.append(scored_rows.select(["channel_id", "time"]).append_column("score", _floats(of_each)))
    study.load(method.named("scores", 0), pa.concat_tables(parts))
    add_moving_average(study.steps, method, study.instant_of)


def _of(table: pa.Table, channel: int) -> pa.Table:
    return table.filter(pa.array(table["channel_id"].to_numpy() == channel))


def _filled(samples: pa.Table) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Return times and normalised values, from the first one that is not missing on."""
    values = samples["x_0"].fill_null(np.nan).to_numpy()
    there = ~np.isnan(values)
    last = np.maximum.accumulate(np.where(there, np.arange(len(values)), -1))
    begun = last >= 0
    return samples["time"].to_numpy()[begun], values[last[begun]]


def _floats(values: object) -> pa.Array:
    return pa.array(values, pa.float64())
