"""Settings of versions, and those that channels share, which are in the text of a run."""

from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

from gam_db.settings.source import Programs


class Setting(NamedTuple):
    """What channels must share to be scored by one query.

    Attributes:
        m, tau, bins, window_length, stride: as in the version.
        max_gap: integer time; None for no limit.
        has_start: whether the version is scored from a given instant on.
        still_after: samples; None for never.
        programs: the column that says which program runs, where states are healthy for one.
        by_column: whether channels differ in tau, window and stride, which are columns then; tau is the
            largest, the others say nothing.
    """

    m: int
    tau: int
    bins: int
    window_length: int
    stride: int
    max_gap: int | None
    has_start: bool
    still_after: int | None = None
    programs: Programs | None = None
    by_column: bool = False

    @property
    def has_programs(self) -> bool:
        """Whether states are healthy for a program."""
        return self.programs is not None

    @property
    def radix(self) -> int:
        """R = bins + 3, the codes a sample can have (method, section 3)."""
        return self.bins + 3


#: Fields of a setting that are no columns of a version.
NO_FIGURES = ("has_start", "programs", "by_column")


def setting_of(version: Mapping[str, Any]) -> Setting:
    """Return the setting of a row of the plan."""
    figures = {name: version[name] for name in Setting._fields if name not in NO_FIGURES}
    begins = version["score_from"] is not None
    return Setting(**figures, has_start=begins, programs=version.get("programs"))


def shape_of(version: Mapping[str, Any], by_column: bool = False) -> Setting:
    """Return the settings in the text of a run: without those that are read as columns.

    Where an engine takes delays ``by_column``, it reads tau, window and stride so, too.
    """
    setting = setting_of(version)
    if by_column:
        setting = setting._replace(tau=1, window_length=1, stride=1, by_column=True)
    # With how many programs a key fits into 64 bits follows from the bins.
    bins = setting.bins if setting.has_programs else 0
    return setting._replace(bins=bins, max_gap=None if version["max_gap"] is None else 1)


def shared_by(group: Sequence[Mapping[str, Any]], by_column: bool = False) -> Setting:
    """Return the setting of channels of one shape, with the most bins of any, and the largest delay."""
    most = {"bins": max(row["bins"] for row in group)}
    if by_column:  # as far back segments and samples outside calibration are looked for
        most["tau"] = max(row["tau"] for row in group)
    return shape_of(group[0], by_column)._replace(**most)
