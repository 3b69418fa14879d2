"""Layout: SQL on lines of limited length.

This module owns where a printed statement breaks and how far a line is indented. It moves white space
and nothing else: the tokens of a text stay as they are.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from functools import cached_property
from textwrap import wrap

from sqlglot.dialects.dialect import Dialect

WIDTH = 100

#: What begins a clause of a query, by its first word; the second word, where there is one, decides.
_CLAUSES = frozenset(
    (
        "SELECT",
        "FROM",
        "WHERE",
        "GROUP",
        "HAVING",
        "ORDER",
        "UNION",
        "WITH",
        "WINDOW",
        "JOIN",
        "LEFT",
        "CROSS",
    )
)

#: What begins a part of a condition, and of a CASE.
_CONDITION, _CASE = frozenset(("AND", "OR", "ON")), frozenset(("WHEN", "ELSE", "END"))


@dataclass
class Group:
    """Parts between an opening word or bracket and its end."""

    opening: str
    parts: list["Part"] = field(default_factory=list)
    closing: str = ""
    spaced: bool = False
    comment: str = ""

    @cached_property
    def flat(self) -> str:
        """The group on a line."""
        inner = flat_of(self.parts)
        gap = " " if self.opening == "CASE" else ""
        return f"{self.opening}{gap}{inner}{gap}{self.closing}"


@dataclass
class Word:
    """A token, and whether white space comes before it."""

    flat: str
    spaced: bool


Part = Group | Word


def laid_out(text: str, dialect: str | None, width: int = WIDTH) -> str:
    """Return a statement, written on a line, in lines of at most so many characters where it can be cut.

    Args:
        text: the statement.
        dialect: of sqlglot, whose rules tell what a token is.
        width: of a line.
    """
    return "\n".join(_lines(_grouped(text, dialect), 0, width))


def commented(text: str, width: int = WIDTH) -> list[str]:
    """Return the lines of a comment; the number of an equation stays beside its name."""
    whole = " ".join(text.split()).replace("Eq. ", "Eq.\xa0")
    return [f"-- {line}".replace("\xa0", " ") for line in wrap(whole, width - 3)]


def flat_of(parts: Iterable[Part]) -> str:
    """Return parts on a line."""
    return "".join(
        f"{' ' * (part.spaced and number > 0)}{part.flat}" for number, part in enumerate(parts)
    )


def _grouped(text: str, dialect: str | None) -> list[Part]:
    """Return the tokens of a text; what stands in brackets, and each CASE, is a group."""
    outermost = Group("")
    groups, end = [outermost], 0
    for token in Dialect.get_or_raise(dialect).tokenize(text):
        word, spaced = text[token.start : token.end + 1], token.start > end
        end = token.end + 1
        upper = word.upper()
        if word == "(" or upper == "CASE":
            group = Group(word, spaced=spaced, comment=" ".join(token.comments))
            groups[-1].parts.append(group)
            groups.append(group)
        elif (word == ")" or upper == "END") and len(groups) > 1:
            groups.pop().closing = word
        else:
            groups[-1].parts.append(Word(word, spaced))
    return outermost.parts


def _lines(parts: list[Part], indent: int, width: int) -> Iterator[str]:
    """Give the lines of some parts."""
    flat = flat_of(parts)
    if indent + len(flat) <= width and not _is_query(parts, len(flat)) and not _is_commented(parts):
        yield " " * indent + flat
        return
    for cut in (_clauses, _commas, _conditions):
        pieces = cut(parts)
        if len(pieces) > 1:
            break
    else:
        yield from _opened(parts, indent, width)
        return
    if cut is _commas:
        yield from _packed(pieces, indent, width)
        return
    for number, piece in enumerate(pieces):
        yield from _piece(piece, indent + 2 * (number > 0 and cut is _conditions), width)


def _is_commented(parts: list[Part]) -> bool:
    """Tell whether a group among parts, or in one of them, has a comment, which takes lines."""
    groups = [part for part in parts if isinstance(part, Group)]
    return any(group.comment or _is_commented(group.parts) for group in groups)


def _piece(parts: list[Part], indent: int, width: int) -> Iterator[str]:
    """Give the lines of a clause: its words, then what they are about, further in."""
    if indent + len(flat_of(parts)) <= width and not _is_commented(parts):
        yield " " * indent + flat_of(parts)
        return
    head = 1
    while head < len(parts) and _word(parts[head]) in ("BY", "ALL", "DISTINCT", "JOIN", "OUTER"):
        head += 1
    body = parts[head:]
    if len(_commas(body)) > 1:
        yield " " * indent + flat_of(parts[:head])
        yield from _lines(body, indent + 2, width)
    elif len(_conditions(body)) > 1 and indent + len(flat_of(parts)) > width:
        first, *others = _conditions(body)
        yield from _opened([*parts[:head], *first], indent, width)
        for other in others:
            yield from _opened(other, indent + 2, width)
    else:
        yield from _opened(parts, indent, width)


def _packed(pieces: list[list[Part]], indent: int, width: int) -> Iterator[str]:
    """Give lines of as many members of a list as they hold."""
    line = ""
    for piece in pieces:
        flat = flat_of(piece)
        if line and indent + len(line) + 1 + len(flat) <= width and not _is_commented(piece):
            line += f" {flat}"
            continue
        if line:
            yield " " * indent + line
            line = ""
        if indent + len(flat) <= width and not _is_commented(piece):
            line = flat
        else:
            yield from _opened(piece, indent, width)
    if line:
        yield " " * indent + line


def _filled(parts: list[Part], width: int) -> Iterator[str]:
    """Give lines of parts, cut where there is white space."""
    line, word = "", ""
    for part in [*parts, Word("", True)]:
        if not part.spaced:
            word += part.flat
            continue
        if line and word and len(line) + 1 + len(word) > width:
            yield line
            line = ""
        line += f" {word}" if line and word else word
        word = part.flat
    yield line


def _terms(parts: list[Part]) -> list[list[Part]]:
    """Return the terms of a sum, each with the sign before it."""
    pieces: list[list[Part]] = [[]]
    for part in parts:
        if part.flat in ("+", "-") and part.spaced and pieces[-1]:
            pieces.append([])
        pieces[-1].append(part)
    return pieces


def _opened(parts: list[Part], indent: int, width: int) -> Iterator[str]:
    """Give the lines of parts whose longest group, or else each term, is put on lines of its own."""
    flat = flat_of(parts)
    terms = _terms(parts)
    if indent + len(flat) > width and len(terms) > 2:
        first, *others = terms
        yield from _opened(first, indent, width)
        for term in others:
            yield from _opened(term, indent, width)
        return
    groups = [number for number, part in enumerate(parts) if isinstance(part, Group) and part.parts]
    if indent + len(flat) <= width and not _is_commented(parts):
        yield " " * indent + flat
        return
    if not groups:
        yield from (" " * indent + line for line in _filled(parts, width - indent))
        return
    place = max(groups, key=lambda number: (len(parts[number].flat), number))
    group = parts[place]
    assert isinstance(group, Group)
    before, after = flat_of(parts[:place]), flat_of(parts[place + 1 :])
    gap = " " * (group.spaced and place > 0)
    rest = parts[place + 1 :]
    tail = (" " * bool(rest and rest[0].spaced)) + after
    if group.opening == "(":
        yield f"{' ' * indent}{before}{gap}("
        for line in commented(group.comment, width - indent - 2):
            yield f"{' ' * (indent + 2)}{line}"
        yield from _lines(group.parts, indent + 2, width)
        yield from (
            _opened_tail(")", rest, indent, width)
            if len(tail) + indent >= width
            else [f"{' ' * indent}){tail}"]
        )
        return
    cases = _cut(group.parts, _CASE)
    yield f"{' ' * indent}{before}{gap}CASE"
    for case in cases:
        yield from _lines_of_case(case, indent + 2, width)
    yield f"{' ' * indent}END{tail}"


def _opened_tail(closing: str, rest: list[Part], indent: int, width: int) -> Iterator[str]:
    yield from _opened([Word(closing, False), *rest], indent, width)


def _lines_of_case(parts: list[Part], indent: int, width: int) -> Iterator[str]:
    flat = flat_of(parts)
    if indent + len(flat) <= width:
        yield " " * indent + flat
        return
    pieces = _cut(parts, frozenset(("THEN",)))
    if len(pieces) == 1:
        yield from _opened(parts, indent, width)
        return
    when, then = pieces
    yield from _conditional(when, indent, width)
    yield from _opened(then, indent + 2, width)


def _conditional(parts: list[Part], indent: int, width: int) -> Iterator[str]:
    if indent + len(flat_of(parts)) <= width:
        yield " " * indent + flat_of(parts)
        return
    pieces = _conditions(parts)
    yield from _opened(pieces[0], indent, width)
    for piece in pieces[1:]:
        yield from _opened(piece, indent + 2, width)


def _is_query(parts: list[Part], length: int) -> bool:
    """Tell whether parts are a query that reads better by its clauses."""
    return length > 60 and len(_clauses(parts)) > 1


def _clauses(parts: list[Part]) -> list[list[Part]]:
    if not any(_word(part) in ("SELECT", "FROM", "WHERE") for part in parts):
        return [parts]
    return _cut(parts, _CLAUSES)


def _conditions(parts: list[Part]) -> list[list[Part]]:
    pieces: list[list[Part]] = [[]]
    between = False
    for part in parts:
        word = _word(part)
        if word in _CONDITION and not (between and word == "AND") and pieces[-1]:
            pieces.append([])
        between = word == "BETWEEN" or (between and word != "AND")
        pieces[-1].append(part)
    return pieces


def _commas(parts: list[Part]) -> list[list[Part]]:
    pieces: list[list[Part]] = [[]]
    for part in parts:
        pieces[-1].append(part)
        if part.flat == ",":
            pieces.append([])
    return pieces if pieces[-1] else pieces[:-1]


def _cut(parts: list[Part], words: frozenset[str]) -> list[list[Part]]:
    pieces: list[list[Part]] = [[]]
    for number, part in enumerate(parts):
        before = _word(parts[number - 1]) if number else ""
        is_second = _word(part) == "JOIN" and before in ("LEFT", "OUTER", "INNER", "CROSS")
        if _word(part) in words and pieces[-1] and not is_second:
            pieces.append([])
        pieces[-1].append(part)
    return pieces


def _word(part: Part) -> str:
    """Return the first word of a token; a keyword may have several."""
    return part.flat.upper().partition(" ")[0] if isinstance(part, Word) else ""
