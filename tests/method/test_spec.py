"""Specification tests: the tables of ``tests/spec``, worked out by hand, over every form of the method.

How a table is written is said in ``tests/spec/README.md``. This module only reads them; it computes
nothing of the method but the key of a cell that is written as its codes.
"""

import math
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

import gathering
import harness
import scripts

FOLDER = Path(__file__).parents[1] / "spec"
TEXTS = ("asset", "channel", "verdict", "taught_by")  # columns whose entries are words
ENDINGS = re.compile(r"(-?\d+)\.\.(-?\d+)")


@dataclass(frozen=True)
class Case:
    """One case of a file: what goes in, and per question the rows that must come out.

    Frozen: other modules ask these cases, too, and what one of them struck would be struck for all.
    """

    name: str
    parameters: dict[str, Any] = field(default_factory=lambda: {"range": "min_max"})
    calibration: dict[str, Any] = field(default_factory=dict)
    rows: list[harness.Row] = field(default_factory=list)
    expected: list[tuple[str, list[str], harness.Answer]] = field(default_factory=list)


def cases(path: Path) -> Iterator[Case]:
    """Read the cases of a file. Indented lines are data, what stands at the margin is prose."""
    _, *parts = re.split(r"^Case: ", path.read_text(encoding="utf-8"), flags=re.MULTILINE)
    for part in parts:
        title, _, text = part.partition("\n")
        case = Case(f"{path.stem}: {title.strip()}")
        indented = re.sub(r"^(?! {4}).*$", "", text, flags=re.MULTILINE)
        for block in re.split(r"\n\s*\n", indented):
            lines = [line.strip() for line in block.splitlines() if line.strip()]
            if lines:
                read_block(case, lines)
        assert case.rows, f"{case.name}: no source"
        assert case.expected, f"{case.name}: nothing is expected"
        yield case


def read_block(case: Case, lines: list[str]) -> None:
    if lines[0].startswith(("parameters", "calibration")):
        for line in lines:
            read_settings(case, line)
        return
    titles = [part.strip() for part in lines[0].split("|")]
    tables = [[line.split("|")[n].split() for line in lines[1:]] for n in range(len(titles))]
    if titles[0] == "source":
        case.rows.extend(row for entries in tables[0][1:] for row in readings(tables[0][0], entries))
        if len(titles) == 1:
            return
        assert titles[1:] == ["health_indicator"], case.name
        times = [entries[tables[0][0].index("time")] for entries in tables[0]]
        # Beside the source, an answer has the time of its line, and a line without entry has none.
        pairs = zip(times, tables[1], strict=True)
        beside = [[time, *entries] for time, entries in pairs if entries]
        expect(case, titles[1], beside)
    else:
        assert len(titles) == 1, f"{case.name}: {lines[0]}"
        expect(case, titles[0], tables[0])


def expect(case: Case, question: str, table: list[list[str]]) -> None:
    assert question in harness.QUESTIONS, f"{case.name}: there is no {question}"
    columns, *lines = table
    if lines == [["no", "rows"]]:
        lines = []
    answer = [
        {name: entry(name, text) for name, text in zip(columns, line, strict=True)} for line in lines
    ]
    case.expected.append((question, columns, answer))


def readings(columns: list[str], entries: list[str]) -> Iterator[harness.Row]:
    said = dict(zip(columns, entries, strict=True))
    ends = ENDINGS.fullmatch(said["time"])
    first, last = ends.groups() if ends else (said["time"], said["time"])
    value = None if said["value"] == "NULL" else float(said["value"])
    for time in range(int(first), int(last) + 1):
        yield said.get("asset", "a"), said.get("channel", "x"), time, value


def entry(column: str, text: str) -> Any:
    """The meaning of one entry: NULL, a word, codes, an integer, a ratio, a root, a decimal."""
    if text == "NULL":
        return None
    if column in TEXTS:
        return text.replace("_", " ") if column == "taught_by" else text
    if column == "cell":
        return tuple(int(code) for code in text.split(","))
    if text.startswith("sqrt("):
        return math.sqrt(Fraction(text[5:-1]))
    if "/" in text:
        return float(Fraction(text))
    return int(text) if re.fullmatch(r"-?\d+", text) else float(text)


def read_settings(case: Case, line: str) -> None:
    kind, given = re.split(r"\s{2,}", line, maxsplit=1)
    word, _, pattern = kind.partition(" of ")
    if word == "parameters":
        values: dict[str, Any] = {name: number(text) for name, text in pairs(given)}
        if pattern:
            asset, channel = pattern.split("/")
            values |= {"asset": asset, "channel": channel}
            case.parameters.setdefault("overrides", []).append(values)
        else:
            case.parameters.update(values)
    else:
        assert word == "calibration", f"{case.name}: {line}"
        rule = None if given == "none" else {name: of_rule(name, text) for name, text in pairs(given)}
        if pattern:
            case.calibration.setdefault("overrides", {})[pattern] = rule
        else:
            case.calibration.update(rule or {})


def pairs(given: str) -> Iterator[tuple[str, str]]:
    for part in given.split(","):
        name, _, text = part.partition("=")
        yield name.strip(), text.strip()


def number(text: str) -> float:
    return float(text) if "." in text else int(text)


