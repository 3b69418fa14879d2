"""Addresses of ClickHouse: what clickhouse-connect is to open."""

import contextlib
import importlib
import os
from pathlib import Path
from typing import Any
from urllib.parse import parse_qsl, unquote, urlsplit

from gam_db.address import shown
from gam_db.errors import EngineError, nearest, wrong
from gam_db.extras import needed

EXTRA = "clickhouse"

_FOLDER = "chdb:///"
_PARAMETERS = ("ca_cert", "client_cert", "client_cert_key", "verify", "connect_timeout")

#: Seconds that a statement may take.
_PATIENCE = 86_400

#: What lies in a folder of chdb.
_OF_CHDB = {"metadata", "store", "tmp"}


def folder(address: str, writable: bool) -> dict[str, Any]:
    """Return what opens chdb:///FOLDER or chdb:// (in memory).

    Raises:
        EngineError: it is no such address, or no folder of chdb.
        UserError: chdb is not installed.
    """
    needed("chdb", EXTRA)
    if address == "chdb://":
        return {"interface": "chdb"}
    if not address.startswith(_FOLDER):
        raise wrong("chdb_names_a_server", address=address)
    path = Path(address.removeprefix(_FOLDER))
    if not path.is_dir() and not (writable and not path.exists() and path.parent.is_dir()):
        raise EngineError(f"There is no folder {path.absolute()}.")
    there = {entry.name for entry in path.iterdir()} if path.is_dir() else set()
    if there and not there & _OF_CHDB:
        raise EngineError(f"{path} is no folder of chdb; give an empty or a new one.")
    return {"interface": "chdb", "path": str(path)}


def is_locked(folder: str | None) -> bool:
    """Tell whether another process holds a folder of chdb; the error itself does not say."""
    if folder is None:
        return False
    fcntl = importlib.import_module("fcntl")  # chdb runs only where it is there
    with contextlib.suppress(FileNotFoundError), (Path(folder) / "status").open() as status:
        try:
            fcntl.flock(status, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            return True
    return False


def server(address: str) -> dict[str, Any]:
    """Return what opens clickhouse://user@host:8123/database, or clickhouses:// with TLS.

    Raises:
        EngineError: a part of the address is none.
    """
    parts = urlsplit(address)
    said = dict(parse_qsl(parts.query))
    for name in said:
        if name not in _PARAMETERS:
            raise wrong("clickhouse_parameter", name=name, hint=nearest(name, _PARAMETERS))
    try:
        port = parts.port
    except ValueError:
        raise EngineError(f"{shown(address)}: the port is no number.") from None
    secure = parts.scheme == "clickhouses"
    return {
        "interface": "https" if secure else "http",
        "host": parts.hostname or "localhost",
        "port": port or (8443 if secure else 8123),
        "username": unquote(parts.username or os.environ.get("CLICKHOUSE_USER") or "default"),
        "password": unquote(parts.password or "") or os.environ.get("CLICKHOUSE_PASSWORD", ""),
        "database": unquote(parts.path.strip("/")) or None,
        "send_receive_timeout": _PATIENCE,
        "query_retries": 0,
        **said,
    }
