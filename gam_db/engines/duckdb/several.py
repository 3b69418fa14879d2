"""Several files that are one source: their columns, the dialect of CSV files, common types of Parquet's.

The dialect of CSV files is that of the first that has rows. Where Parquet files have other types in a
column, it is read by the type that holds the values of all; where there is none its type says so.
"""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

import duckdb
from sqlglot import exp

from gam_db import data
from gam_db.clock import TimeKind
from gam_db.composing import template
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.reading import csv_options, csv_reader, parquet_reader, reader_option
from gam_db.engines.types import Several
from gam_db.errors import SourceError, wrong
from gam_db.settings.form import Form

_QUERIES = data.table("gam_db.engines.duckdb", "duckdb.toml")["queries"]

Columns = Mapping[str, str]  # name -> type
#: What sniffing a file tells of its dialect, by the option of the reader that says it.
_DIALECT = {"delim": "Delimiter", "quote": "Quote", "escape": "Escape", "skip": "SkipRows"}
_NONE = ("(empty)", "\0")
_CALENDAR = {"DATE", "TIMESTAMP", "TIMESTAMP WITH TIME ZONE"}
_ZONED = (TimeKind.TIMESTAMP_WITH_ZONE, TimeKind.NANOSECONDS_WITH_ZONE)
_NOTHING = '"NULL"'  # the type of a Parquet column without any value
#: Columns that a message lists.
_LISTED = 12


@dataclass(frozen=True)
class Differing:
    """A column that has several types, for which there is no common one."""

    name: str
    files: Mapping[str, str]  # type -> the first file that has it

    @property
    def shown(self) -> str:
        """What takes the place of the type."""
        return Several(" and ".join(f"{type_name} in {file}" for type_name, file in self.files.items()))


def check_columns(by_file: Mapping[str, Iterable[str]]) -> None:
    """Refuse (SourceError) files that have not all the same columns, in whatever order."""
    (first, theirs), *others = by_file.items()
    for file, names in others:
        if {*names} != {*theirs}:
            names, theirs = _differing(names, theirs), _differing(theirs, names)
            raise wrong("other_columns", path=file, names=names, first=first, theirs=theirs)


def _differing(names: Iterable[str], others: Iterable[str]) -> str:
    """Return names as a message lists them: of many, those that the others have not."""
    listed, more = [*names], {*names} - {*others}
    if len(listed) <= _LISTED:
        return f"the columns {', '.join(listed)}"
    shown = [name for name in listed if name in more][:_LISTED]
    left = f" and {len(more) - len(shown)} more" * (len(more) > len(shown))
    return f"{len(listed)} columns" + f", among them {', '.join(shown)}{left}" * bool(shown)


def csv_files(
    connection: duckdb.DuckDBPyConnection,
    files: Sequence[str],
    form: Form,
    columns_of: Callable[[exp.Expr, str], Columns | None],
) -> exp.Expr:
    """Return the node that reads CSV files as one table; those without a row are left out.

    Args:
        connection: of DuckDB.
        files: their paths.
        form: how they are written.
        columns_of: from the node that reads a file, and its path, to its columns; None if it has no row.

    Raises:
        SourceError: none has a row, or a file has other columns than the first.
    """
    dialect: list[exp.Expr] = []
    by_file: dict[str, Columns] = {}
    for file in files:
        try:
            columns = columns_of(csv_reader([file], [*csv_options(form), *dialect]), file)
        except SourceError as error:
            if dialect and columns_of(csv_reader([file], csv_options(form)), file) is not None:
                raise wrong("other_dialect", path=file, first=next(iter(by_file))) from error
            raise
        if columns is None:
            continue
        if not by_file and (len(files) > 1 or form.null):
            dialect, names = _dialect(connection, file, form)
            if {*(form.null or ())} & {*names}:  # these words are names where they stand above
                dialect.append(
                    reader_option("names", exp.Array(expressions=[*map(template.text, names)]))
                )
                columns = columns_of(csv_reader([file], [*csv_options(form), *dialect]), file) or {}
        by_file[file] = columns
    if not by_file:
        shown = files[0] + f" and {len(files) - 1} more" * (len(files) > 1)
        raise SourceError(f"{shown} has no rows; it is empty, or has only a header.")
    check_columns(by_file)
    if len(by_file) > 1:
        dialect.append(reader_option("union_by_name", exp.true()))
        dialect += _common_types(connection, by_file, [*csv_options(form), *dialect])
    return csv_reader([*by_file], [*csv_options(form), *dialect])


