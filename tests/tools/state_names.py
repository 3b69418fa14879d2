"""The names of the tables and views of a state with the usual prefix."""

from gam_db.stored.schema.tables import StateTables

#: ``run`` is called ``gam_state_run``, ``fleet`` is called ``gam_fleet``.
called = StateTables().shown
