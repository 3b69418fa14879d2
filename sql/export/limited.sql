-- Limited, dbt form: what calibration says of each channel, and the limit of its health indicator.
-- Reads:  certified
-- A row:  one channel.
-- Slots:  :hi_limit, :limit_reason  the expressions of judgement/hi_limit.sql and judgement/limit_reason.sql
--         :columns                  what calibration says, all of which goes on
SELECT
  learnt.channel_id AS channel_id,
  :hi_limit AS hi_limit,
  :limit_reason AS limit_reason,
  :columns
FROM certified AS learnt
