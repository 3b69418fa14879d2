"""DuckDB at work: what a session on it can do beside what all can."""

import contextlib
import secrets
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import duckdb
import sqlglot
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.duckdb.driver import DuckDriver, parsed
from gam_db.engines.duckdb.files import metadata
from gam_db.engines.duckdb.journal import Journal, put_back
from gam_db.engines.refusals import refused
from gam_db.engines.session import Session
from gam_db.errors import FullError, SourceError, StatementError

#: What DuckDB writes beside a database file.
_BESIDE = ("", ".wal", ".wal.checkpoint", ".wal.recovery")


class DuckSession(Session):
    """DuckDB at work: reads files and Arrow tables where they lie, and writes files.

    Arguments are those of :func:`gam_db.connect`, but that a file is only read unless told otherwise.

    Raises:
        EngineError: the file cannot be opened, this DuckDB is too old, or the connection is closed or
            set to compare or order in a way that would change results.
    """

    driver: DuckDriver

    def __init__(
        self,
        target: Any = None,
        threads: int | None = None,
        writable: bool = False,
        files: Sequence[str | Path] = (),
    ) -> None:
        super().__init__(DuckDriver(target, threads, writable))
        self.connection = self.driver.connection
        self._mark = f"gam_{secrets.token_hex(4)}"
        self._results = [beside for path in map(Path, files) for beside in (path, self.unfinished(path))]

    def files(self) -> frozenset[Path]:
        """Return the database files that are open here, by their full paths."""
        rows = self.driver.catalogue_rows("files")
        return frozenset(Path(path).resolve() for (path,) in rows if path is not None)

    def file(self) -> Path | None:
        """Return the file of the current database; None for one in memory."""
        ((path,),) = self.driver.catalogue_rows("current_file")
        return None if path is None else Path(path)

    def check_condition(
        self, relation: exp.Expr, condition: exp.Expr, shown: str, called: str = "where"
    ) -> None:
        """Try a user's condition on no row; from then on no other files are opened."""
        if self.driver.owned:
            self._shut()
        super().check_condition(relation, condition, shown, called)

    def write(self, query: exp.Query, path: Path, table: str) -> None:
        """Write the rows of a query as all sessions do.

        They go to a file beside the target first, or are written in one transaction: what was there
        before stays as it was until everything is written.
        """
        if path.suffix in (".duckdb", ".db"):
            self._write_table(query, path, table)
            return
        unfinished = self.unfinished(path)
        copy = exp.Copy(
            this=exp.Subquery(this=query),
            kind=False,
            files=[template.text(str(unfinished))],
            params=[
                exp.CopyParameter(this=exp.var("FORMAT"), expression=exp.var("PARQUET")),
                exp.CopyParameter(this=exp.var("COMPRESSION"), expression=exp.var("ZSTD")),
                exp.CopyParameter(this=exp.var("KV_METADATA"), expression=metadata(self.driver.sources)),
            ],
        )
        try:
            self._run(copy)
            unfinished.replace(path)
        except (duckdb.IOException, OSError) as error:
            raise refused("results", str(error), path=path) from error
        finally:
            unfinished.unlink(missing_ok=True)

    def unfinished(self, path: Path) -> Path:
        """Return where this session writes what becomes a file when all of it is there."""
        return path.with_name(f".{path.name}.{self._mark}")

    @contextlib.contextmanager
    def attached(self, path: Path) -> Iterator[exp.Identifier]:
        """Open another DuckDB file for writing beside this one, and give its catalogue.

        Raises:
            SourceError: it cannot be opened.
        """
        catalog = template.name(f"{self._mark}_target")
        attach = exp.Attach(
            this=exp.alias_(template.text(str(path)), catalog, table=False),
            # Said in full: a session that only reads would attach other files for reading, too.
            expressions=[exp.AttachOption(this=exp.var("READ_WRITE"))],
        )
        put_back(path)
        try:
            self._run(attach)
        except (duckdb.IOException, duckdb.BinderException) as error:
            if isinstance(full := refused("results", str(error), path=path), FullError):
                raise full from error
            raise SourceError(f"{path} cannot be opened as a DuckDB file for writing.") from error
        journal = Journal(self.connection, catalog.name)
        try:
            with _written(path):
                journal.keep()  # on a connection of the user's DuckDB may make a checkpoint of its own
                yield catalog
                journal.checkpoint()
        finally:
            with _written(path), contextlib.closing(journal), self._without_checkpoint():
                self._run(exp.Detach(this=catalog.copy()))

    def following(self, relation: exp.Expr) -> exp.Expr:
        """Return a node that reads the files of the original patterns, also new ones."""
        return relation.transform(self.driver.by_pattern)

    def progress(self) -> float:
        """Return how far the running statement is, in percent; negative if it is not known."""
        return float(self.connection.query_progress())

    def _shut(self) -> None:
        """Open no other files from now on than the database, the sources, what views name, and results.

        All stays as it is where a source is remote, as what reads that is loaded when it is needed, and
        where the database is open on another connection of the process, which shares the setting.
        """
        if self.driver.catalogue_rows("access") != [(True, 1)]:
            return
        views = [text for (text,) in self.driver.catalogue_rows("views")]
        patterns = {*self.driver.sources, *_named_in_views(views)}
        if any("://" in pattern for pattern in patterns):
            return
        allowed = (
            patterns
            | {*self.driver.copies.paths}
            | {f"{path}{end}" for path in self._results for end in _BESIDE}
        )
        for pattern in patterns:
            with contextlib.suppress(duckdb.IOException):  # a text in a view that is no pattern
                allowed.update(*self.driver.catalogue_rows("matching", pattern))
        self.connection.execute("SET allowed_paths = ?", [sorted(allowed)])
        self.connection.execute("SET enable_external_access = false")

    @contextlib.contextmanager
    def _without_checkpoint(self) -> Iterator[None]:
        """Let a file be detached as it is."""
        (before,) = self.driver.catalogue_rows("detaching")
        self.connection.execute("SET checkpoint_on_detach = 'DISABLED'")
        try:
            yield
        finally:
            self.connection.execute("SET checkpoint_on_detach = ?", before)

    def _write_table(self, query: exp.Query, path: Path, table: str) -> None:
        target = exp.Table(this=template.name(table), db=template.name("main"))
        create = exp.Create(this=target, kind="TABLE", replace=True, expression=query)
        if path.resolve() in self.files():  # it is read, too
            with _written(path):
                self._run(create)
            return
        is_new = not path.exists()
        try:
            with self.attached(path) as catalog:
                target.set("catalog", catalog)
                self._run(create)
        except BaseException:
            for end in _BESIDE if is_new else ():
                Path(f"{path}{end}").unlink(missing_ok=True)
            raise

    def _run(self, tree: exp.Expr) -> None:
        """Run a statement that writes a file; the caller reports why it cannot be written."""
        text = self.engine.text(tree)
        try:
            self._answer(lambda: self.connection.execute(parsed(text)), text)
        except (StatementError, FullError) as error:
            if isinstance(error.__cause__, (duckdb.IOException, duckdb.BinderException)):
                raise error.__cause__ from None
            raise

    def _is_among(self, node: exp.Expr, tables: Sequence[tuple[str, ...]]) -> bool:
        """Tell the same, case aside; a schema may be left out between database and name."""
        parts = [part.name.casefold() for part in node.parts]  # type: ignore[attr-defined]
        folded = [[part.casefold() for part in name] for name in tables]
        return any(parts in (name[-len(parts) :], [name[0], name[-1]]) for name in folded)

    def _unknown(self, shown: str, hint: str) -> str:
        where = " in memory" if self.driver.owned and not self.files() else ""
        return (
            f"There is no table or view {shown!r} in the database{where} (files end in .parquet, .csv "
            f"or .tsv){hint}"
        )


def _named_in_views(views: Sequence[str]) -> set[str]:
    """Return all in the definitions of views that may be the path of a file."""
    tokens = [token for text in views for token in sqlglot.tokenize(text, read="duckdb")]
    quoted = (sqlglot.TokenType.STRING, sqlglot.TokenType.IDENTIFIER)
    texts = {token.text for token in tokens if token.token_type in quoted and {".", "/"} & {*token.text}}
    return {text for text in texts if not text.endswith(("/", "."))}


@contextlib.contextmanager
def _written(path: Path) -> Iterator[None]:
    """Raise an error in the user's terms if a file of results cannot be written."""
    try:
        yield
    except (OSError, duckdb.IOException, duckdb.FatalException, duckdb.TransactionException) as error:
        raise refused("results", str(error), path=path) from error
