"""Errors of PostgreSQL in the user's terms: by SQLSTATE, else by the English text of libpq."""

import re
from typing import Any

from gam_db.engines.refusals import refusal, refused
from gam_db.errors import UserError, wrong

#: SQLSTATE of a name that is not found: of a table, function or operator, type, schema
_UNKNOWN = ("42P01", "42883", "42704", "3F000")

_DENIED = re.compile(r"permission denied (?:for|to create temporary tables in) (\w+) (.+)")
_TARGET = re.compile(r'(INSERT INTO|UPDATE|DELETE FROM|CREATE)\b[^"]*((?:"[^"]+"\.)?"[^"]+")')


def of_connecting(message: str, place: str) -> UserError:
    """Return why there is no connection to a server, whose place is empty if the address means none.

    What libpq says is not shown, since it can hold parts of a password.
    """
    if not place:
        return wrong("postgres_no_address")
    return refused("postgres_connecting", message.lower(), place=place)


def of_statement(error: Any, statement: str, closed: bool) -> UserError | None:
    """Return what the user can do about a statement that was refused; None if it is our fault."""
    state, message = error.sqlstate or "", error.diag.message_primary or ""
    if state == "42501" and not closed:
        return _denied(message, statement)
    if state in _UNKNOWN and not closed and "function" in (error.diag.context or ""):
        return wrong("postgres_function", said=message)
    return refusal("postgres", "closed" if closed else state, f"{state} {message}")


def _denied(message: str, statement: str) -> UserError:
    """Return which privilege is missing, and of what."""
    if (match := _DENIED.search(message)) is None:
        return wrong("postgres_denied", said=message)
    kind, name = match[1], match[2].strip('"')
    target = _TARGET.match(statement)
    privilege = "SELECT"
    if "temporary" in message:
        privilege = "TEMPORARY"
    elif kind in ("schema", "database"):
        creating = statement.startswith("CREATE") and not statement.startswith("CREATE TEMP")
        privilege = "CREATE" if creating else "USAGE"
    elif target is not None and target[2].rpartition(".")[2].strip('"') == name:
        privilege = target[1].partition(" ")[0]
    return wrong("postgres_privilege", privilege=privilege, kind=kind.upper(), name=name)
