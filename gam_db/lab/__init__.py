"""The laboratory: benchmarks, the paper's experiments, other estimators, simulation and evaluation.

It stands on the core, and the core does not know it: its commands come by entry points (pyproject.toml),
and its SQL is in ``sql/lab``.
"""
