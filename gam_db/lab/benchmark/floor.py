"""The engine floor: one pass over the sorted channels that looks back twice, and nothing else."""

from pathlib import Path

from gam_db.lab.benchmark.database import opened, statement


def run(source: Path, threads: int, name: str) -> None:
    """Sort every channel by time, delay its values and add them up.

    Args:
        source: the file of the workload.
        threads: of DuckDB.
        name: ``floor_on_ids`` or ``floor_on_names``, each a statement of ``sql/benchmark``.
    """
    with opened(source, threads, read_only=True) as connection:
        connection.execute(statement(name)).fetchall()
