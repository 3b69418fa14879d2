"""Tables of words beside the code: what is in them is asked for, and what is asked for is in them."""

import ast
from collections.abc import Iterator
from pathlib import Path
from string import Formatter

import gam_db
from gam_db import data, errors
from gam_db.cli.config import SECTIONS
from gam_db.cli.options import Common
from gam_db.cli.score import Scope
from gam_db.report import Wishes
from gam_db.selection.search import Search
from gam_db.settings.form import Form
from gam_db.settings.setting import settings_of

ERRORS = data.table("gam_db", "errors.toml")


def asked(*functions: str) -> Iterator[tuple[str, set[str]]]:
    """The calls of functions with a key of a table: the key, and the words that are filled in."""
    for path in Path(gam_db.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in functions:
                keys = [one.value for one in ast.walk(node.args[0]) if isinstance(one, ast.Constant)]
                yield "".join(map(str, keys)), {str(word.arg) for word in node.keywords}


def places(text: str) -> set[str]:
    """The words that are to be filled in."""
    return {name for _, name, *_ in Formatter().parse(text) if name}


def test_each_error_is_asked_for_with_its_own_words() -> None:
    said = [(key, text) for sentences in ERRORS.values() for key, text in sentences.items()]
    known = {key: places(text) for key, text in said}
    assert len(known) == len(said), "a key is there twice"
    found = list(asked("wrong"))
    assert [one for one in found if one != (one[0], known.get(one[0]))] == []
    assert known.keys() == {key for key, _ in found}


def test_each_option_is_asked_for() -> None:
    table = data.table("gam_db.cli", "options.toml")
    known = {f"{command}.{name}": said for command, own in table.items() for name, said in own.items()}
    found = dict(asked("option", "argument"))
    assert found.keys() - known.keys() == {"shared.of_stateread_only"}
    assert known.keys() - found.keys() == {"shared.of_state", "shared.read_only"}
    assert [key for key, said in known.items() if places(said["what"]) - found.get(key, set())] == []


def test_each_setting_has_a_field() -> None:
    classes = {of.__name__: of for of in (*SECTIONS.values(), Form, Search, Wishes, Scope, Common)}
    for name, said in data.table("gam_db.settings", "settings.toml").items():
        assert said.keys() <= settings_of(classes[name]).keys(), name
    assert all(one.what for of in classes.values() for one in settings_of(of).values())


def test_each_class_is_one_of_an_error_of_the_user() -> None:
    assert all(issubclass(getattr(errors, name), errors.UserError) for name in ERRORS)
    error = errors.wrong("no_time_zone", name="Mars/Olympus")
    assert isinstance(error, errors.ConfigurationError)
    assert "'Mars/Olympus'" in str(error)
