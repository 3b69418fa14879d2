-- Own: what a list of the row of rounds says of the channel whose turn it is; see rounds/codes.sql.
-- Dialect: duckdb
-- Slots:  :listed  the list
LIST_EXTRACT(:listed, place)
