-- Left out: the root of each block of calibration as it would stand had the blocks within g of it not been there, in
-- thousandths of a spread above the centre, towards minus infinity (alarms, section 3).
-- Reads:  block_roots, spreads, members
-- A row:  one block of one channel; blocks counts those that stay.
-- Slots:  :centre, :spread  the expressions of alarms/centre.sql and alarms/spread.sql
SELECT
  channel_id,
  family_no,
  block,
  blocks,
  CAST(
    FLOOR(
      (CAST(1000 * (own_root - centre) AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(spread AS DOUBLE)
    ) AS BIGINT
  ) AS root
FROM (
  SELECT
    channel_id,
    family_no,
    block,
    own_root,
    blocks,
    :centre AS centre,
    :spread AS spread
  FROM (
    SELECT
      told.channel_id AS channel_id,
      member.family_no AS family_no,
      own.block AS block,
      own.root AS own_root,
      told.least AS least,
      told.blocks - CAST(COUNT(*) AS BIGINT) AS blocks,
      told.total - CAST(SUM(near.root - told.least) AS BIGINT) AS total,
      told.squares - CAST(
        SUM((near.root - told.least) * (near.root - told.least)) AS BIGINT
      ) AS squares
    FROM members AS member
    JOIN spreads AS told ON told.channel_id = member.channel_id AND told.g = member.g
    JOIN block_roots AS own ON own.channel_id = told.channel_id AND own.g = told.g
    JOIN block_roots AS near
      ON near.channel_id = own.channel_id
      AND near.g = own.g
      AND near.block BETWEEN own.block - own.g AND own.block + own.g
    GROUP BY
      told.channel_id,
      member.family_no,
      own.block,
      own.root,
      told.least,
      told.blocks,
      told.total,
      told.squares
  ) AS reduced
) AS scaled
