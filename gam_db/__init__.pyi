"""The public names, each from where it is made: ``__init__.py`` imports one when it is asked for."""

from gam_db.alarms import Alarms as Alarms
from gam_db.alarms import episodes as episodes
from gam_db.alarms import judgements as judgements
from gam_db.alarms import limits as limits
from gam_db.alarms.backtesting import backtest as backtest
from gam_db.checking import check as check
from gam_db.cli.summary import Summary as Summary
from gam_db.cli.summary import summary as summary
from gam_db.engines.connecting import connect as connect
from gam_db.errors import CalibrationWarning as CalibrationWarning
from gam_db.errors import GamError as GamError
from gam_db.errors import UserError as UserError
from gam_db.export.script import render as render
from gam_db.health import certificate as certificate
from gam_db.health import health_at_buckets as health_at_buckets
from gam_db.health import health_indicator as health_indicator
from gam_db.health import probe as probe
from gam_db.health import programs as programs
from gam_db.health import support as support
from gam_db.lab.estimators import scores as scores
from gam_db.lab.estimators import scores_at_buckets as scores_at_buckets
from gam_db.lab.evaluation import Conventions as Conventions
from gam_db.lab.evaluation import Evaluation as Evaluation
from gam_db.lab.evaluation import evaluate as evaluate
from gam_db.lab.evaluation.detection import Detection as Detection
from gam_db.lab.evaluation.detection import detection as detection
from gam_db.selection.select import Selection as Selection
from gam_db.selection.select import select as select
from gam_db.settings.calibration import Calibration as Calibration
from gam_db.settings.parameters import Override as Override
from gam_db.settings.parameters import Parameters as Parameters
from gam_db.settings.source import Source as Source
from gam_db.settings.source import WideSource as WideSource
from gam_db.stored.monitor import Monitor as Monitor
from gam_db.version import __version__ as __version__

__all__: list[str]
