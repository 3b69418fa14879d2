"""Fleets: simulated into a file, read by the product, and forgotten but for its tables and the truth."""

import tempfile
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pyarrow as pa
from pyarrow import parquet

from gam_db.lab.benchmark.alarms.plan import Plan, is_watched
from gam_db.lab.benchmark.alarms.tables import Learnt, Name, learnt
from gam_db.lab.simulate.fleet import Fleet
from gam_db.settings.calibration import Calibration
from gam_db.settings.source import Source


@dataclass
class Fleets:
    """Some fleets.

    Attributes:
        learnt: the product's tables of each.
        wearing: what becomes of each joint that wears: fault, onset, failed_at.
        calm: the channels that nothing happens to.
        outputs: what else was made of each file.
    """

    learnt: list[Learnt] = field(default_factory=list)
    wearing: dict[Name, dict[str, Any]] = field(default_factory=dict)
    calm: set[Name] = field(default_factory=set)
    outputs: list[Any] = field(default_factory=list)


#: Makes something of a fleet's file; told the channels that were read so far.
OnFile = Callable[[Fleet, Source, Fleets], Any]


def read(
    plan: Plan,
    fleets: Iterable[Fleet],
    calibration: Calibration,
    show: Callable[[str], None],
    wearing: bool = True,
    on_file: OnFile | None = None,
    more: Sequence[str] = (),
) -> Fleets:
    """Simulate fleets and read them, one after another.

    Args:
        plan: which robots and joints.
        fleets: the fleets.
        calibration: of each channel.
        show: told which fleet is at work.
        wearing: with the joints that wear.
        on_file: makes something else of each file.
        more: steps whose tables are wanted, too.
    """
    result = Fleets()
    for fleet in fleets:
        show(f"fleet {fleet.seed}")
        with tempfile.TemporaryDirectory(prefix="gam-") as folder:
            path = Path(folder) / "fleet.parquet"
            _write(path, plan, fleet, wearing, result)
            source = Source(path, "asset", "channel", "time", "value")
            result.learnt.append(learnt(source, plan.parameters, calibration, more))
            if on_file is not None:
                result.outputs.append(on_file(fleet, source, result))
    return result


def _write(path: Path, plan: Plan, fleet: Fleet, wearing: bool, result: Fleets) -> None:
    with parquet.ParquetWriter(path, fleet.schema, compression="zstd") as writer:
        for robot in range(1, plan.robots + 1):
            joints = [n for n in range(1, 7) if is_watched(fleet, robot, n, plan, wearing)]
            for number, joint in ((number, fleet.joint(robot, number)) for number in joints):
                # A family is named by patterns of channels, so they say which fleet and robot.
                name = joint.truth["asset"], f"f{fleet.seed}_r{robot}_j{number}"
                repeated = pa.array([name[1]]).take(pa.array([0] * joint.readings.num_rows))
                writer.write_table(joint.readings.set_column(1, "channel", repeated))
                if joint.truth["failed_at"] is not None:
                    result.wearing[name] = joint.truth
                else:
                    result.calm.add(name)
