"""Reading files with DuckDB, as trees: its readers and their options, words as numbers and times."""

import re
from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import called, formula
from gam_db.settings.form import SPACES, Form, number_pattern

#: An hour, and behind it a zone.
_HAS_ZONE = r"[0-9][T ][0-9].*(Z|[+-][0-9]{2}(:?[0-9]{2})?)\s*$"
_IS_ZONED = "own.REGEXP_MATCHES(own.TRIM(:words), :zoned)"
_DAY = r"[0-9]{4}(?:-[0-9]{1,2}-[0-9]{1,2}|/[0-9]{1,2}/[0-9]{1,2})"
_HOUR = r"[0-9]{1,2}:[0-9]{2}(?::[0-9]{2}(?:\.[0-9]+)?)?"
#: A time in ISO 8601 without a zone, and with one.
_LOCAL = rf"\s*{_DAY}(?:[T ]{_HOUR})?\s*"
_ZONED = rf"\s*{_DAY}[T ]{_HOUR} ?(?:Z|UTC|[+-][0-9]{{2}}(?::?[0-9]{{2}})?)\s*"
_INSTANT = """
    CASE WHEN own.REGEXP_FULL_MATCH(:words, :local) THEN TRY_CAST(own.TRIM(:words) AS TIMESTAMP)
    WHEN own.REGEXP_FULL_MATCH(:words, :zoned)
    THEN own.MAKE_TIMESTAMP(own.EPOCH_US(TRY_CAST(own.TRIM(:words) AS TIMESTAMPTZ))) END
"""
#: Infinite, or beyond 64 bits, is no count.
_COUNT = """
    CASE WHEN own.REGEXP_FULL_MATCH(:words, :whole) THEN TRY_CAST(own.TRIM(:words) AS BIGINT) END
"""


def number_of(words: exp.Expr, form: Form) -> exp.Expr:
    """Return the numbers of words."""
    digits = called("REGEXP_EXTRACT", words, template.text(number_pattern(form)), exp.Literal.number(1))
    if form.thousands:
        between = f"[{SPACES}]" if form.thousands == " " else f"[{form.thousands}]"
        digits = called("REGEXP_REPLACE", digits, *map(template.text, (between, "", "g")))
    if form.decimal == "," or (form.decimal is None and form.thousands == "."):
        digits = called("REPLACE", digits, template.text(","), template.text("."))
    return exp.TryCast(this=digits, to=exp.DataType.build("DOUBLE"))


def instant_of_text(words: exp.Expr, time_format: str | None) -> exp.Expr:
    """Return the times of words.

    Cause: cast to TIMESTAMP, a text loses its zone, AM and PM, and whatever else stands behind an hour,
    and 03/03/26 is a day of the year 3; cast to TIMESTAMPTZ, one without a zone takes that of the
    connection. Symptom: 10:00+01:00 is 10:00, and so is 10:00 PM.
    """
    if time_format is not None:
        return called("TRY_STRPTIME", called("TRIM", words), template.text(time_format))
    return formula(_INSTANT, words=words, local=template.text(_LOCAL), zoned=template.text(_ZONED))


def count_of_text(words: exp.Expr) -> exp.Expr:
    """Return the integers of words.

    Cause: cast to BIGINT, a text is rounded, and read as hexadecimal. Symptom: 1.5 is 2, and 0x10 is 16.
    """
    return formula(_COUNT, words=words, whole=template.text(r"\s*[+-]?[0-9]+\s*"))


def is_zoned(words: exp.Expr) -> exp.Expr:
    """Return whether words tell times with their zones."""
    return formula(_IS_ZONED, words=words, zoned=template.text(_HAS_ZONE))


def is_csv_reader(relation: exp.Expr) -> bool:
    """Tell whether a node reads CSV files."""
    return isinstance(relation.this, exp.Anonymous) and relation.this.name == "READ_CSV"


def all_as_text(reader: exp.Expr) -> exp.Expr:
    """Return the reader of CSV files with all columns as they are written."""
    reader = reader.copy()
    files, *options = reader.this.expressions
    others = [files, *(option for option in options if option.this.name not in ("types", "nullstr"))]
    reader.this.set("expressions", [*others, reader_option("all_varchar", exp.true())])
    reader.set("alias", None)
    return reader


def retyped(relation: exp.Expr, types: Mapping[str, str]) -> exp.Expr:
    """Return the reader of a text file with the types of some columns set."""
    if not is_csv_reader(relation):
        return relation
    reader, struct = relation.copy(), exp.Struct(expressions=[])
    for option in reader.this.expressions[1:]:
        if option.this.name == "types":
            struct = option.expression
            option.pop()
    others = [pair for pair in struct.expressions if pair.this.name not in types]
    more = [
        exp.PropertyEQ(this=template.text(name), expression=template.text(of))
        for name, of in types.items()
    ]
    if others or more:
        reader.this.append(
            "expressions", reader_option("types", exp.Struct(expressions=[*others, *more]))
        )
    return reader


def reader_option(name: str, value: exp.Expr) -> exp.Expr:
    """Return an option of a reader."""
    return exp.EQ(this=exp.column(name), expression=value)


def parquet_reader(paths: Sequence[str]) -> exp.Expr:
    """Return the node that reads Parquet files by their paths, which may be patterns.

    Cause: Parquet's statistics leave NaN out, and DuckDB trusts them. Symptom: where all other values of
    a column lie between -1e300 and 1e300, the test for missing ones is optimised away, and NaN counts as
    a reading (seen on files that PyArrow wrote; DuckDB's own have no statistics then).
    """
    return exp.Table(
        this=called("READ_PARQUET", _files(paths), reader_option("can_have_nan", exp.true()))
    )


def csv_reader(paths: Sequence[str], options: Sequence[exp.Expr], reader: str = "READ_CSV") -> exp.Expr:
    """Return the node that reads CSV files by their paths, which may be patterns."""
    return exp.Table(this=called(reader, _files(paths), *(option.copy() for option in options)))


def _files(paths: Sequence[str]) -> exp.Expr:
    first, *others = map(template.text, paths)
    return exp.Array(expressions=[first, *others]) if others else first


def paths_read(reader: exp.Expr) -> list[str]:
    """Return the paths that such a node reads."""
    return [literal.name for literal in reader.this.expressions[0].find_all(exp.Literal)]


def is_text_file(path: str) -> bool:
    """Tell whether a path is that of a CSV file."""
    return path.lower().endswith((".csv", ".tsv", ".csv.gz", ".tsv.gz", ".csv.zst"))


def csv_options(form: Form) -> list[exp.Expr]:
    """Return the options of the reader of CSV files; a word for missing values is one in any column."""
    has_hour = {"%H", "%I", "%c", "%X"} & {*re.findall("%-?[A-Za-z]", form.time_format or "%H")}
    settings = {
        "delim": form.delimiter,
        "decimal_separator": form.decimal or ("," if form.thousands == "." else None),
        "thousands": form.thousands,
        "skip": form.skip_rows,
        "timestampformat" if has_hour else "dateformat": form.time_format,
    }
    options = [
        reader_option(
            name, exp.Literal.number(value) if isinstance(value, int) else template.text(value)
        )
        for name, value in settings.items()
        if value is not None
    ]
    if form.null:
        words = [template.text(word) for word in ("", *form.null)]
        options.append(reader_option("nullstr", exp.Array(expressions=words)))
    return options
