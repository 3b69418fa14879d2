"""A Spark Connect server from the wheel of pyspark, for as long as the tests of one process run.

It is started once (``server()``), listens on a free port of this machine, keeps its tables in a folder
of its own, and is stopped and wiped when the process ends.
"""

import atexit
import functools
import os
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

import pyspark

from spark_settings import QUICK_JAVA, QUICK_SPARK

#: Seconds for Java to start on a busy machine.
PATIENCE = 120

HOST = "127.0.0.1"


@functools.cache
def server() -> str:
    """Return the address of the server, which is started if it is not there yet."""
    home, folder = Path(pyspark.__file__).parent, Path(tempfile.mkdtemp(prefix="gam-connect-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    with socket.socket() as free:
        free.bind((HOST, 0))
        port = free.getsockname()[1]
    settings = {
        **QUICK_SPARK,
        "spark.connect.grpc.binding.address": HOST,
        "spark.connect.grpc.binding.port": port,
        "spark.driver.bindAddress": HOST,
        "spark.driver.host": HOST,
        "spark.sql.shuffle.partitions": 2,
        "spark.sql.warehouse.dir": folder / "warehouse",
        "spark.ui.enabled": "false",
    }
    words = [word for name, said in settings.items() for word in ("--conf", f"{name}={said}")]
    log = folder / "log"
    with log.open("wb") as stream:
        process = subprocess.Popen(
            [
                *(str(home / "bin" / "spark-submit"), "--master", "local[2]", "--driver-memory", "1g"),
                *("--class", "org.apache.spark.sql.connect.service.SparkConnectServer", *words),
            ],
            cwd=folder,
            env={**os.environ, "SPARK_HOME": str(home), "JDK_JAVA_OPTIONS": QUICK_JAVA},
            stdin=subprocess.DEVNULL,
            stdout=stream,
            stderr=subprocess.STDOUT,
        )
    atexit.register(process.wait)
    atexit.register(process.terminate)  # the last one registered is the first to be called
    deadline = time.monotonic() + PATIENCE
    while time.monotonic() < deadline and process.poll() is None:
        try:
            socket.create_connection((HOST, port), 1).close()
            return f"sc://{HOST}:{port}"
        except OSError:
            time.sleep(0.1)
    raise AssertionError(f"Spark Connect did not start:\n{log.read_text(errors='replace')[-5000:]}")
