"""From files of ``sql/`` to a query: slots filled on the parsed tree, steps composed; it runs nothing.

:mod:`~gam_db.composing.template` fills one file, :mod:`~gam_db.composing.pipeline` puts named steps
together. This folder knows neither what they compute nor any engine.
"""
