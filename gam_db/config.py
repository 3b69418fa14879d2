"""Settings: what ``gam.toml`` and the options of the command line say, checked key by key.

This module owns the shape of that file and how options are laid over it. What a value may be is said by
the dataclasses it ends up in (``Parameters``, ``Calibration``, ``Source``); it looks at no source.

All of it is optional. Columns that are not named are guessed from the source::

    [source]
    relation = "telemetry.parquet"   # a file, relative to this one, or a table of the database
    # database = "plant.duckdb"      # or postgresql://HOST/DATABASE and others; no password here
    asset = "machine"                # false: there is no such column, it is one machine
    channel = "signal"               # false: there is no such column, it is one signal
    time = "ts"
    value = "reading"
    where = "reading < 1000"         # a condition in SQL, applied before everything else
    # layout = "wide"                # one column per channel, instead of channel and value
    # channels = ["current", "torque"]
    # time_kind = "timestamp"        # or "counter"; needed only to compile without the source

    [parameters]
    m = 3
    tau = 1
    bins = 100
    window = 5000
    stride = 100                     # false: the default, gcd(window, 100)
    max_gap = "5 s"                  # a number: seconds, or steps of a counter; false: no limit
    target_floor = 0.05

    [[override]]                     # the first that matches a channel applies; * and ? as usual
    asset = "robot_7"
    channel = "temperature_*"
    tau = 10
    bins = 20

    [calibration]                    # one of fraction, duration, intervals
    intervals = [[2026-03-01, 2026-03-14T18:00:00]]
    exclude = [[2026-03-04T06:00:00, 2026-03-04T07:30:00]]
    score_from = 2026-03-15
    pool = "channel"                 # or groups of assets: [["robot_1", "robot_2"], ["press_*"]]

    [calibration.overrides."robot_9*"]
    duration = "30 d"

    [calibration.overrides]
    robot_8 = false                  # no calibration of its own: it learns from its pool

    [monitor]                        # what is kept in the database from run to run
    name = "default"                 # several monitors can share one database
    # schema = "monitoring"          # of the state tables; default the current one
    prefix = "gam_"                  # begins their names
    lookback = "1 h"                 # how late a reading may come; a number: seconds, or counter steps
    park_after = "1 d"               # channels silent for longer are looked at once a day
    keep = "400 d"                   # age up to which gam prune keeps buckets; default all
    keep_novel = "90 d"              # the same for their novel cells
"""

import dataclasses
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal, TypeAlias

from gam_db.address import has_password, is_url, shown
from gam_db.calibration import Calibration
from gam_db.clock import Length
from gam_db.errors import ConfigurationError, nearest
from gam_db.parameters import Override, Parameters
from gam_db.source import is_file
from gam_db.stored.tables import StateTables

DEFAULT_FILE = "gam.toml"

#: A column that was named, False for "there is none", None for "not said".
Column: TypeAlias = str | Literal[False] | None


@dataclass(frozen=True)
class SourceSettings:
    """What was said of the source; None is "not said", and what is not said is guessed.

    Attributes:
        relation: a table name or the path of a file.
        database: address of the database that holds the table; see :func:`gam_db.connect`.
        asset, channel: columns; False where there is no such column.
        time, value: columns.
        where: a condition in SQL.
        layout: "long" (one row per reading) or "wide" (one column per channel).
        channels: the columns of a wide table that hold readings.
        time_kind: "timestamp" or "counter".
    """

    relation: str | None = None
    database: str | None = None
    asset: Column = None
    channel: Column = None
    time: str | None = None
    value: str | None = None
    where: str | None = None
    layout: str | None = None
    channels: tuple[str, ...] | None = None
    time_kind: str | None = None

    @property
    def shown_database(self) -> str | None:
        """The address of the database without its password."""
        return None if self.database is None else shown(self.database)


@dataclass(frozen=True)
class MonitorSettings:
    """What is kept in the database, where, and for how long.

    Attributes:
        name: of the monitor; several can share one database.
        schema: of the state tables; None for the current one.
        prefix: of their names.
        lookback: how far behind the newest time of its channel a reading may come.
        park_after: channels silent for longer are looked at once a day; None for never.
        keep: age up to which buckets are kept; None for all.
        keep_novel: the same for novel cells.
    """

    name: str = "default"
    schema: str | None = None
    prefix: str = "gam_"
    lookback: Length | None = None
    park_after: Length | None = None
    keep: Length | None = None
    keep_novel: Length | None = None

    @property
    def tables(self) -> StateTables:
        """Where the state lies."""
        return StateTables(self.schema, self.prefix)


