"""Mappings, lists and values as YAML, which Python's library neither reads nor writes.

This module owns quoting: texts that could mean something else are written as JSON, which is YAML.
"""

import json
import re
from collections.abc import Mapping, Sequence
from typing import Any

_PLAIN = re.compile(r"[A-Za-z][A-Za-z0-9_+ .,;()'/<>=*-]*[A-Za-z0-9_.)]|[A-Za-z]")
_OTHERS = ("true", "false", "yes", "no", "on", "off", "null", "y", "n")


def text(of: Mapping[str, Any]) -> str:
    """Return a mapping of texts, numbers, truth values, lists and mappings as a YAML document."""
    return "\n".join(_lines(of)) + "\n"


def _lines(of: Any) -> list[str]:
    lines: list[str] = []
    if isinstance(of, Mapping):
        for key, value in of.items():
            if _is_nested(value):
                lines += [f"{_scalar(key)}:", *(f"  {line}" for line in _lines(value))]
            else:
                lines.append(f"{_scalar(key)}: {_inline(value)}")
        return lines
    for value in of:
        first, *rest = _lines(value) if _is_nested(value) else [_inline(value)]
        lines += [f"- {first}", *(f"  {line}" for line in rest)]
    return lines


def _is_nested(value: Any) -> bool:
    """Tell whether a value takes lines of its own: a mapping, or a list that holds one."""
    if isinstance(value, Mapping):
        return bool(value)
    return _is_list(value) and any(isinstance(part, Mapping) for part in value)


def _inline(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{}"
    if _is_list(value):
        return f"[{', '.join(_scalar(part, is_listed=True) for part in value)}]"
    return _scalar(value)


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str)


def _scalar(value: Any, is_listed: bool = False) -> str:
    is_plain = isinstance(value, str) and _PLAIN.fullmatch(value) and value.lower() not in _OTHERS
    if is_plain and not (is_listed and "," in value):
        return str(value)
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")
