"""What a page is to hold: keywords in Python, and options of ``gam report``."""

import datetime as dt
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from gam_db.clock import Length, aware, zone
from gam_db.errors import ConfigurationError, wrong
from gam_db.settings.setting import COLUMNS, COUNT, FLAG, LENGTH, TEXT, Kind, check, declared, setting


def _instant(name: str, given: Any) -> dt.datetime:
    try:
        return aware(given if isinstance(given, dt.datetime) else dt.datetime.fromisoformat(given))
    except (TypeError, ValueError):
        raise wrong("no_moment", name=name, given=given) from None


#: An error names the option, or the keyword.
_INSTANT = Kind(lambda _, name, given: _instant(name, given), read=_instant)


@declared
@dataclass(frozen=True)
class Wishes:
    """What the page is to hold.

    Raises:
        ConfigurationError: there is no such time zone, or another value cannot be used.
    """

    title: str = setting("Fleet health", TEXT)
    details: int = setting(24, COUNT, least=0)
    signals: Sequence[str] = setting((), replace(COLUMNS, option=list[str]))
    since: Length | None = setting(None, LENGTH)
    time_zone: str = setting("UTC", TEXT)
    raw: bool = setting(True, replace(FLAG, read=lambda *_: False))
    asset: str = setting("*", TEXT)
    made: dt.datetime | None = setting(None, _INSTANT)

    def __post_init__(self) -> None:
        check(self, ConfigurationError)
        zone(self.time_zone)
