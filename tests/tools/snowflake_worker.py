"""Answers statements of Snowflake's SQL on a relative of it, in a process of the relative's environment.

``python snowflake_worker.py fakesnow`` (or ``databend``) reads pickled statements from its standard
input and answers each by a pickled pair: ``found`` and an Arrow table, or ``refused`` and why. It
imports nothing of gam-db: the relatives pin versions of what gam-db needs, too.
"""

import contextlib
import os
import pickle
import re
import sys
import warnings
from collections.abc import Callable
from typing import Any

Run = Callable[[str], Any]


def fakesnow() -> tuple[str, Run]:
    """Return the version of fakesnow, and what runs a statement: Snowflake's words over DuckDB."""
    import importlib.metadata

    import fakesnow as library

    connection = library.FakeSnow().connect(database="plants", schema="public")

    def run(statement: str) -> Any:
        # The rows as DuckDB has them: the fake connector makes decimals of whole numbers.
        cursor = connection.cursor().execute(statement)
        return cursor._arrow_table

    return importlib.metadata.version("fakesnow"), run


def databend() -> tuple[str, Run]:
    """Return the version of Databend's embedded wheel, and what runs a statement."""
    import importlib.metadata

    from databend import SessionContext

    session = SessionContext()

    def run(statement: str) -> Any:
        frame = session.sql(statement)
        if re.match(r"(\s*--[^\n]*\n)*\s*(SELECT|WITH)\b", statement):
            return frame.to_arrow_table()
        frame.collect()
        return None

    return importlib.metadata.version("databend"), run


def main() -> None:
    """Answer until the input ends; the first answer is the version."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no answer
    warnings.simplefilter("ignore")
    version, run = {"fakesnow": fakesnow, "databend": databend}[sys.argv[1]]()
    answer: tuple[str, Any] = ("found", version)
    with contextlib.suppress(EOFError):
        while True:
            pickle.dump(answer, answers)
            answers.flush()
            statement = pickle.load(sys.stdin.buffer)
            try:
                answer = ("found", run(statement))
            except BaseException as error:  # a panic of Rust is no Exception
                answer = ("refused", str(error).partition("\n\n   0: ")[0])  # and no stack


if __name__ == "__main__":
    main()
