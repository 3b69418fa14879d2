"""Opening Spark: a session in this process, one on a cluster, or a copy of the user's own.

Ours is always a session beside the others of the process, with settings of its own (UTC, ANSI mode):
what the user set stays as it is.
"""

import atexit
import contextlib
import logging
import os
import shutil
import sys
import tempfile
import warnings
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlsplit

from gam_db import data
from gam_db.engines.refusals import first_line, refused
from gam_db.engines.spark import ENGINE
from gam_db.errors import EngineError, wrong
from gam_db.extras import needed

AT_WORK = data.table("gam_db.engines.spark", "spark.toml")


def address_of(url: str) -> tuple[str | None, Path]:
    """Return master (None: that of the environment) and folder of ``spark://HOST:PORT/FOLDER``.

    Raises:
        EngineError: it names no folder.
    """
    parts = urlsplit(url)
    folder = unquote(parts.path)
    if folder.startswith("//"):  # to Spark, what follows two slashes is a host
        folder = f"/{folder.lstrip('/')}"
    if not folder.strip("/"):
        raise wrong("spark_no_folder", url=url)
    return f"spark://{parts.netloc}" if parts.netloc else None, Path(folder).absolute()


def started(master: str | None) -> Any:
    """Return a new session of the Spark of this process, which is started if there is none.

    Raises:
        EngineError: there is no Java, or a too old one, the master does not answer, Spark is too old, or
            this process runs Spark on another master already.
    """
    if (context := needed("pyspark", "spark").SparkContext._active_spark_context) is None:
        base = _started(master or os.environ.get("SPARK_MASTER"))
    else:
        if master not in (None, context.master):
            raise wrong("spark_master", master=context.master, wanted=master)
        base = needed("pyspark.sql", "spark").SparkSession.builder.getOrCreate()
    with quiet():
        return _set(base.newSession(), base)


def beside(session: Any) -> Any:
    """Return a session with the user's views, settings and current schema, plus gam-db's settings.

    Raises:
        EngineError: it is stopped, or too old.
    """
    if session.sparkContext._jsc is None or session.sparkContext._jsc.sc().isStopped():
        raise EngineError("This SparkSession is stopped; start another one and pass it.")
    return _set(type(session)(session.sparkContext, session._jsparkSession.cloneSession()), session)


@cache
def scratch() -> Path:
    """Return a folder that is removed when this process ends."""
    folder = Path(tempfile.mkdtemp(prefix="gam-spark-"))
    atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


@contextlib.contextmanager
def quiet() -> Iterator[None]:
    """Hide PySpark's messages for developers, and its logs of errors, from users."""
    log = logging.getLogger("SQLQueryContextLogger")
    before = log.disabled
    log.disabled = True
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            yield
    finally:
        log.disabled = before


@contextlib.contextmanager
def as_before(session: Any) -> Iterator[None]:
    """Restore the active session, which making a table of rows would change."""
    before = type(session).getActiveSession()
    try:
        yield
    finally:
        if before is not None:
            type(session)._activeSession = before
            session._jvm.SparkSession.setActiveSession(before._jsparkSession)


def _set(session: Any, base: Any) -> Any:
    ENGINE.check_version(session.version)
    for name, value in (AT_WORK["settings"] | AT_WORK["preferred"]).items():
        session.conf.set(name, value)
    if base.sparkContext.master.startswith("local"):
        session.conf.set("spark.sql.shuffle.partitions", str(base.sparkContext.defaultParallelism))
    return session


def _started(master: str | None) -> Any:
    """Start Spark; the output of Java goes to a file.

    What it says later, too: the process of Java keeps the streams that it was started with.
    """
    builder = needed("pyspark.sql", "spark").SparkSession.builder.appName("gam-db")
    if master is not None:
        builder = builder.master(master)
    is_local = master is None or master.startswith("local")
    settings = AT_WORK["started"] | (AT_WORK["local"] if is_local else {})
    for name, value in settings.items():
        builder = builder.config(name, value)
    # A quarter of the memory, unless the settings of Spark say otherwise.
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**30  # in GiB
    os.environ.setdefault("SPARK_DRIVER_MEMORY", f"{max(memory // 4, 1)}g")
    log = scratch() / "java.log"
    try:
        with quiet(), _stderr_to(log):
            session = builder.getOrCreate()
    except Exception as error:
        text = log.read_text(encoding="utf-8", errors="replace") if log.exists() else ""
        words = {"master": master, "first_line": first_line(error)}
        no_java = "" if shutil.which("java") else "no java"
        raise refused("spark_starting", f"{error}\n{text}", no_java, **words) from error
    atexit.register(_stop, session)
    return session


def _stop(session: Any) -> None:
    with contextlib.suppress(Exception):
        session.stop()


@contextlib.contextmanager
def _stderr_to(path: Path) -> Iterator[None]:
    """Let processes that are started inside write their errors to a file."""
    sys.stderr.flush()
    saved = os.dup(2)
    try:
        with path.open("ab") as stream:
            os.dup2(stream.fileno(), 2)
        yield
    finally:
        os.dup2(saved, 2)
        os.close(saved)
