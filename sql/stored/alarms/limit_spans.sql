-- Limit spans: which limit is for which judgements: the newest that begins at or before one. The CASE lets an empty
-- frame be NULL on ClickHouse, too, where the MIN of a column without NULLs is 0.
-- Reads:  judged_until, stored_limit
-- A row:  one limit of one version, for from_judgement up to, not with, until_judgement.
SELECT
  spanned.channel_id AS channel_id,
  spanned.limit_no AS limit_no,
  spanned.from_judgement AS from_judgement,
  CASE WHEN spanned.limits_back = 1 THEN 4611686018427387904 ELSE spanned.next_judgement END
    AS until_judgement,
  spanned.reference AS reference,
  spanned.height AS height,
  spanned.cap AS cap
FROM (
  SELECT
    part.channel_id AS channel_id,
    limit_row.limit_no AS limit_no,
    limit_row.from_judgement AS from_judgement,
    CAST(ROW_NUMBER() OVER (PARTITION BY limit_row.version_id ORDER BY limit_row.limit_no DESC) AS BIGINT)
      AS limits_back,
    MIN(limit_row.from_judgement) OVER (
      PARTITION BY limit_row.version_id
      ORDER BY limit_row.limit_no DESC
      ROWS BETWEEN UNBOUNDED PRECEDING AND 1 PRECEDING
    ) AS next_judgement,
    limit_row.reference AS reference,
    limit_row.height AS height,
    limit_row.cap AS cap
  FROM stored_limit AS limit_row
  JOIN judged_until AS part ON part.version_id = limit_row.version_id
) AS spanned
WHERE spanned.height IS NOT NULL
