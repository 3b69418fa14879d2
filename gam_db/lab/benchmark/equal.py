"""Are the integers of two programs the same, row by row?"""

from pathlib import Path
from typing import Any

import pyarrow as pa

from gam_db.errors import InternalError
from gam_db.lab.benchmark.database import opened, statement
from gam_db.lab.benchmark.inside import PARAMETERS, RESULTS


def compare(first: Path, second: Path) -> dict[str, Any]:
    """Compare the tables that two programs have written.

    Returns:
        The rows of each table, and novel_share: novel vectors among all vectors in full buckets.

    Raises:
        InternalError: they differ; the message says where.
    """
    rows = {}
    for table in RESULTS:
        left, right = _written(first, table), _written(second, table)
        if left.num_rows != right.num_rows:
            raise InternalError(
                f"The programs disagree: {table} has {left.num_rows} rows in one result and "
                f"{right.num_rows} in the other."
            )
        for column in left.column_names:
            if not left.column(column).equals(right.column(column)):
                raise InternalError(f"The programs disagree in the column {column} of {table}.")
        rows[table] = left.num_rows
    novel = _written(first, "bucket_health").column("novel").to_numpy()
    vectors = len(novel) * PARAMETERS.bucket_length
    return {"rows": rows, "novel_share": float(novel.sum()) / vectors if vectors else None}


def _written(path: Path, table: str) -> pa.Table:
    with opened(path, threads=1, read_only=True) as connection:
        return connection.sql(statement(f"written_{table}")).to_arrow_table()
