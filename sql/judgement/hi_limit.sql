-- HI limit: the health indicator above which a channel is high. There is none where nothing can be judged: hi > hi_limit
-- is then true of no channel.
-- Slots:  :verdict  of the certificate
--         :limit    the expression of judgement/limit.sql
CASE WHEN :verdict IN ('ready', 'blind') THEN :limit END