def of_rule(name: str, text: str) -> Any:
    if name == "reference":
        return text.split()
    if name in ("intervals", "exclude"):
        return [(int(start), int(end)) for start, end in ENDINGS.findall(text)]
    if name == "pool":
        return text if text == "channel" else [group.split() for group in re.findall(r"\((.*?)\)", text)]
    return number(text)


def arguments_of(case: Case) -> tuple[Any, Any, Any]:
    """Return the rows of a case, its parameters and its calibration."""
    return (case.rows, *harness.made(case.parameters, case.calibration))


def compare(case: Case, answers: dict[str, harness.Answer]) -> None:
    """Compare the columns that the case names."""
    for question, columns, expected in case.expected:
        found = [{name: row[name] for name in columns if name != "cell"} for row in answers[question]]
        wanted = [{name: value for name, value in row.items() if name != "cell"} for row in expected]
        harness.assert_same(wanted, found, question)
        if "cell" in columns:
            radix = case.parameters["bins"] + 3
            keys = [sum(code * radix**k for k, code in enumerate(row["cell"])) for row in expected]
            assert keys == [row["cell_key"] for row in answers[question]]


FILES = sorted(FOLDER.glob("*.txt"))
CASES = [case for path in FILES for case in cases(path)]


def settings_of(case: Case) -> str:
    """Name the parameters of a case and the form of its vectors, in which it is like others."""
    sets = gathering.sets_of(case.parameters)
    usual = {**gathering.USUAL, "asset": "*", "channel": "*"}
    shown = [" ".join(f"{key}={one[key]}" for key in usual if one[key] != usual[key]) for one in sets]
    return f"{' or '.join(shown)}{', in pieces' * gathering.is_in_pieces(case.calibration)}"


def grouped() -> dict[str, list[Case]]:
    """Return the cases that can be one source, by how many there are and what they share."""
    groups: dict[str, list[Case]] = {}
    for case in CASES:
        groups.setdefault(settings_of(case), []).append(case)
    return {
        f"{len(group)} case{'s' * (len(group) > 1)}: {said}": group for said, group in groups.items()
    }


GROUPS = grouped()


def compare_all(group: list[Case], answered: Callable[..., dict[str, harness.Answer]]) -> None:
    """Let one source answer for all cases of a group, and name each case that it answers wrongly."""
    source = gathering.Gathered(
        {case.name: (case.rows, case.parameters, case.calibration) for case in group}
    )
    found = answered(source.rows, source.parameters, source.calibration)
    named = {case.name: case for case in group}
    gathering.each(named, lambda name: compare(named[name], source.answers(found, name)))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_case_by_reference(case: Case) -> None:
    compare(case, harness.all_by_reference(*arguments_of(case)))


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.name)
def test_case_alone(case: Case) -> None:
    """With no other case in its source, and its settings as they are written."""
    compare(case, harness.all_by_engine("sqlite", *arguments_of(case)))


@pytest.mark.parametrize("group", GROUPS)
def test_cases(group: str, engine: str) -> None:
    compare_all(GROUPS[group], lambda *asked: harness.all_by_engine(engine, *asked))


@pytest.mark.thorough
@pytest.mark.parametrize("group", GROUPS)
def test_cases_by_script(group: str, engine: str) -> None:
    """What the scripts answer: they write no buckets."""
    asked = [
        replace(case, expected=[one for one in case.expected if one[0] in scripts.RELATIONS])
        for case in GROUPS[group]
    ]
    compare_all(asked, lambda *asked: scripts.on(engine, *asked))


def test_every_file_has_cases() -> None:
    assert len(FILES) >= 9
    assert {path.stem for path in FILES} == {case.name.partition(":")[0] for case in CASES}
    assert len({case.name for case in CASES}) == len(CASES)
    assert sorted(case.name for group in GROUPS.values() for case in group) == sorted(
        case.name for case in CASES
    )


def test_each_case_that_is_answered_wrongly_is_named() -> None:
    """In a source of many, those whose rows differ are named, and no others."""
    group = next(group for group in GROUPS.values() if len(group) > 9)
    wrong = {group[2].name, group[7].name}

    def answered(rows: list[harness.Row], *settings: Any) -> dict[str, harness.Answer]:
        found = harness.all_by_reference(rows, *settings)
        for question, answer in found.items():
            prefixes = ("002:", "007:")
            found[question] = [row for row in answer if not row["asset"].startswith(prefixes)]
        return found

    compare_all(group, harness.all_by_reference)
    with pytest.raises(AssertionError) as error:
        compare_all(group, answered)
    assert {case.name for case in group if case.name in str(error.value)} == wrong


def test_a_wrong_entry_is_noticed() -> None:
    """Each kind of wrong table fails: a changed number, a wrong cell, a row too few, a row too many."""
    case = next(case for case in CASES if case.name == "eq4_novelty: inside a bin nothing is new")
    question, columns, answer = case.expected[0]
    wrong: list[harness.Answer] = [
        [{**answer[0], "novel": 1}, *answer[1:]],
        [{**answer[0], "cell": (5, 2)}, *answer[1:]],
        answer[1:],
        [*answer, answer[-1]],
    ]
    answers = harness.all_by_reference(*arguments_of(case))
    compare(case, answers)
    for table in wrong:
        with pytest.raises(AssertionError):
            compare(replace(case, expected=[(question, columns, table)]), answers)
