"""Guessing which column is the machine, the signal, the time and the reading, where no setting names it.

This module owns the settings of a source, well-known column names and the rules of guessing. Where it
cannot tell, it asks: a wrong guess would merge machines or signals silently. It reads no rows.
"""

import dataclasses
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, TypeAlias

from gam_db import data
from gam_db.address import shown
from gam_db.clock import Length
from gam_db.engines.base import Engine
from gam_db.engines.conditions import check_conditions
from gam_db.engines.frames import arrow_table, signal_table
from gam_db.engines.session import Session
from gam_db.errors import SourceError, nearest
from gam_db.settings.form import Form
from gam_db.settings.setting import (
    COLUMN,
    COLUMNS,
    FLAG,
    LENGTH,
    TEXT,
    TEXT_OR_TEXTS,
    choice_of,
    declared,
    setting,
)
from gam_db.settings.source import AnySource, Source, WideSource, as_folder, is_file

#: The name of a column, False for "there is none", None for "not set".
Column: TypeAlias = str | Literal[False] | None

#: One column per channel: a text in gam.toml, an option without a value on the command line.
LAYOUT = dataclasses.replace(choice_of("long", "wide"), option=bool, read=lambda *_: "wide")


@declared
@dataclass(frozen=True)
class SourceSettings(Form):
    """The settings of a source; None is "not set", and gam-db guesses what is not set."""

    relation: str | tuple[str, ...] | None = setting(None, TEXT_OR_TEXTS)
    database: str | None = setting(None, TEXT)
    asset: Column = setting(None, COLUMN)
    channel: Column = setting(None, dataclasses.replace(COLUMN, option=list[str]))
    time: str | None = setting(None, COLUMN)
    value: str | None = setting(None, COLUMN)
    layout: str | None = setting(None, LAYOUT)
    channels: tuple[str, ...] | None = setting(None, COLUMNS)
    where: str | None = setting(None, TEXT)
    where_any: bool | None = setting(None, FLAG)
    time_kind: str | None = setting(None, choice_of("timestamp", "timestamp with time zone", "counter"))
    clock_tolerance: Length | Literal[False] | None = setting(None, LENGTH, off=(False, "any time"))

    @property
    def shown_database(self) -> str | None:
        """The address of the database without its password."""
        return None if self.database is None else shown(self.database)

    def check_conditions(self, engine: Engine) -> None:
        """Refuse conditions that are not allowed on an engine, unless ``where_any`` allows all.

        Raises:
            UserError: one is not a condition, or contains something that is not listed.
        """
        if not self.where_any:
            check_conditions(self.where, self.valid_when, engine)


#: role -> names of columns that have it, in two strengths.
COLUMN_NAMES: Mapping[str, tuple[frozenset[str], frozenset[str]]] = {
    role: (frozenset(words["strong"].split()), frozenset(words["weak"].split()))
    for role, words in data.table("gam_db.reading", "guess.toml").items()
}
_TAIL = re.compile(r"(?<=..)(id|name|number|no|nr)$")

_WHAT = {"asset": "the machine", "channel": "the signal", "time": "the time", "value": "the reading"}
_LONGEST = 260
"""Approximate length of an error that names columns; of many columns it names only the first."""
_NONE = {"asset": "--no-asset if it is one machine", "channel": "--no-channel if it is one signal"}


@dataclass(frozen=True)
class Guess:
    """A source with its columns, and which of them were guessed."""

    source: AnySource  # all columns named
    guessed: Mapping[str, str]  # role -> column, or a short phrase, for each role that was not set
    unused: tuple[str, ...]  # columns that are not read


def guess(
    relation: Any, columns: Mapping[str, str], settings: SourceSettings, session: Session
) -> Guess:
    """Return the source that the settings describe; guess the columns that they do not name.

    Columns are name -> type, in order; only columns, layout and condition of the settings count.

    Raises:
        SourceError: a named column does not exist, or a column that is not named cannot be guessed;
            the message lists the columns and the options to use.
        ConfigurationError: a condition contains something that is not allowed on the engine.
    """
    settings.check_conditions(session.engine)
    return _Guesser(columns, settings, session).guess(relation)


