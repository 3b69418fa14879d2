"""Addresses of databases: the path of a DuckDB file, or a URL.

This module owns what an address looks like, and that no password is shown or kept in a file.
"""

from urllib.parse import SplitResult, urlsplit

from gam_db.errors import EngineError

#: The environment variable that names the database where no option and no gam.toml does.
VARIABLE = "GAM_DATABASE"


def is_url(address: str) -> bool:
    """Tell whether an address is a URL, not the path of a DuckDB file."""
    return "://" in address


def has_password(address: str) -> bool:
    """Tell whether a password stands in an address."""
    return is_url(address) and _split(address).password is not None


def shown(address: str) -> str:
    """Return an address without its password."""
    if not has_password(address):
        return address
    parts = _split(address)
    person, _, place = parts.netloc.rpartition("@")
    return parts._replace(netloc=f"{person.partition(':')[0]}@{place}").geturl()


def _split(address: str) -> SplitResult:
    try:
        return urlsplit(address)
    except ValueError as error:
        raise EngineError("The address of the database is no URL; brackets in it are open.") from error
