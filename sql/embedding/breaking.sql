-- Breaking: 1 if a segment begins with a sample: a step in time larger than max_gap ends one (method, section 1). The
-- first sample that is read begins none: no vector ends before it.
-- Slots:  :previous_time  of the sample before
--         :max_gap        the longest step inside a segment, in the unit of time
CASE WHEN time - :previous_time > :max_gap THEN 1 ELSE 0 END
