"""Export: the method as a package of another tool, from the same files of ``sql/``.

The tools are dbt (:mod:`gam_db.export.dbt`) and Grafana
(:mod:`gam_db.export.grafana`), which only reads the views. What is written needs no Python to run.
"""

from gam_db.export.dbt import Package, write

__all__ = ["Package", "write"]
