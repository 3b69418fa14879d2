-- Opening visits: how often its first block visited a cell; a column of certificate/cells.sql, likewise.
ARG_MIN(visit.visits, visit.place)