@dataclass(frozen=True)
class Settings:
    """Everything that can be set, as it was said.

    Attributes:
        source: see :class:`SourceSettings`.
        parameters: keywords of :class:`~gam_db.Parameters`; only what was said.
        calibration: keywords of :class:`~gam_db.Calibration`; only what was said.
        overrides: parameters of some channels.
        monitor: see :class:`MonitorSettings`.
        file: the file it was read from, None if there was none.
    """

    source: SourceSettings = SourceSettings()
    parameters: Mapping[str, Any] = field(default_factory=dict)
    calibration: Mapping[str, Any] = field(default_factory=dict)
    overrides: tuple[Override, ...] = ()
    monitor: MonitorSettings = MonitorSettings()
    file: Path | None = None

    def under(
        self,
        source: Mapping[str, Any],
        parameters: Mapping[str, Any],
        calibration: Mapping[str, Any],
        monitor: Mapping[str, Any] | None = None,
    ) -> "Settings":
        """Return these settings with options laid over them; an option that is None says nothing.

        Names and values are those of the file's sections, and mean the same.
        An option replaces the value of its name. The three ways to say where calibration lies replace
        one another, and so do the two layouts with what belongs to each.
        """
        said_source = _said(source)
        said_calibration = _said(calibration)
        kept_source = self.source
        if said_source.get("layout") == "wide":
            kept_source = dataclasses.replace(kept_source, channel=None, value=None)
        elif "channel" in said_source or "value" in said_source:
            kept_source = dataclasses.replace(kept_source, layout=None, channels=None)
        if is_file(said_source.get("relation")):
            kept_source = dataclasses.replace(kept_source, database=None)
        kept_calibration = dict(self.calibration)
        if said_calibration.keys() & set(_WHERE_IT_LIES):
            for name in _WHERE_IT_LIES:
                kept_calibration.pop(name, None)
        return dataclasses.replace(
            self,
            source=dataclasses.replace(kept_source, **said_source),
            parameters={**self.parameters, **_unset(_said(parameters))},
            calibration={**kept_calibration, **said_calibration},
            monitor=dataclasses.replace(self.monitor, **_said(monitor or {})),
        )

    def method(self) -> tuple[Parameters, Calibration]:
        """Return the parameters and the calibration.

        Raises:
            ParameterError, CalibrationError: a value is out of its range, or they contradict.
        """
        return Parameters(**self.parameters, overrides=self.overrides), Calibration(**self.calibration)


def load(path: Path | None = None, folder: Path | None = None) -> Settings:
    """Read a settings file.

    Args:
        path: the file; None for ``gam.toml``, if it is there.
        folder: where to look for ``gam.toml``; default the current folder.

    Raises:
        ConfigurationError: the file cannot be read, is no TOML, or holds a key that has no meaning.
    """
    if path is None:
        path = (folder or Path()) / DEFAULT_FILE
        if not path.exists():
            return Settings()
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigurationError(f"{path} cannot be read; is it there?") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigurationError(f"{path} is no TOML file: {error}.") from error
    try:
        return _settings(document, path)
    except ConfigurationError as error:
        raise ConfigurationError(f"{path}: {error}") from error


def _names(of: type) -> tuple[str, ...]:
    return tuple(one.name for one in dataclasses.fields(of))


_WHERE_IT_LIES = ("fraction", "duration", "intervals")
_SECTIONS = ("source", "parameters", "override", "calibration", "monitor")
_SOURCE = _names(SourceSettings)
_MONITOR = _names(MonitorSettings)
_PARAMETERS = tuple(name for name in _names(Parameters) if name != "overrides")
_OVERRIDE = _names(Override)
_CALIBRATION = _names(Calibration)
_CALIBRATION_OF_ONE = tuple(name for name in _CALIBRATION if name not in ("overrides", "pool"))


def _settings(document: Mapping[str, Any], path: Path) -> Settings:
    _check_keys("the file", document, _SECTIONS, "section")
    tables = document.get("override", [])
    if not _is_list_of(tables, dict):
        raise ConfigurationError("override is a list of tables; begin each with [[override]].")
    return Settings(
        source=_source(_section(document, "source", _SOURCE), path.parent),
        parameters=_unset(_section(document, "parameters", _PARAMETERS)),
        calibration=_calibration("[calibration]", _section(document, "calibration", _CALIBRATION)),
        overrides=tuple(_override(number, table) for number, table in enumerate(tables, start=1)),
        monitor=_monitor(_section(document, "monitor", _MONITOR)),
        file=path,
    )


def _section(document: Mapping[str, Any], name: str, known: Iterable[str]) -> dict[str, Any]:
    section = document.get(name, {})
    if not isinstance(section, dict):
        raise ConfigurationError(f"{name} is a section; begin it with [{name}].")
    _check_keys(f"[{name}]", section, known)
    return section


