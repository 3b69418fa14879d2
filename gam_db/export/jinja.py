"""The few words of Jinja that a model needs, as nodes of a tree and as lines around a query.

This module owns how a query names what dbt knows. A node of it is put into the tree like any other table
and written as it is; the text of a query is never searched for names.
"""

from collections.abc import Mapping
from typing import Any

from sqlglot import exp

from gam_db.composing.layout import WIDTH
from gam_db.errors import wrong

THIS = exp.Table(this=exp.var("{{ this }}"))

_SIGNS = ("{{", "{%", "{#")


def reference(model: str) -> exp.Table:
    """Return the node that reads another model."""
    return exp.Table(this=exp.var(f"{{{{ ref({_quoted(model)}) }}}}"))


def source(name: str, table: str) -> exp.Table:
    """Return the node that reads a table of a source."""
    return exp.Table(this=exp.var(f"{{{{ source({_quoted(name)}, {_quoted(table)}) }}}}"))


def config(settings: Mapping[str, Any]) -> str:
    """Return what configures a model."""
    words = [f"{name}={_value(value)}" for name, value in settings.items()]
    line = f"{{{{ config({', '.join(words)}) }}}}"
    if len(line) <= WIDTH:
        return line
    return "{{ config(\n" + ",\n".join(f"  {word}" for word in words) + "\n) }}"


def run(statement: str) -> str:
    """Return what runs a statement in the transaction of a test, which has no hooks."""
    return f"{{% call statement('before') %}}{statement}{{% endcall %}}"


def built_once(query: str) -> str:
    """Return the configuration of a model that is built once: later builds add nothing."""
    nothing = "{% if is_incremental() %} SELECT * FROM {{ this }} WHERE 1 = 0 {% else %}"
    return f"{nothing}\n{query}\n{{% endif %}}"


def if_there(model: str, query: str, nothing: str) -> str:
    """Return the head of a model that reads a later one, as the last build left it, as ``before``."""
    place = f"this.database, this.schema, {_quoted(model)}"
    before = f"{{% set before = adapter.get_relation({place}) %}}"
    condition = "{% if before is not none and not should_full_refresh() %}"
    return f"{before}\n{condition}\n{query}\n{{% else %}}\n{nothing}\n{{% endif %}}"


def check_is_free(tree: exp.Expr) -> None:
    """Refuse names and texts of the user that dbt would take for Jinja."""
    for node in tree.find_all(exp.Literal, exp.Identifier):
        if any(sign in node.name for sign in _SIGNS):
            raise wrong("jinja_in_a_name", name=node.name, names=", ".join(_SIGNS))


def _value(value: Any) -> str:
    if isinstance(value, str):
        return _quoted(value)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(_value(part) for part in value)}]"
    return "true" if value is True else "false" if value is False else repr(value)


def _quoted(text: str) -> str:
    return '"{}"'.format(text.replace("\\", "\\\\").replace('"', '\\"')) if "'" in text else f"'{text}'"
