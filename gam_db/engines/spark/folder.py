"""A folder of Parquet tables with a small catalogue of its own.

Spark's built-in catalogue ends with its process. So each table and view that is made here is kept as a
file, and a later process makes it known to its Spark again. A file is written beside its place and
renamed: what it says changes in one step. The rows of a table lie in a folder whose name its file says,
so a table is exchanged for another in one step, too.
"""

import contextlib
import json
import os
import re
import secrets
import shutil
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from gam_db.engines.refusals import READ_ONLY
from gam_db.errors import EngineError, unwritable, wrong

_CATALOGUE = "gam_catalogue"
_SCRATCH = "gam_scratch"

#: Seconds after which the steps of a process that was killed are removed.
_FORGOTTEN = 7 * 86_400


@dataclass(frozen=True)
class Entry:
    """A table or view: the statement that makes it, without the place of its rows, and its columns.

    Its schema is None in the folder itself, the folder of its rows (*data*) is None for a view.
    """

    schema: str | None
    name: str
    statement: str
    columns: tuple[str, ...]
    data: str | None

    @property
    def key(self) -> str:
        """Its name as others are compared with it: Spark folds case."""
        return (self.name if self.schema is None else f"{self.schema}.{self.name}").casefold()


class Folder:
    """The folder of an address; it is made if it is to be written.

    Raises:
        EngineError: there is no such folder, or it cannot be written.
    """

    def __init__(self, path: Path, writable: bool) -> None:
        self.path = path
        self._catalogue = path / _CATALOGUE
        self._read: dict[Path, tuple[tuple[int, int], Entry]] = {}
        try:
            if writable:
                self._catalogue.mkdir(parents=True, exist_ok=True)
                self._write(self._catalogue / "probe", "")
                (self._catalogue / "probe").unlink(missing_ok=True)
        except OSError as error:
            raise unwritable(f"The folder {path}", error, EngineError) from error
        if not path.is_dir():
            raise EngineError(f"There is no folder {path}.")

    def entries(self) -> dict[str, Entry]:
        """Return all tables and views, by key; files that did not change are not read again."""
        fresh: dict[Path, tuple[tuple[int, int], Entry]] = {}
        for path in self._catalogue.glob("*.json"):
            try:
                state = path.stat()
                stamp = (state.st_mtime_ns, state.st_ino)
                cached = self._read.get(path)
                fresh[path] = cached if cached and cached[0] == stamp else (stamp, _entry(path))
            except FileNotFoundError:
                continue  # another process dropped it just now
            except OSError as error:
                raise EngineError(f"{path} cannot be read: {error.strerror}.") from error
        self._read = fresh
        return {entry.key: entry for _, entry in fresh.values()}

    def place(self, entry: Entry) -> Path:
        """Return the folder of the rows of a table."""
        assert entry.data is not None
        return self.path / entry.data

    def new_data(self, schema: str | None, name: str) -> str:
        """Return a name for the rows of a table that no other has."""
        return f"{_file_name(schema, name)}-{secrets.token_hex(4)}"

    def put(self, entry: Entry) -> None:
        """Keep a table or view; one of its name is replaced in one step.

        Raises:
            EngineError: the folder cannot be written.
        """
        if entry.data is not None:
            self.place(entry).mkdir(exist_ok=True)
        fields = {**entry.__dict__, "columns": list(entry.columns)}
        try:
            self._write(self._file(entry), json.dumps(fields, indent=1))
        except OSError as error:
            if isinstance(error, PermissionError):
                raise EngineError(READ_ONLY) from error
            raise unwritable(f"The folder {self.path}", error, EngineError) from error

    def drop(self, entry: Entry) -> None:
        """Remove a table or view: its file first, then its rows."""
        self._file(entry).unlink(missing_ok=True)
        self.sweep(entry.schema, entry.name, ())

    def sweep(self, schema: str | None, name: str, folders: Iterable[str]) -> None:
        """Remove all rows of a table but those of some folders: what a process left that was killed."""
        prefix = f"{_file_name(schema, name)}-"
        for path in self.path.glob(f"{prefix}*"):
            if path.name not in folders and len(path.name) == len(prefix) + 8:
                shutil.rmtree(path, ignore_errors=True)

    def scratch(self) -> Path:
        """Return a new folder for the steps of one process, and remove those of processes long gone."""
        for left in (self.path / _SCRATCH).glob("*"):
            with contextlib.suppress(FileNotFoundError):
                if time.time() - left.stat().st_mtime > _FORGOTTEN:
                    shutil.rmtree(left, ignore_errors=True)
        folder = self.path / _SCRATCH / secrets.token_hex(4)
        folder.mkdir(parents=True)
        return folder

    def _file(self, entry: Entry) -> Path:
        return self._catalogue / f"{_file_name(entry.schema, entry.name)}.json"

    def _write(self, path: Path, text: str) -> None:
        beside = path.with_name(f".{path.name}.{secrets.token_hex(4)}")
        try:
            with beside.open("w", encoding="utf-8") as stream:
                stream.write(text)
                stream.flush()
                os.fsync(stream.fileno())
            beside.replace(path)
        finally:
            beside.unlink(missing_ok=True)


def _entry(path: Path) -> Entry:
    try:
        fields = json.loads(path.read_text(encoding="utf-8"))
        return Entry(**{**fields, "columns": tuple(fields["columns"])})
    except (ValueError, TypeError, KeyError) as error:
        raise wrong("spark_no_table_of_ours", path=path) from error


def _file_name(schema: str | None, name: str) -> str:
    """Return a name of files: letters, digits and underscores as they are, else percent codes."""
    parts = (part.casefold() for part in (schema, name) if part is not None)
    return ".".join(re.sub("[^a-z0-9_]", lambda sign: f"%{ord(sign[0]):x}%", part) for part in parts)
