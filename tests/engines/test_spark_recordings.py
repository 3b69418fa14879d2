"""A real recording on Spark: every figure of reference_counts.csv for it, to the integer."""

from collections.abc import Iterator
from pathlib import Path

import pytest

import engines
import spark_settings
from gam_db.engines.session import Session
from test_recordings import SETTINGS, agrees, counts, series

DATASET = "ur3_cobot"


@pytest.fixture
def spark() -> Iterator[Session]:
    """The session on Spark, for a while with Spark's own settings, as users run it."""
    session = engines.session("spark")
    driver = session.driver
    before = [
        (name, driver.fetch(f"SET {name}")["value"][0].as_py()) for name in spark_settings.QUICK_SPARK
    ]
    own = {"spark.sql.codegen.factoryMode": "FALLBACK"}
    for name, _ in before:
        driver.fetch(f"SET {name}={own.get(name, 'true')}")
    yield session
    for name, value in before:
        driver.fetch(f"SET {name}={value}")


@pytest.mark.parametrize("setting", SETTINGS, ids="/".join)
def test_reference_counts_on_spark(spark: Session, recordings: Path, setting: tuple[str, ...]) -> None:
    expected = counts(recordings)[DATASET, *setting]
    agrees(spark, series(recordings, DATASET), expected, setting)
