"""Arguments of public calls: a wrong one ends in one sentence that names it, before any work is done."""

import functools
import inspect
import types
from collections.abc import Callable, Iterable, Mapping, Sequence
from numbers import Integral, Real
from typing import Any, TypeVar, Union, get_args, get_origin

from gam_db.errors import ArgumentError, nearest

_Public = TypeVar("_Public", bound=Callable[..., Any])

_NAMED = 8
"""Arguments that are named where none is near to a misspelt one."""

#: Types that an annotation names -> the class that values have, and what a sentence calls it.
_PLAIN: Mapping[Any, tuple[type, str]] = {
    str: (str, "a text"),
    bool: (bool, "True or False"),
    int: (Integral, "an integer"),
    float: (Real, "a number"),
    Sequence: (Sequence, "a list"),
    tuple: (Sequence, "a list"),
    Mapping: (Mapping, "a dict"),
    None: (type(None), "None"),
    type(None): (type(None), "None"),
}


def public(of: _Public) -> _Public:
    """Let a public function, or the making of a public class, refuse arguments that do not fit.

    Raises:
        ArgumentError: when it is called: an argument is misspelt, missing, or of another type.
    """
    if not isinstance(of, type):
        checked: _Public = _checked(of, of.__name__)
        return checked
    setattr(of, "__init__", _checked(vars(of)["__init__"], of.__name__, of_class=True))  # noqa: B010
    return of


def public_methods(of: _Public) -> _Public:
    """Let the methods of a public class do the same, and its making, which takes no settings alone."""
    setattr(of, "__init__", _checked(vars(of)["__init__"], of.__name__))  # noqa: B010
    for name, method in list(vars(of).items()):
        if not name.startswith("_") and inspect.isfunction(method):
            setattr(of, name, _checked(method, f"{of.__name__}.{name}"))
    return of


def check_names(call: str, arguments: Iterable[str], parameters: Iterable[str]) -> None:
    """Refuse an argument that a call does not have; the message says which it may be."""
    for name in arguments:
        if name not in (names := list(parameters)):
            raise ArgumentError(f"{call} has no argument {name!r}{nearest(name, names, _NAMED)}")


def _checked(call: Any, name: str, of_class: bool = False) -> Any:
    signature = inspect.signature(call)
    parameters = [
        parameter.name
        for parameter in signature.parameters.values()
        if parameter.kind not in _OPEN and parameter.name != "self"
    ]
    is_open = any(
        parameter.kind is inspect.Parameter.VAR_KEYWORD for parameter in signature.parameters.values()
    )

    @functools.wraps(call)
    def called(*positional: Any, **named: Any) -> Any:
        if not is_open:
            check_names(name, named, parameters)
        try:
            bound = signature.bind(*positional, **named)
        except TypeError as error:
            raise ArgumentError(f"{name}: {error}.") from None
        if not of_class:  # settings say themselves what they take
            for argument, value in bound.arguments.items():
                _check_type(name, argument, value, signature.parameters[argument])
        return call(*positional, **named)

    return called


_OPEN = (inspect.Parameter.VAR_POSITIONAL, inspect.Parameter.VAR_KEYWORD)


def _check_type(call: str, argument: str, value: Any, parameter: inspect.Parameter) -> None:
    """Refuse a value that is none of the classes that its annotation names, where it names all."""
    if parameter.kind in _OPEN or value is parameter.default:
        return
    kinds = _kinds(parameter.annotation)
    if kinds is None or any(isinstance(value, kind) for kind, _ in kinds):
        return
    takes = " or ".join(dict.fromkeys(words for _, words in kinds))
    raise ArgumentError(f"{argument} of {call} is a {type(value).__name__}; it takes {takes}.")


def _kinds(annotation: Any) -> list[tuple[type, str]] | None:
    """Return the classes that an annotation names, in words, too; None if it may be something else."""
    if get_origin(annotation) in (Union, types.UnionType):
        parts = [_kinds(part) for part in get_args(annotation)]
        return None if None in parts else [kind for part in parts for kind in part or ()]
    plain = _PLAIN.get(get_origin(annotation) or annotation)
    if plain is not None:
        return [plain]
    if isinstance(annotation, type) and annotation.__module__.startswith("gam_db."):
        return [(annotation, f"gam_db.{annotation.__name__}")]
    return None
