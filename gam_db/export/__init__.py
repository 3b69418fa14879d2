"""Export: the method as a package of another tool, from the same files of ``sql/``.

So far that tool is dbt (:mod:`gam_db.export.dbt`). What is written needs no Python to run.
"""

from gam_db.export.dbt import Package, write

__all__ = ["Package", "write"]
