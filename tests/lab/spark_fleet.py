"""A fleet's telemetry as partitioned Parquet, calibrated and scored in a process of its own.

As a program it does so on a cluster, and can lose a worker in the middle:

    python tests/lab/spark_fleet.py --channels 30 --samples 1000000 [--kill]
"""

import argparse
import contextlib
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import sqlglot

import gam_db
import spark_cluster
from gam_db.lab.benchmark import workload
from gam_db.lab.benchmark.inside import CALIBRATION, PARAMETERS

LOGGED = "--conf spark.eventLog.enabled=true --conf spark.eventLog.compress=false"

#: What is compared: the visible rows of every channel, and what was learnt.
QUERIES = {
    "buckets": (
        "SELECT asset, channel, bucket_no, first_time, last_time, context_time, samples, novel, "
        "out_of_range, novel_in_window FROM gam_state_visible_bucket "
        "JOIN gam_state_version USING (version_id) JOIN gam_state_channel USING (channel_id) "
        "ORDER BY asset, channel, bucket_no"
    ),
    "novel": (
        "SELECT asset, channel, bucket_no, cell_key, visits, first_time, last_time "
        "FROM gam_state_visible_novel JOIN gam_state_version USING (version_id) "
        "JOIN gam_state_channel USING (channel_id) ORDER BY asset, channel, bucket_no, cell_key"
    ),
    "support": (
        "SELECT asset, channel, cell_key, visits, first_block, last_block, first_time, last_time "
        "FROM gam_state_support JOIN gam_state_version USING (support_id) "
        "JOIN gam_state_channel USING (channel_id) ORDER BY asset, channel, cell_key"
    ),
    "bounds": (
        "SELECT asset, channel, lo, hi, calibration_vectors, cells, seen_once, verdict, finest_bins "
        "FROM gam_state_bounds JOIN gam_state_version USING (support_id) "
        "JOIN gam_state_channel USING (channel_id) ORDER BY asset, channel"
    ),
}


def write(folder: Path, channels: int, samples: int) -> Path:
    """Write the telemetry, a folder per robot; return what Spark reads."""
    place = folder / "telemetry.parquet"
    for rows in workload.batches("channel", channels, samples):
        asset, channel = rows["asset"][0].as_py(), rows["channel"][0].as_py()
        part = place / f"asset={asset}"
        part.mkdir(parents=True, exist_ok=True)
        pq.write_table(rows.select(["channel", "t", "value"]), part / f"{channel}.parquet")
    return place


def done(address: str, telemetry: str) -> dict[str, Any]:
    """Calibrate and score; return the seconds of each, and the integers."""
    seconds: dict[str, float] = {}
    began_at: dict[str, float] = {}
    with gam_db.connect(address) as session:
        source = gam_db.Source(telemetry, time="t")
        monitor = gam_db.Monitor(session, source, PARAMETERS, CALIBRATION)
        for step in ("migrate", "calibrate", "score"):
            print(step, flush=True, file=sys.stderr)
            began_at[step] = time.time()
            began = time.perf_counter()
            getattr(monitor, step)()
            seconds[step] = round(time.perf_counter() - began, 1)
        began_at["look"] = time.time()
        found = {
            name: session.fetch(sqlglot.parse_one(query, dialect="duckdb"))
            for name, query in QUERIES.items()
        }
    return {"seconds": seconds, "began_at": began_at, **found}


def by_duckdb(folder: Path) -> dict[str, Any]:
    """Do the same on DuckDB."""
    return done(f"duckdb:///{folder / 'plant.duckdb'}", str(folder / "telemetry.parquet/*/*.parquet"))


