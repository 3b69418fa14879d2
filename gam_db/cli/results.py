"""Where the results of ``gam run`` go: which files, and whether they may be written.

This module owns what is refused before any work.
"""

import os
import re
from dataclasses import dataclass
from itertools import takewhile
from pathlib import Path
from typing import Any, Literal

from pyarrow import ArrowInvalid, parquet

from gam_db.cli import options
from gam_db.engines.duckdb_files import SOURCE_MARK
from gam_db.errors import ConfigurationError
from gam_db.source import FILE_ENDINGS, is_file, paths_of

#: The estimator that is the method itself; others come by the entry points ``gam_db.estimators``.
DSE = "dse"

_PARQUET_ENDINGS = (".parquet", ".pq")

Every = Literal["vector", "stride"]


@dataclass(frozen=True)
class Result:
    """Where the rows of one step go."""

    step: str
    path: Path
    table: str

    def __str__(self) -> str:
        return f"{self.path} (table {self.table})" if _is_database(self.path) else str(self.path)


def results_of(
    relation: Any, database: str | None, out: Path | None, every: Every, estimator: str
) -> list[Result]:
    """Return what is written where; refuse, before any work, what cannot be written."""
    health = ("bucket_health", "health_at_buckets") if every == "stride" else ("health_indicator",) * 2
    steps = {health[0]: health[1], "support_summary": "support", "certificate": "certificate"}
    if estimator != DSE:
        steps = {
            f"score_{health[0]}" if every == "stride" else "score_health": f"{health[1]}_{estimator}"
        }
    ending = "health" if estimator == DSE else estimator
    path = Path(f"{_stem(relation)}.{ending}.parquet") if out is None else out
    if _is_database(path):
        paths = [path] * 3
    elif path.suffix.lower() in _PARQUET_ENDINGS:
        name = path.stem.removesuffix(".health")
        beside = [path.with_name(f"{name}.{what}{path.suffix}") for what in ("support", "certificate")]
        paths = [path, *beside]
    else:
        raise ConfigurationError(
            f"--out is {path}; give a Parquet file (.parquet) or a DuckDB file (.duckdb, .db)."
        )
    if not path.parent.is_dir():
        raise ConfigurationError(f"--out is {path}; the folder {path.parent} is not there.")
    for one in paths:
        if not os.access(one if one.exists() else one.parent, os.W_OK):
            raise ConfigurationError(f"--out is {path}; you may not write {one}.")
    if out is None and not _is_database(path):
        _check_theirs(path, relation)
    read = {Path(one).resolve() for one in (*paths_of(relation), database) if one is not None}
    for one in paths:
        if one.resolve() in read and not (isinstance(relation, tuple) and _made_from(one)):
            raise ConfigurationError(f"{one} would be overwritten while it is read; give another --out.")
    return [
        Result(step, one, f"gam_{table}")
        for (step, table), one in zip(steps.items(), paths[: len(steps)], strict=True)
    ]


def _check_theirs(path: Path, relation: Any) -> None:
    """Refuse to write over the results of another source that is called alike.

    Results may be replaced where all that they were made from is read again.

    Raises:
        ConfigurationError: the file holds such.
    """
    of = _made_from(path)
    read = [Path(os.path.abspath(one)) for one in paths_of(relation)]
    read = [one.parent if "*" in one.name else one for one in read]
    if (
        of
        and is_file(relation)
        and not all(any(map(Path(one).is_relative_to, read)) for one in of.split(";"))
    ):
        raise ConfigurationError(
            f"{path} holds the results of {of}, a source of the same name; say --out, or remove it."
        )


def _made_from(path: Path) -> str:
    """Return what a file of results was made from; empty where there is none, or it is none of ours."""
    try:
        said = parquet.read_metadata(path).metadata or {}
    except (OSError, ArrowInvalid):
        return ""
    return str(said.get(SOURCE_MARK.encode(), b"").decode())


def _stem(relation: Any) -> str:
    """Return a file name for the results of a source, whatever the source is called.

    Of several files it is what their names begin with, as it is that of a pattern: then results among
    them, where a shell wrote a pattern out, change nothing.
    """
    name = relation
    if is_file(relation):
        signs = zip(*(Path(one).name for one in paths_of(relation)), strict=False)
        name = "".join(first for first, *others in takewhile(lambda at: len({*at}) == 1, signs))
    for ending in sorted(FILE_ENDINGS, key=len, reverse=True):
        if name.lower().endswith(ending):
            name = name[: -len(ending)]
            break
    return re.sub(r"[^\w.-]+", "_", name).strip("._")[:100] or "gam"


def _is_database(path: Path) -> bool:
    return path.suffix in options.DATABASE_ENDINGS
