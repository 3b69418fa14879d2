"""The methods that are compared, in one flat list: each makes a health indicator of a study."""

import dataclasses
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import pyarrow as pa

from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ConfigurationError, nearest
from gam_db.extras import needed
from gam_db.lab.baselines import BASELINES, FULL, QUICK, Effort, Nets, add_baseline
from gam_db.lab.baselines.context import EVERY, LONG, LONG_FULL, LONG_QUICK, add_long
from gam_db.lab.baselines.training import OnEpoch
from gam_db.lab.estimators import SAMPLE, add_estimator
from gam_db.lab.estimators.scoring import usual
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource
from gam_db.study import Study

_COLUMNS = (
    "asset",
    "channel",
    "time",
    "bucket",
    "last_time",
    "novel_in_window",
    "vectors_in_window",
    "hi",
)
_QUICK_SAMPLE = 2_000


@dataclass(frozen=True)
class Task:
    """How a method is to be run.

    Attributes:
        seed: of whatever is random in it.
        quick: train and fit for a moment only.
        at_buckets: give the indicator at bucket ends, not at every vector.
        on_epoch: told how training goes on.
        nets: where trained nets are kept for another score of the same nets, of the same calibration;
            None keeps none.
        epochs: how often calibration is gone through in training; None for the usual number.
    """

    seed: int = 0
    quick: bool = False
    at_buckets: bool = False
    on_epoch: OnEpoch = lambda epoch, loss: None
    nets: Nets | None = None
    epochs: int | None = None

    @property
    def effort(self) -> Effort:
        """How long networks are trained."""
        usual = QUICK if self.quick else FULL
        return usual if self.epochs is None else Effort(self.epochs)

    @property
    def sample(self) -> int:
        """Calibration vectors that scikit-learn is given at most."""
        return _QUICK_SAMPLE if self.quick else SAMPLE


@dataclass(frozen=True)
class Method:
    """One method.

    Attributes:
        title: what the paper calls it.
        series: makes the series of a study.
        library: what it needs, if anything.
        settings: what a result of it depends on, beside the data and the parameters.
        cheap: whether it is run on many channels unless asked otherwise; nothing is fitted outside SQL.
    """

    title: str
    series: Callable[[Study, Task], pa.Table]
    library: str | None = None
    settings: Callable[[Task], dict[str, Any]] = lambda task: {}
    cheap: bool = True


def health(
    name: str,
    source: AnySource,
    parameters: Parameters,
    calibration: Calibration,
    task: Task,
    on_step: Callable[[str], None] = lambda step: None,
) -> tuple[pa.Table, float]:
    """Return the health indicators by a method, and the seconds from the raw table to them.

    Args:
        name: a key of :data:`METHODS`.
        source: where the telemetry lies.
        parameters: of the method.
        calibration: the healthy part.
        task: how it is run.
        on_step: called with the name of each step before it is run.

    Returns:
        One row per scored vector or bucket: asset, channel, time or bucket and last_time, hi (NULL
        until the window is full); with "dse" also the counts. The time that importing a library takes
        is left out.

    Raises:
        UserError: see its subclasses; also where a library is not installed.
    """
    method = method_named(name)
    check_libraries([name])
    begin = time.perf_counter()
    with DuckSession() as session:
        study = Study(session, source, parameters, calibration, on_step)
        table = method.series(study, task)
    seconds = time.perf_counter() - begin
    return table.select([column for column in _COLUMNS if column in table.column_names]), seconds


def chosen(text: str | None, among: Sequence[str], there: Sequence[str] | None = None) -> list[str]:
    """Return the methods that an option names, with commas; without it, those given.

    Args:
        text: of the option.
        among: what is taken without it.
        there: all that it may name; default METHODS.

    Raises:
        ConfigurationError: there is no such method.
    """
    if text is None:
        return list(among)
    names = [usual(part.strip()) for part in text.split(",") if part.strip()]
    there = there or list(METHODS)
    if not names:
        raise ConfigurationError(f"--methods is empty; it takes some of {', '.join(there)}.")
    for name in names:
        if name not in there:
            raise ConfigurationError(f"--methods does not know {name!r}{nearest(name, there)}")
    return [name for name in there if name in names]


