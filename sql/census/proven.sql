-- Proven: whether a row is of a channel, or of a support, that is not done again.
-- Reads:  staying
-- Slots:  :whose  channel_id or support_id
:whose IN (SELECT :whose FROM staying)
