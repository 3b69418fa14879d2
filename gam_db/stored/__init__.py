"""The stored form: what is learnt and scored is kept in tables, so that a run reads only what is new."""