def method_named(name: str) -> Method:
    """Return a method, out of METHODS or LONG_METHODS."""
    return (METHODS | LONG_METHODS)[name]


def check_libraries(names: Sequence[str]) -> None:
    """Import what methods need, before anything is computed.

    Raises:
        UserError: a library is not installed; the message says what to install.
    """
    for name in names:
        library = method_named(name).library
        if library is not None:
            needed(library, "benchmark")


def _discrete(study: Study, task: Task) -> pa.Table:
    return study.table("bucket_health" if task.at_buckets else "health_indicator")


def _averaged(study: Study, task: Task) -> pa.Table:
    return study.table("score_bucket_health" if task.at_buckets else "score_health")


def _estimator(name: str, title: str, library: str | None = None, cheap: bool = True) -> Method:
    def series(study: Study, task: Task) -> pa.Table:
        add_estimator(study, name, task.seed, task.sample)
        return _averaged(study, task)

    def settings(task: Task) -> dict[str, Any]:
        return {} if library is None else {"sample": task.sample}

    return Method(title, series, library, settings, cheap)


def _network(name: str, title: str) -> Method:
    def series(study: Study, task: Task) -> pa.Table:
        add_baseline(study, name, task.seed, task.effort, task.on_epoch, task.nets)
        return _averaged(study, task)

    def settings(task: Task) -> dict[str, Any]:
        return {**dataclasses.asdict(task.effort), "forecasts": BASELINES[name].forecasts}

    return Method(title, series, "torch", settings, cheap=False)


def _long(name: str, title: str) -> Method:
    def effort_of(task: Task) -> Effort:
        return LONG_QUICK if task.quick else LONG_FULL

    def series(study: Study, task: Task) -> pa.Table:
        add_long(study, name, task.seed, effort_of(task), task.on_epoch, task.nets)
        return _averaged(study, task)

    def settings(task: Task) -> dict[str, Any]:
        return {
            **dataclasses.asdict(effort_of(task)),
            "context": LONG[name].length or "window",
            "learnt_every": EVERY,
            "forecasts": LONG[name].baseline.forecasts,
        }

    return Method(title, series, "torch", settings, cheap=False)


METHODS: dict[str, Method] = {
    "dse": Method("DSE", _discrete),
    "gmm": _estimator("gmm", "GMM", "sklearn.mixture", cheap=False),
    "forest": _estimator("forest", "Isolation Forest", "sklearn.ensemble", cheap=False),
    "ocsvm": _estimator("ocsvm", "OCSVM", "sklearn.svm", cheap=False),
    "centroid": _estimator("centroid", "Centroid"),
    "ae": _network("ae", "Autoencoder"),
    "vae_rec": _network("vae_rec", "VAE (Rec)"),
    "vae_latent": _network("vae_latent", "VAE (latent)"),
    "lstm": _network("lstm", "LSTM (Pred)"),
    "lstm_ae": _network("lstm_ae", "LSTM-AE"),
    "mlp": _network("mlp", "MLP"),
}

LONG_METHODS: dict[str, Method] = {
    "long_cnn_ae": _long("long_cnn_ae", "CNN-AE"),
    "long_vae_rec": _long("long_vae_rec", "VAE (Rec)"),
    "long_vae_latent": _long("long_vae_latent", "VAE (latent)"),
    "long_lstm_ae": _long("long_lstm_ae", "LSTM-AE"),
    "long_lstm": _long("long_lstm", "LSTM (Pred)"),
    "long_ae": _long("long_ae", "Autoencoder"),
    "long_mlp": _long("long_mlp", "MLP"),
    "long_transformer": _long("long_transformer", "Transformer"),
}
"""Those of the paper's table of long contexts."""
