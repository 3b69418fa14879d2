"""The stored form: tables hold calibrations and scores, so that a run reads only new rows.

``schema/`` owns the tables, ``planning/`` the range that a run reads, ``calibrating.py`` the content of
a version, ``alarms/`` judgements, limits and episodes, ``checking/`` what must hold, ``scoring/`` a run,
and :mod:`~gam_db.stored.monitor` what is called from Python.
"""
