"""What all tests share: how many random cases are tried, and where the recordings lie."""

import os
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, settings

# The same cases in every run; more, and other ones, by HYPOTHESIS_PROFILE=many.
settings.register_profile(
    "few",
    max_examples=100,
    derandomize=True,
    deadline=None,
    database=None,
    # Looking for a smaller case takes minutes where each one runs a hundred statements.
    phases=(Phase.explicit, Phase.generate),
    suppress_health_check=[HealthCheck.too_slow],
)
settings.register_profile(
    "many", max_examples=2000, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "few"))


@pytest.fixture(scope="session")
def recordings() -> Path:
    """The folder of the real recordings; without it the test says that it was left out."""
    folder = os.environ.get("GAM_TEST_DATA")
    if not folder:
        pytest.skip("left out: set GAM_TEST_DATA to the folder of the real recordings to run it")
    return Path(folder)
