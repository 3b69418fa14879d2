"""Settings of users: source, method and calibration, and how each setting is declared.

This package owns the bounds of values and the errors on others; it reads no data and runs nothing.
"""
