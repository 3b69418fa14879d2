"""Options that commands share: those of the settings, made of what is declared, and what they open.

This module owns how a declaration becomes an option, and how options are laid over gam.toml.
"""

import functools
import inspect
import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, is_dataclass
from pathlib import Path
from typing import Annotated, Any, TypeVar

import typer
from typer.models import ArgumentInfo

from gam_db import address as addresses
from gam_db import data
from gam_db.address import VARIABLE, is_url
from gam_db.cli import config
from gam_db.cli.config import SECTIONS, Settings
from gam_db.engines.connecting import connect
from gam_db.engines.session import Session
from gam_db.errors import ConfigurationError, EngineError, wrong
from gam_db.settings.calibration import WAYS, Calibration
from gam_db.settings.parameters import Parameters
from gam_db.settings.setting import COUNT, FLAG, TEXT, Setting, check, setting, settings_of
from gam_db.settings.source import FILE_ENDINGS, as_folder, is_file, is_spreadsheet

DATABASE_ENDINGS = (".duckdb", ".db")

SHOWN = 40
"""Channels shown unless all are asked for."""

_PANELS = data.table("gam_db.cli", "words.toml")["panels"]

#: Every setting that is an option, with the section of gam.toml that it stands in.
_FIELDS: Mapping[str, tuple[str, Setting]] = {
    name: (section, field)
    for section, of in SECTIONS.items()
    for name, field in settings_of(of).items()
    if name not in ("relation", "database", "channels")
}

#: What options say of single assets, too, as ASSET=VALUE.
BY_ASSET = tuple(name for name in settings_of(Calibration) if name not in ("pool", "reference"))

#: Options of commands that read a source, and of commands that work with the state.
READ = tuple(
    name
    for name, (section, _) in _FIELDS.items()
    if section not in ("alarms", "monitor") and name != "time_kind"
)
ALARMS = ("rate", "family")
STATE = ("name", "schema", "prefix")

_Row = TypeVar("_Row")


def option(path: str, default: Any = None, **words: str) -> Any:
    """Return an option of a command, to stand as the default of a parameter.

    What is said of it is in ``options.toml`` by its path there, as ``run.out``; words are filled in.
    """
    names, keywords = _described(path, words)
    return typer.Option(default, *names, **keywords)


def argument(path: str, default: Any = ..., **words: str) -> Any:
    """Return an argument of a command, likewise."""
    _, keywords = _described(path, words)
    return typer.Argument(default, show_default=False, **keywords)


def _described(path: str, words: Mapping[str, str]) -> tuple[list[str], dict[str, Any]]:
    """Return the names of an option or an argument, and what else is said of it."""
    command, _, name = path.partition(".")
    entry = data.table("gam_db.cli", "options.toml")[command][name]
    named = entry.get("named", "").split()
    metavar = " ".join(word for word in named if not word.startswith("-")) or None
    more = {"help": entry["what"].format(**words), "rich_help_panel": entry.get("panel")}
    names = [word for word in named if word.startswith("-")]
    return names, {"metavar": metavar, **more, **({"min": entry["min"]} if "min" in entry else {})}


@dataclass(frozen=True)
class Common:
    """What many commands take beside settings."""

    everything: bool = setting(
        False, FLAG, f"print every channel, not only the {SHOWN} most urgent, and all remarks"
    )
    time_zone: str = setting("UTC", TEXT)
    as_json: bool = setting(False, FLAG)
    quiet: bool = setting(False, FLAG)
    threads: int | None = setting(None, COUNT)

    def __post_init__(self) -> None:
        check(self)

    def of(self, rows: Sequence[_Row], most: int = SHOWN) -> Sequence[_Row]:
        """Return the rows that are printed."""
        return rows if self.everything else rows[:most]


#: What commands that print a page take of it.
PAGE = ("everything", "as_json", "quiet")

_OF_COMMON = {name: ("common", field) for name, field in settings_of(Common).items()}


def _typer(name: str, section: str, field: Setting, *default: Any) -> Any:
    panel = "Output" if section == "common" and name != "threads" else _PANELS.get(section)
    names, metavar = _option(name, field), field.metavar or field.takes.metavar
    return typer.Option(*default, *names, help=field.help, metavar=metavar, rich_help_panel=panel)


def _option(name: str, field: Setting) -> list[str]:
    return (field.option or f"--{name.replace('_', '-')}").split()


Threads = Annotated[int | None, _typer("threads", *_OF_COMMON["threads"])]
All = Annotated[bool, _typer("everything", *_OF_COMMON["everything"])]
Json = Annotated[bool, _typer("as_json", *_OF_COMMON["as_json"])]


