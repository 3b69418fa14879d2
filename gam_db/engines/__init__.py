"""Engines: flat data and small rewrites, one file per engine."""
