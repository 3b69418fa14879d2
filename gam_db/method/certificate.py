"""The certificate of one set (method, section 5)."""

from collections.abc import Mapping

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import union_of
from gam_db.method.adding import OfSet, add_stacked
from gam_db.method.programs import weight_of
from gam_db.method.vectors import add_vectors, compared
from gam_db.settings.parameters import Parameters


def add_missing_vectors(set_steps: OfSet, samples: str) -> None:
    """Add how many vectors of each channel have a missing sample, be they learnt, scored or neither."""
    columns = compared(set_steps.setting)
    may_lack = exp.true() if columns else exp.column("missing_readings", table="named") > 0
    slots: dict[str, template.Slot] = {"read": may_lack, "carried": columns}
    set_steps.add("certificate/present_codes", slots, tables={"samples": samples})
    add_vectors(set_steps, "present_", has_keys=False)
    set_steps.add("certificate/missing_vectors", tables={"vectors": "present_vectors"})


def coarse_key(setting: Parameters, has_programs: bool = False) -> exp.Expr:
    """Return the key of a cell on a coarser grid, of its key and a divisor of bins.

    Where there are programs, the coarser cell is of the same one.
    """
    radix, top = setting.radix, setting.m - 1
    spelt = setting.m if has_programs else top
    coarse = [
        template.fill("certificate/coarse_term", {"weight": radix**k, "above": radix ** (k + 1)})
        for k in range(spelt)
    ]
    if has_programs:
        coarse.append(template.fill("program/key_term", {"weight": weight_of(setting)}))
    else:
        coarse.append(template.fill("certificate/top_term", {"weight": radix**top}))
    return template.added(coarse)


def add_judgement(set_steps: OfSet, by_halves: bool = False) -> None:
    """Add the certificate of one set (section 5).

    Args:
        set_steps: those of the set, with its learnable vectors and bounds.
        by_halves: keep the cells of each grid and make those of the next one of them, which pays where
            they are many; else all grids are made of the finest in one statement.
    """
    setting = set_steps.setting
    for name in ("learnt", "visits", "block_sizes"):
        set_steps.add(f"certificate/{name}")
    set_steps.add("certificate/cells", {"gathered": [], "carried": []})
    for name in ("blocks", "first_visits", "cell_shares", "learning"):
        set_steps.add(f"certificate/{name}")
    bins = {k: -(-setting.grid // 2**k) for k in range(setting.grid.bit_length() + 1)}
    rungs = [k for k in bins if k == 0 or bins[k] >= 2]

    def add_levels(name: str, divisors: dict[int, int]) -> None:
        rows = [{"level": k, "divisor": of, "level_bins": bins[k]} for k, of in divisors.items()]
        add_stacked(set_steps.steps, "certificate/levels", rows, set_steps.named(name))

    add_levels("levels", {k: 2**k for k in rungs})
    slots: dict[str, template.Slot] = {
        "coarse_key": coarse_key(setting, set_steps.method.programs is not None)
    }
    if by_halves and len(rungs) > 1:
        finer, halved = "cells", []
        for k in rungs[1:]:
            add_levels(f"level_{k}", {k: 2})
            set_steps.add(
                "certificate/coarsened", slots, f"halved_{k}", {"cells": finer, "levels": f"level_{k}"}
            )
            finer = f"halved_{k}"
            halved.append(set_steps.named(finer))
        set_steps.steps.small |= set(halved)
        comment = template.load("certificate/coarsened").comment
        set_steps.steps.add(set_steps.named("coarsened"), union_of(set_steps.steps, halved), comment)
    else:
        set_steps.add("certificate/coarsened", slots)
    set_steps.add("certificate/ladder")
    set_steps.add("certificate/spread")
    for name in ("finest", "outlook"):
        set_steps.add(f"certificate/{name}")
    if set_steps.method.pools:
        _add_members(set_steps, slots)


def _add_members(set_steps: OfSet, slots: Mapping[str, template.Slot]) -> None:
    """Add the certificate of whole machines of pools: as that of blocks, each member being one."""
    set_steps.add("certificate/member_sizes")
    set_steps.add("certificate/member_cells")
    renamed = {
        "block_sizes": "member_sizes",
        "cells": "member_cells",
        "blocks": "machines",
        "coarsened": "member_coarsened",
        "ladder": "member_ladder",
        "spread": "member_spread",
    }
    for file in ("blocks", "coarsened", "ladder", "spread", "finest"):
        name = renamed.get(file, f"member_{file}")
        set_steps.add(f"certificate/{file}", slots if file == "coarsened" else None, name, renamed)
    set_steps.add("certificate/vouching")
    set_steps.add("certificate/pool_spread")
