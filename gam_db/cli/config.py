"""Settings: what ``gam.toml`` and the options of the command line say, checked key by key.

This module owns the shape of that file, all of which ``docs/gam.toml`` shows, and how options are laid
over it. What a value may be is said by the dataclasses it ends up in. It looks at no source.
"""

import dataclasses
import os
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from gam_db.address import has_password, is_url, shown
from gam_db.alarms import Alarms
from gam_db.errors import ConfigurationError, UserError, nearest, wrong
from gam_db.reading.guess import SourceSettings
from gam_db.settings.calibration import WAYS, Calibration
from gam_db.settings.parameters import Override, Parameters
from gam_db.settings.setting import settings_of
from gam_db.settings.source import is_file, paths_of, slashed
from gam_db.stored.settings import MonitorSettings

DEFAULT_FILE = "gam.toml"

#: Users whose settings are read like one's own: the administrator.
_TRUSTED = frozenset({0})

#: The sections of gam.toml, and what their keys are the settings of.
SECTIONS: Mapping[str, type] = {
    "source": SourceSettings,
    "parameters": Parameters,
    "calibration": Calibration,
    "alarms": Alarms,
    "monitor": MonitorSettings,
}


@dataclass(frozen=True)
class Settings:
    """Everything that can be set, as it was said."""

    source: SourceSettings = field(default_factory=SourceSettings)
    #: Keywords of these two; only what was said.
    parameters: Mapping[str, Any] = field(default_factory=dict)
    calibration: Mapping[str, Any] = field(default_factory=dict)
    overrides: tuple[Override, ...] = ()  # parameters of some channels
    alarms: Alarms = field(default_factory=Alarms)
    monitor: MonitorSettings = field(default_factory=MonitorSettings)
    file: Path | None = None  # the file it was read from, None if there was none
    is_of_another: bool = False  # its section [source] was said of another source, and left out

    def for_source(self, relation: str | tuple[str, ...] | None) -> "Settings":
        """Return these settings for a source that was named beside the file.

        Columns and conditions that were said of another one are left out; its database stays, in which
        the other may lie.
        """
        of_file = self.source.relation
        if relation is None or of_file is None or of_file == relation:
            return self
        here, there = (list(map(os.path.abspath, paths_of(name))) for name in (of_file, relation))
        if is_file(of_file) and here == there:
            return self
        source = SourceSettings(database=self.source.database)
        return dataclasses.replace(self, source=source, is_of_another=True)

    def under(self, **sections: Mapping[str, Any]) -> "Settings":
        """Return these settings with what was said by options (section -> name -> value) laid over them.

        An option replaces the value of its name. The three ways to say where calibration lies replace
        one another, and so do the two layouts with what belongs to each.
        """
        columns, calibration = sections.get("source", {}), sections.get("calibration", {})
        source, of_file = self.source, dict(self.calibration)
        if columns.get("layout") == "wide":
            source = dataclasses.replace(source, channel=None, value=None)
        elif "channel" in columns or "value" in columns:
            source = dataclasses.replace(source, layout=None, channels=None)
        if calibration.keys() & set(WAYS):
            of_file = {name: value for name, value in of_file.items() if name not in WAYS}
        source = dataclasses.replace(source, **columns)
        return dataclasses.replace(
            self,
            source=source,
            parameters={**self.parameters, **sections.get("parameters", {})},
            calibration={**of_file, **calibration},
            alarms=dataclasses.replace(self.alarms, **sections.get("alarms", {})),
            monitor=dataclasses.replace(self.monitor, **sections.get("monitor", {})),
        )

    def method(self) -> tuple[Parameters, Calibration]:
        """Return the parameters and the calibration, which are checked as they are made."""
        return Parameters(**self.parameters, overrides=self.overrides), Calibration(**self.calibration)


def load(path: Path | None = None, folder: Path | None = None) -> Settings:
    """Read a settings file; without a path ``gam.toml`` of a folder (the current one), if it is there.

    Raises:
        ConfigurationError: the file cannot be read, is no TOML, or holds a key that has no meaning.
    """
    if path is None:
        path = (folder or Path()) / DEFAULT_FILE
        if not path.exists():
            return Settings()
        _check_owner(path)
    try:
        document = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise ConfigurationError(f"{path} cannot be read; is it there?") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise ConfigurationError(f"{path} is no TOML file: {error}.") from error
    try:
        return _settings(document, path)
    except UserError as error:
        raise ConfigurationError(f"{path}: {error.options}") from error


