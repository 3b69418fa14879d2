"""What the user can do about an error of ClickHouse, by its code."""

import re

from gam_db.engines.refusals import refusal
from gam_db.errors import UserError

#: What the temporary tables of a session begin with.
MARK = "gam_"

_GRANT = re.compile(r"the grant (.+?)(?:\. \(ACCESS_DENIED\)|\.?$)", re.MULTILINE)


def problem(error: Exception, address: str) -> UserError | None:
    """Return what the user can do about an error; None if it is none of the user's.

    It is one of clickhouse-connect or of the transport below; the address has no password.
    """
    code, said = getattr(error, "code", None), str(error)
    if code is None and (
        isinstance(error, OSError) or type(error).__name__ in ("OperationalError", "StreamFailureError")
    ):
        code = "transport"
    found = _GRANT.search(said)
    return refusal(
        *("clickhouse", str(code), f"{code} {said}"),
        address=address,
        grant=found[1] if found else "SELECT, INSERT, CREATE TABLE, ALTER DELETE, DROP",
        name=getattr(error, "name", None) or code,
    )
