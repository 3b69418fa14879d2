"""What dbt does with a package, as far as our models need it: enough to build one in memory on DuckDB.

The real dbt builds the same files in test_dbt_built.py, where it is installed; this stand-in is quick
enough for many random histories.
"""

import re
from typing import Any

import duckdb

TELEMETRY = "telemetry"

_CONFIG = re.compile(r"\{\{ config\((.*?)\) \}\}\n", re.DOTALL)
_FORMS = re.compile(r"\{% if is_incremental\(\) %\}(.*)\{% else %\}(.*)\{% endif %\}", re.DOTALL)
_BEFORE = re.compile(
    r"\{% set before = adapter.get_relation\(this.database, this.schema, '([^']*)'\) %\}\n"
    r"\{% if before is not none and not should_full_refresh\(\) %\}(.*)\{% else %\}(.*)\{% endif %\}",
    re.DOTALL,
)
_REFERENCE = re.compile(r"\{\{ ref\('([^']*)'\) \}\}")
_SOURCE = "{{ source('gam_source', 'telemetry') }}"


class Builder:
    """A package and the database it is built in, which must hold the table ``telemetry``."""

    def __init__(self, files: dict[str, str], connection: duckdb.DuckDBPyConnection) -> None:
        self.models = {
            path.rpartition("/")[2].removesuffix(".sql"): text
            for path, text in files.items()
            if path.startswith("models/") and path.endswith(".sql")
        }
        self.models = {name: self.models[name] for name in self._ordered()}
        self.connection = connection
        self.built: set[str] = set()

    def _ordered(self) -> list[str]:
        """The models, each after those that it reads."""
        order: list[str] = []

        def visit(name: str) -> None:
            if name in order:
                return
            for read in _REFERENCE.findall(self.models[name]):
                visit(read)
            order.append(name)

        for name in self.models:
            visit(name)
        return order

    def build(self, full_refresh: bool = False) -> None:
        """Build all models; the first build of a model is a full one anyway."""
        for name, text in self.models.items():
            config = self.config(text)
            if config["materialized"] == "ephemeral":
                continue
            is_incremental = config["materialized"] == "incremental"
            is_later = is_incremental and name in self.built and not full_refresh
            query = self.rendered(name, text, is_later, full_refresh)
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

    def rendered(self, name: str, text: str, is_later: bool, full_refresh: bool = False) -> str:
        """The query of a model, over the ephemeral ones that it reads; nothing of Jinja may be left."""
        lists: dict[str, str] = {}
        body = self._body(name, text, is_later, full_refresh, lists)
        if not lists:
            return body
        entries = ",\n".join(f"{entry} AS ({query})" for entry, query in lists.items())
        return f"WITH {entries}\nSELECT * FROM ({body}) AS rows_of_model"

    def _body(
        self, name: str, text: str, is_later: bool, full_refresh: bool, lists: dict[str, str]
    ) -> str:
        body = _CONFIG.sub("", text)
        body = _FORMS.sub(r"\1" if is_later else r"\2", body)
        if match := _BEFORE.search(body):
            is_there = match[1] in self.built and not full_refresh
            body = match[2].replace("{{ before }}", f'main."{match[1]}"') if is_there else match[3]
        for read in dict.fromkeys(_REFERENCE.findall(body)):
            place = f'main."{read}"'
            if self.config(self.models[read])["materialized"] == "ephemeral":
                place = f"__dbt__cte__{read}"
                if place not in lists:
                    query = self._body(read, self.models[read], False, full_refresh, lists)
                    lists[place] = query
            body = body.replace(f"{{{{ ref('{read}') }}}}", place)
        body = body.replace(_SOURCE, f'main."{TELEMETRY}"').replace("{{ this }}", f'main."{name}"')
        assert not re.search(r"[{}]", body), body
        return body

    def _add(self, this: str, query: str, config: dict[str, Any]) -> None:
        self.connection.execute(f"CREATE OR REPLACE TEMP TABLE arriving AS {query}")
        if config["incremental_strategy"] == "delete+insert":
            same = " AND ".join(f"{this}.{key} = arriving.{key}" for key in config["unique_key"])
            self.connection.execute(f"DELETE FROM {this} USING arriving WHERE {same}")
        self.connection.execute(f"INSERT INTO {this} SELECT * FROM arriving")
