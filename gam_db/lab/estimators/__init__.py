"""The framework's estimators beside Discrete Support Estimation, scored by SQL.

Centroid is fitted in SQL; Gaussian mixture, Isolation Forest and One-Class SVM are fitted by
scikit-learn on a bounded, seeded sample of the calibration vectors and stored as rows. All score the
same delay vectors as Discrete Support Estimation, and their scores go through the same moving average.
"""

from gam_db.lab.estimators.scoring import (
    DSE,
    ESTIMATORS,
    SAMPLE,
    add_estimator,
    estimator_named,
    scores,
    scores_at_buckets,
)

__all__ = [
    "DSE",
    "ESTIMATORS",
    "SAMPLE",
    "add_estimator",
    "estimator_named",
    "scores",
    "scores_at_buckets",
]
