"""Who teaches a pool: references and calibrations of machines, in Python, gam.toml and options."""

import itertools
import re
from pathlib import Path
from typing import Any

import pytest
import typer
from typer.testing import CliRunner, Result

from gam_db import Calibration
from gam_db.cli import options
from gam_db.cli.config import Settings
from gam_db.clock import TimeKind
from gam_db.errors import CalibrationError, UserError
from gam_db.settings.calibration import Rule, patterns_meet, resolve
from gam_db.settings.parameters import pattern_matches
from gam_db.stored.calibrating import number_of, without

KEPT: list[Settings] = []


@options.taking(*options.READ)
def taken(settings: Settings) -> None:
    """A command that keeps the settings it is called with."""
    KEPT.append(settings)


def asked(text: str, *words: str) -> Result:
    """What comes of calling it with options, beside a gam.toml with this text."""
    Path("gam.toml").write_text(text, encoding="utf-8")
    app = typer.Typer()
    app.command()(taken)
    return CliRunner().invoke(app, [*words])


def calibration_by(text: str, *words: str) -> Calibration:
    """The calibration that it is called with."""
    assert asked(text, *words).exit_code == 0
    return KEPT.pop().method()[1]


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every test works in a folder of its own."""
    monkeypatch.chdir(tmp_path)


def teaching(calibration: Calibration, *assets: str) -> list[str]:
    """The assets that a calibration lets teach anything."""
    rules, patterns = resolve(calibration, TimeKind.COUNTER), [name for name, _ in calibration.cases]
    return [asset for asset in assets if rules[number_of(asset, patterns)] != Rule()]


def test_patterns_meet_where_a_name_matches_both() -> None:
    """Each pair of patterns of up to 3 signs, by all names of up to 5: more are never needed."""
    patterns = ["".join(signs) for n in range(4) for signs in itertools.product("ab*?", repeat=n)]
    names = ["".join(signs) for n in range(6) for signs in itertools.product("ab", repeat=n)]
    found = {one: {name for name in names if pattern_matches(one, name)} for one in patterns}
    for one, other in itertools.product(patterns, repeat=2):
        assert patterns_meet(one, other) == bool(found[one] & found[other]), (one, other)


@pytest.mark.parametrize(
    ("arguments", "expected"),
    [
        ({}, "M1 M2 N1"),
        ({"pool": "channel"}, "M1 M2 N1"),
        ({"pool": "channel", "reference": "M1"}, "M1"),
        ({"pool": "channel", "reference": ["M*"]}, "M1 M2"),
        ({"pool": "channel", "reference": ["M1", "N?"]}, "M1 N1"),
        ({"pool": "channel", "reference": "X"}, ""),
        ({"pool": "channel", "overrides": {"M1": Calibration(duration=5)}}, "M1"),
        ({"pool": "channel", "overrides": {"X": Calibration(duration=5)}}, ""),
        ({"overrides": {"M1": Calibration(duration=5)}}, "M1 M2 N1"),  # no pool: each for itself
        ({"pool": "channel", "overrides": {"M1": None}}, "M2 N1"),  # excepted, nobody named
        ({"pool": "channel", "overrides": {"M1": Calibration(intervals=[])}}, "M2 N1"),
        (
            {"pool": "channel", "overrides": {"M1": Calibration(duration=5)}, "reference": "*"},
            "M1 M2 N1",
        ),
        ({"pool": "channel", "overrides": {"M1": None}, "reference": "M*"}, "M2"),
        ({"pool": [["M*"]], "overrides": {"M1": Calibration(duration=5)}}, "M1 N1"),
        ({"pool": [["M*"], ["N*"]], "reference": "M2"}, "M2 N1"),
        ({"pool": [["N*"], ["M*"]], "reference": "M2"}, "M2 N1"),
        ({"pool": [["M1"], ["M*", "N*"]], "overrides": {"N1": Calibration(duration=5)}}, "M1 N1"),
    ],
)
def test_who_teaches(arguments: dict[str, Any], expected: str) -> None:
    assert teaching(Calibration(**arguments), "M1", "M2", "N1") == expected.split()


def test_a_reference_learns_by_the_general_rule() -> None:
    rule = Calibration(0.5, pool="channel", overrides={"a": Calibration(duration=3)}, reference="b*")
    assert [pattern for pattern, _ in rule.cases] == ["a", "b*", "*"]
    general, of_a, of_b, others = resolve(rule, TimeKind.COUNTER)
    assert (of_a.duration, of_b, others) == (3, general, Rule())


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"reference": "M1"}, "there is no pool"),
        ({"reference": 5, "pool": "channel"}, r"reference is 5; it takes asset patterns, such as"),
        ({"reference": ["M1", 5], "pool": "channel"}, "it takes asset patterns"),
        (
            {"overrides": {"a": Calibration(pool="channel", reference="b")}},
            ("only the general calibration may"),
        ),
    ],
)
def test_what_is_no_reference_is_refused(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(CalibrationError, match=message):
        Calibration(**arguments)


@pytest.mark.parametrize("reference", [(), ("M*",), ("N1", "X")])
def test_an_interval_taken_out_names_nobody(reference: tuple[str, ...]) -> None:
    """What labels take out of the calibration of a machine leaves all others as they were."""
    calibration = Calibration(0.5, pool=[["M*", "N*"]], reference=reference, overrides={"M3": None})
    cut = without(calibration, {"M1": [(3, 4)], "M3": [(5, 6)]})
    assets = ("M1", "M2", "M3", "N1")
    assert teaching(cut, *assets) == teaching(calibration, *assets)
    rules, patterns = resolve(cut, TimeKind.COUNTER), [name for name, _ in cut.cases]
    is_teaching = "M1" in teaching(calibration, *assets)
    assert len(rules[number_of("M1", patterns)].allowed) == (2 if is_teaching else 0)
    assert without(calibration, {}) == calibration


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--calibrate", "0/9", "--calibrate", "M3=false"], "intervals=[['0','9']]\noverrides.M3=false"),
        (
            ["--calibrate", "M1=0/9", "--calibrate", "M1=20/29"],
            "overrides.M1.intervals=[['0','9'],['20','29']]",
        ),
        (["--calibration-fraction", "M1=0.5"], "overrides.M1.fraction=0.5"),
        (
            ["--calibration-fraction", "0.3", "--calibration-fraction", "M1=0.5"],
            "fraction=0.3\noverrides.M1.fraction=0.5",
        ),
        (["--calibration-duration", "M?=30 d"], "overrides.'M?'.duration='30 d'"),
        (["--calibration-duration", "M1=30"], "overrides.M1.duration=30"),
        (
            [
                "--calibrate",
                "M1=0/9",
                "--exclude",
                "M1=3/4",
                "--exclude",
                "5/6",
                "--score-from",
                "M1=12",
            ],
            "exclude=[['5','6']]\n"
            "overrides.M1={intervals=[['0','9']], exclude=[['3','4']], score_from='12'}",
        ),
        (
            ["--pool", "channel", "--reference", "M*", "--reference", "N"],
            "pool='channel'\nreference=['M*','N']",
        ),
        # An asset goes before a pattern that would hide it.
        (
            ["--calibration-fraction", "M*=0.5", "--calibrate", "M1=false"],
            "overrides.M1=false\noverrides.'M*'.fraction=0.5",
        ),
    ],
)
def test_options_say_what_a_file_says(words: list[str], text: str) -> None:
    said, written = calibration_by("", *words), calibration_by(f"[calibration]\n{text}")
    assert said == written
    assert list(said.overrides) == list(written.overrides)


def test_an_option_goes_before_the_file() -> None:
    file = "[calibration.overrides]\nM1.fraction = 0.5\nM2.fraction = 0.6\n"
    rules = calibration_by(file, "--calibrate", "M1=false").overrides
    assert rules == {"M1": None, "M2": Calibration(0.6)}


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--calibration-fraction", "M1=half"], "--calibration-fraction is 'half'; it takes a number"),
        (["--calibration-fraction", "0.1", "--calibration-fraction", "0.2"], "given twice"),
        (["--exclude", "M1=0/5"], "--exclude names 'M1', which has no calibration of its own"),
        (["--calibrate", "M1=false", "--calibrate", "M1=0/9"], "--calibrate is 'false'; write FROM/TO"),
        (["--calibrate", "M1=false", "--calibration-fraction", "M1=0.2"], "write FROM/TO|takes one of"),
    ],
)
def test_options_that_say_nothing_clear_are_refused(words: list[str], message: str) -> None:
    refusal = asked("", *words).exception
    assert isinstance(refusal, UserError)
    assert re.search(message, refusal.options)
