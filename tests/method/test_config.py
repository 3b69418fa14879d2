"""gam.toml and options: what is read, what is refused, and what replaces what."""

import dataclasses
import datetime as dt
import inspect
import re
from pathlib import Path
from typing import Any

import pytest

from gam_db import Calibration, Override, Parameters, config
from gam_db.config import MonitorSettings, Settings, SourceSettings
from gam_db.errors import CalibrationError, ConfigurationError
from gam_db.stored.tables import StateTables

OPTIONS: tuple[dict[str, Any], dict[str, Any], dict[str, Any]] = ({}, {}, {})


def read(folder: Path, text: str) -> Settings:
    """Settings of a file with this text."""
    path = folder / "gam.toml"
    path.write_text(text, encoding="utf-8")
    return config.load(path)


def documented() -> str:
    """The example of the module's own documentation."""
    _, _, example = inspect.getdoc(config).partition("::\n")  # type: ignore[union-attr]
    return inspect.cleandoc(example)


def test_the_documented_example(tmp_path: Path) -> None:
    """What the documentation shows is read, and means what it says there."""
    settings = read(tmp_path, documented())
    parameters, calibration = settings.method()
    assert settings.source == SourceSettings(
        relation=str(tmp_path / "telemetry.parquet"),
        asset="machine",
        channel="signal",
        time="ts",
        value="reading",
        where="reading < 1000",
    )
    assert parameters == Parameters(
        stride=100,
        max_gap="5 s",
        overrides=[Override(asset="robot_7", channel="temperature_*", tau=10, bins=20)],
    )
    assert calibration == Calibration(
        intervals=[(dt.date(2026, 3, 1), dt.datetime(2026, 3, 14, 18))],
        exclude=[(dt.datetime(2026, 3, 4, 6), dt.datetime(2026, 3, 4, 7, 30))],
        score_from=dt.date(2026, 3, 15),
        pool="channel",
        overrides={"robot_9*": Calibration(duration="30 d"), "robot_8": None},
    )
    assert settings.monitor == MonitorSettings(
        lookback="1 h", park_after="1 d", keep="400 d", keep_novel="90 d"
    )


def test_the_documented_alternatives(tmp_path: Path) -> None:
    """The lines that the example has as comments can be read, too."""
    text = re.sub("(?m)^# ", "", documented()).replace('asset = "machine"', "asset = false", 1)
    settings = read(tmp_path, text)
    assert settings.source.asset is False
    assert settings.source.database == str(tmp_path / "plant.duckdb")
    assert settings.source.layout == "wide"
    assert settings.source.channels == ("current", "torque")
    assert settings.source.time_kind == "timestamp"
    assert settings.monitor.tables == StateTables("monitoring", "gam_")


def test_the_example_holds_every_key() -> None:
    """A new parameter that nobody documents would be found here."""
    example = documented()
    for kind in (SourceSettings, Parameters, Calibration, MonitorSettings):
        for one in dataclasses.fields(kind):
            if one.name not in ("overrides", "fraction"):
                assert f"{one.name} = " in example, one.name
    assert "fraction" in example


@pytest.mark.parametrize(
    ("text", "meant"),
    [
        ("[sorce]\ntime = 't'", "source"),
        ("[parameter]\nm = 2", "parameters"),
        ("[source]\nchanel = 'x'", "channel"),
        ("[parameters]\nwindows = 2", "window"),
        ("[parameters]\nmaxgap = 2", "max_gap"),
        ("[[override]]\nasset = 'a'\nbin = 2", "bins"),
        ("[calibration]\nfracton = 0.5", "fraction"),
        ("[monitor]\nlook_back = 3", "lookback"),
        ("[monitors]\nname = 'x'", "monitor"),
        ("[calibration.overrides.R1]\nduraton = '3 d'", "duration"),
    ],
)
def test_an_unknown_key_is_refused_with_the_nearest_name(tmp_path: Path, text: str, meant: str) -> None:
    with pytest.raises(ConfigurationError, match=f"did you mean '{meant}'"):
        read(tmp_path, text)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("source = 3", r"\[source\]"),
        ("[source]\ntime = 3", "time in"),
        ("[source]\ntime = false", "time in"),
        ("[source]\nasset = ''", "asset in"),
        ("[source]\nchannels = 'x'", "channels in"),
        ("[source]\nlayout = 'wid'", "did you mean 'wide'"),
        ("[override]\nm = 3", r"\[\[override\]\]"),
        ("[[override]]\nasset = 3", "number 1"),
        ("[calibration]\nintervals = [1, 2]", "intervals in"),
        ("[calibration]\nexclude = 3", "exclude in"),
        ("[calibration]\npool = 3", "pool in"),
        ("[calibration]\noverrides = 3", "overrides in"),
        ("[calibration.overrides]\nR1 = true", "R1"),
        ("[calibration.overrides.R1]\npool = 'channel'", "pool"),
        ("monitor = 3", r"\[monitor\]"),
        ("[monitor]\nname = ''", r"name in \[monitor\]"),
        ("[monitor]\nname = 3", r"name in \[monitor\]"),
        ("[monitor]\nschema = false", r"schema in \[monitor\]"),
        ("[monitor]\nprefix = 3", r"prefix in \[monitor\]"),
        ("[monitor]\nprefix = 'a-b'", "letters, digits"),
        ("[monitor]\nlookback = true", "takes a length"),
        ("[monitor]\nkeep = [3]", "takes a length"),
        ("[source", "TOML"),
    ],
)
def test_a_value_of_the_wrong_shape_is_refused(tmp_path: Path, text: str, named: str) -> None:
    """The message names the file and the place."""
    with pytest.raises(ConfigurationError, match=named) as caught:
        read(tmp_path, text)
    assert "gam.toml" in str(caught.value)


