"""Spark by pyspark: a session in this process or on a cluster, or one of Spark Connect.

What both do is asked of Spark by public calls alone: SQL, the catalogue, settings, frames. A session in
this process takes more of Java where there is no such call, or a dearer one; see :class:`SparkDriver`.
"""

import contextlib
import secrets
import shutil
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.engines.driver import Driver, usual
from gam_db.engines.refusals import READ_ONLY, refusal
from gam_db.engines.spark import ENGINE, OVER, remote
from gam_db.engines.spark.folder import Folder
from gam_db.engines.spark.opening import address_of, as_before, beside, quiet, scratch, started
from gam_db.engines.spark.tables import FolderTables, MetastoreTables, format_of
from gam_db.errors import EngineError, UserError, wrong
from gam_db.extras import needed
from gam_db.settings.form import Form

#: Steps with at most so many rows are handed back to Spark as rows: its plans then end there.
_FEW = 20_000

#: What Spark estimates to be at most so many bytes is not written to files first.
_SMALL = 2**20


def connected(target: Any, writable: bool) -> "SparkDriver":
    """Return a driver on an address, or on the user's open session.

    Raises:
        EngineError: Spark cannot be started or reached, is too old, or the folder cannot be used.
    """
    if isinstance(target, str) and target.startswith(remote.SCHEME):
        return ConnectDriver(remote.opened(target), writable)
    if isinstance(target, str):
        master, path = address_of(target)
        folder = Folder(path, writable)  # first: that there is none is said before Spark is started
        return SparkDriver(started(master), ENGINE, writable, folder)
    if remote.is_remote(target):
        return ConnectDriver(remote.lent(target), writable)
    needed("pyspark", "spark")
    session = beside(target)
    form = format_of(session)
    return SparkDriver(session, OVER[form], writable, form)


