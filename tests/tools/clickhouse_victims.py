"""Processes on a folder of chdb that are made to be killed; see :mod:`victims`, whose program this is.

A process does ``work``, in this order: ``begin`` makes the source and calibrates on its rows, ``look``
writes down what is seen and stored, ``score`` scores, ``prune`` prunes, ``arrive`` adds rows. A
process that is told to die ``after`` a table dies when that table was appended to.
"""

import json
import os
import signal
from pathlib import Path
from typing import Any

from sqlglot import exp

import gam_db
import small_plant
import victims
from gam_db.engines.session import Session
from gam_db.stored import pruning
from gam_db.stored.monitor import Monitor
from harness import arrow
from scripts import arrive
from visible import BUCKETS, NOVEL, visible

#: A statement is cut into blocks of so many rows, so that it may be cut short between two of them.
BLOCK = 7

_UNFINISHED = """
    SELECT COUNT(*) AS unfinished FROM gam_state_bucket AS written
    LEFT JOIN (SELECT run_id, 1 AS hit FROM gam_state_run GROUP BY run_id) AS finished
    ON finished.run_id = written.run_id
    WHERE finished.hit IS NULL OR finished.hit <> 1
"""
_STORED = "SELECT COUNT(*) AS stored FROM gam_state_bucket"


def looked(monitor: Monitor) -> dict[str, Any]:
    """Return what is seen of the state, and how many rows of buckets there are in all."""
    return {
        "seen": [visible(monitor, BUCKETS), visible(monitor, NOVEL)],
        **visible(monitor, _UNFINISHED)[0],
        **visible(monitor, _STORED)[0],
    }


def die_after(table: str) -> None:
    """Let this process die when rows were appended to a table of the state."""
    execute = Session.execute

    def executed(session: Session, statement: exp.Expr) -> None:
        execute(session, statement)
        if isinstance(statement, exp.Insert) and statement.this.this.name.endswith(f"state_{table}"):
            os.kill(os.getpid(), signal.SIGKILL)

    setattr(Session, "execute", executed)  # noqa: B010


def live(order: dict[str, Any], said: int) -> None:
    """Do the work of an order, and announce every step."""

    def announce(step: str) -> None:
        os.write(said, f"{step}\n".encode())

    with gam_db.connect(order["database"]) as session:
        announce("open")
        if order.get("after"):
            die_after(order["after"])
        work(session, order, announce)


def work(session: Session, order: dict[str, Any], announce: Any) -> None:
    """Do the work of an order."""
    assert isinstance(session, Session)
    for setting in ("max_block_size", "min_insert_block_size_rows", "min_insert_block_size_bytes"):
        session.driver.execute(f"SET {setting} = {BLOCK}")
    session.driver.execute("SET max_threads = 1")
    table = exp.to_table("telemetry")
    monitor = small_plant.monitor(session)
    looks = []
    for task in order["work"]:
        if task == "begin":
            with session.lent(arrow(order["rows"])) as lent:
                session.execute(session.engine.create_table(table, exp.select("*").from_(lent)))
            monitor.migrate()
            monitor.calibrate()
        elif task == "look":
            looks.append(looked(monitor))
        elif task == "arrive":
            arrive(session, table, order["rows"])
        elif task == "prune":
            setattr(pruning, "DAY", 0)  # noqa: B010
            monitor.prune()
        else:
            monitor.score(on_step=announce)
    if looks:
        Path(order["into"]).write_text(json.dumps(looks), encoding="utf-8")


if __name__ == "__main__":
    victims.live = live
    victims.serve()
