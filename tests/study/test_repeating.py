"""Channels in which an instant occurs twice are done again, and no others, as the reference has them.

Which ones it were is asked for in each case, so that no case passes by the steps that look first.
"""

import math
import random
from collections.abc import Mapping, Sequence
from operator import itemgetter
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import comparisons
import engines
import gam_db
import gathering
import harness
import strategies
from gam_db.engines.session import Session
from gam_db.study import Study
from harness import Answer, Row

pytestmark = pytest.mark.thorough

#: Samples of a channel; the quota of the calibration below is the 64th.
LENGTH, QUOTA = 160, 64

Method = tuple[gam_db.Parameters, gam_db.Calibration]

#: Keyword arguments of parameters and of calibration.
Said = tuple[dict[str, Any], dict[str, Any]]


def method_of(parameters: dict[str, Any] | None = None, **calibration: Any) -> Said:
    own = {"m": 3, "tau": 2, "bins": 4, "window": 20, "stride": 5, **(parameters or {})}
    return own, calibration or {"fraction": 0.4}


def rows(lacking: Sequence[str] = ("ax",)) -> list[Row]:
    """Channels by time, of which some lack samples."""
    return [
        (asset, channel, 2 * time + number, sample(asset + channel, number, time, lacking))
        for time in range(LENGTH)
        for number, asset in enumerate("abc")
        for channel in "xy"
    ]


def sample(name: str, number: int, time: int, lacking: Sequence[str]) -> float | None:
    if name in lacking and time % 23 in (5, 6):
        return None
    return float(time % (5 + number) if time < 100 or time % 7 else time % 11) - 0.25


def again(table: list[Row], name: str, place: int, value: float | None = 7.5) -> list[Row]:
    """The same with a second reading of the sample of a channel that has a place in it."""
    number = [n for n, row in enumerate(table) if "".join(row[:2]) == name][place]
    return [*table[:number], (*table[number][:3], value), *table[number:]]


def done_again(study: Study) -> set[str]:
    """Return the channels that were done again."""
    if "again_channels" not in study.steps.steps:
        return set()
    return {row["asset"] + row["channel"] for row in study.rows("again_channels")}


def in_order(found: Answer) -> Answer:
    return sorted(found, key=lambda row: [(value is not None, value) for value in row.values()])


def novel_cells(session: Session, relation: str, method: Method) -> Answer:
    """The novel cells by the steps that look first."""
    study = Study(session, gam_db.Source(relation), *method)
    found = of_channels(study, study.table("novel_cells").to_pylist())
    study.forget()
    return found


def of_channels(study: Study, found: Answer) -> Answer:
    """Return novel cells with the names of their channels."""
    named = {row["channel_id"]: row for row in study.rows("channels")}
    return [
        {**row, **{name: named[row["channel_id"]][name] for name in ("asset", "channel")}}
        for row in found
    ]


#: What is asked for before single vectors, which go on from it.
ORDER = ("bucket_health", "support_summary", "novel_cells", "certificate")

QUESTIONS = {step: question for question, step in harness.STEPS.items()}


def asked_for(
    engine: str, table: list[Row], method: Method, asked: Sequence[str], order: Sequence[str]
) -> tuple[dict[str, Answer], set[str], bool]:
    """Return what a study answers, in some order, what was done again, and whether on trust.

    The answers are by step, with *cells*: the novel ones by the steps that look first.
    """
    session = engines.session(engine)
    with session.lent(harness.arrow(table)) as lent:
        source, cells = gam_db.Source(lent.name), novel_cells(session, lent.name, method)
        study = Study(session, source, *method, short_cuts=True, asked=asked)
        found = {"cells": cells}

        def ask(step: str) -> None:
            answer = study.table(step).to_pylist()
            answer = of_channels(study, answer) if step == "novel_cells" else answer
            harness.assert_same(found.setdefault(step, answer), answer, f"{step}, once more")

        for step in order:
            ask(step)
        names, is_trusting = done_again(study), study.is_trusting
        ask("health_indicator")
        study.forget()
    return found, names, is_trusting


def agrees(engine: str, found: Mapping[str, Answer], table: list[Row], method: Method) -> None:
    """Compare what was answered with the reference, and novel cells with those that were looked at."""
    expected = harness.all_by_reference(table, *method)
    for step in found.keys() - {"cells", "novel_cells"}:
        harness.assert_same(expected[QUESTIONS[step]], found[step], step)
    assert in_order(found.get("novel_cells", found["cells"])) == in_order(found["cells"])
    comparisons.compared(engine, "repeating", table, *method)


