"""From a source to the scores of an estimator and the health indicator made of them.

This module owns the public calls, and the order of work: learn, draw, fit, score.
"""

import operator
from collections.abc import Mapping
from typing import Any, SupportsIndex, cast

import numpy as np
import pyarrow as pa

from gam_db.arguments import public
from gam_db.engines.connecting import borrowed
from gam_db.errors import ParameterError, nearest, wrong
from gam_db.extras import needed
from gam_db.lab.estimators import centroid, dse, forest, gmm, ocsvm
from gam_db.lab.estimators.base import Estimator, Fit, Points
from gam_db.lab.estimators.points import add_moving_average, add_points, names_of, point_of
from gam_db.method.adding import OfSet
from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.source import AnySource
from gam_db.study import Study

ESTIMATORS: Mapping[str, Estimator] = {
    module.ESTIMATOR.name: module.ESTIMATOR for module in (dse, centroid, gmm, forest, ocsvm)
}
DSE = dse.ESTIMATOR.name
ALSO_CALLED = {
    "gaussianmixture": "gmm",
    "gaussianmixturemodel": "gmm",
    "isolationforest": "forest",
    "iforest": "forest",
    "oneclasssvm": "ocsvm",
    "svm": "ocsvm",
}
"""Other usual names of estimators, in small letters and digits only -> ours."""

SAMPLE = 10_000
"""Calibration vectors of a support that scikit-learn is given at most."""

_FEWEST = 2


@public
def scores(
    source: AnySource,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
    *,
    estimator: str = DSE,
    seed: int = 0,
    sample: int = SAMPLE,
) -> pa.Table:
    """Return an estimator's score of every scored vector, and the health indicator (paper, Eq. 2).

    Vectors are learnt and scored by the rules of the method; their coordinates are in ranges of
    calibration, (x - lo) / (hi - lo), newest first. For the same vectors scores are those of
    scikit-learn's ``score_samples`` with the sign turned, to about 1e-9.

    Args:
        source: where the telemetry lies.
        parameters: of the method; default :class:`Parameters`. ``bins`` matters to "dse" only.
        calibration: the healthy part; default the first fifth of each channel.
        engine: None for DuckDB in memory, the path of a DuckDB file, or an open DuckDB connection.
        estimator: "dse" (1 for a novel vector, else 0), "centroid" (Euclidean distance to the mean of
            the calibration vectors), "gmm" (negative log-likelihood, 15 Gaussians), "forest"
            (Isolation Forest: 2^(-mean path / average path)) or "ocsvm" (less the sum of the radial
            basis functions; nu 0.01, gamma "scale").
        seed: of the sample and of scikit-learn, from 0 to 2^32 - 1.
        sample: calibration vectors of a support that are given to scikit-learn at most; at least 2.

    Returns:
        One row per scored vector, ordered by asset, channel and time: asset, channel, time (as in the
        source), score (the higher, the less healthy), hi (mean of the last ``window`` scores, each as
        an integer of 2^-20, saturated where a window of them would leave 64 bits; NULL until the
        window is full). A channel whose calibration has no vector, or fewer than 2 where
        scikit-learn fits, has no row, except with "dse".

    Raises:
        UserError: see its subclasses; also where scikit-learn is needed and not installed.
    """
    with borrowed(engine) as session:
        study = Study(session, source, parameters or Parameters(), calibration or Calibration())
        add_estimator(study, estimator, seed, sample)
        return study.table("score_health")


@public
def scores_at_buckets(
    source: AnySource,
    parameters: Parameters | None = None,
    calibration: Calibration | None = None,
    engine: Any = None,
    *,
    estimator: str = DSE,
    seed: int = 0,
    sample: int = SAMPLE,
) -> pa.Table:
    """Return the health indicator by an estimator at the end of every full bucket of ``stride`` vectors.

    Arguments and errors as in :func:`scores`, whose values these are.

    Returns:
        One row per bucket, ordered: asset, channel, bucket (from 0), last_time, hi.
    """
    with borrowed(engine) as session:
        study = Study(session, source, parameters or Parameters(), calibration or Calibration())
        add_estimator(study, estimator, seed, sample)
        return study.table("score_bucket_health")


