"""Files for DuckDB: which files of a folder are read, and the errors on unreadable ones.

This module also owns the metadata of files of results: what they are, and their source.
"""

import contextlib
import os
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import duckdb
from sqlglot import exp

from gam_db import data
from gam_db.composing import template
from gam_db.engines.duckdb import ENGINE
from gam_db.engines.duckdb.encoding import not_utf8
from gam_db.engines.duckdb.reading import all_as_text, paths_read
from gam_db.errors import SourceError, UserError, wrong
from gam_db.settings.form import options_for_null, options_for_numbers, shortened
from gam_db.settings.source import FILE_ENDINGS, as_folder, is_spreadsheet, shown_relation
from gam_db.version import __version__

#: Keys of the metadata of a Parquet file of results: the version that wrote it, and from what.
MARK, SOURCE_MARK = "gam_db", "gam_source"

#: Columns that only results have, in files that were written before these had metadata.
_OF_RESULTS = ("novel_in_window", "calibrated_lo", "learned_floor")


_AT_WORK = data.table("gam_db.engines.duckdb", "duckdb.toml")
_QUERIES, _MESSAGES = _AT_WORK["queries"], _AT_WORK["said"]

#: Formats of tables that are folders -> what inside tells, and the way through Arrow.
_TABLES = {
    "Delta Lake": ("_delta_log", "deltalake.DeltaTable(PATH).to_pyarrow_table()"),
    "Iceberg": (
        "metadata/*.metadata.json",
        "pyiceberg's StaticTable.from_metadata(PATH).scan().to_arrow()",
    ),
}


def without_results(connection: duckdb.DuckDBPyConnection, paths: Sequence[str]) -> list[str]:
    """Return the files of patterns, folders and lists but for those that gam-db wrote; a path as it is.

    Raises:
        SourceError: there are none but such.
    """
    paths = [inside for path in paths for inside in _inside(connection, path)]
    files = matching(connection, paths)
    parquet = [file for file in files if file.lower().endswith((".parquet", ".pq"))]
    if not parquet or files == paths[:1]:
        return paths
    try:
        parameters = [parquet, list(_OF_RESULTS), MARK]
        results = connection.execute(_QUERIES["results"], parameters).fetchall()
    except duckdb.Error:  # a file is not there or damaged, which is said where it is read
        return paths
    ours = {file for (file,) in results}
    if not ours:
        return paths
    others = [file for file in files if file not in ours]
    if not others:
        raise wrong("nothing_but_results", relation=shown_relation(paths))
    return others


def _inside(connection: duckdb.DuckDBPyConnection, path: str) -> list[str]:
    """Return the patterns of the files in a folder; a path as it is."""
    path = as_folder(path)
    if not path.endswith("/"):
        return [path]
    for table, (log, through) in _TABLES.items():
        if any(Path(path).glob(log)):
            raise wrong("table_that_is_a_folder", path=path, table=table, through=through)
    files = _matching(connection, f"{path}**/*")
    endings = {
        file[-len(ending) :]
        for file in files
        for ending in FILE_ENDINGS
        if file.lower().endswith(ending)
    }
    if not endings:
        if any(map(is_spreadsheet, files)):
            raise wrong("spreadsheet", relation=path)
        raise SourceError(f"The folder {path} does not exist, or contains no Parquet or CSV file.")
    return [f"{path}**/*{ending}" for ending in sorted(endings)]


def matching(connection: duckdb.DuckDBPyConnection, paths: Iterable[str]) -> list[str]:
    """Return the files of patterns; remote patterns are not expanded."""
    files: list[str] = []
    for path in paths:
        is_pattern = bool(set(path) & {*"*?["}) and "://" not in path
        files += (_matching(connection, path) or [path]) if is_pattern else [path]
    return [*dict.fromkeys(files)]  # a list may name one twice, by itself and by a folder


def _matching(connection: duckdb.DuckDBPyConnection, pattern: str) -> list[str]:
    return [file for (file,) in connection.execute(_QUERIES["matching"], [pattern]).fetchall()]


def metadata(sources: Sequence[str]) -> exp.Expr:
    """Return the metadata of a file of results: what they are, and their source."""
    paths = (source if "://" in source else os.path.abspath(source) for source in dict.fromkeys(sources))
    marks = {MARK: __version__, SOURCE_MARK: ";".join(paths)}
    pairs = [
        exp.PropertyEQ(this=template.text(name), expression=template.text(value))
        for name, value in marks.items()
    ]
    return exp.Struct(expressions=pairs)


def no_table(path: str, reason: str) -> UserError:
    """Return why a path is no table, in the user's words."""
    if (extension := re.search(_MESSAGES["extension"], reason)) is None:
        return wrong("duckdb_no_table", path=path)
    return wrong("duckdb_extension", path=path, extension=extension[1])


def unalike(error: duckdb.Error) -> UserError | None:
    """Return the error on files of one source with different columns; None for another error."""
    match = next(
        filter(None, (re.search(pattern, str(error)) for pattern in _MESSAGES["unalike"])), None
    )
    if match is None:
        return None
    file, other = match["file"] or "One file", match["first"] or "another"
    return wrong("duckdb_files_unalike", one=file, column=match["column"], other=other)


def wrong_line(message: str) -> UserError:
    """Return the error on an unreadable line of a CSV file."""
    line, file = re.search(_MESSAGES["line"], message), re.search(_MESSAGES["file"], message)
    if file is not None and re.search(_MESSAGES["encoding"], message):
        return not_utf8(file[1])
    at = "A line" if line is None else f"Line {line[1]}"
    return wrong("duckdb_csv_line", line=at, file="" if file is None else f" {file[1]}")


def late_word(
    connection: duckdb.DuckDBPyConnection, error: duckdb.Error, readers: Iterable[exp.Expr]
) -> UserError | None:
    """Return the error on a word far down a CSV file that its column cannot hold, if there is one.

    Of the nodes that read CSV files, that of the file at fault tells how it is written.
    """
    if (match := re.search(_MESSAGES["late"], str(error))) is None:
        return None
    line, column, word, kind, file = match.groups()
    like = exp.EQ(this=template.column(column), expression=template.text(word))
    of_file, rows = [reader for reader in readers if file in matching(connection, paths_read(reader))], 1
    if of_file:
        count = exp.select(exp.Count(this=exp.Star())).from_(all_as_text(of_file[-1])).where(like)
        with contextlib.suppress(duckdb.Error):  # the user's transaction has failed with the statement
            ((rows,),) = connection.execute(ENGINE.text(count)).fetchall()
    same = f", {rows:,} times in all" if rows > 1 else ""
    is_time = any(sign in kind for sign in ("TIME", "DATE"))
    options = {"--time-format" if is_time else options_for_numbers([word]), options_for_null(word)}
    word, read = shortened(word), " or ".join(sorted(options))
    of = "times" if is_time else "numbers"
    return wrong(
        "duckdb_late_word", line=line, file=file, word=word, column=column, same=same, of=of, read=read
    )
