"""The neural baselines: they learn, they tell an obvious anomaly, and a seed means one result."""

import importlib.util

import numpy as np
import pyarrow as pa
import pytest

import gam_db
from gam_db.engines.duckdb.session import DuckSession
from gam_db.errors import ParameterError
from gam_db.lab.baselines import BASELINES, Effort, add_baseline
from gam_db.lab.baselines.baseline import add_forecast_points
from gam_db.lab.estimators.points import add_points
from gam_db.study import Study

torch_needed = pytest.mark.skipif(
    importlib.util.find_spec("torch") is None,
    reason='left out: pip install "gam-db[benchmark]" to run it (the full set needs it)',
)

SAMPLES = 2_000
PARAMETERS = gam_db.Parameters(m=3, tau=2, window=200)
CALIBRATION = gam_db.Calibration(fraction=0.5)


def series(broken: bool = True, missing: int | None = None) -> pa.Table:
    """A sine with some noise; from three quarters on it is torn to and fro."""
    random = np.random.default_rng(0)
    values = np.sin(np.arange(SAMPLES) / 5) + 0.02 * random.standard_normal(SAMPLES)
    if broken:
        values[SAMPLES * 3 // 4 :] += 2 * random.standard_normal(SAMPLES - SAMPLES * 3 // 4)
    if missing is not None:
        values[missing] = np.nan
    names = {"asset": pa.array(["a"] * SAMPLES), "channel": pa.array(["c"] * SAMPLES)}
    return pa.table({**names, "time": np.arange(SAMPLES), "value": values})


def scored(
    name: str, seed: int = 0, epochs: int = 3, table: pa.Table | None = None
) -> tuple[pa.Table, list[float]]:
    losses: list[float] = []
    with DuckSession() as session:
        source = gam_db.Source(series() if table is None else table)
        study = Study(session, source, PARAMETERS, CALIBRATION)
        add_baseline(study, name, seed, Effort(epochs), lambda epoch, loss: losses.append(loss))
        return study.table("score_health"), losses


@pytest.mark.full
@torch_needed
@pytest.mark.parametrize("name", BASELINES)
def test_training_lowers_the_loss_and_an_anomaly_separates(name: str) -> None:
    health, losses = scored(name)
    assert len(losses) == 3
    assert losses[-1] < losses[0]
    hi = health["hi"].drop_null().to_numpy()
    assert health.num_rows == SAMPLES // 2
    assert len(hi) == SAMPLES // 2 - PARAMETERS.window + 1
    if name == "vae_latent":
        assert hi.min() > 0, "a divergence; it need not tell anything of the place"
    else:
        assert hi[-1] > 1.3 * hi[0]


@pytest.mark.full
@torch_needed
@pytest.mark.parametrize("name", ["vae_rec", "mlp"])
def test_a_seed_means_one_result(name: str) -> None:
    import torch

    state = torch.random.get_rng_state()
    first, again, other = (scored(name, seed, epochs=1)[0] for seed in (1, 1, 2))
    assert first.equals(again)
    assert not first.equals(other)
    assert torch.equal(torch.random.get_rng_state(), state), "the state of others is left alone"


@pytest.mark.full
@torch_needed
def test_every_row_of_a_vector_with_a_missing_sample_is_left_out() -> None:
    """A sample that is missing spoils m vectors, and for a forecast also those a sample later."""
    complete, _ = scored("ae", epochs=1)
    for name, spoilt in (("ae", 3), ("mlp", 6)):
        health, _ = scored(name, epochs=1, table=series(missing=1_200))
        assert complete.num_rows - health.num_rows == spoilt


def test_a_forecast_is_made_from_the_vector_a_sample_earlier() -> None:
    with DuckSession() as session:
        study = Study(session, gam_db.Source(series(broken=False)), PARAMETERS, CALIBRATION)
        add_points(study.steps, study.method, 0)
        columns = add_forecast_points(study, 0)
        rows = study.table("forecast_scored_points").sort_by("time")
    assert columns == ["x_0", "before_0", "before_1", "before_2"]
    x = series(broken=False)["value"].to_numpy()
    low, high = x[: SAMPLES // 2].min(), x[: SAMPLES // 2].max()
    time = rows["time"].to_numpy()
    for column, delay in (("x_0", 0), ("x_1", 2), ("before_0", 1), ("before_1", 3), ("before_2", 5)):
        assert np.allclose(rows[column].to_numpy(), (x[time - delay] - low) / (high - low))
    assert set(rows["elapsed"].to_pylist()) == {1}


def test_an_unknown_baseline_is_refused() -> None:
    with DuckSession() as session:
        study = Study(session, gam_db.Source(series()), PARAMETERS, CALIBRATION)
        with pytest.raises(ParameterError, match="did you mean 'lstm'"):
            add_baseline(study, "lsmt")
