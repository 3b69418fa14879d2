-- Within: a judgement that lies in one interval whole.
-- Slots:  :time_from, :time_to  its closed ends
counted.first_time >= :time_from AND counted.last_time <= :time_to
