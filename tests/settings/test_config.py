"""gam.toml and options: what is read, what is refused, and what replaces what."""

import dataclasses
import datetime as dt
import re
from pathlib import Path
from typing import Any

import pytest
import typer
from typer.testing import CliRunner

import tiny
from gam_db import Calibration, Override, Parameters
from gam_db.cli import config, options
from gam_db.cli.config import SECTIONS, Settings
from gam_db.errors import CalibrationError, ConfigurationError
from gam_db.reading.guess import SourceSettings
from gam_db.settings.setting import COLUMNS, COUNT, FLAG, check, setting, settings_of
from gam_db.stored.schema.tables import StateTables
from gam_db.stored.settings import MonitorSettings


def read(folder: Path, text: str) -> Settings:
    """Settings of a file with this text."""
    path = folder / "gam.toml"
    path.write_text(text, encoding="utf-8")
    return config.load(path)


def test_a_folder_stays_one(tmp_path: Path) -> None:
    for relation, kept in (("days/", "days/"), ("days/*.parquet", "days/*.parquet")):
        found = read(tmp_path, f"[source]\nrelation = '{relation}'").source.relation
        assert found == f"{tmp_path}/{kept}"


def documented() -> str:
    """The example of the documentation."""
    return (Path(__file__).parents[2] / "docs" / "gam.toml").read_text(encoding="utf-8")


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
        tau="auto",
        bins="auto",
        window="auto",
        stride=100,
        max_gap="5 s",
        still_after=25,
        least_vectors=400,
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
    text = re.sub(r"(?m)^# (?=\w+ = )", "", documented()).replace(
        'asset = "machine"', "asset = false", 1
    )
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
    for kind in SECTIONS.values():
        for one in dataclasses.fields(kind):
            assert one.name in settings_of(kind) or one.name == "overrides"
            if one.name != "overrides":
                assert f"{one.name} = " in example, one.name


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
        ("[source]\ntime = 3", r"in \[source\], time is 3; it takes a text"),
        ("[source]\ntime = false", r"in \[source\], time is False"),
        ("[source]\nasset = ''", r"in \[source\], asset is ''"),
        ("[source]\nchannels = 'x'", r"in \[source\], channels is 'x'; it takes a list"),
        ("[source]\nlayout = 'wid'", "did you mean 'wide'"),
        ("[source]\ntime_kind = 'stamp'", "time_kind is 'stamp'"),
        ("[parameters]\nbins = 0", r"in \[parameters\], bins is 0; it must be at least 1"),
        ("[parameters]\ntarget_floor = 5", "it must be a share"),
        ("[override]\nm = 3", r"\[\[override\]\]"),
        ("[[override]]\nasset = 3", "number 1"),
        ("[[override]]\nm = 0", r"in \[\[override\]\] number 1, m is 0"),
        ("[calibration]\nintervals = [1, 2]", r"in \[calibration\], intervals takes pairs"),
        ("[calibration]\nexclude = 3", r"in \[calibration\], exclude is 3"),
        ("[calibration]\npool = 3", r"in \[calibration\], pool is 3"),
        ("[calibration]\nfraction = 0", "above 0 and at most 1"),
        ("[calibration]\noverrides = 3", "overrides in"),
        ("[calibration.overrides]\nR1 = true", "R1"),
        ("[calibration.overrides.R1]\npool = 'channel'", "pool"),
        ("monitor = 3", r"\[monitor\]"),
        ("[monitor]\nname = ''", r"in \[monitor\], name is ''"),
        ("[monitor]\nname = 3", r"in \[monitor\], name is 3"),
        ("[monitor]\nschema = false", r"in \[monitor\], schema is False"),
        ("[monitor]\nprefix = 3", r"in \[monitor\], prefix is 3"),
        ("[monitor]\nprefix = 'a-b'", "letters, digits"),
        ("[monitor]\nlookback = true", "give a number, a timedelta or a text such as '1 h'"),
        ("[monitor]\nkeep = [3]", "give a number, a timedelta or a text such as '400 d'"),
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
        source={"time": "ts"}, parameters={"m": 4, "max_gap": None}, calibration={"fraction": 0.5}
    )
    assert laid.source == dataclasses.replace(settings.source, time="ts", value="v")
    parameters, calibration = laid.method()
    assert (parameters.m, parameters.tau, parameters.max_gap) == (4, 1, None)
    assert calibration.fraction == 0.5
    assert settings.under() == settings


