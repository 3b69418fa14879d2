"""The benchmark: what the SQL costs, beside what it cannot cost less than and what it replaces.

Four programs start from the same raw table in a DuckDB file:

* ``gam``: gam-db, from readings to the health indicator at bucket ends and the novel cells;
* ``extract``: the script it replaces: fetch in order, vectorised NumPy, write the same tables back;
* ``floor_on_ids``, ``floor_on_names``: the window pass that no delay vector can do without.

Every run is a fresh process. ``measure`` is the way in; ``programs`` is what such a process does.
"""