def answers(
    engine: str,
    table: list[Row],
    method: Method,
    asked: Sequence[str] = (),
    order: Sequence[str] = ORDER,
) -> tuple[set[str], bool]:
    """Compare what a study answers, in some order; return what was done again, and whether on trust."""
    found, names, is_trusting = asked_for(engine, table, method, asked, order)
    agrees(engine, found, table, method)
    return names, is_trusting


#: name -> the source, the method, and what is to be done again
CASES: dict[str, tuple[list[Row], Said, set[str]]] = {
    "in calibration": (again(rows(), "by", 30), method_of(), {"by"}),
    "the first of all": (again(rows(), "ax", 0), method_of(), {"ax"}),
    "before the first vector": (again(rows(), "by", 2), method_of(), {"by"}),
    "in the run-up": (again(rows(), "cx", QUOTA - 3), method_of(), {"cx"}),
    "at the quota": (again(rows(), "by", QUOTA - 1), method_of(), {"by"}),
    "right after it": (again(rows(), "by", QUOTA), method_of(), {"by"}),
    "while scoring": (again(rows(), "cy", 120), method_of(), {"cy"}),
    "the last of all": (again(rows(), "cy", LENGTH - 1), method_of(), {"cy"}),
    "after the last bucket": (again(rows(), "ay", LENGTH - 2, 0.75), method_of(), {"ay"}),
    "alike": (again(rows(), "by", 110, sample("by", 1, 110, ())), method_of(), {"by"}),
    "far away": (again(rows(), "by", 20, -1e6), method_of(), {"by"}),
    "with NULL beside": (again(rows(), "by", 90, None), method_of(), {"by"}),
    "with NaN beside": (again(rows(), "by", 40, math.nan), method_of(), {"by"}),
    "beside a missing one": (again(rows(), "ax", 28, 3.5), method_of(), {"ax"}),
    "missing twice": (again(rows(), "ax", 28, None), method_of(), {"ax"}),
    "of a channel that lacks samples": (again(rows(), "ax", 100), method_of(), {"ax"}),
    "none lacks samples": (again(rows(()), "ay", 100), method_of(), {"ay"}),
    "in two channels": (again(again(rows(), "ax", 30), "cy", 120), method_of(), {"ax", "cy"}),
    "three times": (again(again(rows(), "ax", 30), "ax", 30, -3.0), method_of(), {"ax"}),
    "one coordinate": (again(rows(), "bx", 99), method_of({"m": 1}), {"bx"}),
    "large keys": (again(rows(), "bx", 99), method_of({"m": 9, "tau": 1, "bins": 100}), {"bx"}),
    "a duration": (again(rows(), "bx", 45), method_of(duration=90), {"bx"}),
    "an interval": (again(rows(), "bx", 45), method_of(intervals=[(-5, 99)]), {"bx"}),
    "all of it": (again(rows(), "bx", 45), method_of(fraction=1.0), {"bx"}),
    "in a pool": (again(rows(), "by", 30), method_of(fraction=0.4, pool=[["a", "b"]]), {"ay", "by"}),
    "in a pool, while scoring": (
        again(rows(), "ax", 100),
        method_of(fraction=0.4, pool=[["a", "b"]]),
        {"ax", "bx"},
    ),
    "without calibration of its own": (
        again(rows(), "by", 30),
        method_of(fraction=0.4, pool=[["a", "b"]], overrides={"b": None}),
        {"ay", "by"},
    ),
    "of one of two sets": (
        again(rows(), "by", 70),
        method_of({"overrides": [{"channel": "y", "m": 1, "bins": 6}]}),
        {"by"},
    ),
    "of each of two sets": (
        again(again(rows(), "by", 20), "cx", 130),
        method_of({"overrides": [{"channel": "y", "m": 2, "bins": 6}]}),
        {"by", "cx"},
    ),
}


#: The case that every engine has in a source of its own.
ALONE = "at the quota"


#: Cases of one source at most: where rows are many, MariaDB takes longer for them than for two sources.
TOGETHER = 12


def grouped() -> dict[str, list[str]]:
    """Return the cases that are one source: those of one set of parameters, where some lack samples."""
    alike: dict[str, list[str]] = {}
    for name, (table, (parameters, _), _) in CASES.items():
        lacks = any(value is None for *_, value in table)
        alike.setdefault(repr((parameters, lacks, name == ALONE)), []).append(name)
    groups = [
        group[start : start + TOGETHER]
        for group in alike.values()
        for start in range(0, len(group), TOGETHER)
    ]
    return {
        f"{group[0]} and {len(group) - 1} others" if len(group) > 1 else group[0]: group
        for group in groups
    }


GROUPS = grouped()


