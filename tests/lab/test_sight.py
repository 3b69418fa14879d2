"""What the certificate says would be seen is seen: shifts of later data of simulated joints."""

import duckdb
import pyarrow as pa
import pytest

import gam_db
from gam_db.lab.simulate.fleet import Fleet

#: Joints of healthy robots, and shifts in percent of the usual width, both ways.
JOINTS, RUNGS = 200, (1, 2, 5, 10, 20, 50)

#: A copy of each joint for each shift, which begins where calibration ends; shift 0 is the joint itself.
SHIFTED = """
CREATE TABLE telemetry AS
SELECT joint.asset || '@' || change.shift AS asset, joint.channel, joint.time,
  joint.value + CASE WHEN joint.place > joint.taught THEN change.shift / 100.0 ELSE 0 END * learnt.width
    AS value
FROM (
  SELECT *, ROW_NUMBER() OVER (PARTITION BY asset, channel ORDER BY time) AS place,
    COUNT(*) OVER (PARTITION BY asset, channel) // 2 AS taught
  FROM joints
) AS joint
JOIN (SELECT *, usual_high - usual_low AS width FROM learnt) AS learnt USING (asset, channel)
CROSS JOIN shifts AS change
WHERE learnt.verdict IN ('ready', 'blind') AND learnt.usual_high > learnt.usual_low
ORDER BY 1, 2, 3"""

#: Of each joint that stays healthy: the smallest shift that shows both ways, said and seen; 7 for none.
COMPARED = """
SELECT COALESCE(LIST_POSITION($rungs, said), 7), COALESCE(LIST_POSITION($rungs, seen), 7)
FROM (
  SELECT MIN(sees) AS said, MIN(ABS(shift)) FILTER (shift <> 0 AND ways = 2) AS seen,
    MAX(CASE WHEN shift = 0 THEN is_above END) AS is_worn
  FROM (
    SELECT *, SUM(is_above) OVER (PARTITION BY asset, channel, ABS(shift)) AS ways
    FROM (
      SELECT learnt.asset, learnt.channel, ANY_VALUE(learnt.sees) AS sees,
        CAST(SPLIT_PART(scored.asset, '@', 2) AS INTEGER) AS shift,
        CAST(SUM(scored.novel) > ANY_VALUE(learnt.hi_limit) * COUNT(*) * $stride AS INTEGER) AS is_above
      FROM buckets AS scored
      JOIN learnt ON learnt.asset = SPLIT_PART(scored.asset, '@', 1) AND learnt.channel = scored.channel
      GROUP BY learnt.asset, learnt.channel, scored.asset
    )
  )
  GROUP BY asset, channel
)
WHERE is_worn = 0"""


@pytest.mark.thorough
def test_the_smallest_shift_is_within_one_rung() -> None:
    fleet, robot = Fleet(seed=11, samples=3000), 0
    readings: list[pa.Table] = []
    while len(readings) < JOINTS:
        robot += 1
        healthy = (joint for joint in fleet.robot(robot) if joint.truth["kind"] == "healthy")
        readings += [joint.readings for joint in healthy]
    method = (
        gam_db.Parameters(m=3, tau=5, bins=16, window=150, stride=50),
        gam_db.Calibration(fraction=0.5),
    )
    with duckdb.connect() as connection:
        joints = pa.concat_tables(readings[:JOINTS])  # noqa: F841
        connection.execute("CREATE TABLE joints AS FROM joints")
        learnt = gam_db.support(gam_db.Source("joints"), *method, connection)  # noqa: F841
        connection.execute("CREATE TABLE learnt AS FROM learnt")
        shifts = pa.table({"shift": [0, *(way * rung for rung in RUNGS for way in (1, -1))]})  # noqa: F841
        connection.execute("CREATE TABLE shifts AS FROM shifts")
        connection.execute(SHIFTED)
        buckets = gam_db.health_at_buckets(gam_db.Source("telemetry"), *method, connection)  # noqa: F841
        connection.execute("CREATE TABLE buckets AS FROM buckets")
        pairs = connection.execute(COMPARED, {"rungs": list(RUNGS), "stride": 50}).fetchall()
    assert len(pairs) > 100
    within = sum(abs(said - seen) <= 1 for said, seen in pairs)
    assert within >= 0.95 * len(pairs), f"{within} of {len(pairs)}"