class SparkDriver(Driver):
    """A session of Spark for this driver alone, and where its tables are.

    That is a folder, or the metastore in a form (:func:`gam_db.engines.spark.tables.format_of`).
    """

    most_rows = 2**40  # Spark spills what does not fit, and a group of channels costs it a round of jobs

    def __init__(self, session: Any, engine: Engine, writable: bool, storage: Folder | str) -> None:
        self.engine = engine
        self._session, self._writable = session, writable
        self.errors = self._refusals()
        self._tables: FolderTables | MetastoreTables = (
            FolderTables(session, self._run, engine, storage)
            if isinstance(storage, Folder)
            else MetastoreTables(session, self._run, engine, storage)
        )
        self._scratch = self._shared_place(storage)
        self._views: dict[str, Path | None] = {}

    def execute(self, statement: str) -> None:
        if not self._writable:
            raise EngineError(READ_ONLY)
        self._tables.execute(statement)

    def fetch(self, query: str) -> pa.Table:
        self._tables.ready(query)
        return self._arrow(self._run(query))

    def keep(self, table: exp.Table, query: exp.Query) -> None:
        """Make a view of the rows of a query, computed once."""
        text = self.engine.text(query)
        self._tables.ready(text)
        frame = self._run(text)
        # What Spark expects: after joins far too many bytes, of compressed files too few.
        if self._bytes(frame, text) <= _SMALL:
            self.ingest(table, self._arrow(frame))
        else:
            self._keep_large(table, frame)

    def _keep_large(self, table: exp.Table, frame: Any) -> None:
        if self._scratch is None:  # in files if the user set a folder for them, else at the workers
            in_files = self._session.sparkContext.getCheckpointDir() is not None
            self._name(table, frame.checkpoint() if in_files else frame.localCheckpoint())
            return
        place = self._scratch / f"{table.name}_{secrets.token_hex(4)}"
        frame.write.parquet(str(place))
        files = [pq.ParquetFile(path) for path in sorted(place.glob("*.parquet"))]
        if sum(file.metadata.num_rows for file in files) <= _FEW:
            self.ingest(table, pa.concat_tables([file.read() for file in files]))
            shutil.rmtree(place)
        else:
            self._name(table, self._session.read.parquet(str(place)), place)

    def ingest(self, table: exp.Table, rows: pa.Table) -> None:
        with quiet():
            self._name(table, self._frame(rows))

    def drop(self, table: exp.Table) -> None:
        """Drop a view made by :meth:`keep` or :meth:`ingest`, and what Spark holds for it."""
        place = self._views.pop(table.name)
        self._session.catalog.dropTempView(table.name)
        if place is not None:
            shutil.rmtree(place, ignore_errors=True)

    def delete(self, table: exp.Table, keys: Sequence[str], key_rows: exp.Query) -> None:
        if not self._writable:
            raise EngineError(READ_ONLY)
        self._tables.delete(table, keys, key_rows)

    def tables(self) -> list[tuple[str, ...]]:
        return [*self._tables.names(), *((name,) for name in self._views)]

    def describe(self, relation: exp.Expr) -> dict[str, str]:
        text = self.engine.text(exp.select("*").from_(relation.copy()))
        self._tables.ready(text)
        return dict(self._run(text).dtypes)

    def relations(self, schema: str | None) -> dict[str, tuple[str, ...]]:
        return dict(self._tables.relations(schema))

    def file(self, relation: Any, form: Form | None = None) -> exp.Expr:
        """Return the node that reads a file, a folder of files, or what a pattern matches."""
        path, reader = str(relation), self._session.read
        with quiet():
            if path.lower().endswith((".parquet", ".pq")):
                frame = self._parquet(path)
            else:
                tabs = ".tsv" in path.lower()
                options = {"header": True, "inferSchema": True, "sep": "\t" if tabs else ","}
                frame = reader.options(**options).csv(path)
        view = exp.Table(this=template.name(f"gam_file_{abs(hash(path)):x}"))
        self._name(view, frame)
        return view

    def _parquet(self, path: str) -> Any:
        """Return the rows of Parquet files, of which none has another type in a column than the others.

        Cause: Spark takes the columns of one file for those of all. Symptom: it cannot read the others,
        or reads them otherwise, by the order of their names.
        """
        try:
            frame = self._session.read.option("mergeSchema", "true").parquet(path)
            frame.columns  # noqa: B018 - Spark Connect looks at the files only when it is asked
            return frame
        except self.errors as error:
            if "CANNOT_MERGE" not in str(error):
                raise
            listed = self._session.read.format("binaryFile").option("recursiveFileLookup", "true")
            files = listed.option("pathGlobFilter", "*.p*q*").load(path).select("path").collect()
            first: dict[str, tuple[str, str]] = {}
            for file in sorted(row.path for row in files):
                for name, of in self._session.read.parquet(file).dtypes:
                    kind, other = first.setdefault(name, (of, file))
                    if kind != of:
                        raise wrong(
                            "types_differ", column=name, one=file, of=of, other=other, kind=kind
                        ) from error
            raise

    def problem(self, error: Exception) -> UserError | None:
        return problem(error)

    def close(self) -> None:
        """Forget the tables; Spark itself goes on until the process ends."""
        for name in list(self._views):
            self.drop(exp.Table(this=template.name(name)))
        if self._scratch is not None:
            shutil.rmtree(self._scratch, ignore_errors=True)
        self._tables.close()

    def _refusals(self) -> tuple[type[Exception], ...]:
        raised = needed("pyspark.errors", "spark").PySparkException
        return raised, needed("py4j.protocol", "spark").Py4JError, ConnectionError

    def _bytes(self, frame: Any, text: str) -> float:
        """Return how many bytes Spark expects of a query: of its plan, which is not made twice."""
        return int(str(frame._jdf.queryExecution().optimizedPlan().stats().sizeInBytes()))

    def _frame(self, rows: pa.Table) -> Any:
        with as_before(self._session):
            return self._session.createDataFrame(rows)

    def _shared_place(self, storage: Folder | str) -> Path | None:
        """Return a folder for steps that Spark's workers reach; None where none is known."""
        if isinstance(storage, Folder) and self._writable:
            return storage.scratch()
        if self._session.sparkContext.master.startswith("local"):
            return Path(tempfile.mkdtemp(dir=scratch()))
        return None

    def _name(self, view: exp.Table, frame: Any, place: Path | None = None) -> None:
        frame.createOrReplaceTempView(view.this.sql(dialect="spark"))
        self._views[view.name] = place

    def _run(self, text: str) -> Any:
        with quiet():
            return self._session.sql(text)

    def _arrow(self, frame: Any) -> pa.Table:
        with quiet():
            rows: pa.Table = frame.toArrow()
        return usual(rows)


