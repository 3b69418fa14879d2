"""What is said of what is wrong: each sentence of the table is used, with words for all its places."""

import ast
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import gam_db
from gam_db import data, errors

TABLE = data.table("gam_db", "errors.toml")


def asked() -> Iterator[tuple[str, set[str]]]:
    """The calls of :func:`gam_db.errors.wrong`: the key, and the words that are filled in."""
    for path in Path(gam_db.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "wrong":
                (key,) = node.args
                assert isinstance(key, ast.Constant), path
                yield str(key.value), {str(word.arg) for word in node.keywords}


def test_each_sentence_is_asked_for_with_its_own_words() -> None:
    said = [(key, text) for sentences in TABLE.values() for key, text in sentences.items()]
    places = {key: {name for _, name, *_ in Formatter().parse(text) if name} for key, text in said}
    assert len(places) == len(said), "a key is there twice"
    found = list(asked())
    assert [one for one in found if one != (one[0], places.get(one[0]))] == []
    assert places.keys() == {key for key, _ in found}


def test_each_class_is_one_of_an_error_of_the_user() -> None:
    assert all(issubclass(getattr(errors, name), errors.UserError) for name in TABLE)
    error = errors.wrong("no_time_zone", name="Mars/Olympus")
    assert isinstance(error, errors.ConfigurationError)
    assert "'Mars/Olympus'" in str(error)