def taking(
    *names: str, source: bool = True, state: bool = False, fresh: bool = False, but: tuple[str, ...] = ()
) -> Callable[[Callable[..., Any]], Callable[..., None]]:
    """Return what gives a command options of the settings; it is called with ``settings``.

    One that has a parameter ``relation`` is also told the SOURCE that was given, apart from gam.toml. A
    parameter that is a dataclass of settings gets an option for each of them; of :class:`Common` those
    that are named. The options stand in the order of the names, less those of ``but``. There may be no
    SOURCE, and with ``fresh`` there is no settings file; with ``state`` the database holds the state,
    else it is only read (but by a command's own --state).
    """
    taken = {name: {**_FIELDS, **_OF_COMMON}[name] for name in names if name not in but}

    def decorated(command: Callable[..., Any]) -> Callable[..., None]:
        of_command = dict(inspect.signature(command, eval_str=True).parameters)
        del of_command["settings"]
        passed = of_command.pop("relation", None) is not None
        named = {name: parameter.annotation for name, parameter in of_command.items()}
        classes: dict[str, Any] = {name: of for name, of in named.items() if is_dataclass(of)}
        of_command = {name: parameter for name, parameter in of_command.items() if name not in classes}
        fields = dict(taken)
        for section, of in classes.items():
            if of is not Common:
                fields |= {name: (section, field) for name, field in settings_of(of).items()}
        read = argument("shared.source", None)
        parameters = [
            *(
                parameter
                for parameter in of_command.values()
                if isinstance(parameter.default, ArgumentInfo)
            ),
            *([_parameter("relation", list[str] | None, read)] if source else []),
            _parameter("database", str | None, option(f"shared.{'of_state' if state else 'read_only'}")),
            *([] if fresh else [_parameter("config", Path | None, option("shared.config"))]),
            *(
                parameter
                for name, (section, field) in fields.items()
                for parameter in _options(name, section, field)
            ),
            *([_parameter("paper", bool, option("shared.paper", False))] if "m" in fields else []),
            *(
                parameter
                for parameter in of_command.values()
                if not isinstance(parameter.default, ArgumentInfo)
            ),
        ]
        parameters = [parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY) for parameter in parameters]

        @functools.wraps(command)
        def called(**arguments: Any) -> None:
            mine = {name: arguments.pop(name) for name in of_command}
            if passed:
                mine["relation"] = as_relation(arguments["relation"])
            sections = _by_section(arguments, fields)
            mine |= {name: of(**sections.pop(name, {})) for name, of in classes.items()}
            laid = _laid(sections, arguments, state or mine.get("state", False), fresh)
            command(settings=laid, **mine)

        called.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        called.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
        return called

    return decorated


#: The same for commands that work with the state and read no SOURCE.
of_state = functools.partial(taking, source=False, state=True)


def _parameter(name: str, of: Any, about: Any) -> inspect.Parameter:
    return inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=about, annotation=of)


def _options(name: str, section: str, field: Setting) -> Iterator[inspect.Parameter]:
    """Yield the option of a setting, and the one that says there is none."""
    kind = field.takes
    of, default = (bool, False) if kind.option is bool else (kind.option | None, None)
    if section == "calibration" and name in BY_ASSET:
        of = list[str] | None
    yield _parameter(name, of, _typer(name, section, field, default))
    if kind.none and field.off is not None:
        help_text = f"{field.off[1][0].upper()}{field.off[1][1:]}."
        none = typer.Option(False, f"--no-{name}", help=help_text, rich_help_panel=_PANELS[section])
        yield _parameter(f"no_{name}", bool, none)


def _by_section(
    arguments: dict[str, Any], fields: Mapping[str, tuple[str, Setting]]
) -> dict[str, dict[str, Any]]:
    """Return what the options say, by section and name; only what was said."""
    sections: dict[str, dict[str, Any]] = {section: {} for section in SECTIONS}
    overrides = _by_asset(arguments)
    for name, (section, field) in fields.items():
        value = arguments.get(name)
        is_set = not (value is None or value is False or value == [])
        if arguments.get(f"no_{name}") and field.off is not None:
            if is_set:
                raise wrong("option_and_its_no", name=name)
            sections[section][name] = field.off[0]
        elif is_set:
            sections.setdefault(section, {})[name] = field.of_option(_option(name, field)[0], value)
    if overrides:
        sections["calibration"]["overrides"] = overrides
    if arguments.get("paper"):
        sections["parameters"] = {**Parameters.PAPER, **sections["parameters"]}
    return sections


def _laid(
    sections: dict[str, dict[str, Any]], arguments: Mapping[str, Any], state: bool, fresh: bool
) -> Settings:
    """Return the settings of the file with what options say laid over them."""
    relation, database, columns = (
        as_relation(arguments.get("relation")),
        arguments["database"],
        sections["source"],
    )
    _check_layout(columns)
    if relation is not None:
        columns["relation"] = relation
    if not database and (state or not is_file(relation)):
        database = os.environ.get(VARIABLE)
    if database or (is_file(relation) and not state):
        columns["database"] = database or None
    settings = Settings() if fresh else config.load(arguments["config"]).for_source(relation)
    if "overrides" in sections["calibration"]:
        # What an option says of a pattern goes before what the file says of it, and is asked first.
        of_options, of_file = (
            sections["calibration"]["overrides"],
            settings.calibration.get("overrides", {}),
        )
        sections["calibration"]["overrides"] = of_options | {
            name: of for name, of in of_file.items() if name not in of_options
        }
    return settings.under(**sections)


