"""Spark by pyspark: a session in this process or on a cluster."""

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
from gam_db.engines.spark import ENGINE, OVER
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
        EngineError: Spark cannot be started, is too old, or the folder cannot be used.
    """
    if isinstance(target, str):
        master, path = address_of(target)
        folder = Folder(path, writable)  # first: that there is none is said before Spark is started
        return SparkDriver(started(master), ENGINE, writable, folder)
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
        self.errors = (
            needed("pyspark.errors", "spark").PySparkException,
            needed("py4j.protocol", "spark").Py4JError,
            ConnectionError,
        )
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
        if int(str(frame._jdf.queryExecution().optimizedPlan().stats().sizeInBytes())) <= _SMALL:
            self.ingest(table, self._arrow(frame))
            return
        if self._scratch is None:  # in files if the user set a folder for them, else at the workers
            in_files = self._session.sparkContext._jsc.sc().getCheckpointDir().isDefined()
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
        with quiet(), as_before(self._session):
            self._name(table, self._session.createDataFrame(rows))

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
            return self._session.read.option("mergeSchema", "true").parquet(path)
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


def problem(error: Exception) -> UserError | None:
    """Return what the user can do about an error of Spark; None if it is none of the user's."""
    message = str(getattr(error, "_desc", None) or error)  # without the stack of Java
    condition = message[1:].partition("]")[0].partition(".")[0] if message.startswith("[") else ""
    causes = f"{message}\n{getattr(error, '_stackTrace', '')}"
    return refusal("spark", type(error).__name__, condition, causes)