def _check_owner(path: Path) -> None:
    """Refuse a file that nobody asked for and another user could write: it says SQL that runs."""
    if not hasattr(os, "getuid"):
        return
    for location in (path, path.resolve().parent):
        if location.stat().st_uid not in {os.getuid(), *_TRUSTED}:
            raise wrong(
                "file_of_another_user", path=path, said="it" if location is path else "its folder"
            )


def _settings(document: Mapping[str, Any], path: Path) -> Settings:
    _check_keys("the file", document, (*SECTIONS, "override"), "section")
    for name in SECTIONS:
        if not isinstance(document.get(name, {}), dict):
            raise ConfigurationError(f"{name} is a section; begin it with [{name}].")
    tables = document.get("override", [])
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise ConfigurationError("override is a list of tables; begin each with [[override]].")
    sections = {name: dict(document.get(name, {})) for name in SECTIONS}
    rules = sections["calibration"].pop("overrides", {})
    if not isinstance(rules, dict):
        raise wrong("overrides_are_a_section")
    _check_keys("[calibration]", sections["calibration"], (*settings_of(Calibration), "overrides"))
    sections = {name: _read(f"[{name}]", table, SECTIONS[name]) for name, table in sections.items()}
    if rules:
        sections["calibration"]["overrides"] = {
            pattern: _rule(f"[calibration.overrides.{pattern!r}]", rule)
            for pattern, rule in rules.items()
        }
    return Settings(
        source=_located(SourceSettings(**sections["source"]), path.parent),
        parameters=sections["parameters"],
        calibration=sections["calibration"],
        overrides=tuple(
            _override(f"[[override]] number {number}", table) for number, table in enumerate(tables, 1)
        ),
        alarms=Alarms(**sections["alarms"]),
        monitor=MonitorSettings(**sections["monitor"]),
        file=path,
    )


def _read(where: str, table: Mapping[str, Any], of: type) -> dict[str, Any]:
    """Return the values of a section, each checked."""
    fields = settings_of(of)
    _check_keys(where, table, fields)
    try:
        return {name: fields[name].of_toml(name, value) for name, value in table.items()}
    except UserError as error:
        raise ConfigurationError(f"in {where}, {error.options}") from error


def _override(where: str, table: Mapping[str, Any]) -> Override:
    patterns = {name: value for name, value in table.items() if name in ("asset", "channel")}
    for name, pattern in patterns.items():
        if not isinstance(pattern, str):
            raise ConfigurationError(f"{name} in {where} is {pattern!r}; it takes a pattern.")
    _check_keys(where, table, ("asset", "channel", *settings_of(Parameters)))
    changes = {name: value for name, value in table.items() if name not in patterns}
    return Override(**patterns, **_read(where, changes, Parameters))


def _rule(where: str, rule: Any) -> Calibration | None:
    if rule is False or rule == "none":
        return None
    if not isinstance(rule, dict):
        raise ConfigurationError(f"{where} is {rule!r}; it is a section, or false for no calibration.")
    for name in ("pool", "reference"):
        if name in rule:
            raise ConfigurationError(f"{where} has a {name} of its own; only [calibration] may.")
    return Calibration(**_read(where, rule, Calibration))


def _located(settings: SourceSettings, folder: Path) -> SourceSettings:
    """Return the same with paths as seen from here, not from the folder of the file."""
    changed: dict[str, Any] = {}
    if settings.database is not None:
        if has_password(settings.database):
            raise wrong("password_in_file", shown=shown(settings.database))
        if not is_url(settings.database):
            changed["database"] = str(folder / settings.database)
    if is_file(settings.relation):
        paths = [
            path if "://" in path else slashed(folder / path, path)
            for path in paths_of(settings.relation)
        ]
        changed["relation"] = paths[0] if isinstance(settings.relation, str) else tuple(paths)
    return dataclasses.replace(settings, **changed)


def _check_keys(where: str, section: Mapping[str, Any], keys: Iterable[str], what: str = "key") -> None:
    choices = tuple(keys)
    for name in section:
        if name not in choices:
            raise ConfigurationError(f"There is no {what} {name!r} in {where}{nearest(name, choices)}")
