"""From a relation to readings: the roles of columns, the kind of time, and texts read as numbers."""