def test_a_contradiction_is_refused(tmp_path: Path) -> None:
    settings = read(tmp_path, "[calibration]\nfraction = 0.5\nduration = '3 d'")
    with pytest.raises(CalibrationError, match="one of fraction, duration, intervals"):
        settings.method()


def test_the_default_file_may_be_missing_but_a_named_one_may_not(tmp_path: Path) -> None:
    assert config.load(folder=tmp_path) == Settings()
    with pytest.raises(ConfigurationError, match=r"other\.toml cannot be read"):
        config.load(tmp_path / "other.toml")
    (tmp_path / "gam.toml").write_text("[parameters]\nm = 2")
    assert config.load(folder=tmp_path).method()[0].m == 2


@pytest.mark.parametrize(
    ("relation", "is_moved"),
    [
        ("a.csv", True),
        ("sub/*.parquet", True),
        ("/data/a.csv", False),
        ("s3://b/a.parquet", False),
        ("a_table", False),
    ],
)
def test_paths_are_relative_to_the_file(tmp_path: Path, relation: str, is_moved: bool) -> None:
    settings = read(tmp_path, f"[source]\nrelation = '{relation}'")
    assert settings.source.relation == (str(tmp_path / relation) if is_moved else relation)


@pytest.mark.parametrize("said", ["false", "'none'"])
def test_no_calibration_of_its_own(tmp_path: Path, said: str) -> None:
    settings = read(tmp_path, f"[calibration.overrides]\nR1 = {said}")
    assert settings.method()[1].overrides == {"R1": None}


def test_false_lifts_a_gap(tmp_path: Path) -> None:
    text = "[parameters]\nmax_gap = 5\nstride = false\n[[override]]\nasset = 'a'\nmax_gap = false"
    parameters, _ = read(tmp_path, text).method()
    assert parameters.max_gap == 5
    assert parameters.stride == 100
    assert parameters.changed_by(parameters.overrides[0]).max_gap is None


def test_options_replace_what_the_file_says(tmp_path: Path) -> None:
    settings = read(tmp_path, "[source]\ntime = 't'\nvalue = 'v'\n[parameters]\nm = 2\nmax_gap = 5")
    laid = settings.under(
        {"time": "ts", "value": None}, {"m": 4, "tau": None, "max_gap": False}, {"fraction": 0.5}
    )
    assert laid.source == SourceSettings(time="ts", value="v")
    parameters, calibration = laid.method()
    assert (parameters.m, parameters.tau, parameters.max_gap) == (4, 1, None)
    assert calibration.fraction == 0.5
    assert settings.under(*OPTIONS) == settings


def test_options_of_the_monitor_replace_what_the_file_says(tmp_path: Path) -> None:
    settings = read(tmp_path, "[monitor]\nname = 'north'\nprefix = 'n_'\nlookback = 5")
    laid = settings.under({}, {}, {}, {"name": "south", "schema": "s", "prefix": None})
    assert laid.monitor == MonitorSettings("south", "s", "n_", lookback=5)


def test_an_option_of_calibration_replaces_the_other_ways_to_say_it(tmp_path: Path) -> None:
    settings = read(tmp_path, "[calibration]\nintervals = [[0, 10]]\nexclude = [[3, 4]]")
    _, calibration = settings.under({}, {}, {"fraction": 0.5}).method()
    assert calibration.intervals is None
    assert calibration.exclude == ((3, 4),)


def test_a_window_given_by_option_keeps_a_stride_that_was_said(tmp_path: Path) -> None:
    said = read(tmp_path, "[parameters]\nwindow = 600\nstride = 60")
    assert said.under({}, {"window": 120}, {}).method()[0].stride == 60
    unsaid = read(tmp_path, "[parameters]\nwindow = 600")
    assert unsaid.under({}, {"window": 250}, {}).method()[0].stride == 50


def test_the_layouts_replace_each_other(tmp_path: Path) -> None:
    long = read(tmp_path, "[source]\nchannel = 'c'\nvalue = 'v'")
    assert long.under({"layout": "wide"}, {}, {}).source == SourceSettings(layout="wide")
    wide = read(tmp_path, "[source]\nlayout = 'wide'\nchannels = ['a']")
    assert wide.under({"value": "v"}, {}, {}).source == SourceSettings(value="v")
    assert wide.under({"time": "t"}, {}, {}).source.channels == ("a",)


def test_a_file_given_by_option_needs_no_database(tmp_path: Path) -> None:
    settings = read(tmp_path, "[source]\nrelation = 't'\ndatabase = 'd.duckdb'")
    assert settings.under({"relation": "a.csv"}, {}, {}).source.database is None
    assert settings.under({"relation": "u"}, {}, {}).source.database == str(tmp_path / "d.duckdb")
