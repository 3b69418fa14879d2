"""BigQuery."""

from sqlglot import exp

from gam_db.engines.base import Engine
from gam_db.engines.rewrites import escape_by_backslash
from gam_db.engines.storage import Storage, clustered
from gam_db.engines.types import Types


def _described(comment: exp.Expr) -> exp.Expr:
    return exp.Property(this=exp.var("description"), value=comment)


def name_rows_apart(tree: exp.Expr) -> exp.Expr:
    """Rename aliases of relations that have the name of a column.

    Cause: a name alone means the relation, as a whole row, before it means a column. Symptom: no
    matching signature, found STRUCT<...>, wherever a step has a column of its own name.
    """
    for select in tree.find_all(exp.Select):
        nodes = _without_queries_inside(select)
        columns = [node for node in nodes if isinstance(node, exp.Column)]
        alone = {column.name for column in columns if not column.table}
        for relation in nodes:
            name = relation.alias_or_name
            if isinstance(relation, (exp.Table, exp.Subquery)) and name in alone:
                apart = exp.to_identifier(f"{name}_rows")
                relation.set("alias", exp.TableAlias(this=apart))
                for column in columns:
                    if column.table == name:
                        column.set("table", apart.copy())
    return tree


def _without_queries_inside(select: exp.Select) -> list[exp.Expr]:
    return list(select.walk(prune=lambda node: isinstance(node, exp.Query) and node is not select))


def find_keys_as_structs(tree: exp.Expr) -> exp.Expr:
    """Look keys of several columns up among structs.

    Cause: what stands after IN has one column. Symptom: subquery of type IN must have only one output
    column, in every DELETE by a key.
    """
    for among in tree.find_all(exp.In):
        query = among.args.get("query")
        key = among.this
        if query is not None and isinstance(key, exp.Tuple) and len(key.expressions) > 1:
            query.unnest().set("kind", "STRUCT")
    return tree


ENGINE = Engine.named(
    "bigquery",
    types=Types("bigquery"),
    storage=Storage(
        comments="inside",  # as OPTIONS
        note=_described,
        column_note=lambda comment: exp.Properties(expressions=[_described(comment)]),
        properties=clustered,
    ),
    rewrites=(escape_by_backslash, name_rows_apart, find_keys_as_structs),
)