def _dialect(
    connection: duckdb.DuckDBPyConnection, file: str, form: Form
) -> tuple[list[exp.Expr], list[str]]:
    """Return the dialect of a file as options of the reader, and its columns."""
    options = [option for option in csv_options(form) if option.this.name != "nullstr"]
    sniffed = csv_reader([file], options, "SNIFF_CSV")
    wanted = [*_DIALECT.values(), "HasHeader", "Columns"]
    (row,) = connection.execute(ENGINE.text(exp.select(*wanted).from_(sniffed))).fetchall()
    *signs, has_header, columns = row
    chosen = {option.this.name for option in options}
    dialect = [
        reader_option(
            name, exp.Literal.number(value) if isinstance(value, int) else template.text(value)
        )
        for name, value in zip(_DIALECT, signs, strict=True)
        if name not in chosen and value not in _NONE
    ]
    dialect.append(reader_option("header", exp.true() if has_header else exp.false()))
    return dialect, [column["name"] for column in columns]


def _common_types(
    connection: duckdb.DuckDBPyConnection, by_file: Mapping[str, Columns], options: Sequence[exp.Expr]
) -> list[exp.Expr]:
    """Return, as an option of the reader, the types of columns that have several."""
    types = []
    for name in next(iter(by_file.values())):
        files = {file: columns[name] for file, columns in by_file.items()}
        if len({*files.values()}) > 1:
            for file in [file for file, of in files.items() if of == "VARCHAR"]:
                counted = exp.select(exp.Count(this=template.column(name)))
                reader = csv_reader(
                    [file], [option for option in options if option.this.name != "union_by_name"]
                )
                if connection.execute(ENGINE.text(counted.from_(reader))).fetchone() == (0,):
                    del files[file]  # it has no value in this file
            common = _common_of_texts({*files.values()})
            types.append(exp.PropertyEQ(this=template.text(name), expression=template.text(common)))
    return [reader_option("types", exp.Struct(expressions=types))] if types else []


def _common_of_texts(types: set[str]) -> str:
    """Return the type of a column that CSV files seem to have by several."""
    if len(types) == 1:
        return next(iter(types))
    if all(map(ENGINE.types.is_numeric, types)):
        return "DOUBLE"
    if types <= _CALENDAR:
        return max(types, key=len)
    return "VARCHAR"


def columns_of_parquet(
    connection: duckdb.DuckDBPyConnection, files: Sequence[str]
) -> dict[str, dict[str, str]]:
    """Return the columns of Parquet files and their types, file by file."""
    columns: dict[str, dict[str, str]] = {file: {} for file in files}
    below = 0  # nodes of a nested column that are still to come
    for file, name, type_name, children in connection.execute(_QUERIES["schemas"], [files]).fetchall():
        if type_name is None:  # the root
            continue
        if not below:
            columns[file][name] = type_name
        below += (children or 0) - (below > 0)
    return columns


