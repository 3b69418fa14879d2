"""From a relation to readings: which column is what, how time is told there, words read as numbers."""
