-- Untold: 1 where no program was told of a reading, which puts it last.
CASE WHEN program IS NULL THEN 1 ELSE 0 END