@contextlib.contextmanager
def on_cluster(folder: Path, cluster: spark_cluster.Cluster, submit: str = "") -> Iterator[Any]:
    """Start a process that does the same on a cluster; what it finds lies in the folder then."""
    environment = {
        **os.environ,
        "SPARK_LOCAL_IP": spark_cluster.HOST,
        "PYSPARK_SUBMIT_ARGS": f"{submit} pyspark-shell",
        "PYTHONPATH": os.pathsep.join(path for path in sys.path if path),
    }
    process = subprocess.Popen(
        [sys.executable, __file__, "--master", cluster.master, "--folder", str(folder)],
        env=environment,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        assert process.stderr is not None
        process.stderr.close()


def found_in(folder: Path) -> dict[str, Any]:
    """Return what a process on the cluster found."""
    found: dict[str, Any] = {name: pq.read_table(folder / f"{name}.parquet") for name in QUERIES}
    return {**json.loads((folder / "seconds.json").read_text()), **found}


def work(folder: Path, master: str) -> None:
    """Do it on a cluster, and leave what is found in the folder."""
    found = done(f"spark://{master}{folder / 'state'}", str(folder / "telemetry.parquet"))
    for name in QUERIES:
        pq.write_table(found.pop(name), folder / f"{name}.parquet")
    (folder / "seconds.json").write_text(json.dumps(found))


def main() -> None:
    """Run on a cluster and on DuckDB, and compare."""
    said = argparse.ArgumentParser()
    said.add_argument("--master")
    said.add_argument("--folder", type=Path)
    said.add_argument("--channels", type=int, default=30)
    said.add_argument("--samples", type=int, default=1_000_000)
    said.add_argument("--kill", action="store_true", help="kill a worker in the middle of scoring")
    options = said.parse_args()
    if options.master:
        work(options.folder, options.master)
        return
    with tempfile.TemporaryDirectory(prefix="gam-fleet-") as name:
        folder = Path(name)
        write(folder, options.channels, options.samples)
        print("DuckDB", (expected := by_duckdb(folder))["seconds"], flush=True)
        events = folder / "events"
        events.mkdir()
        submit = f"{LOGGED} --conf spark.eventLog.dir={events.as_uri()}"
        with (
            spark_cluster.cluster(folder / "cluster", memory="3g") as cluster,
            on_cluster(folder, cluster, f"{submit} --conf spark.executor.memory=2g") as process,
        ):
            for line in process.stderr:
                print(line, end="", flush=True)
                if line == "score\n" and options.kill:
                    time.sleep(20)
                    cluster.kill(0)
                    print("a worker was killed; alive:", cluster.alive(), flush=True)
            assert process.wait() == 0
        found = found_in(folder)
        print("Spark", found["seconds"])
        for table in QUERIES:
            assert found[table].to_pylist() == expected[table].to_pylist(), f"{table} differs"
            print(table, found[table].num_rows, "rows, the same")
        for step, figures in spent(events, found["began_at"]).items():
            print(step, json.dumps(figures))


def spent(events: Path, began_at: dict[str, float]) -> dict[str, dict[str, float]]:
    """Add up what the tasks of each step say, from the event log of an application."""
    names = ("tasks", "failed", "cpu_seconds", "shuffle_written", "spilled")
    total: dict[str, dict[str, float]] = {step: dict.fromkeys(names, 0) for step in began_at}
    for path in events.rglob("events_*"):
        for line in path.open(encoding="utf-8"):
            if not line.startswith('{"Event":"SparkListenerTaskEnd"'):
                continue
            task = json.loads(line)
            launched = task["Task Info"]["Launch Time"] / 1000
            step = max((at, step) for step, at in began_at.items() if at <= launched)[1]
            figures, metrics = total[step], task.get("Task Metrics")
            figures["tasks"] += 1
            figures["failed"] += task["Task End Reason"]["Reason"] != "Success"
            if metrics:
                figures["cpu_seconds"] += metrics["Executor CPU Time"] / 1e9
                figures["shuffle_written"] += metrics["Shuffle Write Metrics"]["Shuffle Bytes Written"]
                figures["spilled"] += metrics["Disk Bytes Spilled"]
    return total


if __name__ == "__main__":
    main()
