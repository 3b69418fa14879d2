"""What dbt does with a package, as far as our models need it: enough to build one in memory on DuckDB.

The real dbt builds the same files in test_dbt_built.py, where it is installed; this stand-in is quick
enough for many random histories.
"""

import re
from typing import Any

import duckdb

TELEMETRY = "telemetry"

_CONFIG = re.compile(r"\{\{ config\((.*)\) \}\}\n")
_FORMS = re.compile(r"\{% if is_incremental\(\) %\}(.*)\{% else %\}(.*)\{% endif %\}", re.DOTALL)
_NAMES = {
    re.compile(r"\{\{ ref\('([^']*)'\) \}\}"): r'main."\1"',
    re.compile(r"\{\{ source\('gam_source', 'telemetry'\) \}\}"): f'main."{TELEMETRY}"',
}


class Builder:
    """A package and the database it is built in, which must hold the table ``telemetry``."""

    def __init__(self, files: dict[str, str], connection: duckdb.DuckDBPyConnection) -> None:
        self.models = {
            path.rpartition("/")[2].removesuffix(".sql"): text
            for path, text in files.items()
            if path.startswith("models/") and path.endswith(".sql")
        }
        self.connection = connection
        self.built: set[str] = set()

    def build(self, full_refresh: bool = False) -> None:
        """Build all models; the first build of a model is a full one anyway."""
        for name, text in self.models.items():
            config = self.config(text)
            is_incremental = config["materialized"] == "incremental"
            is_later = is_incremental and name in self.built and not full_refresh
            query = self.rendered(name, text, is_later)
            this = f'main."{name}"'
            if is_later:
                self._add(this, query, config)
            else:
                kind = "TABLE" if is_incremental else "VIEW"
                self.connection.execute(f"CREATE OR REPLACE {kind} {this} AS {query}")
            if "post_hook" in config:
                self.connection.execute(config["post_hook"].replace("{{ this }}", this))
            self.built.add(name)

    def rows(self, query: str) -> list[dict[str, Any]]:
        """The rows of a query."""
        found: list[dict[str, Any]] = self.connection.sql(query).to_arrow_table().to_pylist()
        return found

    @staticmethod
    def config(text: str) -> dict[str, Any]:
        """What a model says of itself."""
        (said,) = _CONFIG.findall(text)
        found: dict[str, Any] = eval(f"dict({said})", {"true": True, "false": False})
        return found

    @staticmethod
    def rendered(name: str, text: str, is_later: bool) -> str:
        """The query of a model; nothing of Jinja may be left."""
        body = _CONFIG.sub("", text)
        body = _FORMS.sub(r"\1" if is_later else r"\2", body)
        for written, meant in _NAMES.items():
            body = written.sub(meant, body)
        body = body.replace("{{ this }}", f'main."{name}"')
        assert not re.search(r"[{}]", body), body
        return body

    def _add(self, this: str, query: str, config: dict[str, Any]) -> None:
        self.connection.execute(f"CREATE OR REPLACE TEMP TABLE arriving AS {query}")
        if config["incremental_strategy"] == "delete+insert":
            same = " AND ".join(f"{this}.{key} = arriving.{key}" for key in config["unique_key"])
            self.connection.execute(f"DELETE FROM {this} USING arriving WHERE {same}")
        self.connection.execute(f"INSERT INTO {this} SELECT * FROM arriving")
