"""Overrides that set one value for each channel, with as few patterns as possible.

This module owns the choice of patterns. It knows no parameters: it only compares values.
"""

from collections import Counter
from collections.abc import Hashable, Mapping
from typing import TypeVar

from gam_db.errors import wrong
from gam_db.settings.parameters import pattern_matches

Name = tuple[str, str]
"""Asset and channel, or patterns of both."""
_Setting = TypeVar("_Setting", bound=Hashable)


def grouped(settings: Mapping[Name, _Setting]) -> list[tuple[Name, _Setting]]:
    """Return patterns of asset and channel, each with its value; the first that matches applies.

    What most channels have in common comes last; before it stand the assets, or the channels of one
    name, most of which differ from that in the same way, and before these single ones.

    Raises:
        ParameterError: names that hold ``*`` or ``?`` cannot be told apart by patterns.
    """
    if not settings:
        return []
    for rules in (
        *sorted((_nested(settings, place) for place in (1, 0)), key=len),
        list(settings.items()),
    ):
        rules.sort(key=lambda rule: _width(rule[0]))
        if _is_met(settings, rules):
            return rules
    raise wrong("patterns_in_names")


def _is_met(settings: Mapping[Name, _Setting], rules: list[tuple[Name, _Setting]]) -> bool:
    """Tell whether rules give the right values; only a wildcard in a name can break that."""
    if not any(sign in part for name in settings for part in name for sign in "*?"):
        return True
    return all(
        of == next(met for pattern, met in rules if all(map(pattern_matches, pattern, name)))
        for name, of in settings.items()
    )


def _nested(settings: Mapping[Name, _Setting], place: int) -> list[tuple[Name, _Setting]]:
    """Return rules that go by asset (place 0) or by channel (1) first."""
    overall = _commonest(list(settings.values()))
    groups: dict[str, list[Name]] = {}
    for name in settings:
        groups.setdefault(name[place], []).append(name)
    rules: list[tuple[Name, _Setting]] = [(("*", "*"), overall)]
    for key, names in groups.items():
        common = _commonest([settings[name] for name in names])
        apart = [name for name in names if settings[name] != common]
        others = [name for name in names if settings[name] != overall]
        if len(apart) + 1 < len(others) or (len(others) == 1 == len(names)):
            rules.append((("*", key) if place else (key, "*"), common))
            others = apart
        rules += [(name, settings[name]) for name in others]
    return rules


def _commonest(values: list[_Setting]) -> _Setting:
    return Counter(values).most_common(1)[0][0]


def _width(pattern: Name) -> tuple[int, int]:
    """Return a sort key that is smaller for a pattern that matches fewer channels, if that is known."""
    whole = sum(part == "*" for part in pattern)
    return whole, sum(part.count(sign) for part in pattern for sign in "*?") - whole
