"""gam-db: a health indicator for every machine channel, by plain SQL where the telemetry lies."""

from gam_db.calibration import Calibration
from gam_db.checking import check
from gam_db.connect import connect
from gam_db.errors import GamError, UserError
from gam_db.estimators import scores, scores_at_buckets
from gam_db.evaluation import Conventions, Evaluation, evaluate
from gam_db.health import certificate, health_at_buckets, health_indicator, support
from gam_db.parameters import Override, Parameters
from gam_db.script import render
from gam_db.selection import Selection, select
from gam_db.source import Source, WideSource
from gam_db.stored.monitor import Monitor
from gam_db.version import __version__

__all__ = [
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
    "certificate",
    "check",
    "connect",
    "evaluate",
    "health_at_buckets",
    "health_indicator",
    "render",
    "scores",
    "scores_at_buckets",
    "select",
    "support",
]
