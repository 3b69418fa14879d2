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
      (CAST(1000 * (block_root - centre) AS DOUBLE) + CAST(5e-1 AS DOUBLE)) / CAST(spread AS DOUBLE)
    ) AS BIGINT
  ) AS root
FROM (
  SELECT
    channel_id,
    family_no,
    block,
    block_root,
    blocks,
    :centre AS centre,
    :spread AS spread
  FROM (
    SELECT
      member_spread.channel_id AS channel_id,
      member.family_no AS family_no,
      member_block.block AS block,
      member_block.root AS block_root,
      member_spread.least AS least,
      member_spread.blocks - CAST(COUNT(*) AS BIGINT) AS blocks,
      member_spread.total - CAST(SUM(near.root - member_spread.least) AS BIGINT) AS total,
      member_spread.squares - CAST(
        SUM((near.root - member_spread.least) * (near.root - member_spread.least)) AS BIGINT
      ) AS squares
    FROM members AS member
    JOIN spreads AS member_spread ON member_spread.channel_id = member.channel_id AND member_spread.g = member.g
    JOIN block_roots AS member_block
      ON member_block.channel_id = member_spread.channel_id
      AND member_block.g = member_spread.g
    JOIN block_roots AS near
      ON near.channel_id = member_block.channel_id
      AND near.g = member_block.g
      AND near.block BETWEEN member_block.block - member_block.g AND member_block.block + member_block.g
    GROUP BY
      member_spread.channel_id,
      member.family_no,
      member_block.block,
      member_block.root,
      member_spread.least,
      member_spread.blocks,
      member_spread.total,
      member_spread.squares
  ) AS reduced
) AS scaled