def only_theirs_are_done_again(
    engine: str, names: Sequence[str], asked: Sequence[str] = (), order: Sequence[str] = ORDER
) -> None:
    """Compare cases that are one source, each by itself; a single one has its settings as written."""
    if len(names) == 1:
        table, said, expected = CASES[names[0]]
        assert answers(engine, table, harness.made(*said), asked, order) == (expected, True)
        return
    source = gathering.Gathered({name: (CASES[name][0], *CASES[name][1]) for name in names})
    method = source.parameters, source.calibration
    by_time = sorted(source.rows, key=itemgetter(2))
    found, again_of_all, is_trusting = asked_for(engine, by_time, method, asked, order)
    assert is_trusting

    def compare(name: str) -> None:
        table, said, expected = CASES[name]
        prefix = source.prefixes[name]
        own = {one.removeprefix(prefix) for one in again_of_all if one.startswith(prefix)}
        assert own == expected
        agrees(engine, source.answers(found, name), table, harness.made(*said))

    gathering.each(names, compare)


@pytest.mark.parametrize("group", GROUPS)
def test_only_its_channel_is_done_again(engine: str, group: str) -> None:
    """Of each case, in a source of all that have the same parameters."""
    only_theirs_are_done_again(engine, GROUPS[group])


@pytest.mark.parametrize("stored", ["by channel", "shuffled"])
@pytest.mark.parametrize("case", ["at the quota", "in two channels", "in a pool", "of each of two sets"])
def test_however_rows_lie(engine: str, case: str, stored: str) -> None:
    table, said, expected = CASES[case]
    lain = sorted(table, key=lambda row: row[:3])
    if stored == "shuffled":
        lain = random.Random(5).sample(table, len(table))
    assert answers(engine, lain, harness.made(*said)) == (expected, True)


#: What may be asked for first, where it is said that health alone will be, and what after it.
ORDERS: dict[str, Sequence[str]] = {
    "as it was said": ("bucket_health",),
    "novel cells after it": ("bucket_health", "novel_cells", "support_summary"),
    "the certificate after it": ("bucket_health", "certificate", "novel_cells"),
    "the summary after it": ("bucket_health", "support_summary", "certificate"),
    "single vectors before it": ("health_indicator", "bucket_health", "certificate"),
}


@pytest.mark.parametrize("order", ORDERS)
@pytest.mark.parametrize(
    "names", [("in calibration", "while scoring", "in a pool"), ("of each of two sets",)], ids=", ".join
)
def test_what_else_is_asked_for_is_answered(engine: str, names: Sequence[str], order: str) -> None:
    only_theirs_are_done_again(engine, names, ["bucket_health"], ORDERS[order])


@pytest.mark.parametrize("first", ["support_summary", "certificate"])
def test_what_proves_nothing_is_looked_at(engine: str, first: str) -> None:
    """Asked for before anything is scored."""
    table, said, _ = CASES["while scoring"]
    names, is_trusting = answers(engine, table, harness.made(*said), order=(first, *ORDER))
    assert (names, is_trusting) == (set(), False)


@pytest.mark.parametrize("case", ["in calibration", "while scoring"])
def test_where_half_of_all_is_done_again_the_study_begins_anew(engine: str, case: str) -> None:
    table, said, _ = CASES[case]
    for name in ("ax", "ay", "bx", "cx"):
        table = again(table, name, 30 if case == "in calibration" else 100)
    assert answers(engine, table, harness.made(*said)) == (set(), False)


def test_no_other_is_looked_at(engine: str) -> None:
    """No step reads the times of all channels to find what occurs twice."""
    table, said, _ = CASES["while scoring"]
    heard, session = list[str](), engines.session(engine)
    with session.lent(harness.arrow(table)) as lent:
        source = gam_db.Source(lent.name)
        asked = source, *harness.made(*said)
        study = Study(session, *asked, on_step=heard.append, short_cuts=True)
        study.table("bucket_health")
        study.table("support_summary")
        times = study.table("again_samples")["time"].to_pylist()
        study.forget()
    assert not {"timeline", "collapsed", "samples"} & set(heard)
    assert len(times) == LENGTH


@settings(max_examples=max(1, settings().max_examples // 8))
@given(st.data())
def test_random_sources_give_the_integers_of_the_reference(data: st.DataObject) -> None:
    table, parameters, calibration = data.draw(strategies.cases())
    chance = random.Random(data.draw(st.integers(0, 2**32 - 1)))
    first = {row[:3]: row for row in table}
    table = chance.sample(list(first.values()), len(first))
    for row in chance.sample(table, min(len(table), data.draw(st.integers(0, 3)))):
        value = chance.choice([row[3], None, math.nan, 0.5, -2.0, 1e300])
        table.insert(chance.randrange(len(table) + 1), (*row[:3], value))
    asked, order = data.draw(st.sampled_from([((), ORDER), (("bucket_health",), ORDER)]))
    for engine in ("duckdb", "sqlite"):
        answers(engine, table, harness.made(parameters, calibration), asked, order)
