"""What a note is, and how one is made of the channels it concerns."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from gam_db.checking.look import Row

Name = tuple[str, str]


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


def noted(
    subject: str, rows: Sequence[Row], text: Callable[[Sequence[Row]], str], must: bool = False
) -> list[Note]:
    """Return the note on some channels; none if there are no such channels."""
    if not rows:
        return []
    return [Note(subject, must, text(rows), tuple((row["asset"], row["channel"]) for row in rows))]
