"""What users can do about the errors of Spark; what Java says of them is never poured out."""

from typing import Any

from gam_db.engines.session import CONFLICT, FULL
from gam_db.errors import ConflictError, EngineError, SourceError, UserError

_MEMORY = (
    "Spark ran out of memory; give it more (SPARK_DRIVER_MEMORY for one process, spark.executor.memory "
    "on a cluster), or more and smaller partitions (spark.sql.shuffle.partitions)."
)
_LOST = (
    "Spark lost its executors or its connection to the cluster; what was written before is as it was. "
    "Run it again; if it happens again, look at the logs of the workers (memory, disk)."
)
_GONE = "The Java process of Spark has ended; what was written before is as it was. Run it again."
_CONFLICT = (
    "Files of a table went while it was read or written: another process compacts or writes the same "
    "tables. Run it again, one process at a time."
)
_NANOSECONDS = (
    "Spark reads no timestamps in nanoseconds; write the file with microseconds, or with the time as an "
    "integer."
)
_VALUE = (
    "A value of the source cannot be read as what its column must be (a counter needs 64 bits; where= "
    "may ask for it, too); look at the file, or cast the column in a view."
)
_OVERFLOW = "An integer of the source is beyond 64 bits after conversion; subtract an offset in a view."

#: What Spark calls an error (the first words of its message, in brackets) -> what users are told
_BY_CONDITION: dict[str, UserError] = {
    "CAST_INVALID_INPUT": SourceError(_VALUE),
    "CAST_OVERFLOW": SourceError(_VALUE),
    "NUMERIC_VALUE_OUT_OF_RANGE": SourceError(_VALUE),
    "MALFORMED_RECORD_IN_PARSING": SourceError(_VALUE),
    "ARITHMETIC_OVERFLOW": SourceError(_OVERFLOW),
    "PATH_NOT_FOUND": SourceError(
        "There is no such file or folder, or Spark's workers cannot reach it."
    ),
    "UNABLE_TO_INFER_SCHEMA": SourceError("There is no file to read in that folder."),
    "PARQUET_TYPE_ILLEGAL": SourceError(_NANOSECONDS),
    "PARQUET_TYPE_NOT_SUPPORTED": SourceError(_NANOSECONDS),
    "INSUFFICIENT_PERMISSIONS": EngineError("Spark may not do that with this table; ask for the grant."),
}

#: The same by what stands anywhere in the chain of causes.
_BY_TEXT: tuple[tuple[tuple[str, ...], UserError], ...] = (
    (("TIMESTAMP(NANOS",), SourceError(_NANOSECONDS)),
    (("CAST_INVALID_INPUT", "CAST_OVERFLOW", "NumberFormatException"), SourceError(_VALUE)),
    (("ARITHMETIC_OVERFLOW",), SourceError(_OVERFLOW)),
    (("No space left on device",), EngineError(FULL)),
    (("is not a Parquet file", "CANNOT_READ_FILE_FOOTER"), SourceError("A file is no Parquet file.")),
    (("OutOfMemoryError", "UNABLE_TO_ACQUIRE_MEMORY", "MEMORY_LIMIT"), EngineError(_MEMORY)),
    (("ConcurrentAppendException", "CommitFailedException"), ConflictError(CONFLICT)),
    (
        ("FileNotFoundException", "FAILED_READ_FILE", "CANNOT_RENAME", "Failed to rename"),
        ConflictError(_CONFLICT),
    ),
    (("Permission denied", "AccessControlException"), EngineError("Spark may not write there.")),
    (
        (
            *("ExecutorLostFailure", "All masters are unresponsive", "SparkContext was shut down"),
            *("Cannot call methods on a stopped SparkContext", "Stage cancelled because"),
        ),
        EngineError(_LOST),
    ),
)


def problem(error: Exception) -> UserError | None:
    """Return what the user can do about an error; None if it is none of the user's."""
    if type(error).__name__ in ("Py4JNetworkError", "ConnectionRefusedError", "ConnectionResetError"):
        return EngineError(_GONE)
    said = told(error)
    condition = said[1:].partition("]")[0].partition(".")[0] if said.startswith("[") else ""
    if condition in _BY_CONDITION:
        return _BY_CONDITION[condition]
    whole = f"{said}\n{getattr(error, '_stackTrace', '')}"
    for words, answer in _BY_TEXT:
        if any(word in whole for word in words):
            return answer
    return None


def told(error: Any) -> str:
    """Return what Spark says of an error, without the stack of Java."""
    return str(getattr(error, "_desc", None) or error)
