"""The overrides that say one thing of each channel, with as few patterns as do.

This module owns the choice of patterns. It knows no parameter: what is said is compared, no more.
"""

from collections import Counter
from collections.abc import Hashable, Mapping
from typing import TypeVar

from gam_db.errors import wrong
from gam_db.settings.parameters import pattern_matches

Name = tuple[str, str]
"""Asset and channel, or patterns of both."""
_Said = TypeVar("_Said", bound=Hashable)


def grouped(said: Mapping[Name, _Said]) -> list[tuple[Name, _Said]]:
    """Return patterns of asset and channel with what each says, the first that matches being the one.

    What most channels have in common comes last; before it stand the assets, or the channels of one
    name, most of which differ from that in the same way, and before these single ones.

    Raises:
        ParameterError: names that hold ``*`` or ``?`` cannot be told apart by patterns.
    """
    if not said:
        return []
    for rules in (*sorted((_nested(said, place) for place in (1, 0)), key=len), list(said.items())):
        rules.sort(key=lambda rule: _width(rule[0]))
        if _is_met(said, rules):
            return rules
    raise wrong("patterns_in_names")


def _is_met(said: Mapping[Name, _Said], rules: list[tuple[Name, _Said]]) -> bool:
    """Tell whether rules say what they are to; only a sign of patterns in a name can spoil that."""
    if not any(sign in part for name in said for part in name for sign in "*?"):
        return True
    return all(
        of == next(met for pattern, met in rules if all(map(pattern_matches, pattern, name)))
        for name, of in said.items()
    )


def _nested(said: Mapping[Name, _Said], place: int) -> list[tuple[Name, _Said]]:
    """Return rules that go by asset (place 0) or by channel (1) first."""
    overall = _commonest(list(said.values()))
    groups: dict[str, list[Name]] = {}
    for name in said:
        groups.setdefault(name[place], []).append(name)
    rules: list[tuple[Name, _Said]] = [(("*", "*"), overall)]
    for key, names in groups.items():
        common = _commonest([said[name] for name in names])
        apart = [name for name in names if said[name] != common]
        others = [name for name in names if said[name] != overall]
        if len(apart) + 1 < len(others) or (len(others) == 1 == len(names)):
            rules.append((("*", key) if place else (key, "*"), common))
            others = apart
        rules += [(name, said[name]) for name in others]
    return rules


def _commonest(values: list[_Said]) -> _Said:
    return Counter(values).most_common(1)[0][0]


def _width(pattern: Name) -> tuple[int, int]:
    """Return what is less for a pattern that names fewer channels, as far as that can be told."""
    whole = sum(part == "*" for part in pattern)
    return whole, sum(part.count(sign) for part in pattern for sign in "*?") - whole
