"""Traps: operators and functions of somebody else that fit better than PostgreSQL's own, and count.

For every operator between two of the usual types, and for every function that our SQL names, a trap is
made for each combination of types that pg_catalog lacks: PostgreSQL takes an exact match before one of
its own that needs a cast, wherever on the path it lies. In a schema that is searched before pg_catalog
there are traps of the very types of pg_catalog's operators, too. A trap answers much as its namesake
would, so that a command goes on, and counts the call in a sequence, which no rollback takes back; the
server's log says which one was called.
"""

import itertools
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

NUMBERS = ("smallint", "integer", "bigint", "numeric", "real", "double precision")
TEXTS = ("text", "character varying", "character", "name")
OTHERS = ("date", "timestamp", "timestamptz", "interval", "boolean", "oid")
TYPES = (*NUMBERS, *TEXTS, *OTHERS)

#: For functions of three arguments, of which there are very many combinations.
FEWER = ("integer", "bigint", "double precision", "text")

_FOLDER = Path(__file__).parent.parent.parent

_COMPARING = ("=", "<>", "<", "<=", ">", ">=", "~~", "!~~", "~", "!~")
_OF_INTEGERS = ("%", "&", "|", "#", "<<", ">>")

#: Operators between two types: for which pairs pg_catalog has them, and whether they compare.
_OPERATORS = """
    SELECT oprname, array_agg(DISTINCT (oprleft::regtype, oprright::regtype)::text),
        bool_or(oprresult = 16)
    FROM pg_operator WHERE oprnamespace = 'pg_catalog'::regnamespace
        AND oprleft = ANY (%s::regtype[]) AND oprright = ANY (%s::regtype[])
    GROUP BY oprname ORDER BY oprname
"""

_FUNCTIONS = """
    SELECT proname, prokind = 'f', array_agg(DISTINCT pronargs::int)
    FROM pg_proc WHERE pronamespace = 'pg_catalog'::regnamespace
        AND proname = ANY (%s) AND prokind <> 'p' AND pronargs BETWEEN 1 AND 3
    GROUP BY proname, prokind = 'f' ORDER BY proname, 2
"""


def known() -> set[str]:
    """Return the words of our files that can be functions; the server's log shows whether all are."""
    written = [*_FOLDER.glob("sql/**/*.sql"), *_FOLDER.glob("migrations/*.sql")]
    rendering = [file for file in (_FOLDER / "gam_db/engines/postgres").iterdir() if file.is_file()]
    rendering.append(_FOLDER / "gam_db/engines/engines.toml")
    words = (word for file in rendering for word in re.findall(r"\w+", file.read_text(encoding="utf-8")))
    called = named(file.read_text(encoding="utf-8") for file in written)
    return {*called, *map(str.lower, words)}


def named(texts: Iterable[str]) -> set[str]:
    """Return the words of texts that are followed by a parenthesis, in lower case."""
    return {word.lower() for text in texts for word in re.findall(r'\b([A-Za-z_][\w]*)"?\s*\(', text)}


def set_up(connection: Any, schema: str, functions: Iterable[str], own_types: bool = False) -> int:
    """Make the traps in a schema, and return how many there are.

    Args:
        connection: of a superuser.
        schema: where they lie.
        functions: names of functions, as far as pg_catalog has them.
        own_types: also operators of the very types of pg_catalog's.
    """
    connection.execute("CREATE SCHEMA IF NOT EXISTS traps")
    connection.execute("CREATE SEQUENCE IF NOT EXISTS traps.calls")
    connection.execute("GRANT USAGE ON SCHEMA traps TO PUBLIC")
    connection.execute("GRANT ALL ON SEQUENCE traps.calls TO PUBLIC")
    connection.execute(f"CREATE SCHEMA IF NOT EXISTS {schema}")
    connection.execute(f"GRANT USAGE ON SCHEMA {schema} TO PUBLIC")
    made = [
        *_operators(connection, schema, own_types),
        *_functions(connection, schema, sorted(set(functions))),
    ]
    for start in range(0, len(made), 500):
        connection.execute(";\n".join(made[start : start + 500]))
    return len(made)


