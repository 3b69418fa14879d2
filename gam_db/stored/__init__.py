"""The stored form: what is learnt and scored is kept in tables, so that a run reads only what is new.

``schema/`` owns the tables, ``planning/`` from where on a run reads, ``calibrating.py`` what a version
freezes, ``alarms/`` judgements, limits and episodes, ``checking/`` what must hold, ``scoring/`` a run,
and :mod:`~gam_db.stored.monitor` what is called from Python.
"""
