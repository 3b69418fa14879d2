"""Wrong arguments of public calls end in one short sentence that speaks of Python."""

import inspect
import re
from collections.abc import Callable, Iterator
from types import MethodType
from typing import Any

import numpy as np
import pyarrow as pa
import pytest

import gam_db
from gam_db import UserError, plot
from gam_db.errors import ArgumentError, ConfigurationError

LONGEST = 300
SIGNAL = np.sin(np.arange(200) / 7)
TABLE = pa.table({"time": range(200), "value": SIGNAL})
NAMED = gam_db.Source(TABLE, asset=None, channel=None)

#: Public classes that are made by gam-db alone, or are errors.
MADE = {
    *("Detection", "Evaluation", "Selection", "Summary"),
    *("GamError", "UserError", "CalibrationWarning"),
}
CALLABLES: dict[str, Callable[..., Any]] = {
    name: getattr(gam_db, name) for name in gam_db.__all__ if name not in {*MADE, "__version__"}
}
CALLABLES |= {"plot.signal": plot.signal, "plot.fleet": plot.fleet}
CALLABLES |= {
    f"Monitor.{name}": MethodType(method, object())
    for name, method in vars(gam_db.Monitor).items()
    if not name.startswith("_") and inspect.isfunction(method)
}
OF_SOURCES = [name for name, one in CALLABLES.items() if "source" in inspect.signature(one).parameters]


def refused(call: Callable[[], object], of: type[Exception] = UserError) -> str:
    """Return the sentence in which a call ends."""
    with pytest.raises(of) as caught:
        call()
    said = str(caught.value)
    assert isinstance(caught.value, UserError)
    assert len(said) <= LONGEST, (len(said), said)
    assert "--" not in said, said
    assert "\n" not in said
    assert re.search(r"[.?]$", said), said
    assert not re.search(r"[.?!] +[A-Z]", said), f"more than one sentence: {said}"
    return said


def filled(name: str) -> dict[str, Any]:
    """Return arguments with which a call can be made as far as their names go."""
    known = inspect.signature(CALLABLES[name]).parameters.values()
    needed = [one for one in known if one.default is one.empty and one.kind is one.POSITIONAL_OR_KEYWORD]
    return {one.name: None for one in needed}


def test_every_public_callable_is_asked() -> None:
    assert set(gam_db.__all__) == {name for name in CALLABLES if "." not in name} | MADE | {
        "__version__"
    }
    assert {"Monitor.score", "plot.fleet", "summary", "Calibration"} <= CALLABLES.keys()
    assert len(OF_SOURCES) >= 15


@pytest.mark.parametrize("name", CALLABLES)
def test_a_misspelt_argument_is_named_with_the_nearest(name: str) -> None:
    parameters = inspect.signature(CALLABLES[name]).parameters
    known = [one for one in parameters if one not in ("self", "changes", "search")]
    if not known:
        said = refused(lambda: CALLABLES[name](**filled(name), everythign=1), TypeError)
        assert said == f"{name} has no argument 'everythign'."
        return
    longest = max(known, key=len)
    misspelt = longest[:-2] + longest[-1] + longest[-2] + "x"
    said = refused(lambda: CALLABLES[name](**{**filled(name), misspelt: 1}))
    called = name.removeprefix("plot.")
    if name == "Override":
        assert said == f"There is no parameter {misspelt!r}; did you mean {longest!r}?" or "tau" in said
    else:
        assert said == f"{called} has no argument {misspelt!r}; did you mean {longest!r}?"


@pytest.mark.parametrize("name", [one for one in CALLABLES if filled(one)])
def test_a_missing_argument_is_named(name: str) -> None:
    said = refused(lambda: CALLABLES[name](), TypeError)
    assert re.search(r"missing a required (positional )?argument: '\w+'\.$", said)


@pytest.mark.parametrize("name", OF_SOURCES)
@pytest.mark.parametrize(
    "argument", ["parameters", "calibration", "alarms", "asked", "conventions", "wishes"]
)
def test_settings_of_another_type_are_named(name: str, argument: str) -> None:
    if argument not in inspect.signature(CALLABLES[name]).parameters:
        return
    for value, kind in (({"m": 3}, "dict"), (3, "int"), ([1], "list"), ("1 d", "str")):
        given = {**filled(name), "source": NAMED, argument: value}
        if name == "render":
            given |= {"form": "view", "engine": "duckdb"}
        said = refused(lambda given=given: CALLABLES[name](**given), ArgumentError)  # type: ignore[misc]
        assert said.startswith(f"{argument} of {name} is a {kind}; it takes gam_db.")


