"""The method: which steps there are, in which order, and what their slots hold.

This folder owns the way from readings to the health indicator and its certificate (method, sections
2 to 5) as a :class:`~gam_db.composing.pipeline.Pipeline`. It makes trees; it runs nothing and knows
no engine.
Its files go by the folders of ``sql/``: source, census, calibration, vectors (embedding and codes),
scoring (score and health), certificate.

Steps of channels with the same parameters form a *set*; where there are several sets, the steps of
each carry its number, and the rows of all sets are put under one another before the last steps.
"""

from gam_db.method.order import opening_pipeline, pipeline, trusting_pipeline
from gam_db.method.resolved import Method

__all__ = ["Method", "opening_pipeline", "pipeline", "trusting_pipeline"]
