"""Values and comments as TOML, which Python's library reads but does not write.

This module owns quoting: any name that a column or a file can have comes back as it was.
"""

import datetime as dt
import json
import textwrap
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from gam_db.errors import ConfigurationError

_WIDTH = 100


def value(of: Any) -> str:
    """Return a text, a number, a truth value, a date, a time or a list of these as TOML."""
    if isinstance(of, dt.date):
        return of.isoformat()
    if isinstance(of, Sequence) and not isinstance(of, str):
        return f"[{', '.join(value(part) for part in of)}]"
    # JSON's escapes are TOML's, but TOML wants DEL escaped, too.
    text = json.dumps(of, ensure_ascii=False).replace("\x7f", "\\u007f")
    try:
        text.encode("utf-8")
    except UnicodeEncodeError as error:  # half of a UTF-16 pair
        raise ConfigurationError(f"{of!r} cannot be written as text; rename it.") from error
    return text


def comment(text: str) -> list[str]:
    """Return a text as comment lines; what is not printable becomes a mark."""
    shown = "".join(sign if sign.isprintable() else "\N{REPLACEMENT CHARACTER}" for sign in text)
    return [f"# {line}" for line in textwrap.wrap(shown, _WIDTH - 2, break_on_hyphens=False)]


def entries(values: Mapping[str, tuple[Any, str]], aside: Collection[str] = ()) -> list[str]:
    """Return lines of ``key = value  # comment`` with the comments under one another.

    Args:
        values: key -> (value, comment); a long comment goes before its line.
        aside: keys that are commented out.
    """
    written = {key: f"{'# ' * (key in aside)}{key} = {value(of)}" for key, (of, _) in values.items()}
    column = max((len(line) for line in written.values() if len(line) <= 40), default=0)
    lines = []
    for key, line in written.items():
        (_, remark) = values[key]
        beside = f"{line:{column}}  {' '.join(comment(remark))}"
        if not remark:
            lines.append(line)
        elif len(beside) <= _WIDTH and len(comment(remark)) == 1:
            lines.append(beside)
        else:
            lines += [*comment(remark), line]
    return lines
