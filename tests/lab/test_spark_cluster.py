"""A cluster of two workers on this machine: the integers of DuckDB, from partitioned Parquet."""

from pathlib import Path

import pytest

import spark_cluster
import spark_fleet
import spark_settings

#: 30 channels of a million samples, and a worker killed: by hand, ``python tests/lab/spark_fleet.py``.
CHANNELS, SAMPLES = 6, 20_000


@pytest.mark.full
def test_a_cluster_counts_as_duckdb_does(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("JDK_JAVA_OPTIONS", spark_settings.QUICK_JAVA)
    spark_fleet.write(tmp_path, CHANNELS, SAMPLES)
    expected = spark_fleet.by_duckdb(tmp_path)
    with (
        spark_cluster.cluster(tmp_path / "cluster") as cluster,
        spark_fleet.on_cluster(tmp_path, cluster) as process,
    ):
        _, said = process.communicate()
        assert process.returncode == 0, said
    found = spark_fleet.found_in(tmp_path)
    for table in spark_fleet.QUERIES:
        assert found[table].num_rows > 0, table
        assert found[table].to_pylist() == expected[table].to_pylist(), table