class ConnectDriver(SparkDriver):
    """A session of Spark Connect, and the tables of its metastore; by public calls alone."""

    def __init__(self, work: remote.Work, writable: bool) -> None:
        form = format_of(work.session)
        super().__init__(work.session, OVER[form], writable, form)
        self._work = work
        self._saved: dict[str, str] = {}  # view -> the table of its rows, where no other place is
        self._checkpoints = True

    def drop(self, table: exp.Table) -> None:
        super().drop(table)
        self._drop_saved(table)

    def close(self) -> None:
        """Forget the tables, and give the session back as it was, or end it if it is ours."""
        with quiet(), contextlib.suppress(*self.errors):  # a server that is gone has forgotten them
            super().close()
            self._work.give_back()

    def _keep_large(self, table: exp.Table, frame: Any) -> None:
        """Keep rows at Spark's workers; where the session keeps none there, in a table."""
        settled = self._checkpoint(frame)
        name = f"gam_step_{secrets.token_hex(6)}"
        if settled is None:
            with quiet():
                frame.write.saveAsTable(name)
            self._saved[table.name] = name
            settled = self._session.table(name)
        rows = self._arrow(settled.limit(_FEW + 1))
        if rows.num_rows > _FEW:
            self._name(table, settled)
            return
        self.ingest(table, rows)
        self._drop_saved(table)

    def _checkpoint(self, frame: Any) -> Any:
        """Return the rows of a frame where they were computed; None where the session cannot."""
        if not self._checkpoints or not remote.keeps_checkpoints(self._session):
            return None
        try:
            with quiet():
                return frame.localCheckpoint()
        except self.errors as error:
            if not remote.is_unsupported(error):
                raise
            self._checkpoints = False
            return None

    def _drop_saved(self, view: exp.Table) -> None:
        if (name := self._saved.pop(view.name, None)) is not None:
            gone = exp.Table(this=template.name(name))
            self._run(self.engine.text(exp.Drop(tables=[gone], kind="TABLE", exists=True)))

    def _refusals(self) -> tuple[type[Exception], ...]:
        return needed("pyspark.errors", remote.EXTRA).PySparkException, ConnectionError

    def _bytes(self, frame: Any, text: str) -> float:
        return remote.expected_bytes(self._run(f"EXPLAIN COST {text}").collect()[0][0])

    def _frame(self, rows: pa.Table) -> Any:
        if rows.num_rows:
            return self._session.createDataFrame(rows)
        # Of no rows it does not take the types, other than classic Spark.
        nulls = [pa.nulls(1, column.type) for column in rows.schema]
        return self._session.createDataFrame(pa.table(nulls, rows.column_names)).limit(0)

    def _shared_place(self, storage: Folder | str) -> Path | None:
        return None


def problem(error: Exception) -> UserError | None:
    """Return what the user can do about an error of Spark; None if it is none of the user's."""
    message = str(getattr(error, "_desc", None) or error)  # of Spark Connect with the stack of Java
    condition = message[1:].partition("]")[0].partition(".")[0] if message.startswith("[") else ""
    causes = f"{message}\n{getattr(error, '_stackTrace', '')}"
    return refusal("spark", type(error).__name__, condition, causes)
