-- The schema palpate, step 4: what analysts need to compare conditions without knowing which is which, and the
-- background of the participants in bands.

-- What a condition is called in the analysts' views: drawn at random for each run mode by itself, so that a pilot that
-- was unblinded says nothing of the study. Codes never change; a condition that a later version of the protocol adds
-- gets the next one. In a study that blinds nothing it is the condition itself.
CREATE TABLE condition_code (
  study     text NOT NULL REFERENCES study,
  run_mode  text NOT NULL,
  condition text NOT NULL,
  code      text NOT NULL,
  PRIMARY KEY (study, run_mode, condition),
  UNIQUE (study, run_mode, code)
);

CREATE FUNCTION draw_codes(of_study text, protocol json) RETURNS void
LANGUAGE sql SET search_path = palpate, pg_temp AS $$
  INSERT INTO condition_code (study, run_mode, condition, code)
  SELECT of_study, m.run_mode, c.id,
         CASE protocol->>'blinding' WHEN 'open' THEN c.id ELSE
           'C' || row_number() OVER (PARTITION BY m.run_mode ORDER BY gen_random_uuid()) + (
             SELECT count(*) FROM condition_code AS k WHERE k.study = of_study AND k.run_mode = m.run_mode) END
  FROM json_to_recordset(protocol->'conditions') AS c (id text),
       unnest(ARRAY['live', 'pilot', 'simulated']) AS m (run_mode)
  WHERE NOT EXISTS (SELECT 1 FROM condition_code AS k
                    WHERE k.study = of_study AND k.run_mode = m.run_mode AND k.condition = c.id);
$$;

CREATE FUNCTION protocol_has_codes() RETURNS trigger
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  PERFORM draw_codes(NEW.study, NEW.text::json);
  RETURN NULL;
END $$;
CREATE TRIGGER conditions_have_codes AFTER INSERT ON protocol FOR EACH ROW EXECUTE FUNCTION protocol_has_codes();

-- The codes of a session are in its own row, not in those of its answers: they are many, and all of them are in steps
-- of it. Of each step, from step 0, the place of its code among them; 0: it has no condition. Numbers of one width are
-- found without looking at those before.
ALTER TABLE session ADD COLUMN codes text[] NOT NULL DEFAULT '{}', ADD COLUMN coded smallint[] NOT NULL DEFAULT '{}';

CREATE FUNCTION codes_of(of_station integer, mode text, facts json, OUT codes text[], OUT coded smallint[])
LANGUAGE sql STABLE SET search_path = palpate, pg_temp AS $$
  WITH allotted AS (
    SELECT a.step, k.code, dense_rank() OVER (ORDER BY k.code) AS place
    FROM json_to_recordset(facts->'allocation') AS a (step integer, condition text)
    JOIN station AS s ON s.id = of_station
    JOIN condition_code AS k ON k.study = s.study AND k.run_mode = mode AND k.condition = a.condition)
  SELECT (SELECT coalesce(array_agg(DISTINCT a.code ORDER BY a.code), '{}') FROM allotted AS a),
         (SELECT coalesce(array_agg(coalesce(a.place, 0)::smallint ORDER BY n.step), '{}')
          FROM generate_series(0, (SELECT max(step) FROM allotted)) AS n (step)
          LEFT JOIN allotted AS a ON a.step = n.step);
$$;

CREATE FUNCTION session_has_codes() RETURNS trigger
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  SELECT c.codes, c.coded INTO NEW.codes, NEW.coded FROM codes_of(NEW.station, NEW.run_mode, NEW.facts::json) AS c;
  RETURN NEW;
END $$;
CREATE TRIGGER steps_have_codes BEFORE INSERT ON session FOR EACH ROW EXECUTE FUNCTION session_has_codes();

DO $$
DECLARE
  version protocol;
BEGIN
  FOR version IN SELECT * FROM protocol ORDER BY added, sha256 LOOP
    PERFORM draw_codes(version.study, version.text::json);
  END LOOP;
  UPDATE session AS s SET (codes, coded) =
    (SELECT c.codes, c.coded FROM codes_of(s.station, s.run_mode, s.facts::json) AS c);
END $$;

-- Without it PostgreSQL takes one session in ten to be another one, and looks for the answers of each by its key; with it
-- it reads all answers once, which counts need anyway.
CREATE STATISTICS each_is_another (ndistinct) ON station, number FROM session;

-- Points alone: numbers and words may tell who somebody is.
CREATE OR REPLACE VIEW answers AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, a.phase, a.instrument,
       a.alternative, a.item, a.point, s.codes[s.coded[a.step + 1]] AS code
FROM answer AS a
JOIN session AS s ON s.station = a.station AND s.number = a.number
JOIN station AS st ON st.id = a.station
WHERE a.counts AND a.point IS NOT NULL AND st.set_aside IS NULL;

-- ---------------------------------------------------------------------------------------------------------------------
-- What people say about themselves is seen as an export tells it: numbers in bands, choices as they are, no words.

-- The questions that are about the person. 'palpate collect init' writes them for the study's protocol.
CREATE TABLE background_item (
  study text NOT NULL REFERENCES study,
  phase text NOT NULL,
  item  text NOT NULL,
  width double precision CHECK (width > 0),  -- of the bands of a number; NULL: a choice, or a number of few
  whole boolean NOT NULL,                    -- "20 to 24", otherwise "20 to <25"
  PRIMARY KEY (study, phase, item)
);

CREATE FUNCTION band(value double precision, width double precision, whole boolean) RETURNS text
LANGUAGE sql IMMUTABLE SET search_path = palpate, pg_temp AS $$
  SELECT f.low::double precision || ' to ' ||
         CASE WHEN whole THEN (f.low + width::numeric - 1)::double precision::text
              ELSE '<' || (f.low + width::numeric)::double precision END
  FROM (SELECT round((floor(value / width) * width)::numeric, 9) AS low) AS f;
$$;

CREATE VIEW backgrounds AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, a.phase, a.item,
       CASE WHEN b.width IS NULL THEN coalesce(a.words, a.value::text, a.point::text)
            ELSE band(coalesce(a.value, a.point), b.width, b.whole) END AS told
FROM answer AS a
JOIN session AS s ON s.station = a.station AND s.number = a.number
JOIN station AS st ON st.id = a.station
JOIN background_item AS b ON b.study = st.study AND b.phase = a.phase AND b.item = a.item
WHERE a.counts AND st.set_aside IS NULL;

REVOKE ALL ON condition_code, background_item FROM PUBLIC;
REVOKE ALL ON FUNCTION draw_codes(text, json), protocol_has_codes(), codes_of(integer, text, json),
  session_has_codes(), band(double precision, double precision, boolean) FROM PUBLIC;
GRANT EXECUTE ON FUNCTION band(double precision, double precision, boolean) TO palpate_analyst;
GRANT SELECT ON backgrounds TO palpate_analyst;
