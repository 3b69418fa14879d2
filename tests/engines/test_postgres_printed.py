"""A filter on one signal of a printed view reads its rows alone, by an index, on PostgreSQL."""

import json
from typing import Any

from scripts import filtered


def test_a_filter_on_one_signal_reads_its_rows_by_an_index() -> None:
    session, table, view = filtered("postgres")
    session.driver.execute(f"CREATE INDEX {table}_signal ON public.{table} (asset, channel, time)")
    session.driver.execute(f"ANALYZE public.{table}")
    (row,) = session.driver.fetch(f"EXPLAIN (ANALYZE, FORMAT JSON) {view}").to_pylist()
    plan = row["QUERY PLAN"]
    pending: list[dict[str, Any]] = [(json.loads(plan) if isinstance(plan, str) else plan)[0]["Plan"]]
    scans = []
    while pending:
        node = pending.pop()
        pending += node.get("Plans") or ()
        if node.get("Relation Name") == table or (node.get("Index Name") or "").startswith(table):
            scans.append(node)
    assert scans
    for node in scans:
        assert "'a3'" in (node.get("Index Cond") or node.get("Recheck Cond") or "")
        assert node["Actual Rows"] * node["Actual Loops"] == 600  # of 24,000