def folder_or_table(relation: Any, session: Session) -> Any:
    """Return a relation with the slash of a folder, if it is one and no table has its name."""
    folder = as_folder(relation)
    if not isinstance(relation, str) or folder == relation:
        return folder  # the database is not asked for its tables: a user may have no schema of his own
    return relation if relation.casefold() in session.relations() else folder


def sourced(source: Any, session: Session) -> AnySource:
    """Return a source as it is, or the source that a relation alone means: see :func:`looked_up`."""
    return looked_up(source, session).source


def looked_up(source: Any, session: Session) -> Guess:
    """Return a source as it is, or the source that a relation alone means, with guessed columns.

    A relation is a path, a list of paths, a folder, the name of a table, a data frame of pandas or
    polars, an Arrow table, a relation of DuckDB, a table of Ibis, or a single signal
    (:func:`gam_db.engines.frames.signal_table`).

    Raises:
        SourceError: it cannot be read, or a column cannot be guessed.
    """
    if isinstance(source, (Source, WideSource)):
        return Guess(source, {}, ())
    settings = SourceSettings()
    if isinstance(source, (list, tuple)) and is_file(several := [as_folder(path) for path in source]):
        source = several
    source = folder_or_table(source, session)
    if isinstance(source, (str, Path, list, tuple)):
        return guess(source, session.describe(session.relation(source)), settings, session)
    if (signal := signal_table(source)) is not None:
        time, value = signal.column_names
        return Guess(Source(signal, asset=None, channel=None, time=time, value=value), {}, ())
    table = arrow_table(source)
    with session.lent(table) as relation:
        return guess(table, session.describe(relation), settings, session)