def wrong_sources() -> Iterator[tuple[str, Any]]:
    pandas = pytest.importorskip("pandas", reason="it comes with the extra engines")
    many = pandas.DataFrame({f"a text column {n}": ["x"] for n in range(40)} | {"time": [1]})
    yield from {
        "None": None,
        "number": 5,
        "numbers": [1.0, 2.0],
        "rows": [{"time": 1, "value": 2.0}],
        "dict": {"time": [1], "value": [2.0]},
        "set": {1.0},
        "bytes": b"telemetry",
        "name of nothing": "telemetry",
        "two dimensions": np.zeros((9, 2)),
        "array of objects": np.array([1, None]),
        "series of objects": pandas.Series([1, "a"]),
        "objects": pandas.DataFrame({"time": [1, 2], "value": [1, "a"]}),
        "texts": pandas.DataFrame({"time": [1, 2], "value": ["1,5", "2"]}),
        "numbers as texts": pandas.DataFrame({"time": [1, 2], "value": ["1.5", "2"]}),
        "times as texts": pandas.DataFrame({"time": ["a", "b"], "value": [1, 2]}),
        "no readings": pandas.DataFrame({"time": [1, 2]}),
        "many columns": many,
        "truths of time": pandas.DataFrame({"time": [True, False], "value": [1, 2]}),
    }.items()


@pytest.mark.parametrize("name", [one for one in OF_SOURCES if one not in ("Monitor", "render")])
def test_a_source_that_is_none_is_refused(name: str) -> None:
    call = CALLABLES[name]
    for what, source in wrong_sources():
        given = {**filled(name), "source": source}
        said = refused(lambda given=given: call(**given))  # type: ignore[misc]
        assert len(said) > 20, what


@pytest.mark.parametrize("name", ["Monitor", "render"])
def test_calls_that_take_sources_alone_say_so(name: str) -> None:
    for _, source in wrong_sources():
        given = {"form": "view", "engine": "duckdb", "source": source}
        if name == "Monitor":
            given = {"engine": None, "source": source}
        said = refused(lambda given=given: CALLABLES[name](**given))  # type: ignore[misc]
        assert said.endswith("; it takes gam_db.Source or gam_db.WideSource.")


@pytest.mark.parametrize("name", OF_SOURCES)
def test_an_engine_that_is_none_is_refused(name: str) -> None:
    if name == "render":
        said = refused(lambda: gam_db.render("view", "duk", NAMED))
        assert said == "There is no engine 'duk'; did you mean 'duckdb'?"
        return
    for engine in (5, [1], {"database": "x"}):
        given = {**filled(name), "source": NAMED, "engine": engine}
        said = refused(lambda given=given: CALLABLES[name](**given))  # type: ignore[misc]
        assert said.startswith(("The database is a ", "The source names no program column"))


@pytest.mark.parametrize("name", ["Source", "WideSource", "Parameters", "Calibration", "Alarms"])
def test_a_setting_of_another_type_is_refused(name: str) -> None:
    """Each keyword, given what no setting takes."""
    parameters = inspect.signature(CALLABLES[name]).parameters
    for keyword in parameters:
        if keyword in ("relation", "where", "time_kind", "clock_tolerance", "score_from"):  # when read
            continue
        given = {**({"relation": TABLE} if "relation" in parameters else {}), keyword: object}
        said = refused(lambda given=given: CALLABLES[name](**given))  # type: ignore[misc]
        assert keyword in said


def test_methods_of_a_monitor_take_what_they_say() -> None:
    monitor = gam_db.Monitor(None, NAMED)
    truth, text = "it takes True or False.", "it takes a text."
    for name, argument, value, said in (
        ("calibrate", "again", "yes", f"is a str; {truth}"),
        ("score", "full", 1, f"is a int; {truth}"),
        ("health", "asset", 3, f"is a int; {text}"),
        ("label", "kind", 3, f"is a int; {text}"),
        ("limits", "reason", None, f"is a NoneType; {text}"),
        ("prune", "keep_versions", "1", "is a str; it takes an integer or None."),
        ("report", "wishes", {}, "is a dict; it takes gam_db.Wishes or None."),
    ):
        given = {**filled(f"Monitor.{name}"), argument: value}
        call = getattr(monitor, name)
        expected = f"{argument} of Monitor.{name} {said}"
        assert refused(lambda call=call, given=given: call(**given), ArgumentError) == expected  # type: ignore[misc]
    with pytest.raises(UserError, match="state"):
        monitor.prune(keep_versions=np.int64(3))  # type: ignore[arg-type]


def test_options_of_the_command_line_become_arguments() -> None:
    for options, arguments in (
        ("say --null N/A, or --no-asset", "say null='N/A', or asset=None"),
        ("--thousands . --decimal , would read them", "thousands='.' decimal=',' would read them"),
        ("--time-format '%d.%m.%Y' reads it.", "time_format='%d.%m.%Y' reads it."),
        ("All; --clock-tolerance none accepts them", "All; clock_tolerance=False accepts them"),
        ("leave --source-time-zone out", "leave source_time_zone out"),
        ("by --calibrate FROM/TO.", "by intervals=FROM/TO."),
        ("say --asset COLUMN; the", "say asset=COLUMN; the"),
    ):
        error = ConfigurationError(options)
        assert (str(error), error.options) == (arguments, options)
