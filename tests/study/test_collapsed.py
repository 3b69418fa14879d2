"""Where an instant occurs twice, the steps run once more over collapsed readings: as the reference.

Each case asks whether they did, so that none passes by the steps that look first.
"""

import math
import random
from collections.abc import Mapping, Sequence
from operator import itemgetter
from pathlib import Path
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
from gam_db.study.running import RepeatedError, once_more
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
) -> tuple[dict[str, Answer], bool, str]:
    """Return what a study answers, in some order, whether readings were collapsed, and the form.

    The answers are by step, with *cells*: the novel ones by the steps that look first.
    """
    session = engines.session(engine)
    with session.lent(harness.arrow(table)) as lent:
        source, cells = gam_db.Source(lent.name), novel_cells(session, lent.name, method)
        study = Study(session, source, *method, short_cuts=True, targets=asked)
        found = {"cells": cells}

        def ask(step: str) -> None:
            answer = study.table(step).to_pylist()
            answer = of_channels(study, answer) if step == "novel_cells" else answer
            harness.assert_same(found.setdefault(step, answer), answer, f"{step}, once more")

        for step in order:
            ask(step)
        is_collapsed, form = study.is_collapsed, study.form
        ask("health_indicator")
        study.forget()
    return found, is_collapsed, form


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
) -> tuple[bool, str]:
    """Compare what a study answers, in some order; return whether it collapsed, and the form."""
    found, is_collapsed, form = asked_for(engine, table, method, asked, order)
    agrees(engine, found, table, method)
    return is_collapsed, form


#: name -> the source, and the method
CASES: dict[str, tuple[list[Row], Said]] = {
    "in calibration": (again(rows(), "by", 30), method_of()),
    "the first of all": (again(rows(), "ax", 0), method_of()),
    "before the first vector": (again(rows(), "by", 2), method_of()),
    "in the run-up": (again(rows(), "cx", QUOTA - 3), method_of()),
    "at the quota": (again(rows(), "by", QUOTA - 1), method_of()),
    "right after it": (again(rows(), "by", QUOTA), method_of()),
    "while scoring": (again(rows(), "cy", 120), method_of()),
    "the last of all": (again(rows(), "cy", LENGTH - 1), method_of()),
    "after the last bucket": (again(rows(), "ay", LENGTH - 2, 0.75), method_of()),
    "alike": (again(rows(), "by", 110, sample("by", 1, 110, ())), method_of()),
    "far away": (again(rows(), "by", 20, -1e6), method_of()),
    "with NULL beside": (again(rows(), "by", 90, None), method_of()),
    "with NaN beside": (again(rows(), "by", 40, math.nan), method_of()),
    "beside a missing one": (again(rows(), "ax", 28, 3.5), method_of()),
    "missing twice": (again(rows(), "ax", 28, None), method_of()),
    "of a channel that lacks samples": (again(rows(), "ax", 100), method_of()),
    "none lacks samples": (again(rows(()), "ay", 100), method_of()),
    "in two channels": (again(again(rows(), "ax", 30), "cy", 120), method_of()),
    "three times": (again(again(rows(), "ax", 30), "ax", 30, -3.0), method_of()),
    "one coordinate": (again(rows(), "bx", 99), method_of({"m": 1})),
    "large keys": (again(rows(), "bx", 99), method_of({"m": 9, "tau": 1, "bins": 100})),
    "a duration": (again(rows(), "bx", 45), method_of(duration=90)),
    "an interval": (again(rows(), "bx", 45), method_of(intervals=[(-5, 99)])),
    "all of it": (again(rows(), "bx", 45), method_of(fraction=1.0)),
    "in a pool": (again(rows(), "by", 30), method_of(fraction=0.4, pool=[["a", "b"]])),
    "in a pool, while scoring": (
        again(rows(), "ax", 100),
        method_of(fraction=0.4, pool=[["a", "b"]]),
    ),
    "without calibration of its own": (
        again(rows(), "by", 30),
        method_of(fraction=0.4, pool=[["a", "b"]], overrides={"b": None}),
    ),
    "of one of two sets": (
        again(rows(), "by", 70),
        method_of({"overrides": [{"channel": "y", "m": 1, "bins": 6}]}),
    ),
    "of each of two sets": (
        again(again(rows(), "by", 20), "cx", 130),
        method_of({"overrides": [{"channel": "y", "m": 2, "bins": 6}]}),
    ),
}


#: The case that every engine has in a source of its own.
ALONE = "at the quota"


#: Cases of one source at most: where rows are many, MariaDB takes longer for them than for two sources.
TOGETHER = 12


def grouped() -> dict[str, list[str]]:
    """Return the cases that are one source: those of one set of parameters, where some lack samples."""
    alike: dict[str, list[str]] = {}
    for name, (table, (parameters, _)) in CASES.items():
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


def readings_are_collapsed(
    engine: str, names: Sequence[str], asked: Sequence[str] = (), order: Sequence[str] = ORDER
) -> None:
    """Compare cases that are one source, each by itself; a single one has its settings as written."""
    if len(names) == 1:
        table, said = CASES[names[0]]
        assert answers(engine, table, harness.made(*said), asked, order) == (True, "census")
        return
    source = gathering.Gathered({name: (CASES[name][0], *CASES[name][1]) for name in names})
    method = source.parameters, source.calibration
    by_time = sorted(source.rows, key=itemgetter(2))
    found, is_collapsed, form = asked_for(engine, by_time, method, asked, order)
    assert (is_collapsed, form) == (True, "census")

    def compare(name: str) -> None:
        table, said = CASES[name]
        agrees(engine, source.answers(found, name), table, harness.made(*said))

    gathering.each(names, compare)


@pytest.mark.parametrize("group", GROUPS)
def test_the_steps_run_once_more(engine: str, group: str) -> None:
    """Of each case, in a source of all that have the same parameters."""
    readings_are_collapsed(engine, GROUPS[group])


@pytest.mark.parametrize("stored", ["by channel", "shuffled"])
@pytest.mark.parametrize("case", ["at the quota", "in two channels", "in a pool", "of each of two sets"])
def test_however_rows_lie(engine: str, case: str, stored: str) -> None:
    table, said = CASES[case]
    lain = sorted(table, key=lambda row: row[:3])
    if stored == "shuffled":
        lain = random.Random(5).sample(table, len(table))
    assert answers(engine, lain, harness.made(*said)) == (True, "census")


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
    readings_are_collapsed(engine, names, ["bucket_health"], ORDERS[order])


@pytest.mark.parametrize("first", ["support_summary", "certificate"])
def test_what_is_not_scored_is_proven_as_well(engine: str, first: str) -> None:
    """The summary of calibration, before anything of the scored vectors."""
    table, said = CASES["while scoring"]
    assert answers(engine, table, harness.made(*said), order=(first, *ORDER)) == (True, "census")


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


def test_there_is_a_single_fall_back() -> None:
    """Of studies, runs and checks: all else is chosen before the work."""
    package = Path(gam_db.__file__).parent
    catching = [
        path.relative_to(package).as_posix()
        for path in package.rglob("*.py")
        for _ in range(path.read_text(encoding="utf-8").count("except RepeatedError"))
    ]
    assert catching == ["study/running.py"]


def test_work_is_done_once_more_and_no_more_than_that() -> None:
    done = list[str]()

    def work() -> None:
        done.append("work")
        raise RepeatedError("An instant occurs twice.")

    with pytest.raises(RepeatedError):
        once_more(work, lambda: done.append("collapse"))
    assert done == ["work", "collapse", "work"]
