"""The settings file, from the code: ``python tests/tools/settings_page.py > docs/gam.toml``."""

from gam_db.cli.config import SECTIONS
from gam_db.cli.toml_text import entries
from gam_db.settings.setting import Setting, settings_of

HEAD = """\
# Every setting of gam.toml. All are optional; options of the command line override them.
# A length of time is seconds, a text with a unit (us, ms, s, min, h, d, w), or steps of a counter.
"""

REMARKS = {
    "calibration": "one of fraction, duration, intervals",
    "monitor": "storage of results between runs",
}

#: What is no setting of its own: parameters and calibration of some channels.
AFTER = {
    "parameters": """\
[[override]]  # the first that matches a channel applies; * and ? as usual
asset = "robot_7"
channel = "temperature_*"
tau = 10
bins = 20
""",
    "calibration": """\
[calibration.overrides."robot_9*"]
duration = "30 d"

[calibration.overrides]
robot_8 = false  # no calibration of its own: it learns from its pool
""",
}


def remark(one: Setting) -> str:
    """Return what is said beside a key."""
    said = [one.what, one.note, f"default: {one.usual}" if one.usual else ""]
    said.append("" if one.off is None else f"false: {one.off[1]}")
    return "; ".join(filter(None, said))


def text() -> str:
    """Return the whole file."""
    parts = [HEAD]
    for section, of in SECTIONS.items():
        known = settings_of(of)
        said = {
            name: (one.default if one.example is None else one.example, remark(one))
            for name, one in known.items()
        }
        heading = f"[{section}]" + (f"  # {REMARKS[section]}" if section in REMARKS else "")
        lines = [heading, *entries(said, [name for name, one in known.items() if one.aside])]
        parts += ["\n".join(lines) + "\n", *([AFTER[section]] if section in AFTER else [])]
    return "\n".join(parts)


if __name__ == "__main__":
    print(text(), end="")
