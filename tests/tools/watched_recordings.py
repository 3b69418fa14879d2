"""The recordings whose alarms are tried, each with its method, what is alike in it, and its faults."""

from dataclasses import dataclass

from gam_db.settings.calibration import Calibration
from gam_db.settings.parameters import Override, Parameters

#: Cycles of the rig in which all components are healthy, and tenths of a second of a cycle.
HEALTHY_CYCLES, CYCLE = ((1664, 1673), (1756, 1756), (1787, 1796)), 600


@dataclass(frozen=True)
class Recording:
    """One recording, or a part of it, under one method.

    Attributes:
        folder: of the recording.
        parameters, calibration: the method.
        family: patterns of channels that are alike.
        faults: labels that are a fault; none: the recording is healthy.
        time: the column of time.
    """

    folder: str
    parameters: Parameters
    calibration: Calibration
    family: tuple[str, ...]
    faults: tuple[str, ...] = ()
    time: str = "t"


_HEALTHY = [(CYCLE * first, CYCLE * last + CYCLE - 1) for first, last in HEALTHY_CYCLES]
_ONE_HERTZ = [Override(channel=name, window=60) for name in ("TS*", "VS1", "CE", "CP", "SE")]
ACTUATOR = ("PG_*", "Accel_*", "Angle", "Temp_*")
RECORDINGS = {
    "plant": Recording(
        "production_plant",
        Parameters(tau=1, bins=16, window=200, max_gap=1, still_after=25),
        Calibration(fraction=0.2),
        ("L_*", "A_*", "B_*", "C_*"),
        ("end_of_life",),
    ),
    "bearings": Recording(
        "femto_bearings",
        Parameters(tau=1, bins=16, window=1000, max_gap=1),
        Calibration(fraction=0.2),
        ("acc_*",),
        ("end_of_life",),
    ),
    "actuators": Recording(
        "hydraulic_actuators",
        Parameters(tau=1, bins=64, window=2000, max_gap=1),
        Calibration(fraction=0.25),
        ACTUATOR,
    ),
    "seal": Recording(
        "hydraulic_actuators",
        Parameters(tau=1, bins=64, window=2000, max_gap=1),
        Calibration(
            fraction=0.25,
            pool=[["Act_1", "Act_2", "Act_4"]],
            overrides={"Act_2": None, "Act_4": None},
        ),
        ACTUATOR,
        ("seal_defect",),
    ),
    "rig": Recording(
        "hydraulic_rig",
        Parameters(tau=1, bins=16, window=600, stride=60, max_gap=10, overrides=_ONE_HERTZ),
        Calibration(intervals=_HEALTHY),
        ("FS*", "TS*"),
        ("pump_leak=1", "pump_leak=2", "accumulator=115", "accumulator=100", "accumulator=90"),
    ),
    "cobot": Recording(
        "ur3_cobot",
        Parameters(tau=1, bins=8, window=100, max_gap="5 s"),
        Calibration(fraction=0.25),
        ("Current_*", "Speed_*", "Temperature_*"),
        time="ts",
    ),
}
