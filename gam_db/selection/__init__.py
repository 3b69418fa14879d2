"""Choosing tau, m, B and W from the healthy part of each channel (method, section 8).

This folder owns the way from samples to curves, choices and what the calibration at hand affords. The
mathematics is in ``sql/selection``; here its steps are put in order and run.
"""