def test_options_of_the_monitor_replace_what_the_file_says(tmp_path: Path) -> None:
    settings = read(tmp_path, "[monitor]\nname = 'north'\nprefix = 'n_'\nlookback = 5")
    laid = settings.under(monitor={"name": "south", "schema": "s"})
    assert laid.monitor == MonitorSettings(name="south", schema="s", prefix="n_", lookback=5)


def test_an_option_of_calibration_replaces_the_other_ways_to_say_it(tmp_path: Path) -> None:
    settings = read(tmp_path, "[calibration]\nintervals = [[0, 10]]\nexclude = [[3, 4]]")
    _, calibration = settings.under(calibration={"fraction": 0.5}).method()
    assert calibration.intervals is None
    assert calibration.exclude == ((3, 4),)


def test_a_window_given_by_option_keeps_a_stride_that_was_said(tmp_path: Path) -> None:
    said = read(tmp_path, "[parameters]\nwindow = 600\nstride = 60")
    assert said.under(parameters={"window": 120}).method()[0].stride == 60
    unsaid = read(tmp_path, "[parameters]\nwindow = 600")
    assert unsaid.under(parameters={"window": 250}).method()[0].stride == 50


def test_the_layouts_replace_each_other(tmp_path: Path) -> None:
    long = read(tmp_path, "[source]\nchannel = 'c'\nvalue = 'v'")
    assert long.under(source={"layout": "wide"}).source == SourceSettings(layout="wide")
    wide = read(tmp_path, "[source]\nlayout = 'wide'\nchannels = ['a']")
    assert wide.under(source={"value": "v"}).source == SourceSettings(value="v")
    assert wide.under(source={"time": "t"}).source.channels == ("a",)


@options.taking(*options.READ)
def taken(settings: Settings) -> None:
    """A command that keeps what it was given."""
    KEPT.append(settings)


KEPT: list[Settings] = []


def by_options(folder: Path, text: str, *words: str) -> Settings:
    """What a command is given that is called with options, beside a gam.toml."""
    (folder / "gam.toml").write_text(text, encoding="utf-8")
    app = typer.Typer()
    app.command()(taken)
    result = CliRunner().invoke(app, ["--config", str(folder / "gam.toml"), *words])
    assert result.exit_code == 0, result.output
    return KEPT.pop()


