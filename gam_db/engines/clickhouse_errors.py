"""What the user can do about an error of ClickHouse, by its code."""

import re
from typing import Any

from gam_db.engines.session import FULL
from gam_db.errors import EngineError, LostConnectionError, SourceError, UserError

#: What the temporary tables of a session begin with.
MARK = "gam_"

_GRANT = re.compile(r"the grant (.+?)(?:\. \(ACCESS_DENIED\)|\.?$)", re.MULTILINE)

_AUTHENTICATION = (192, 193, 194, 516)
_LIMITS = (158, 159, 191, 201, 307, 396)
_LOST = (3, 32, 209, 210, 279)


def problem(error: Exception, address: str) -> UserError | None:
    """Return what the user can do about an error; None if it is none of the user's.

    Args:
        error: of clickhouse-connect, or of the transport below it.
        address: the database, without password.
    """
    code = getattr(error, "code", None)
    said = str(error)
    if code in _AUTHENTICATION:
        return EngineError(
            f"{address} refuses the user or the password; the user stands in the address or in "
            "CLICKHOUSE_USER, the password in CLICKHOUSE_PASSWORD."
        )
    if code == 81:
        return EngineError(f"{address} names a database that is not there; create it, or name another.")
    if code == 497:
        found = _GRANT.search(said)
        grant = (
            f"GRANT {found[1]}" if found else "GRANT SELECT, INSERT, CREATE TABLE, ALTER DELETE, DROP"
        )
        return EngineError(f"The ClickHouse user lacks a privilege; ask for: {grant} TO the user.")
    if code == 164:
        return EngineError(
            "The ClickHouse user may only read: readonly = 2 lets gam-db check and report (it needs "
            "temporary tables and settings), readonly = 0 lets it write."
        )
    if code == 243 or "No space left on device" in said:
        return EngineError(FULL)
    if code == 241:
        return EngineError(
            "ClickHouse ran out of memory; give it more (max_memory_usage, max_server_memory_usage), or "
            "take fewer channels at a time."
        )
    if code in _LIMITS:
        return EngineError(
            "A limit of the ClickHouse user's profile or quota stopped a query "
            f"({getattr(error, 'name', None) or code}); lift it, or take fewer channels at a time."
        )
    if code in (372, 373) or (code == 60 and re.search(rf"\b{MARK}[0-9]+_", said)):
        return EngineError(
            f"{address} does not keep the temporary tables of a session: does a load balancer stand "
            "before several servers? Give the address of one of them, or let it send one session_id to "
            "one server."
        )
    if "cannot be safely converted" in said:
        return SourceError(
            "A value of the source cannot be read as what its column must be (a counter needs 64 bits); "
            "leave it out by where=, or cast the column in a view."
        )
    if code in _LOST or (code is None and _is_transport(error)):
        return LostConnectionError(
            f"The connection to {address} was lost or refused; is the server there? What was written "
            "before is as it was: run it again."
        )
    return None


def _is_transport(error: Any) -> bool:
    return type(error).__name__ in ("OperationalError", "StreamFailureError") or isinstance(
        error, OSError
    )
