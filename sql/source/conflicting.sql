-- Conflicting: whether an instant had two different values.
MIN(repeated.reading) < MAX(repeated.reading)