class _Guesser:
    """The state of a guess: the columns without a role so far, and the roles of the others."""

    def __init__(self, columns: Mapping[str, str], settings: SourceSettings, session: Session) -> None:
        self.columns = columns
        self.settings = settings
        self.types = session.engine.types
        self.guessed: dict[str, str] = {}
        self.wide = settings.layout == "wide" or settings.channels is not None
        named = {
            role: column
            for role in ("asset", "channel", "time", "value")
            if isinstance(column := getattr(settings, role), str)
        }
        for role, column in [*named.items(), *(("channel", name) for name in settings.channels or ())]:
            if column not in columns:
                hint = nearest(column, columns)
                raise SourceError(f"There is no column {column!r} for {_WHAT[role]}{hint}")
        taken = {*named.values(), *(settings.channels or ())}
        self.free = [name for name in columns if name not in taken]

    def guess(self, relation: Any) -> Guess:
        time = self.settings.time or self._time()
        asset = self._name("asset")
        channel = None if self.wide else self._name("channel")
        value = None if self.wide else self.settings.value or self._value(channel)
        self._ask_about_texts(asset, channel)
        where, kind, written = self.settings.where, self.settings.time_kind, self.settings.written
        written = {**written, "clock_tolerance": self.settings.clock_tolerance}
        source: AnySource
        if value is None:
            signals = self.settings.channels or tuple(self._numeric())
            if not signals:
                raise self._unclear("No numeric column is left that could hold readings", ("value",))
            source = WideSource(relation, signals, asset, time, where, kind, **written)
        else:
            source = Source(relation, asset, channel, time, value, where, kind, **written)
        used = set(source.columns.values())
        return Guess(source, self.guessed, tuple(name for name in self.columns if name not in used))

    def _time(self) -> str:
        """A strong name, then the only calendar column, then weak names; weak ones must fit by type."""
        if (column := self._by_name("time", self.free, weak=False)) is None:
            kinds = {name: self.types.time_kind(self.columns[name]) for name in self.free}
            calendars = [name for name, kind in kinds.items() if kind and not kind.is_counter]
            if len(calendars) == 1:
                return self._take("time", calendars[0])
            has_unit = self.settings.time_unit is not None  # then numbers may be times, too
            fitting = [
                name
                for name, kind in kinds.items()
                if kind or (has_unit and self.types.is_numeric(self.columns[name]))
            ]
            if (column := self._by_name("time", calendars or fitting or self.free)) is None:
                many = f"{_listed(calendars)} could each be" if calendars else "No column looks like"
                raise self._unclear(f"{many} the time", ("time",))
        return self._take("time", column)

    def _name(self, role: str) -> str | None:
        if (named := getattr(self.settings, role)) is not None:
            return named or None
        fitting = [name for name in self.free if self.types.is_name(self.columns[name])]
        column = self._by_name(role, fitting)
        return None if column is None else self._take(role, column)

    def _value(self, channel: str | None) -> str | None:
        """Return the column of the readings; None where the table turns out to be wide."""
        if (strong := self._by_name("value", self.free, weak=False)) is not None:
            return self._take("value", strong)
        numeric = self._numeric()
        if len(numeric) == 1:
            return self._take("value", numeric[0])
        if not numeric:
            raise self._unclear("No numeric column is left that could hold readings", ("value",))
        if channel is None and self.settings.channel is None and self.settings.layout is None:
            self.guessed["layout"] = "wide: no column names the signal, so each numeric column is one"
            return None
        if (weak := self._by_name("value", numeric)) is None:
            raise self._unclear("Several columns could be the reading", ("value",))
        return self._take("value", weak)

    def _ask_about_texts(self, asset: str | None, channel: str | None) -> None:
        """Refuse columns of text that may name machines or signals; leaving them out would mix these."""
        is_wide = self.wide or "layout" in self.guessed
        open_roles = [
            role
            for role, column in (("asset", asset), ("channel", channel))
            if column is None
            and getattr(self.settings, role) is None
            and not (role == "channel" and is_wide)
        ]
        free = ((name, self.columns[name]) for name in self.free)
        texts = [name for name, of in free if self.types.is_name(of) and not self.types.is_numeric(of)]
        if open_roles and texts:
            what = " or ".join(_WHAT[role] for role in open_roles)
            raise self._unclear(f"{_listed(texts)} may name {what}", open_roles)

    def _by_name(self, role: str, among: Iterable[str], weak: bool = True) -> str | None:
        for names in COLUMN_NAMES[role] if weak else COLUMN_NAMES[role][:1]:
            matches = [name for name in among if {plain := _plain(name), _TAIL.sub("", plain)} & names]
            if len(matches) > 1:
                raise self._unclear(f"{_listed(matches)} could each be {_WHAT[role]}", (role,))
            if matches:
                return matches[0]
        return None

    def _take(self, role: str, column: str) -> str:
        self.guessed[role] = column
        self.free.remove(column)
        return column

    def _numeric(self) -> list[str]:
        """Return the columns that may hold readings: numbers, else truths, else readable texts."""
        types, reads_words = self.types, self.settings.reads_words
        for holds in (types.is_numeric, types.is_truth, *([types.is_text] if reads_words else [])):
            if columns := [name for name in self.free if holds(self.columns[name])]:
                return columns
        return []

    def _unclear(self, what: str, roles: Sequence[str]) -> SourceError:
        options = "; ".join(
            f"give --{role} COLUMN" + (f", or {_NONE[role]}" if role in _NONE else "") for role in roles
        )
        shown = [f"{name} ({type_name})" for name, type_name in self.columns.items()]
        room = _LONGEST - len(what) - len(options)
        named = next((n for n in range(len(shown), 0, -1) if len(", ".join(shown[:n])) <= room), 1)
        more = ", ..." if named < len(shown) else ""
        return SourceError(f"{what}; {options}; the columns are: {', '.join(shown[:named])}{more}.")


def _plain(name: str) -> str:
    return "".join(sign for sign in name.casefold() if sign.isalnum())


def _listed(names: Sequence[str]) -> str:
    return " and ".join(repr(name) for name in names)
