"""What can be set of a monitor: its keywords, the section [monitor] of gam.toml, and options."""

from dataclasses import dataclass
from typing import Literal

from gam_db.clock import Length
from gam_db.settings.setting import LENGTH, TEXT, check, declared, setting
from gam_db.stored import lengths
from gam_db.stored.pruning import NOVEL_ROWS
from gam_db.stored.schema.tables import StateTables


@declared
@dataclass(kw_only=True)
class MonitorSettings:
    """Settings of the stored tables: their place, and how long rows stay.

    Lengths are counter steps, or seconds, a timedelta or a text where the source has timestamps.

    Raises:
        UserError: a value cannot be used.
    """

    name: str = setting(
        "default", TEXT, "name of the monitor; one database can hold several", metavar="MONITOR"
    )
    schema: str | None = setting(
        *(None, TEXT, "schema of the state tables"),
        usual="the current one",
        example="monitoring",
        aside=True,
    )
    prefix: str = setting("gam_", TEXT, "first part of the names of tables, views and models", least=0)
    lookback: Length | None = setting(
        *(None, LENGTH, "how late a row may come"),
        usual=f"{lengths.LOOKBACK}, or 0 steps of a counter",
        example="1 h",
    )
    park_after: Length | Literal[False] | None = setting(
        *(
            None,
            LENGTH,
            "lag behind the newest data after which a channel is silent, and read once a day",
        ),
        usual=f"{lengths.PARK_AFTER}, or never for a counter",
        off=(False, "never"),
        example="1 d",
    )
    keep: Length | None = setting(
        *(None, LENGTH, "age up to which gam prune keeps buckets"), usual="all", example="400 d"
    )
    keep_novel: Length | None = setting(
        *(None, LENGTH, "age up to which gam prune keeps novel cells"),
        usual=f"the newest {NOVEL_ROWS:,} of each version, so that a saturated channel stays bounded",
        example="90 d",
    )

    def __post_init__(self) -> None:
        check(self)
        _ = self.tables  # which refuses a prefix that cannot begin a name

    @property
    def tables(self) -> StateTables:
        """The schema and prefix of the state."""
        return StateTables(self.schema, self.prefix)