def parquet_files(
    connection: duckdb.DuckDBPyConnection, paths: Sequence[str], by_file: Mapping[str, Columns]
) -> tuple[exp.Expr, list[Differing]]:
    """Return the node that reads Parquet files as one table, and the columns without a common type.

    Raises:
        SourceError: a file has other columns than the first.
    """
    check_columns(by_file)
    first, *others = by_file.values()
    if not any(columns[name] != first[name] for columns in others for name in first):
        return parquet_reader(paths), []
    alike: dict[tuple[str, ...], list[str]] = {}
    for file, columns in by_file.items():
        alike.setdefault(tuple(columns[name] for name in first), []).append(file)
    groups = sorted(alike.items())  # by their types: names of files and their order change nothing
    read: dict[str, Mapping[str, exp.Expr]] = {}
    differing = []
    for place, name in enumerate(first):
        having: dict[str, list[str]] = {}
        for types, named in groups:
            having.setdefault(types[place], []).extend(named)
        files = {of: min(named) for of, named in sorted(having.items())}
        terms = _common(connection, name, files, having)
        if terms is None:
            differing.append(Differing(name, files))
            terms = {of: exp.cast(template.column(name), "VARCHAR") for of in files}
        read[name] = terms
    parts = []
    for types, named in groups:
        every = [
            exp.alias_(read[name][of].copy(), template.name(name))
            for name, of in zip(first, types, strict=True)
        ]
        parts.append(exp.select(*every).from_(parquet_reader(named)))
    return exp.union(*parts, distinct=False).subquery("several"), differing


def _common(
    connection: duckdb.DuckDBPyConnection,
    name: str,
    files: Mapping[str, str],
    groups: Mapping[str, list[str]],
) -> dict[str, exp.Expr] | None:
    """Return how a column is read by each of its types, as one type; None if there is none for all."""
    column, types = template.column(name), ENGINE.types
    there = [of for of in files if of != _NOTHING]
    kinds = {of: types.time_kind(of) for of in there}
    if len(there) == 1:
        return {of: exp.cast(column, there[0]) if of == _NOTHING else column for of in files}
    if all(kind is not None and not kind.is_counter for kind in kinds.values()):
        zoned = {kind in _ZONED for kind in kinds.values()}
        if len(zoned) > 1:
            return None
        common = TimeKind.TIMESTAMP_WITH_ZONE if zoned == {True} else TimeKind.TIMESTAMP
        of_type = {
            of: ENGINE.instant_of(common, ENGINE.micros_of(kind, column))
            for of, kind in kinds.items()
            if kind is not None
        }
        return of_type | {of: exp.cast(exp.null(), "TIMESTAMP") for of in files if of == _NOTHING}
    if not all(map(types.is_numeric, there)):
        return None
    wanted = common_number(there)
    narrowed = [of for of in there if wanted == "DOUBLE" and not types.is_binary_float(of)]
    if any(_loses(connection, column, of, wanted, groups[of]) for of in narrowed):
        return None
    return {of: exp.cast(column, wanted) for of in files}


def common_number(types: Iterable[str]) -> str:
    """Return the narrowest type that holds numbers of some types, DOUBLE where no other does."""
    whole = scale = 0
    for of in types:
        if ENGINE.types.is_binary_float(of):
            return "DOUBLE"
        digits = [int(number) for number in re.findall(r"\d+", of)] if of.startswith("DECIMAL") else []
        digits = digits or [_DIGITS.get(of, 38), 0]
        whole, scale = max(whole, digits[0] - digits[1]), max(scale, digits[1])
    if not scale and not any(of.startswith("DECIMAL") for of in types):
        return "BIGINT" if whole < _DIGITS["UBIGINT"] else "HUGEINT"
    return f"DECIMAL({whole + scale},{scale})" if whole + scale <= 38 else "DOUBLE"


#: Digits of integers.
_DIGITS = {"TINYINT": 3, "SMALLINT": 5, "INTEGER": 10, "BIGINT": 19}
_DIGITS |= {"UTINYINT": 3, "USMALLINT": 5, "UINTEGER": 10, "UBIGINT": 20}


def _loses(
    connection: duckdb.DuckDBPyConnection, column: exp.Expr, of: str, wanted: str, files: Sequence[str]
) -> bool:
    """Tell whether a value of a type is another one as the wanted type."""
    again = exp.TryCast(
        this=exp.cast(column.copy(), wanted), to=exp.DataType.build(of, dialect="duckdb")
    )
    lost = exp.NullSafeNEQ(this=again, expression=column.copy())
    query = exp.select(exp.Literal.number(1)).from_(parquet_reader(files)).where(lost).limit(1)
    return connection.execute(ENGINE.text(query)).fetchone() is not None
