"""Addresses of databases: the path of a DuckDB file, or a URL.

This module owns what an address looks like, and that no password is shown or kept in a file.
"""

import re

#: The environment variable that names the database where no option and no gam.toml does.
VARIABLE = "GAM_DATABASE"

#: A password among the options at the end of a URL.
_OPTION = re.compile(r"(?i)([?&])(?:ssl)?password=[^&]*&?")


def is_url(address: str) -> bool:
    """Tell whether an address is a URL, not the path of a DuckDB file."""
    return "://" in address


def has_password(address: str) -> bool:
    """Tell whether a password stands in an address."""
    return shown(address) != address


def shown(address: str) -> str:
    """Return an address without its password.

    It is not parsed as a URL: a password with a sign that ought to be escaped would be taken for
    something else, and shown.
    """
    if not is_url(address):
        return address
    scheme, _, rest = address.partition("://")
    person, at, place = rest.rpartition("@")
    place = _OPTION.sub(r"\1", place).rstrip("?&")
    return f"{scheme}://{person.partition(':')[0]}{at}{place}"