def _source(section: dict[str, Any], folder: Path) -> SourceSettings:
    for name, value in section.items():
        if name == "channels":
            if not _is_list_of(value, str):
                raise ConfigurationError("channels in [source] takes a list of column names.")
        elif value is False and name in ("asset", "channel"):
            continue
        elif not isinstance(value, str) or not value:
            raise ConfigurationError(f"{name} in [source] is {value!r}; it takes a text.")
    if section.get("layout", "long") not in ("long", "wide"):
        raise ConfigurationError(
            f"layout in [source] is {section['layout']!r}{nearest(section['layout'], ('long', 'wide'))}"
        )
    said = dict(section)
    if "channels" in said:
        said["channels"] = tuple(said["channels"])
    if "database" in said:
        if has_password(said["database"]):
            raise ConfigurationError(
                f"database in [source] is {shown(said['database'])}; a password does not belong into a "
                "file: leave it out, and put it into the environment (PGPASSWORD, CLICKHOUSE_PASSWORD)."
            )
        if not is_url(said["database"]):
            said["database"] = str(folder / said["database"])
    if is_file(said.get("relation")) and "://" not in said["relation"]:
        said["relation"] = str(folder / said["relation"])
    return SourceSettings(**said)


def _monitor(section: dict[str, Any]) -> MonitorSettings:
    for name, value in section.items():
        if name == "prefix" and isinstance(value, str):
            continue
        if name in ("name", "schema", "prefix"):
            fits, what = isinstance(value, str) and value != "", "a text"
        else:
            fits = isinstance(value, (int, float, str)) and not isinstance(value, bool)
            what = "a length of time, such as '1 h'"
        if not fits:
            raise ConfigurationError(f"{name} in [monitor] is {value!r}; it takes {what}.")
    said = MonitorSettings(**section)
    _ = said.tables  # which refuses a prefix that cannot begin a name
    return said


def _override(number: int, table: dict[str, Any]) -> Override:
    where = f"[[override]] number {number}"
    _check_keys(where, table, _OVERRIDE)
    for name in ("asset", "channel"):
        if not isinstance(table.get(name, "*"), str):
            raise ConfigurationError(f"{name} in {where} is {table[name]!r}; it takes a pattern.")
    return Override(**_unset(table))


def _calibration(
    where: str, section: dict[str, Any], known: Iterable[str] = _CALIBRATION
) -> dict[str, Any]:
    _check_keys(where, section, known)
    for name in ("intervals", "exclude"):
        if not all(_is_list(pair) and len(pair) == 2 for pair in _list(section.get(name, []))):
            raise ConfigurationError(
                f"{name} in {where} takes a list of pairs, such as [[2026-03-01, 2026-03-14]]."
            )
    said = dict(section)
    pool = said.get("pool", "channel")
    if not isinstance(pool, str) and not (
        _is_list(pool) and all(isinstance(group, str) or _is_list_of(group, str) for group in pool)
    ):
        raise ConfigurationError(
            f'pool in {where} takes "channel" or groups of asset patterns, such as [["press_*"]].'
        )
    if "overrides" in said:
        if not isinstance(said["overrides"], dict):
            raise ConfigurationError(
                f'overrides in {where} is a section; write [calibration.overrides."pattern"].'
            )
        said["overrides"] = {
            pattern: _calibration_of(pattern, rule) for pattern, rule in said["overrides"].items()
        }
    return said


def _calibration_of(pattern: str, rule: object) -> Calibration | None:
    if rule is False or rule == "none":
        return None
    where = f"[calibration.overrides.{pattern!r}]"
    if not isinstance(rule, dict):
        raise ConfigurationError(f"{where} is {rule!r}; it is a section, or false for no calibration.")
    return Calibration(**_calibration(where, rule, _CALIBRATION_OF_ONE))


def _check_keys(where: str, section: Mapping[str, Any], known: Iterable[str], what: str = "key") -> None:
    choices = tuple(known)
    for name in section:
        if name not in choices:
            raise ConfigurationError(f"There is no {what} {name!r} in {where}{nearest(name, choices)}")


def _unset(section: Mapping[str, Any]) -> dict[str, Any]:
    """TOML has no null: false says that there is no stride or max_gap of its own."""
    return {
        name: None if value is False and name in ("stride", "max_gap") else value
        for name, value in section.items()
    }


def _said(options: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in options.items() if value is not None}


def _is_list(value: object) -> bool:
    return isinstance(value, (list, tuple))


def _list(value: Any) -> list[Any]:
    return list(value) if _is_list(value) else [value]


def _is_list_of(value: object, kind: type) -> bool:
    return isinstance(value, (list, tuple)) and all(isinstance(one, kind) for one in value)
