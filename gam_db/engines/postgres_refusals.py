"""What PostgreSQL refuses, in the user's words: by SQLSTATE, else by what libpq says in English."""

import re
from typing import Any

from gam_db.engines.session import CONFLICT, FULL
from gam_db.errors import ConflictError, EngineError, LostConnectionError, SourceError, UserError

REFUSED_TRANSACTION = (
    "The connection to PostgreSQL is in a transaction that has failed, or still busy; roll it back, or "
    "give another connection."
)
LOST = (
    "The connection to PostgreSQL was lost; what was to be written was not, and the state is as before. "
    "Run it again."
)
READ_ONLY = (
    "This PostgreSQL session may only read: a standby, or default_transaction_read_only is on. gam-db "
    "keeps its steps in temporary tables; connect to the primary, or as a user without that setting."
)

NO_SCHEMA = (
    "The search_path of this PostgreSQL user names no schema that is there; give --schema, or make "
    "the schema."
)

#: SQLSTATE, or the class of it -> what is said
_SAID: dict[str, UserError] = {
    "08": LostConnectionError(LOST),
    "57P": LostConnectionError(LOST),
    "25006": EngineError(READ_ONLY),
    "25P02": EngineError(REFUSED_TRANSACTION),
    "40": ConflictError(CONFLICT),
    "55P03": ConflictError(CONFLICT),
    "23505": ConflictError(CONFLICT),
    "42P07": ConflictError(CONFLICT),
    "53100": EngineError(FULL),
    "58030": EngineError(FULL),
    "53200": EngineError(
        "PostgreSQL ran out of memory; give it more, lower work_mem, or score fewer channels at a time."
    ),
    "53400": EngineError(
        "PostgreSQL reached temp_file_limit; raise it for this user, or score fewer channels at a time."
    ),
    "57014": EngineError(
        "PostgreSQL cancelled a statement: somebody asked for it, or statement_timeout is too short for "
        "this work; raise it for this user (ALTER ROLE ... SET statement_timeout = 0)."
    ),
    "22003": SourceError(
        "A number or time of the source is beyond what doubles or 64 bits hold; leave such rows out by "
        "where=, or cast the column in a view."
    ),
    "22P02": SourceError(
        "A value of the source cannot be read as what its column must be (where= may ask for it, too); "
        "cast the column in a view."
    ),
    "22008": SourceError(
        "A time of the source is beyond the calendar of PostgreSQL; leave such rows out by where=."
    ),
}

#: SQLSTATE of a name that is not found: of a table, function or operator, type, schema
_UNKNOWN = ("42P01", "42883", "42704", "3F000")

#: What libpq and the server say of a refused connection, and what that means.
_CONNECTING = (
    (r"password authentication failed", "does not accept this user and password."),
    (r"no password supplied", "wants a password; set PGPASSWORD, or write it into ~/.pgpass."),
    (r'database ".*" does not exist', "has no such database."),
    (r'role ".*" does not exist', "has no such user."),
    (r"no pg_hba.conf entry|authentication failed", "does not let this user in (pg_hba.conf)."),
    (r"permission denied for database", "lets this user into no such database (GRANT CONNECT)."),
    (r"resolve host|translate host", "is not known by that name."),
    (r"SSL|certificate", "and this client do not agree on encryption; see sslmode."),
)

#: The same, of what passes by itself.
_PASSING = (
    (r"too many clients|connection slots", "has no room for another connection; try again in a while."),
    (r"starting up|shutting down|recovery mode", "is starting or stopping; try again in a while."),
    (r"refused|No such file", "does not answer: is it running, and does it listen there?"),
    (r"timeout|timed out", "does not answer in time: is it running, and is no firewall between?"),
)

_DENIED = re.compile(r"permission denied (?:for|to create temporary tables in) (\w+) (.+)")
_TARGET = re.compile(r'(INSERT INTO|UPDATE|DELETE FROM|CREATE)\b[^"]*((?:"[^"]+"\.)?"[^"]+")')


def of_connecting(said: str, place: str) -> EngineError:
    """Return why there is no connection.

    Args:
        said: by libpq; it is not shown, since it can hold parts of a password.
        place: of the server, for the message; empty if the address means none.
    """
    if not place:
        return EngineError(
            "The address of the database is none that PostgreSQL understands; write it like "
            "postgresql://user@host:5432/database."
        )
    for pattern, meaning in _PASSING:
        if re.search(pattern, said, re.IGNORECASE):
            return LostConnectionError(f"The PostgreSQL server at {place} {meaning}")
    for pattern, meaning in _CONNECTING:
        if re.search(pattern, said, re.IGNORECASE):
            return EngineError(f"The PostgreSQL server at {place} {meaning}")
    return EngineError(
        f"The PostgreSQL server at {place} cannot be reached, or does not let this user in."
    )


def of_statement(error: Any, statement: str, closed: bool) -> UserError | None:
    """Return what the user can do about a statement that was refused; None if it is our fault.

    Args:
        error: of psycopg.
        statement: that was run.
        closed: whether the connection is closed now.
    """
    state = error.sqlstate or ""
    if closed:
        return LostConnectionError(LOST)
    if state == "42501":
        return _denied(error.diag.message_primary or "", statement)
    if state == "XX000" and "concurrently" in (error.diag.message_primary or ""):
        return ConflictError(CONFLICT)
    if state in _UNKNOWN and "function" in (error.diag.context or ""):
        return SourceError(
            f"A function that the source calls looks names up on the search_path "
            f"({error.diag.message_primary}), which gam-db keeps to PostgreSQL's own schemas; give the "
            "function the path that it needs: ALTER FUNCTION ... SET search_path = ..."
        )
    for length in (5, 3, 2):
        found = _SAID.get(state[:length])
        if found is not None:
            return type(found)(*found.args)
    return None


def _denied(said: str, statement: str) -> EngineError:
    """Return which privilege is missing, and of what."""
    found = _DENIED.search(said)
    if found is None:
        return EngineError(
            f"PostgreSQL does not let this user do that ({said}); the owner of the tables can."
        )
    kind, name = found[1], found[2].strip('"')
    target = _TARGET.match(statement)
    privilege = "SELECT"
    if "temporary" in said:
        privilege = "TEMPORARY"
    elif kind in ("schema", "database"):
        creating = statement.startswith("CREATE") and not statement.startswith("CREATE TEMP")
        privilege = "CREATE" if creating else "USAGE"
    elif target is not None and target[2].rpartition(".")[2].strip('"') == name:
        privilege = target[1].partition(" ")[0]
    return EngineError(
        f"This PostgreSQL user lacks a privilege: GRANT {privilege} ON {kind.upper()} {name} TO it."
    )
