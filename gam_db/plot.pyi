"""The names of ``plot.py``, each from where it is made."""

from gam_db.lab.plot import fleet as fleet
from gam_db.lab.plot import signal as signal
