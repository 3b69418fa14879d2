"""What a note is, and how one is made of the channels it concerns; what it says is in ``notes.toml``."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gam_db import data
from gam_db.checking.look import Row
from gam_db.checking.words import extent

Name = tuple[str, str]

#: A word of a sentence: as it is, or what makes it of the channels concerned.
Word = str | int | Callable[[Sequence[Row]], str | int]


@dataclass(frozen=True)
class Note:
    """Something to be known of a source before it is watched.

    Attributes:
        subject: one word, the same for the same finding: what programs go by.
        must: it must be fixed, or there is no result, or a wrong one.
        text: what it is and what to do, in plain words.
        channels: (asset, channel) of those concerned; none where it concerns the source as a whole.
    """

    subject: str
    must: bool
    text: str
    channels: tuple[Name, ...] = ()


def noted(subject: str, rows: Sequence[Row], must: bool = False, **words: Word) -> list[Note]:
    """Return the note on some channels; none if there are no such channels."""
    if not rows:
        return []
    said = _Words({name: word(rows) if callable(word) else word for name, word in words.items()})
    said.rows = rows
    names = tuple((row["asset"], row["channel"]) for row in rows)
    return [Note(subject, must, sentence(subject).format_map(said), names)]


def whole(subject: str, must: bool = False, **words: str | int) -> list[Note]:
    """Return the note on a source as a whole."""
    return [Note(subject, must, sentence(subject).format(**words))]


def sentence(subject: str) -> str:
    """Return what is said of a subject, with words in braces to be filled in."""
    return str(data.table("gam_db.checking", "notes.toml")[subject])


class _Words(dict[str, str | int]):
    """The words of a sentence; one that is not given is the extent of a column of the channels."""

    rows: Sequence[Row] = ()

    def __missing__(self, column: str) -> str:
        return extent([row[column] for row in self.rows])
