"""CSV files in another encoding than UTF-8: read through a copy in UTF-8, or refused by name."""

import codecs
import os
import tempfile
from pathlib import Path

import pyarrow as pa

from gam_db.errors import SourceError, UserError, wrong

#: How a file begins by which its encoding is known, the longer first.
_MARKS = {codecs.BOM_UTF32_LE: "utf-32", codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}
_PIECE = 2**20


class Copies:
    """Copies in UTF-8 of files, which go when this does."""

    def __init__(self) -> None:
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._copies: dict[tuple[str, str, int, int], str] = {}

    @property
    def paths(self) -> list[str]:
        """The copies."""
        return [*self._copies.values()]

    def of(self, path: str, encoding: str) -> str:
        """Return the path of a file in UTF-8; a file that changed is copied anew.

        Raises:
            SourceError: it cannot be read, or is not in that encoding.
        """
        if codecs.lookup(encoding).name == "utf-8":
            return path
        try:
            status = os.stat(path)
            key = path, encoding, status.st_mtime_ns, status.st_size
            if key not in self._copies:
                self._folder = self._folder or tempfile.TemporaryDirectory(prefix="gam_")
                target = Path(self._folder.name) / f"{len(self._copies)}.csv"
                _copy(path, encoding, target)
                self._copies[key] = str(target)
        except UnicodeError as error:
            raise wrong("other_encoding", path=path, encoding=encoding) from error
        except OSError as error:
            raise wrong("file_unreadable", path=path) from error
        return self._copies[key]

    def original(self, error: UserError) -> UserError:
        """Return an error that names the files themselves, not their copies."""
        message = error.options
        for (path, *_), copy in self._copies.items():
            message = message.replace(copy, path)
        return type(error)(message)

    def close(self) -> None:
        """Remove them."""
        if self._folder is not None:
            self._folder.cleanup()
        self._folder = None
        self._copies.clear()


def _copy(path: str, encoding: str, target: Path) -> None:
    decoder = codecs.getincrementaldecoder(encoding)()
    with pa.input_stream(path) as stream, target.open("w", encoding="utf-8", newline="") as file:
        is_first = True
        while piece := stream.read(_PIECE):
            text = decoder.decode(piece)
            if is_first and "\0" in text:
                raise UnicodeError("The encoding uses more than one byte per character.")
            file.write(text.removeprefix("\ufeff") if is_first else text)
            is_first = False
        file.write(decoder.decode(b"", final=True))


def not_utf8(path: str) -> SourceError:
    """Return the error on a file that is not in UTF-8."""
    error: SourceError = wrong("not_utf8", path=path, likely=_likely(path))  # type: ignore[assignment]
    return error


def looks_wide(path: str) -> bool:
    """Tell whether a file seems to have more bytes than one for each sign."""
    return _likely(path) in ("utf-16", "utf-16-le", "utf-16-be", "utf-32")


def _likely(path: str) -> str:
    """Return the encoding that a file seems to have."""
    try:
        with pa.input_stream(path) as stream:
            head = stream.read(4096)
    except OSError:
        return "cp1252"
    for mark, encoding in _MARKS.items():
        if head.startswith(mark):
            return encoding
    if b"\0" in head:
        return "utf-16-be" if head[:1] == b"\0" else "utf-16-le"
    return "cp1252"
