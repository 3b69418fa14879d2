"""Adding steps to a pipeline: by file, for one set of parameters, or as literal rows."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from sqlglot import exp

from gam_db.composing import template
from gam_db.composing.pipeline import Pipeline, filled, union_of
from gam_db.method.resolved import Method
from gam_db.method.slots import following
from gam_db.settings.parameters import Parameters


def add(
    steps: Pipeline,
    path: str,
    slots: Mapping[str, template.Slot] | None = None,
    name: str | None = None,
    tables: Mapping[str, str] | None = None,
) -> None:
    """Add the step of one file, called as the file unless named otherwise."""
    steps.fill(name or path.rpartition("/")[2], path, slots, tables)


@dataclass(frozen=True)
class OfSet:
    """The steps of one set of parameters.

    Attributes:
        steps: the pipeline that they are in.
        method: with all sets.
        number: of this one.
    """

    steps: Pipeline
    method: Method
    number: int

    @property
    def setting(self) -> Parameters:
        """The parameters."""
        return self.method.settings[self.number]

    def named(self, step: str) -> str:
        """Return what a step of this set is called."""
        return self.method.named(step, self.number)

    def add(
        self,
        path: str,
        slots: Mapping[str, template.Slot] | None = None,
        name: str | None = None,
        tables: Mapping[str, str] | None = None,
    ) -> None:
        """Add the step of one file, reading the steps of the same set where there are such.

        Slots that follow from the parameters are filled by their names (:mod:`gam_db.method.slots`).
        """
        step_names, filled_slots, renamed = (
            frozenset(self.steps.steps),
            dict(slots or {}),
            dict(tables or {}),
        )

        def inputs() -> dict[str, str]:
            read_steps = {table: renamed.get(table, table) for table in template.load(path).tables}
            steps_of_set = {table: self.named(step) for table, step in read_steps.items()}
            return {
                table: steps_of_set[table] if steps_of_set[table] in step_names else read_steps[table]
                for table in read_steps
            }

        self.steps.fill(
            self.named(name or path.rpartition("/")[2]),
            path,
            lambda: self.slots(path, filled_slots),
            inputs,
        )

    def slots(self, path: str, filled_slots: Mapping[str, template.Slot]) -> dict[str, template.Slot]:
        """Return the slots of a file: the given ones, and those that follow from the parameters."""
        names = template.load(path).slots - filled_slots.keys()
        set_slots = {"settings_no": self.number, "max_gap": self.method.gaps[self.number]}
        mine: dict[str, template.Slot] = {name: of for name, of in set_slots.items() if name in names}
        if "settings" in names:
            mine["settings"] = [
                exp.alias_(exp.column(name, table="scale"), name) for name in self.method.columns
            ]
        if "differing" in names:
            mine["differing"] = [exp.column("buckets")] * ("buckets" in self.method.columns)
        return {**mine, **following(self.setting, names, self.method.columns), **filled_slots}


def add_stacked(
    steps: Pipeline,
    path: str,
    rows: Sequence[Mapping[str, Any]],
    name: str | None = None,
) -> None:
    """Add a step of one file that is filled once per row of slots, one under another."""
    queries = [filled(path, slots) for slots in rows]
    query = queries[0] if len(rows) == 1 else exp.union(*queries, distinct=False)
    steps.add(name or path.rpartition("/")[2], query, template.load(path).comment)


def join_sets(steps: Pipeline, method: Method, names: Sequence[str]) -> None:
    """Unite the rows of all sets; with one set, do nothing."""
    if len(method.settings) > 1:
        for name in names:
            parts = [method.named(name, number) for number in range(len(method.settings))]
            steps.add(name, union_of(steps, parts), f"{name}: the rows of all sets of parameters.")
