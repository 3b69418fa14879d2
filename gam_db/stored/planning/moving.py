"""What changes of a whole signal explain of windows that are read again, for one set."""

from sqlglot import exp

from gam_db.composing import template
from gam_db.method.adding import OfSet
from gam_db.method.programs import JUDGED, coded, keyed, numbers
from gam_db.method.slots import code_in


def add_moves(of_set: OfSet) -> None:
    """Add *move_counts* over *placed*: the novel vectors that are healthy once a change is undone."""
    setting = of_set.setting
    programs, (_, tables) = numbers(of_set), coded(of_set, JUDGED)
    value = exp.column("value")
    delayed = [
        exp.alias_(
            template.fill("embedding/delayed", {"column": value, "delay": k * setting.tau}), f"x_{k}"
        )
        for k in range(1, setting.m)
    ]
    carried = [*(exp.column(f"x_{k}") for k in range(1, setting.m)), *programs]
    of_sample = [exp.alias_(exp.column(of.name, table="newest"), of.name) for of in carried]
    slots: dict[str, template.Slot] = {"delayed": [*delayed, *programs], "carried": of_sample}
    of_set.add("stored/alarms/reread", {**slots, "window": setting.window}, tables=tables)
    of_set.add("stored/alarms/reread_usual")
    of_set.add("stored/alarms/moves")
    undone = [
        exp.alias_(
            template.fill("stored/alarms/unmoved", {"value": exp.column(f"x_{k}", table="vector")}),
            f"y_{k}",
        )
        for k in range(setting.m)
    ]
    codes = [
        exp.alias_(code_in(setting.grid, value=exp.column(f"y_{k}")), f"code_{k}")
        for k in range(setting.m)
    ]
    ran = [exp.alias_(exp.column(of.name, table="vector"), of.name) for of in programs]
    filled: dict[str, template.Slot] = {"samples": [*undone, *ran], "codes": [*codes, *programs]}
    of_set.add("stored/alarms/moved", {**filled, **keyed(of_set)})
    of_set.add("stored/alarms/move_counts")
