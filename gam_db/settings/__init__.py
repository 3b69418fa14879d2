"""What a user says: of the source, of the method, of calibration, and how each setting is declared.

This folder owns what a value may be and what is said if it is not; it reads no data and runs nothing.
"""