def estimator_named(name: str) -> Estimator:
    """Return the estimator of that name.

    Raises:
        ParameterError: there is none; the message suggests the nearest.
    """
    ours = usual(name)
    if ours not in ESTIMATORS:
        raise ParameterError(f"There is no estimator {name!r}{nearest(str(name), ESTIMATORS)}")
    return ESTIMATORS[ours]


def usual(name: str) -> str:
    """Return our name of an estimator that is known by others, such as ``isolation_forest``; else it."""
    plain = "".join(sign for sign in str(name).lower() if sign.isalnum())
    return ALSO_CALLED.get(plain, plain if plain in ESTIMATORS else name)


def add_estimator(study: Study, name: str, seed: int = 0, sample: int = SAMPLE) -> None:
    """Fit an estimator and add its steps to a study: ``score_health`` and the like.

    The steps to be asked for are ``score_health``, ``score_bucket_health`` and ``last_scores`` (where
    each channel stands).

    Args:
        study: of a source; it takes one estimator only.
        name: of the estimator.
        seed: of the sample and of scikit-learn.
        sample: calibration vectors of a support that are given to scikit-learn at most.

    Raises:
        ParameterError: there is no such estimator, the source names a program, or the sample or seed is
            no number that will do.
    """
    estimator = estimator_named(name)
    if study.method.programs is not None:
        raise wrong("estimator_of_programs", name=name, column=study.method.programs.column)
    seed, sample = _whole("seed", seed, 0, 2**32), _whole("sample", sample, _FEWEST, 2**63)
    if estimator.fit is not None:
        needed("sklearn", "benchmark")  # said before anything is read
    steps, method = study.steps, study.method
    for number in range(len(method.settings)):
        add_points(steps, method, number)
        if estimator.fit is None or _put_fitted(study, estimator.fit, number, seed, sample):
            estimator.add_scores(steps, method, number)
        else:
            OfSet(steps, method, number).add("lab/estimators/no_scores", name="scores")
    add_moving_average(steps, method, study.instant_of)


def _put_fitted(study: Study, fit: Fit, number: int, seed: int, sample: int) -> bool:
    """Fit on the drawn points of one set and put the rows into the study; False if there are none."""
    points = _drawn(study, number, seed, sample)
    if not points:
        return False
    # One thread: what is fitted is small, and its sums then come in one order.
    with needed("threadpoolctl", "benchmark").threadpool_limits(limits=1):
        tables = fit(points, seed)
    for table, rows in tables.items():
        study.load(study.method.named(table, number), rows)
    return True


def _drawn(study: Study, number: int, seed: int, sample: int) -> dict[int, Points]:
    """Return the points of each support that an estimator is fitted on, in order."""
    method, names = study.method, names_of(study.method, number)
    counts = study.table(method.named("learnt_counts", number)).to_pylist()
    drawn = [pa.table({"support_id": pa.array([], pa.int64()), "number": pa.array([], pa.int64())})]
    for row in counts:
        support, points = row["support_id"], row["points"]
        if points >= _FEWEST:
            generator = np.random.default_rng([seed, support])
            chosen = generator.choice(points, min(points, sample), replace=False) + 1
            drawn.append(pa.table({"support_id": np.full(len(chosen), support), "number": chosen}))
    study.load(method.named("drawn", number), pa.concat_tables(drawn))
    point = {"point": point_of(method, number)}
    OfSet(study.steps, method, number).add("lab/estimators/drawn_points", point)
    rows = study.table(method.named("drawn_points", number))
    of = rows["support_id"].to_numpy()
    stacked = np.column_stack([rows[name].to_numpy() for name in names])
    return {support: stacked[of == support] for support in np.unique(of).tolist()}


def _whole(name: str, value: object, least: int, beyond: int) -> int:
    try:
        whole = operator.index(cast(SupportsIndex, value))
    except TypeError:
        raise ParameterError(f"{name} is {value!r}; it must be an integer.") from None
    if not least <= whole < beyond:
        raise ParameterError(f"{name} is {whole}; it must be at least {least} and below {beyond}.")
    return whole