def test_a_file_given_by_option_needs_no_database(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.delenv("GAM_DATABASE", raising=False)
    text = "[source]\nrelation = 't'\ndatabase = 'd.duckdb'"
    assert by_options(tmp_path, text, "a.csv").source.database is None
    assert by_options(tmp_path, text, "u").source.database == str(tmp_path / "d.duckdb")
    assert by_options(tmp_path, text, "a.csv", "--database", "e").source.database == "e"
    monkeypatch.setenv("GAM_DATABASE", "f")
    assert by_options(tmp_path, text, "a.csv").source.database is None
    assert by_options(tmp_path, text, "u").source.database == "f"


@dataclasses.dataclass(frozen=True)
class Asked:
    """What one command takes beside the settings."""

    depth: int = setting(3, COUNT, "how deep", least=2)
    names: tuple[str, ...] = setting((), dataclasses.replace(COLUMNS, option=list[str]), "some names")
    raw: bool = setting(True, dataclasses.replace(FLAG, read=lambda *_: False), "no", option="--no-raw")

    def __post_init__(self) -> None:
        check(self)


@pytest.mark.parametrize(
    ("words", "meant"),
    [
        ((), Asked()),
        (("--depth", "2"), Asked(depth=2)),
        (("--names", "a", "--names", "b", "--no-raw"), Asked(names=("a", "b"), raw=False)),
        (("--depth", "1"), "depth is 1; it must be at least 2."),
    ],
)
def test_a_dataclass_of_settings_becomes_options(words: tuple[str, ...], meant: Any) -> None:
    """So that an option, its range and its help are said where the value is used."""
    kept = []

    @options.taking("quiet", source=False, fresh=True)
    def command(settings: Settings, asked: Asked, common: options.Common) -> None:
        kept.append((asked, common))

    app = typer.Typer()
    app.command()(command)
    result = CliRunner().invoke(app, [*words, "-q"])
    if isinstance(meant, str):
        assert str(result.exception) == meant
    else:
        assert kept == [(meant, options.Common(quiet=True))]
    shown = CliRunner().invoke(app, ["--help"], env={"COLUMNS": "200"}).stdout
    assert "How deep (default 3)." in shown
    assert "--json" not in shown, "only what the command names"


#: An option for every setting that has one, and what it comes to.
GIVEN: dict[str, tuple[tuple[str, ...], Any]] = {
    "asset": (("--asset", "robot"), "robot"),
    "channel": (("--channel", "joint"), "joint"),
    "time": (("--time", "ts"), "ts"),
    "value": (("--value", "v"), "v"),
    "layout": (("--wide",), "wide"),
    "where": (("--where", "v > 0"), "v > 0"),
    "where_any": (("--where-any",), True),
    "clock_tolerance": (("--clock-tolerance", "1 h"), "1 h"),
    "decimal": (("--decimal", ","), ","),
    "thousands": (("--thousands", " "), " "),
    "unit": (("--unit", "A"), "A"),
    "null": (("--null", "N/A", "--null", "Bad"), ("N/A", "Bad")),
    "delimiter": (("--delimiter", ";"), ";"),
    "skip_rows": (("--skip-rows", "2"), 2),
    "encoding": (("--encoding", "cp1252"), "cp1252"),
    "time_format": (("--time-format", "%d.%m.%Y"), "%d.%m.%Y"),
    "time_unit": (("--time-unit", "ms"), "ms"),
    "source_time_zone": (("--source-time-zone", "Europe/Berlin"), "Europe/Berlin"),
    "valid_when": (("--valid-when", "v > 0"), "v > 0"),
    "program": (("--program", "product"), "product"),
    "m": (("--m", "2"), 2),
    "tau": (("--tau", "0"), 0),
    "bins": (("--bins", "7"), 7),
    "window": (("--window", "60"), 60),
    "stride": (("--stride", "20"), 20),
    "max_gap": (("--max-gap", "none"), None),
    "still_after": (("--still-after", "25"), 25),
    "range": (("--range", "min_max"), "min_max"),
    "target_floor": (("--target-floor", "0.0"), 0.0),
    "least_vectors": (("--least-vectors", "250"), 250),
    "fraction": (("--calibration-fraction", "0.3"), 0.3),
    "duration": (("--calibration-duration", "30"), 30),
    "intervals": (("--calibrate", "0/9", "--calibrate", "20/29"), [("0", "9"), ("20", "29")]),
    "exclude": (("--exclude", "3/4"), [("3", "4")]),
    "score_from": (("--score-from", "40"), "40"),
    "pool": (("--pool", "a*,b", "--pool", "c"), [["a*", "b"], ["c"]]),
    "reference": (("--reference", "a*", "--reference", "b"), ["a*", "b"]),
}


def test_every_setting_is_tried_as_an_option() -> None:
    assert set(GIVEN) == set(options.READ)


@pytest.mark.parametrize("name", GIVEN)
def test_an_option_says_what_the_key_says(tmp_path: Path, name: str) -> None:
    """Nothing else is said by it, and nothing of it is lost, whatever its type."""
    words, meant = GIVEN[name]
    settings = by_options(tmp_path, "", *words)
    said = {name: value for name, value in vars(settings.source).items() if value is not None}
    assert {**said, **settings.parameters, **settings.calibration} == {name: meant}


def test_there_is_none_can_be_said_by_an_option(tmp_path: Path) -> None:
    settings = by_options(tmp_path, "", "--no-asset", "--no-channel")
    assert (settings.source.asset, settings.source.channel) == (False, False)
    wide = by_options(tmp_path, "", "--wide", "--channel", "a", "--channel", "b").source
    assert (wide.layout, wide.channel, wide.channels) == ("wide", None, ("a", "b"))


def test_calibration_chooses_unless_the_user_does() -> None:
    assert {name: settings_of(Parameters)[name].default for name in ("tau", "bins", "window")} == {
        "tau": "auto",
        "bins": "auto",
        "window": "auto",
    }
    with tiny.as_delivered():
        assert Parameters() == Parameters(tau="auto", bins="auto", window="auto", least_vectors=400)
