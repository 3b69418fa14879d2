"""Bins that are found by the certificate (method, section 5): the grid of each channel."""

import dataclasses
from collections import Counter
from collections.abc import Sequence

from gam_db.columns import name_of
from gam_db.engines.session import Row
from gam_db.settings.parameters import AUTO, RUNGS, Override, Parameters
from gam_db.settings.patterns import grouped
from gam_db.settings.setting import settings_of


def found_bins(asked: Parameters, verdicts: Sequence[Row], channels: Sequence[Row]) -> Parameters:
    """Return parameters with the bins that the certificates of a study under the finest grids accept.

    They have one override per pattern. A channel has the finest grid that its support's certificate
    accepts, the coarsest if none, and the commonest if it has no certificate.
    """
    judged = {row["channel_id"]: row for row in verdicts}
    rungs, said = {}, {}
    for row in channels:
        name, verdict = name_of(row), judged[row["channel_id"]]
        said[name] = asked.of(*name)
        if verdict["verdict"] not in ("no_data", "constant"):
            rungs[name] = max(verdict["finest_bins"] or 0, RUNGS[-1])
    usual = max(Counter(rungs.values()).items(), key=lambda one: one[::-1], default=(RUNGS[-1],))[0]
    for name, one in said.items():
        if one.bins == AUTO:
            bins = min(rungs.get(name, usual), one.grid)
            said[name] = dataclasses.replace(one, bins=bins)
    rules, everything = grouped(said), ("*", "*")
    general = next((one for pattern, one in rules if pattern == everything), asked.finest())
    overrides = [
        Override(*pattern, **{key: getattr(one, key) for key in settings_of(Parameters)})
        for pattern, one in rules
        if pattern != everything
    ]
    return dataclasses.replace(general, overrides=overrides)