def calls(connection: Any) -> int:
    """Return how many traps were called so far."""
    ((last, is_called),) = connection.execute("SELECT last_value, is_called FROM traps.calls").fetchall()
    return int(last) if is_called else 0


def told(log: str) -> list[str]:
    """Return which traps the server's log speaks of."""
    return sorted(set(re.findall(r"LOG:  trap: (.*)", log)))


def _operators(connection: Any, schema: str, own_types: bool) -> Iterator[str]:
    found = connection.execute(_OPERATORS, [list(TYPES), list(TYPES)]).fetchall()
    numbers = itertools.count()
    for name, own, is_boolean in found:
        there = {pair.replace('"', "") for pair in own}
        for left, right in itertools.product(TYPES, repeat=2):
            if not own_types and f"({_full(left)},{_full(right)})" in there:
                continue
            function = f"{schema}.operator_{next(numbers)}"
            kind = "boolean" if is_boolean else _kind(name, left, right)
            through = "text" if name in _COMPARING and not {left, right} <= set(NUMBERS) else kind
            through = "numeric" if through == "boolean" else through
            answer = f"l::text::{through} {name} r::text::{through}"
            yield (
                f"CREATE FUNCTION {function}(l {left}, r {right}) RETURNS {kind} LANGUAGE plpgsql SET "
                f"search_path = pg_catalog AS $$BEGIN {_counted(f'{name} ({left}, {right})')} "
                f"RETURN {answer}; EXCEPTION WHEN OTHERS THEN RETURN NULL; END$$;\n"
                f"CREATE OPERATOR {schema}.{name} (LEFTARG = {left}, RIGHTARG = {right}, "
                f"FUNCTION = {function})"
            )


def _functions(connection: Any, schema: str, functions: list[str]) -> Iterator[str]:
    """Yield traps for functions; for what aggregates or is for windows an aggregate serves both."""
    for name, is_plain, counts in connection.execute(_FUNCTIONS, [functions]).fetchall():
        for count in counts:
            for kinds in itertools.product(FEWER if count == 3 else TYPES, repeat=count):
                said = f"{name} ({', '.join(kinds)})"
                if is_plain:
                    yield (
                        f'CREATE FUNCTION {schema}."{name}"({", ".join(kinds)}) RETURNS {kinds[0]} '
                        f"LANGUAGE plpgsql SET search_path = pg_catalog AS $$BEGIN {_counted(said)} "
                        "RETURN $1; END$$"
                    )
                    continue
                step = f'{schema}."{name}_of_{"_".join(kinds)}"'
                arguments = ", ".join([kinds[0], *kinds])
                yield (
                    f"CREATE FUNCTION {step}({arguments}) RETURNS {kinds[0]} LANGUAGE plpgsql SET "
                    f"search_path = pg_catalog AS $$BEGIN {_counted(said)} RETURN $2; END$$;\n"
                    f'CREATE AGGREGATE {schema}."{name}"({", ".join(kinds)}) '
                    f"(SFUNC = {step}, STYPE = {kinds[0]})"
                )


def _counted(said: str) -> str:
    return f"PERFORM nextval('traps.calls'); RAISE LOG 'trap: {said.replace('%', '%%')}';"


def _kind(name: str, left: str, right: str) -> str:
    if name == "||":
        return "text"
    times = {left, right} & {"date", "timestamp", "timestamptz"}
    return times.pop() if times else "bigint" if name in _OF_INTEGERS else "numeric"


def _full(kind: str) -> str:
    """Return a type as PostgreSQL shows it."""
    return {
        "timestamp": "timestamp without time zone",
        "timestamptz": "timestamp with time zone",
    }.get(kind, kind)
