"""Many cases in one source: what an engine is asked once answers all of them.

The method is per channel, and settings go by patterns of assets. So a case keeps its rows, its settings
and its answers when its assets are given a prefix of their own and its settings become overrides for
that prefix; one study of all the rows then answers for every case.
"""

import dataclasses
from collections.abc import Callable, Iterable, Mapping
from typing import Any

import gam_db
import harness

Arguments = dict[str, Any]

#: name of a case -> its rows, and the keyword arguments of its parameters and its calibration
Cases = Mapping[str, tuple[list[harness.Row], Arguments, Arguments]]

#: The parameters and what each is where a case says nothing.
USUAL = {
    one.name: one.default for one in dataclasses.fields(gam_db.Parameters) if one.name != "overrides"
}


def sets_of(parameters: Arguments) -> list[Arguments]:
    """Return the complete parameters of a case, set by set: the first that matches applies, alone.

    Each has the patterns "asset" and "channel" as well; the last is the general one.
    """
    general = {**USUAL, **parameters}
    sets = []
    for own in [*general.pop("overrides", []), {}]:
        stride = {"stride": None} if "window" in own else {}
        sets.append({"asset": "*", "channel": "*", **general, **stride, **own})
    return sets


def rules_of(calibration: Arguments) -> list[tuple[str, Arguments | None]]:
    """Return the rules of a case with the pattern of each: the first that matches applies."""
    apart = ("overrides", "pool", "reference")
    general = {name: value for name, value in calibration.items() if name not in apart}
    of, own = harness.made({}, calibration)[1], calibration.get("overrides", {})
    rules = [
        (pattern, None if rule is None else general if rule is of else own[pattern])
        for pattern, rule in of.cases
    ]
    return rules if "*" in dict(rules) else [*rules, ("*", general)]


class Gathered:
    """Cases in one source.

    Attributes:
        rows: of all of them.
        parameters, calibration: under which they keep their meaning.
        prefixes: what stands before the assets of each case.
    """

    def __init__(self, cases: Cases) -> None:
        self.rows: list[harness.Row] = []
        self.prefixes = {name: f"{number:03}:" for number, name in enumerate(cases)}
        sets: list[Arguments] = []
        rules: dict[str, Arguments | None] = {}
        pool: list[list[str]] = []
        for name, (rows, parameters, calibration) in cases.items():
            prefix = self.prefixes[name]
            self.rows += [(prefix + row[0], *row[1:]) for row in rows]
            sets += [{**one, "asset": prefix + one["asset"]} for one in sets_of(parameters)]
            rules |= {prefix + pattern: rule for pattern, rule in rules_of(calibration)}
            groups = calibration.get("pool") or []
            groups = [["*"]] if groups == "channel" else groups
            pool += [[prefix + pattern for pattern in group] for group in groups]
        general = {name: sets[0][name] for name in USUAL}
        apart = [one for one in sets if any(one[name] != value for name, value in general.items())]
        self.parameters, self.calibration = harness.made(
            {**general, "overrides": sets if apart else []},
            # Rules say of each machine what it teaches: here none is there because another is named.
            {"overrides": rules, "pool": pool or None, "reference": ["*"] if pool else []},
        )

    def answers(self, found: Mapping[str, harness.Answer], name: str) -> dict[str, harness.Answer]:
        """Return the rows of one case among those of all, its assets called as the case calls them."""
        prefix = self.prefixes[name]
        return {
            question: [
                {
                    name: value.replace(prefix, "")
                    if name in ("asset", "taught_by") and value
                    else value
                    for name, value in row.items()
                }
                for row in answer
                if row["asset"].startswith(prefix)
            ]
            for question, answer in found.items()
        }


def is_in_pieces(calibration: Arguments) -> bool:
    """Tell whether a calibration has all vectors of its source asked which samples are of it."""
    rules = [rule for _, rule in rules_of(calibration) if rule is not None]
    return any(
        rule.get("score_from") is not None or rule.get("exclude") or len(rule.get("intervals") or ()) > 1
        for rule in rules
    )


def each(cases: Iterable[str], compare: Callable[[str], None]) -> None:
    """Compare every case of a source, and name each one that is answered wrongly."""
    wrong = []
    for case in cases:
        try:
            compare(case)
        except AssertionError as error:
            wrong.append(f"{case}: {error}")
    assert not wrong, "\n".join(wrong)
