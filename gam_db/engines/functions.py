"""Functions that return rows: views with parameters of a script or session."""

from collections.abc import Sequence

from sqlglot import exp

#: What a function of one signal is called with.
SIGNAL = ("asset_name", "channel_name")


def signal_rows(view: exp.Table) -> exp.Query:
    """Return the rows of a view that are of the signal that a function is called with."""
    asset, channel = map(exp.column, SIGNAL)
    named = exp.column("asset").eq(asset), exp.column("channel").eq(channel)
    return exp.select("*").from_(view.copy()).where(*named)


def macro(
    name: exp.Table, parameters: Sequence[str], query: exp.Query, *properties: exp.Expr
) -> exp.Create:
    """Return the definition of a query as a function; its parameters are columns without a table."""
    arguments = [exp.to_identifier(parameter) for parameter in parameters]
    function = exp.UserDefinedFunction(this=name, expressions=arguments, wrapped=True)
    gives_rows = exp.ReturnsProperty(this=exp.Schema(this=exp.var("TABLE")), is_table=True)
    all_properties = exp.Properties(expressions=[*properties, gives_rows])
    return exp.Create(
        this=function, kind="MACRO", expression=query, properties=all_properties, replace=True
    )
