"""Export: the method as SQL to run elsewhere, from the same files of ``sql/``.

That is one script for an engine (:mod:`gam_db.export.script`), a package for dbt
(:mod:`gam_db.export.dbt`), and dashboards for Grafana (:mod:`gam_db.export.grafana`), which only read
the views. What is written needs no Python to run.
"""

from gam_db.export.dbt import Package, write

__all__ = ["Package", "write"]
