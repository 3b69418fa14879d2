-- Alarm moves: which change of the whole signal explains an episode's first judgements best: the simplest one that
-- explains 90 % of the novel vectors and makes at most 10 % of all novel (explains = 1), else that which explains most, less
-- what it makes novel. Its numbers are those of the judgement that it explains best.
-- Reads:  stored_alarm, stored_move, stored_visible_judgement
-- A row:  one episode whose first judgements were read again; vectors and novel ones are those of all of them. move_no is 0
--         where no change explains a vector.
-- Slots:  :monitor  its name
SELECT episode_id AS episode, vectors, novel, move_no, factor, displacement, regained, lost, explains
FROM (
  SELECT
    episode_id,
    move_no,
    factor,
    displacement,
    regained,
    lost,
    vectors,
    novel,
    explains,
    CAST(
      ROW_NUMBER() OVER (
        PARTITION BY episode_id
        ORDER BY
          held.explains DESC,
          CASE WHEN held.explains = 1 THEN held.move_no ELSE held.lost - held.regained END,
          held.move_no
      ) AS BIGINT
    ) AS place
  FROM (
    SELECT
      episode_id,
      move_no,
      factor,
      displacement,
      regained,
      lost,
      vectors,
      novel,
      CASE WHEN novel > 0 AND 10 * regained >= 9 * novel AND 10 * lost <= vectors THEN 1 ELSE 0 END AS explains
    FROM (
      SELECT
        episode_id,
        move_no,
        factor,
        displacement,
        regained,
        lost,
        MAX(CASE WHEN summed.move_no = 0 THEN summed.vectors END) OVER (PARTITION BY episode_id) AS vectors,
        MAX(CASE WHEN summed.move_no = 0 THEN summed.novel END) OVER (PARTITION BY episode_id) AS novel
      FROM (
        SELECT
          episode_id,
          move_no,
          MAX(CASE WHEN part.place = 1 THEN part.factor END) AS factor,
          MAX(CASE WHEN part.place = 1 THEN part.displacement END) AS displacement,
          CAST(SUM(part.vectors) AS BIGINT) AS vectors,
          CAST(SUM(part.novel) AS BIGINT) AS novel,
          CAST(SUM(part.regained) AS BIGINT) AS regained,
          CAST(SUM(part.lost) AS BIGINT) AS lost
        FROM (
          SELECT
            raised.episode_id AS episode_id,
            tried.move_no AS move_no,
            tried.factor AS factor,
            tried.displacement AS displacement,
            tried.vectors AS vectors,
            tried.novel AS novel,
            tried.regained AS regained,
            tried.lost AS lost,
            CAST(
              ROW_NUMBER() OVER (
                PARTITION BY raised.episode_id, tried.move_no
                ORDER BY tried.regained - tried.lost DESC, tried.judgement_no
              ) AS BIGINT
            ) AS place
          FROM stored_alarm AS raised
          JOIN (
            SELECT DISTINCT version_id, judgement_no, run_id, move_no, factor, displacement, vectors, novel, regained, lost
            FROM stored_move
          ) AS tried ON tried.version_id = raised.version_id
          JOIN stored_visible_judgement AS judged
            ON judged.version_id = tried.version_id
            AND judged.judgement_no = tried.judgement_no
            AND judged.run_id = tried.run_id
          WHERE raised.monitor = :monitor
            AND tried.judgement_no >= raised.first_judgement
            AND tried.judgement_no <= raised.last_judgement
            AND tried.judgement_no < raised.first_judgement + 5
            AND raised.status <> 'merged'
            AND raised.status <> 'withdrawn'
        ) AS part
        GROUP BY episode_id, move_no
      ) AS summed
    ) AS compared
  ) AS held
) AS ranked
WHERE place = 1
ORDER BY episode_id
