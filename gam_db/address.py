"""Addresses of databases: the path of a DuckDB file, or a URL.

This module owns what an address looks like, and that no password is shown or kept in a file.
"""

import re
from urllib.parse import urlsplit

from gam_db.errors import wrong

#: The environment variable that names the database where no option and no gam.toml does.
VARIABLE = "GAM_DATABASE"

#: Schemes of addresses in which no user and no password can stand.
_OF_FILES = ("duckdb", "sqlite", "chdb", "spark")

#: A password among the options at the end of a URL.
_OPTION = re.compile(r"(?i)([?&])(?:ssl)?password=[^&\s]*&?")

#: A token or the like among the parameters of Spark Connect: ``sc://host:443/;token=...``.
_PARAMETER = re.compile(r"(?i)(;)([^;=\s]*(?:token|password|secret|authorization)[^;=\s]*)=[^;\s]*")

#: A password in libpq's own words.
_WORD = re.compile(r"(?i)\b((?:ssl)?password\s*=\s*)('[^']*'|[^\s&]+)")

#: What libpq's own words begin with.
_LIBPQ = re.compile(r"(?i)(?:^|\s)(?:host|hostaddr|dbname|user|password|port|service)\s*=")

#: A user and a password in any text. To the last @: a password may hold one that ought to be escaped.
_PERSON = re.compile(r"(://[^\s:/@]*):\S*@")


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
        return _WORD.sub("", address) if _LIBPQ.search(address) else address
    scheme, _, rest = address.partition("://")
    if scheme == "sc":
        rest = _PARAMETER.sub("", rest)
    # A file or a folder is no person's, and its name may hold any sign.
    person, at, place = ("", "", rest) if rest.startswith("/") else rest.rpartition("@")
    if _OPTION.search(place):
        place = _OPTION.sub(r"\1", place).rstrip("?&")
    return f"{scheme}://{person.partition(':')[0]}{at}{place}"


def check(address: str) -> None:
    """Refuse an address with a user or a password where there can be none.

    Raises:
        EngineError: it is libpq's text, of an engine that knows no users, or cannot be read at all.
    """
    if not is_url(address):
        if _LIBPQ.search(address):
            raise wrong("libpq_words")
        return
    try:
        urlsplit(address)
    except ValueError:
        # Not chained: the message quotes the address.
        raise wrong("unreadable_address") from None
    scheme, _, rest = address.partition("://")
    is_file = rest.startswith("/")
    if scheme in _OF_FILES and (has_password(address) or (not is_file and "@" in rest)):
        raise wrong("user_in_address_of_files", scheme=scheme)


def without_passwords(text: str) -> str:
    """Return a text that may hold addresses without what looks like a password in one.

    The last net: messages of other libraries quote what they were given.
    """
    return _PARAMETER.sub(r"\1\2=***", _WORD.sub(r"\1***", _PERSON.sub(r"\1@", text)))
