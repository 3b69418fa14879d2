"""Reading files with DuckDB, as trees: its readers and their options, words as numbers and times."""

import re
from collections.abc import Mapping, Sequence

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import called, formula
from gam_db.settings.form import SPACES, Form, number_pattern

#: An hour, and behind it a zone.
_ZONED = r"[0-9][T ][0-9].*(Z|[+-][0-9]{2}(:?[0-9]{2})?)\s*$"
_IS_ZONED = "own.REGEXP_MATCHES(own.TRIM(:words), :zoned)"
_INSTANT = """
    CASE WHEN own.REGEXP_MATCHES(own.TRIM(:words), :zoned)
    THEN own.MAKE_TIMESTAMP(own.EPOCH_US(TRY_CAST(own.TRIM(:words) AS TIMESTAMPTZ)))
    ELSE TRY_CAST(own.TRIM(:words) AS TIMESTAMP) END
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

    Cause: cast to TIMESTAMP, a text loses its zone; cast to TIMESTAMPTZ, one without takes that of the
    connection. Symptom: 10:00+01:00 is 10:00.
    """
    if time_format is not None:
        return called("TRY_STRPTIME", called("TRIM", words), template.text(time_format))
    return formula(_INSTANT, words=words, zoned=template.text(_ZONED))


def is_zoned(words: exp.Expr) -> exp.Expr:
    """Return whether words tell times with their zones."""
    return formula(_IS_ZONED, words=words, zoned=template.text(_ZONED))


def is_csv_reader(relation: exp.Expr) -> bool:
    """Tell whether a node reads CSV files."""
    return isinstance(relation.this, exp.Anonymous) and relation.this.name == "READ_CSV"


def all_as_text(reader: exp.Expr) -> exp.Expr:
    """Return the reader of CSV files with all columns as they are written."""
    reader = reader.copy()
    files, *options = reader.this.expressions
    kept = [files, *(one for one in options if one.this.name not in ("types", "nullstr"))]
    reader.this.set("expressions", [*kept, _option("all_varchar", exp.true())])
    reader.set("alias", None)
    return reader


def seen_formats(relation: exp.Expr) -> exp.Query | None:
    """Return the query for the formats of dates and times that a CSV file seems to have."""
    if not is_csv_reader(relation):
        return None
    files, *options = [one.copy() for one in relation.this.expressions]
    first = files.expressions[0] if isinstance(files, exp.Array) else files
    sniffer = exp.Table(this=called("SNIFF_CSV", first, *options))
    return exp.select("DateFormat", "TimestampFormat").from_(sniffer)


def retyped(relation: exp.Expr, types: Mapping[str, str]) -> exp.Expr:
    """Return the reader of a text file with the types of some columns said."""
    if not is_csv_reader(relation):
        return relation
    reader, said = relation.copy(), exp.Struct(expressions=[])
    for option in reader.this.expressions[1:]:
        if option.this.name == "types":
            said = option.expression
            option.pop()
    others = [one for one in said.expressions if one.this.name not in types]
    more = [
        exp.PropertyEQ(this=template.text(name), expression=template.text(of))
        for name, of in types.items()
    ]
    reader.this.append("expressions", _option("types", exp.Struct(expressions=[*others, *more])))
    return reader


def _option(name: str, value: exp.Expr) -> exp.Expr:
    return exp.EQ(this=exp.column(name), expression=value)


def file_reader(paths: Sequence[str], form: Form | None = None) -> exp.Expr:
    """Return the node that reads Parquet or CSV files by their paths, which may be patterns.

    Cause: Parquet's statistics leave NaN out, and DuckDB trusts them. Symptom: where all other values of
    a column lie between -1e300 and 1e300, the test for missing ones is optimised away, and NaN counts as
    a reading (seen on files that PyArrow wrote; DuckDB's own have no statistics then).
    """
    paths = [f"{path}**/*.parquet" if path.endswith("/") else path for path in paths]
    files = template.text(paths[0])
    if len(paths) > 1:
        files = exp.Array(expressions=[template.text(path) for path in paths])
    if not is_text_file(paths[0]):
        return exp.Table(this=called("READ_PARQUET", files, _option("can_have_nan", exp.true())))
    return exp.Table(this=called("READ_CSV", files, *_csv_options(form or Form())))


def paths_read(reader: exp.Expr) -> list[str]:
    """Return the paths that such a node reads."""
    return [one.name for one in reader.this.expressions[0].find_all(exp.Literal)]


def is_text_file(path: str) -> bool:
    """Tell whether a path is that of a CSV file."""
    return path.lower().endswith((".csv", ".tsv", ".csv.gz", ".tsv.gz", ".csv.zst"))


def _csv_options(form: Form) -> list[exp.Expr]:
    """Return what the reader of CSV files is told; a word that means a missing value is so anywhere."""
    has_hour = {"%H", "%I", "%c", "%X"} & {*re.findall("%-?[A-Za-z]", form.time_format or "%H")}
    said = {
        "delim": form.delimiter,
        "decimal_separator": form.decimal or ("," if form.thousands == "." else None),
        "thousands": form.thousands,
        "skip": form.skip_rows,
        "timestampformat" if has_hour else "dateformat": form.time_format,
    }
    options = [
        _option(name, exp.Literal.number(value) if isinstance(value, int) else template.text(value))
        for name, value in said.items()
        if value is not None
    ]
    if form.null:
        words = [template.text(word) for word in ("", *form.null)]
        options.append(_option("nullstr", exp.Array(expressions=words)))
    return options
