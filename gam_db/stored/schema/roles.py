"""Roles: the rights of owner, writer and reader of the state, as GRANT statements.

The owner creates, changes and drops the tables and views. The writer calibrates, scores, checks and
prunes. The reader prints the status, and reads the views. This module owns which tables and views each
role needs, and with which rights.
"""

from collections.abc import Iterator
from dataclasses import dataclass

from sqlglot import exp

from gam_db.composing import template
from gam_db.engines.base import Engine
from gam_db.errors import ConfigurationError, EngineError
from gam_db.stored.schema.tables import FOR_READERS, TABLES, VIEWS, StateTables

ROLES = ("owner", "writer", "reader")

#: Rows that a later run hides, or that are old, go.
_DELETED = (
    *("version", "calibration", "bounds", "block", "support", "bucket", "novel", "run", "unplaced"),
    *("checksum", "horizon", "ladder", "judgement", "buffered", "band", "extent", "limit", "band_visit"),
    *("left_out", "probe", "program", "unknown_program", "move"),
)

#: Where one writer waits for another: a column of one row is written, and stays what it was.
_TOUCHED = {"migration": "applied_at", "monitor": "created"}

#: The views by which runs, buckets and cells that count are found, and what a run or a label says in the
#: end.
_COUNTING = (
    "alarm",
    *("finished_run", "visible_bucket", "visible_novel", "visible_program"),
    *("visible_judgement", "visible_episode"),
    *("fleet", "stillness", "unjudged_program"),
)

#: What the status is made of.
_STATUS = (
    *("migration", "monitor", "proof", "visible_bucket", "fleet", "machine", "stillness"),
    *("version", "bounds", "run", "finished_run", "unplaced", "left_out", "unjudged_program"),
)

#: What readers use, and what other commands of a reader take.
_SHOWN = (
    *(name for name in (*VIEWS, *TABLES) if name in FOR_READERS and name not in _STATUS),
    *("labelled_episode", "channel", "limit"),
)

#: What a script cannot know, as comments of it.
ALSO = (
    "-- The writer reads the source, too: GRANT USAGE on its schema, GRANT SELECT on it.\n"
    "-- Where not everybody makes temporary tables: GRANT TEMPORARY ON DATABASE to writer and reader."
)


@dataclass(frozen=True)
class Roles:
    """The names of owner, writer and reader; None for no role.

    Raises:
        ConfigurationError: nobody is named, or one name is empty.
    """

    owner: str | None = None
    writer: str | None = None
    reader: str | None = None

    def __post_init__(self) -> None:
        named = [getattr(self, role) for role in ROLES]
        if not any(named) or "" in named:
            raise ConfigurationError(f"Name at least one of {', '.join(ROLES)}, as owner=NAME.")

    @classmethod
    def parsed(cls, text: str) -> "Roles":
        """Return the roles of a text such as ``owner=plant_owner,writer=plant,reader=everybody``.

        Raises:
            ConfigurationError: it is no such text.
        """
        names: dict[str, str] = {}
        for part in text.split(","):
            role, equals, name = (word.strip() for word in part.partition("="))
            if role not in ROLES or role in names or not equals:
                raise ConfigurationError(
                    f"grants is {text!r}; write owner=NAME,writer=NAME,reader=NAME, each at most once."
                )
            names[role] = name
        return cls(**names)


def before(engine: Engine, tables: StateTables, roles: Roles) -> Iterator[exp.Expr]:
    """Yield what comes before the tables and views, so that they belong to the owner.

    Raises:
        EngineError: the engine knows no such statements.
    """
    if engine.home is None:
        raise EngineError(f"gam-db writes grants only for PostgreSQL, not for {engine.title}.")
    schema = exp.Table(db=template.name(tables.schema or engine.home))
    if tables.schema is not None:
        yield exp.Create(this=schema.copy(), kind="SCHEMA", exists=True)
    for name, privileges in (
        (roles.owner, ("USAGE", "CREATE")),
        (roles.writer, ("USAGE",)),
        (roles.reader, ("USAGE",)),
    ):
        if name is not None:
            yield _grant(dict.fromkeys(privileges), "SCHEMA", schema, name)
    if roles.owner is not None:
        as_owner = exp.EQ(this=exp.var("role"), expression=template.text(roles.owner))
        yield exp.Set(expressions=[exp.SetItem(this=as_owner)])


def after(tables: StateTables, roles: Roles) -> Iterator[exp.Expr]:
    """Yield the statements that grant writer and reader their rights."""
    if roles.writer is not None:
        for name in (*TABLES, *_COUNTING):
            privileges: dict[str, str | None] = {"SELECT": None}
            # Rows are added to all tables but the record of migrations.
            privileges |= {"INSERT": None} if name in TABLES and name != "migration" else {}
            privileges |= {"DELETE": None} if name in _DELETED else {}
            privileges |= {"UPDATE": _TOUCHED[name]} if name in _TOUCHED else {}
            yield _grant(privileges, "TABLE", tables.table(name), roles.writer)
    if roles.reader is not None:
        for name in (*_STATUS, *_SHOWN):
            yield _grant({"SELECT": None}, "TABLE", tables.table(name), roles.reader)
    if roles.owner is not None:
        yield exp.Command(this="RESET", expression="ROLE")


def _grant(privileges: dict[str, str | None], kind: str, of: exp.Table, to: str) -> exp.Grant:
    """Return a GRANT; a privilege is for a column, or for the whole."""
    return exp.Grant(
        privileges=[
            exp.GrantPrivilege(
                this=exp.var(privilege),
                expressions=None if column is None else [exp.column(template.name(column))],
            )
            for privilege, column in privileges.items()
        ],
        kind=kind,
        securable=of.copy(),
        principals=[exp.GrantPrincipal(this=template.name(to))],
    )