def as_relation(sources: Sequence[str] | None) -> str | tuple[str, ...] | None:
    """Return the SOURCE that was given: None, one, or the files and folders of a list."""
    return sources[0] if sources and len(sources) == 1 else tuple(map(as_folder, sources or ())) or None


def _by_asset(arguments: dict[str, Any]) -> dict[str, Calibration | None]:
    """Return the calibration of each asset that options name; what is for all stays in ``arguments``.

    An asset comes before patterns, which would hide it: the first that matches applies.
    """
    rules: dict[str, dict[str, Any]] = {}
    for name in BY_ASSET:
        field, by_asset = settings_of(Calibration)[name], dict[str, list[str]]()
        for text in arguments.get(name) or []:
            asset, _, value = text.rpartition("=")
            by_asset.setdefault(asset.strip(), []).append(value.strip())
        values = {
            asset: _read_texts(_option(name, field)[0], field, texts)
            for asset, texts in by_asset.items()
        }
        arguments[name] = values.pop("", None)
        for asset, value in values.items():
            rules.setdefault(asset, {})[name] = value
    ordered = sorted(rules, key=lambda asset: "*" in asset or "?" in asset)
    return {asset: _of_asset(asset, rules[asset]) for asset in ordered}


def _read_texts(option: str, field: Setting, texts: list[str]) -> Any:
    """Return what one option says of one asset, or of all: a list of texts, or one value."""
    if field.takes.option == list[str]:
        return texts
    if len(texts) > 1:
        raise wrong("said_twice", option=option, values=" and ".join(texts))
    try:
        return field.takes.option(texts[0])
    except ValueError:
        raise wrong("option_takes_a_number", option=option, text=texts[0]) from None


def _of_asset(asset: str, rule: Mapping[str, Any]) -> Calibration | None:
    fields = settings_of(Calibration)
    if rule.get("intervals") in (["false"], ["none"]) and len(rule) == 1:
        return None
    if not set(WAYS) & set(rule):
        option = _option(name := next(iter(rule)), fields[name])[0]
        raise wrong("no_way_of_asset", option=option, asset=asset)
    return Calibration(
        **{name: fields[name].of_option(_option(name, fields[name])[0], of) for name, of in rule.items()}
    )


def _check_layout(columns: dict[str, Any]) -> None:
    """Refuse what contradicts itself; the signals of a wide table become its channels."""
    signals, wide = columns.get("channel"), "layout" in columns
    if wide and ("value" in columns or signals is False):
        raise wrong("wide_has_no_value")
    if isinstance(signals, list):
        if len(signals) > 1 and not wide:
            raise ConfigurationError("Several --channel are columns of a wide table; add --wide.")
        del columns["channel"]
        columns |= {"channels": tuple(signals)} if wide else {"channel": signals[0]}


def named_relation(settings: Settings) -> str | tuple[str, ...]:
    """Return the relation that was named: a file, some, or a table of the database; refuse others."""
    relation, database = settings.source.relation, settings.source.database
    if relation is None:
        raise wrong("no_source")
    if not isinstance(relation, str):
        for path in relation:
            _check_no_spreadsheet(path)
            if not is_file(path):
                raise wrong("several_are_files", one=path, names=", ".join(FILE_ENDINGS))
        return relation
    if database is None and Path(relation).is_dir():
        return str(as_folder(relation))
    if database is None and not is_file(relation):
        _check_no_spreadsheet(relation)
        if Path(relation).suffix in DATABASE_ENDINGS:
            raise wrong("source_is_a_database", relation=relation)
        raise wrong("no_database_for_table", relation=relation, names=", ".join(FILE_ENDINGS))
    return relation


def _check_no_spreadsheet(relation: str) -> None:
    if is_spreadsheet(relation):
        raise wrong("spreadsheet", relation=relation)


def opened(
    settings: Settings,
    threads: int | None = None,
    writable: bool = True,
    must_exist: bool = True,
    files: Sequence[Path] = (),
) -> Session:
    """Open the database that holds the state; a file that must not exist already may be made.

    Raises:
        UserError: no database was named, or it cannot be opened.
    """
    if (address := settings.source.database) is None:
        raise wrong("no_database_for_state")
    addresses.check(address)
    if must_exist and not is_url(address) and not Path(address).exists():
        raise EngineError(f"There is no database file {address}.")
    return connect(address, threads, writable, files)
