"""gam-db: a health indicator for every machine channel, by plain SQL where the telemetry lies.

Importing it loads nothing but this file: each name is imported from its module when it is asked for.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from gam_db.version import __version__

if TYPE_CHECKING:
    from gam_db.alarms import Alarms, episodes, judgements, limits
    from gam_db.backtesting import backtest
    from gam_db.calibration import Calibration
    from gam_db.checking import check
    from gam_db.connecting import connect
    from gam_db.errors import GamError, UserError
    from gam_db.health import certificate, health_at_buckets, health_indicator, support
    from gam_db.lab.estimators import scores, scores_at_buckets
    from gam_db.lab.evaluation import Conventions, Evaluation, evaluate
    from gam_db.parameters import Override, Parameters
    from gam_db.script import render
    from gam_db.selection.channels import select
    from gam_db.selection.select import Selection
    from gam_db.source import Source, WideSource
    from gam_db.stored.monitor import Monitor

__all__ = [
    "Alarms",
    "Calibration",
    "Conventions",
    "Evaluation",
    "GamError",
    "Monitor",
    "Override",
    "Parameters",
    "Selection",
    "Source",
    "UserError",
    "WideSource",
    "__version__",
    "backtest",
    "certificate",
    "check",
    "connect",
    "episodes",
    "evaluate",
    "health_at_buckets",
    "health_indicator",
    "judgements",
    "limits",
    "render",
    "scores",
    "scores_at_buckets",
    "select",
    "support",
]

#: module -> the names that are public
_PUBLIC = {
    "alarms": ("Alarms", "episodes", "judgements", "limits"),
    "backtesting": ("backtest",),
    "calibration": ("Calibration",),
    "checking": ("check",),
    "connecting": ("connect",),
    "errors": ("GamError", "UserError"),
    "health": ("certificate", "health_at_buckets", "health_indicator", "support"),
    "lab.estimators": ("scores", "scores_at_buckets"),
    "lab.evaluation": ("Conventions", "Evaluation", "evaluate"),
    "parameters": ("Override", "Parameters"),
    "script": ("render",),
    "selection.channels": ("select",),
    "selection.select": ("Selection",),
    "source": ("Source", "WideSource"),
    "stored.monitor": ("Monitor",),
}
_MODULE_OF = {name: module for module, names in _PUBLIC.items() for name in names}


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for."""
    if name not in _MODULE_OF:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_MODULE_OF[name]}"), name)


def __dir__() -> list[str]:
    """Return the public names, imported or not."""
    return sorted({*globals(), *__all__})
