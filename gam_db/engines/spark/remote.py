"""Opening sessions of Spark Connect, by public calls alone: there is no Java to ask in this process.

A user's session is worked in as it is, and gets back the settings that it had: in a copy of it, Spark
4.3 would look for its checkpoints in the other one.
"""

import re
import socket
import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlsplit

from gam_db.address import shown, without_passwords
from gam_db.engines.refusals import first_line
from gam_db.engines.spark import ENGINE
from gam_db.engines.spark.opening import AT_WORK, quiet
from gam_db.errors import EngineError, wrong
from gam_db.extras import needed

SCHEME = "sc://"
EXTRA = "spark-connect"

#: The port of a server whose address names none.
_PORT = 15002

#: Seconds for a server to take a connection.
_PATIENCE = 10

#: How often the client tries again when a server is gone: in a quarter of a minute all in all.
_RETRIES = 5

#: What is said where a session lacks a feature.
_UNSUPPORTED = re.compile(r"NOT_SUPPORTED|UNSUPPORTED|NOT_IMPLEMENTED|UNIMPLEMENTED")

_STATISTICS = re.compile(r"Statistics\(sizeInBytes=([0-9.E+]+) ([KMGTPE]?)i?B")


@dataclass(frozen=True)
class Work:
    """A session that we work in, and what ends that."""

    session: Any
    give_back: Callable[[], None]


@dataclass
class _Lent:
    """What a user's session was set to, and how many of ours work in it."""

    before: dict[str, str] = field(default_factory=dict)
    users: int = 0


_LENT: dict[Any, _Lent] = {}
_LENDING = threading.Lock()


def is_remote(session: Any) -> bool:
    """Tell whether a session of pyspark is one of Spark Connect."""
    return any(".connect." in kind.__module__ for kind in type(session).__mro__)


def opened(url: str) -> Work:
    """Return a new session on a server, ``sc://HOST:PORT/;token=...``.

    Raises:
        EngineError: the address cannot be used, the server does not answer, refuses, or is too old.
    """
    _reach(url)
    with quiet():
        # Not by pyspark.sql: that would let no other session of this process have Java.
        builder = needed("pyspark.sql.connect.session", EXTRA).SparkSession.builder
        trying = needed("pyspark.sql.connect.client.retries", EXTRA).DefaultPolicy
        raised = needed("pyspark.errors", EXTRA).PySparkException
        try:
            session = builder.remote(url).create()
            session.client.set_retry_policies([trying(max_retries=_RETRIES)])
            _set(session, raised)
        except (raised, ValueError) as error:
            said = without_passwords(first_line(error))
            raise wrong(
                "spark_connect_refused", address=shown(url), said=said
            ) from None  # the error quotes the token
    return Work(session, session.stop)


def lent(session: Any) -> Work:
    """Return a user's session, set as we need it until the last of ours gives it back.

    Raises:
        EngineError: it is stopped, too old, or cannot be set to UTC and ANSI mode.
    """
    if session.is_stopped:
        raise EngineError("This SparkSession is stopped; start one and give that.")
    with quiet(), _LENDING:
        before = _set(session, needed("pyspark.errors", EXTRA).PySparkException)
        loan = _LENT.setdefault(session, _Lent())
        loan.before = before | loan.before
        loan.users += 1

    def give_back() -> None:
        with quiet(), _LENDING:
            loan.users -= 1
            if not loan.users:
                del _LENT[session]
                for name, setting in loan.before.items():
                    session.conf.set(name, setting)

    return Work(session, give_back)


def keeps_checkpoints(session: Any) -> bool:
    """Tell whether a checkpoint of a session is one of its own.

    Cause: PySpark 4.3 looks for it in the active session of the process. Symptom: one of another session
    is not there.
    """
    return type(session).active() is session


def is_unsupported(error: Exception) -> bool:
    """Tell whether an error is that a session lacks a feature."""
    return _UNSUPPORTED.search(first_line(error)) is not None


def expected_bytes(explained: str) -> float:
    """Return how many bytes a plan says that a query will give; infinite where it does not say so."""
    if (said := _STATISTICS.search(explained)) is None:
        return float("inf")
    return float(said[1]) * 1024.0 ** " KMGTPE".index(said[2] or " ")


def _set(session: Any, raised: type[Exception]) -> dict[str, str]:
    """Set a session to what we need; return what it was set to."""
    ENGINE.check_version(session.version)
    before: dict[str, str] = {}
    for name, setting in (AT_WORK["settings"] | AT_WORK["preferred"]).items():
        try:
            there = session.conf.get(name)
            if there != setting:
                session.conf.set(name, setting)
                before[name] = there
        except raised as error:
            if name in AT_WORK["settings"]:
                said = first_line(error)
                raise wrong("spark_setting", name=name, setting=setting, said=said) from error
    return before


def _reach(url: str) -> None:
    """Look whether anything listens at an address."""
    try:
        parts = urlsplit(url)
        host, port = parts.hostname, parts.port or _PORT
    except ValueError:
        host, port = None, 0
    if host is None or "@" in urlsplit(url).netloc:
        raise wrong("spark_connect_address", address=shown(url))
    try:
        socket.create_connection((host, port), _PATIENCE).close()
    except OSError as error:
        said = error.strerror or str(error)
        raise wrong("spark_connect_unreachable", host=host, port=port, said=said) from error
