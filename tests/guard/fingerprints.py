"""A fingerprint of every text that gam-db renders: scripts, migrations and dbt packages.

A text is rendered for each engine from settings which together take every way that rendering has. Of
each one ``fingerprints.txt`` keeps a line: its name and a short hash. That file is written anew by

    python -m tests.guard.fingerprints

in a commit that changes nothing else than what the changed names say.
"""

import hashlib
from collections.abc import Iterator, Mapping
from functools import partial
from pathlib import Path
from typing import Any
from unittest.mock import patch

import gam_db
from gam_db.engines import NAMES, engine_named
from gam_db.export import Package
from gam_db.export.models import ADAPTERS
from gam_db.export.script import FORMS
from gam_db.settings.parameters import LEAST_VECTORS
from gam_db.stored.schema.migrations import rendered
from gam_db.stored.schema.tables import StateTables
from gam_db.version import __version__

FILE = Path(__file__).with_name("fingerprints.txt")
COMMAND = "python -m tests.guard.fingerprints"

#: Parameters with the default that tests do without (tests/tools/tiny.py), and with numbers.
_ASKED = partial(gam_db.Parameters, tau=1, bins=100, window=5000, least_vectors=LEAST_VECTORS)

_COUNTER = gam_db.Source("telemetry", time_kind="counter")
_DATED = gam_db.Source(
    "plant.lines.readings", "robot", "joint", "ts", "torque", "joint <> 'it''s'", "timestamp"
)
_SINGLE = gam_db.Source(("odd schema", 'a "table"'), None, None, "t", "Value", time_kind="counter")
_WIDE = gam_db.WideSource("lines.wide", ("temp", "Flow rate"), "machine", "at", "temp > 0", "timestamp")
_LOCAL = gam_db.Source("telemetry", source_time_zone="Europe/Berlin", valid_when="quality IN (0, 192)")
_RECIPES = gam_db.Source("telemetry", time_kind="counter", program="recipe")
_BARE = gam_db.WideSource("wide", ("v",), None)  # time_kind left open

#: name -> arguments of ``gam_db.render`` after the engine
SCRIPTS: Mapping[str, tuple[Any, ...]] = {
    "plain": (_COUNTER, _ASKED()),
    "dated": (
        _DATED,
        _ASKED(m=2, tau=4, bins=20, window=500, max_gap="5 s", target_floor=0.1),
        gam_db.Calibration(
            duration="30 d", exclude=[("2026-01-03", "2026-01-04")], score_from="2026-02-01"
        ),
    ),
    "intervals": (
        _COUNTER,
        _ASKED(m=2, bins=5, window=12, stride=3),
        gam_db.Calibration(intervals=[(0, 90), (120, 200)], exclude=[(30, 40), (150, 150)]),
    ),
    "still samples": (_COUNTER, _ASKED(tau=4, window=500, still_after=25)),
    "overrides": (
        _COUNTER,
        _ASKED(
            window=200,
            overrides=[
                gam_db.Override(asset="a_%!*", channel="x?", m=1, max_gap=3),
                gam_db.Override(channel="y", tau=2, window=60),
                gam_db.Override(asset="*"),
            ],
        ),
        gam_db.Calibration(
            fraction=0.5,
            overrides={"b*": None, "c?": gam_db.Calibration(intervals=[]), "": gam_db.Calibration()},
        ),
    ),
    "pooled channels": (_WIDE, _ASKED(m=1), gam_db.Calibration(pool="channel"), "other_"),
    "pooled groups": (
        _SINGLE,
        _ASKED(m=4, bins=50_000, max_gap=2),
        gam_db.Calibration(fraction=1.0, pool=[["a*", "b"], ["c"]], score_from=0),
    ),
    "no calibration of its own": (
        _BARE,
        _ASKED(m=1, bins=2**31 - 3, window=1),
        gam_db.Calibration(intervals=[], overrides={"*": None}),
    ),
    "one bin": (
        gam_db.Source("telemetry"),
        _ASKED(m=5, tau=3, bins=1, target_floor=0.0),
        gam_db.Calibration(intervals=[("2026-01-01", "2026-01-08")]),
    ),
    "local times": (_LOCAL, _ASKED(m=2, bins=9)),
    "programs": (_RECIPES, _ASKED(m=2, bins=9)),
}

#: name -> arguments of :class:`gam_db.export.Package`
PACKAGES: Mapping[str, Mapping[str, Any]] = {
    "short": {
        "source": _COUNTER,
        "parameters": _ASKED(),
        "calibration": gam_db.Calibration(intervals=[(0, 20)]),
    },
    "complete": {
        "source": _WIDE,
        "parameters": _ASKED(m=2, tau=5, bins=9, window=40, stride=8, max_gap="1 min"),
        "calibration": gam_db.Calibration(
            intervals=[("2026-01-01", "2026-01-08"), ("2026-02-01", "2026-02-02")],
            exclude=[("2026-01-03", "2026-01-04")],
            score_from="2026-03-01",
            pool=[["m*"], ["n"]],
            overrides={"m_?*": None},
        ),
        "prefix": "other_",
        "lookback": "2 h",
        "silent_after": "3 d",
    },
}


def texts_of(engine: str) -> Iterator[tuple[str, str]]:
    """Yield the name and the text of everything that is rendered for an engine."""
    for form in FORMS:
        for name, arguments in SCRIPTS.items():
            yield f"{engine} / {form} / {name}", gam_db.render(form, engine, *arguments)
    for schema in (None, "plant") if engine_named(engine).schemas else (None,):
        tables = StateTables(schema, "gam_" if schema is None else "")
        with patch("time.time_ns", return_value=0):  # a migration records when it was applied
            text = rendered(engine_named(engine), tables)
        yield f"{engine} / migrations / {schema or 'no'} schema", text
    for name, said in PACKAGES.items() if engine in ADAPTERS else ():
        for path, text in Package(**said, engine=engine).files().items():
            yield f"{engine} / dbt / {name} / {path}", text


def fingerprint(text: str) -> str:
    """Return a short hash of a text; a release alone, whose number is in some, changes none."""
    return hashlib.sha256(text.replace(__version__, "VERSION").encode()).hexdigest()[:16]


def fingerprints(engine: str) -> dict[str, str]:
    """Return the fingerprint of every text of an engine, by its name."""
    return {name: fingerprint(text) for name, text in texts_of(engine)}


def kept(engine: str, file: Path = FILE) -> dict[str, str]:
    """Return those of an engine that the file keeps."""
    lines = [line.rsplit(maxsplit=1) for line in file.read_text(encoding="utf-8").splitlines()]
    return {name: mark for name, mark in lines if name.startswith(f"{engine} / ")}


def differing(before: Mapping[str, str], now: Mapping[str, str]) -> list[str]:
    """Return a line for each text that is another, new or gone."""
    words = {
        name: "gone" if name not in now else "new" if name not in before else "changed"
        for name in sorted({*before, *now})
        if before.get(name) != now.get(name)
    }
    return [f"{word}: {name}" for name, word in words.items()]


def write(file: Path = FILE) -> list[str]:
    """Write the file anew, and return what differs from what it held."""
    before = {key: mark for engine in NAMES for key, mark in kept(engine, file).items()}
    now = {key: mark for engine in NAMES for key, mark in fingerprints(engine).items()}
    file.write_text("".join(f"{name}  {now[name]}\n" for name in sorted(now)), encoding="utf-8")
    return differing(before, now)


if __name__ == "__main__":
    FILE.touch()
    print("\n".join(write()) or "nothing changed")
