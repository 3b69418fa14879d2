"""Judgements of a monitor, their limits, episodes, and alarms for people."""
