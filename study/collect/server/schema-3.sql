-- The schema palpate, step 3: what is here of a station can be set aside; erasures are answered with a receipt; who
-- enrolled a station is kept; rows name the site and the station that were enrolled.

ALTER TABLE station
  ADD COLUMN enrolled_by text,
  ADD COLUMN revoked_by  text,
  ADD COLUMN set_aside   timestamptz,
  ADD COLUMN was         text;  -- the uuid of the station that goes on in its place
ALTER TABLE station ALTER COLUMN enrolled_by SET DEFAULT session_user;  -- of those before it is not known

-- What is here of a station is not what it recorded: all of it stays under another name and is pulled no more, and the
-- station sends everything again. For the owner alone.
CREATE FUNCTION set_aside(of_study text, of_label text, because text) RETURNS boolean
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  me station;
BEGIN
  SELECT * INTO me FROM station WHERE study = of_study AND label = of_label FOR UPDATE;
  IF NOT FOUND THEN RETURN false; END IF;
  UPDATE station SET uuid = replace(gen_random_uuid()::text, '-', ''), label = me.label || '/' || me.id, was = me.uuid,
                     set_aside = now() WHERE id = me.id;
  INSERT INTO station (study, uuid, site, label, role, key, enrolled, enrolled_by, expires, first_contact)
  VALUES (me.study, me.uuid, me.site, me.label, me.role, me.key, me.enrolled, me.enrolled_by, me.expires,
          coalesce(me.first_contact, now()));
  INSERT INTO incident (station, what, detail) VALUES (me.id, 'set_aside', because);
  RETURN true;
END $$;

-- The rows that are here of an erased session but its own, also among what was set aside.
CREATE FUNCTION left_of(me station, which bigint, code text) RETURNS bigint
LANGUAGE sql STABLE SET search_path = palpate, pg_temp AS $$
  WITH here AS (SELECT id FROM station WHERE id = me.id OR was = me.uuid)
  SELECT (SELECT count(*) FROM answer WHERE station = me.id AND number = which)
       + (SELECT count(*) FROM chunk WHERE station IN (SELECT id FROM here) AND session = which)
       + (SELECT count(*) FROM content_key WHERE station IN (SELECT id FROM here) AND participant = code)
       + (SELECT count(*) FROM session WHERE station IN (SELECT id FROM here WHERE id <> me.id)
            AND (number = which OR participant = code));
$$;

CREATE FUNCTION forget(me station, which bigint, code text, said_of bigint) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  DELETE FROM chunk WHERE session = which AND station IN (SELECT id FROM station WHERE id = me.id OR was = me.uuid);
  DELETE FROM content_key WHERE participant = code
    AND station IN (SELECT id FROM station WHERE id = me.id OR was = me.uuid);
  DELETE FROM session WHERE (number = which OR participant = code)
    AND station IN (SELECT id FROM station WHERE was = me.uuid);
  INSERT INTO tombstone (station, number, participant, as_of)
  VALUES (me.id, which, code, said_of) ON CONFLICT DO NOTHING;
END $$;

-- Of each erased session of the batch: what was erased when, and how many rows are left of it.
CREATE FUNCTION receipts(me station, said json) RETURNS json
LANGUAGE sql STABLE SET search_path = palpate, pg_temp AS $$
  SELECT coalesce(json_agg(json_build_object(
      'session', x.number, 'participant', x.participant, 'as_of', x.as_of,
      'utc', to_char(x.erased AT TIME ZONE 'UTC', 'YYYY-MM-DD"T"HH24:MI:SS.MS"Z"'),
      'left', left_of(me, x.number, x.participant)) ORDER BY x.number), '[]')
  FROM tombstone AS x
  WHERE x.station = me.id
    AND x.number IN (SELECT s.session FROM json_to_recordset(said->'sessions') AS s (session bigint));
$$;

-- One session, as it stood after its event as_of.
CREATE OR REPLACE FUNCTION take_session(me station, which bigint, said_of bigint, facts text, digest bytea) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  here session; reached bigint; sent json := facts; head json := sent->'session'; missing text;
BEGIN
  IF sha256(convert_to(facts, 'UTF8')) <> digest THEN PERFORM refuse('damaged', format('session %s', which)); END IF;
  IF EXISTS (SELECT 1 FROM fact AS f WHERE f.station = me.id AND f.number = which AND f.as_of = said_of
             AND f.sha256 <> digest) THEN
    PERFORM refuse('fork', format('session %s is here with other rows', which));
  END IF;
  SELECT last INTO reached FROM progress WHERE station = me.id AND number = which;
  IF reached IS NULL OR said_of > reached THEN
    PERFORM refuse('gap', format('session %s came before its events', which));
  END IF;
  SELECT * INTO here FROM session WHERE station = me.id AND number = which;
  IF here.as_of >= said_of THEN RETURN; END IF;

  IF NOT EXISTS (SELECT 1 FROM protocol WHERE study = me.study AND sha256 = head->>'protocol') THEN
    PERFORM refuse('protocol', head->>'protocol');
  END IF;
  IF NOT starts_with(sent->'participant'->>'code', me.label || '_') THEN
    PERFORM refuse('code', sent->'participant'->>'code');
  END IF;
  IF head->>'site' IS DISTINCT FROM me.site OR head->>'station' IS DISTINCT FROM me.label THEN
    PERFORM refuse('place', format('session %s: %s, %s', which, head->>'site', head->>'station'));
  END IF;
  SELECT format('session %s, step %s', which, t.step) INTO missing
    FROM json_to_recordset(sent->'trial') AS t (step integer, attempt integer, trace_samples bigint)
    WHERE t.trace_samples <> coalesce((SELECT sum(c.samples) FROM chunk AS c WHERE c.station = me.id
      AND c.session = which AND c.step = t.step AND c.attempt = t.attempt), 0) LIMIT 1;
  IF FOUND THEN PERFORM refuse('traces', missing); END IF;

  INSERT INTO fact (station, number, as_of, sha256) VALUES (me.id, which, said_of, digest);
  DELETE FROM session WHERE station = me.id AND number = which;
  INSERT INTO session (station, number, as_of, facts, sha256, participant, cohort, run_mode, protocol, language, state,
                       started_utc, ended_utc)
  VALUES (me.id, which, said_of, facts, digest, sent->'participant'->>'code', head->>'cohort', head->>'run_mode',
          head->>'protocol', head->>'language', head->>'state', head->>'started_utc', head->>'ended_utc');
  INSERT INTO answer (station, number, step, attempt, item, phase, instrument, alternative, counts, kind, point, value,
                      words)
  SELECT me.id, which, a.step, a.attempt, a.item, s.phase, s.instrument, s.label, v.status = 'finished', a.kind, a.point,
         a.number, a.text
  FROM json_to_recordset(sent->'answer')
    AS a (step integer, attempt integer, item text, kind text, point integer, number double precision, text text)
  JOIN json_to_recordset(sent->'step') AS s (step integer, phase text, instrument text, label integer)
    ON s.step = a.step
  JOIN json_to_recordset(sent->'visit') AS v (step integer, attempt integer, status text)
    ON v.step = a.step AND v.attempt = a.attempt;
  IF head->>'state' = 'erased' THEN PERFORM forget(me, which, sent->'participant'->>'code', said_of); END IF;
END $$;

-- As in step 2, and with receipts: "erased".
CREATE OR REPLACE FUNCTION ingest(batch text, digest bytea, traces bytea[]) RETURNS json
LANGUAGE plpgsql SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
DECLARE
  said json; me station; one record; reached bigint; why text; about text; pending bigint;
BEGIN
  BEGIN
    IF sha256(convert_to(batch, 'UTF8')) <> digest THEN PERFORM refuse('damaged', 'the batch'); END IF;
    said := batch;
    SELECT * INTO me FROM station WHERE uuid = said->>'station' AND study = said->>'study' FOR UPDATE;
    IF NOT FOUND THEN PERFORM refuse('unknown', coalesce(said->>'station', '')); END IF;
    -- Whoever owns all of it takes in what a station without a network sent as a file.
    IF me.role <> session_user AND NOT pg_has_role(session_user, 'palpate_owner', 'MEMBER') THEN
      PERFORM refuse('foreign', format('station %s', me.label));
    END IF;
    IF me.revoked IS NOT NULL THEN PERFORM refuse('revoked', coalesce(me.revoked_reason, '')); END IF;
    IF me.first_contact IS NULL AND me.expires < now() THEN PERFORM refuse('expired', me.expires::text); END IF;
    IF (said->>'format')::integer > 1 THEN PERFORM refuse('newer', said->>'format'); END IF;
    PERFORM take_traces(me, said, traces);
    PERFORM take_keys(me, said);
    reached := take_events(me, said);
    FOR one IN SELECT * FROM json_to_recordset(said->'sessions')
      AS s (session bigint, as_of bigint, sha256 text, facts text)
    LOOP
      PERFORM take_session(me, one.session, one.as_of, one.facts, decode(one.sha256, 'hex'));
    END LOOP;
    UPDATE station SET have = reached, last_contact = now(), first_contact = coalesce(first_contact, now())
    WHERE id = me.id;
    SELECT count(*) INTO pending FROM progress AS p
    LEFT JOIN session AS s ON s.station = p.station AND s.number = p.number
    WHERE p.station = me.id AND (s.as_of IS NULL OR s.as_of < p.last);
    RETURN json_build_object(
      'have', reached, 'pending', pending, 'head',
      (SELECT encode(hash, 'hex') FROM event WHERE station = me.id AND seq = reached),
      'erased', receipts(me, said));
  EXCEPTION
    WHEN SQLSTATE 'PC001' THEN
      GET STACKED DIAGNOSTICS why = MESSAGE_TEXT, about = PG_EXCEPTION_DETAIL;
    WHEN data_exception OR integrity_constraint_violation THEN
      why := 'damaged';
      about := SQLERRM;
  END;
  INSERT INTO incident (station, what, detail) VALUES (me.id, why, left(about, 1000));
  RETURN json_build_object('have', coalesce(me.have, 0), 'refused', why, 'detail', about);
END $$;

CREATE OR REPLACE FUNCTION pull_stations(ticket bigint)
RETURNS TABLE (id integer, uuid text, site text, label text, key text, have bigint)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT s.id, s.uuid, s.site, s.label, s.key, s.have FROM station AS s
  WHERE s.study = opened(ticket) AND s.set_aside IS NULL ORDER BY s.label;
$$;

CREATE OR REPLACE VIEW answers AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, a.phase, a.instrument,
       a.alternative, a.item, a.point
FROM answer AS a
JOIN session AS s ON s.station = a.station AND s.number = a.number
JOIN station AS st ON st.id = a.station
WHERE a.counts AND a.point IS NOT NULL AND st.set_aside IS NULL;

CREATE OR REPLACE VIEW sessions AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, s.language,
       left(s.started_utc, 10) AS day
FROM session AS s JOIN station AS st ON st.id = s.station
WHERE st.set_aside IS NULL;

CREATE OR REPLACE VIEW stations AS
SELECT s.study, d.name AS study_name, s.site, s.label AS station, s.have AS events, s.enrolled, s.first_contact,
       s.last_contact, s.revoked,
       (SELECT count(*) FROM session AS x WHERE x.station = s.id) AS sessions,
       (SELECT count(*) FROM incident AS i WHERE i.station = s.id) AS incidents,
       s.set_aside
FROM station AS s JOIN study AS d ON d.uuid = s.study;

ALTER POLICY own_site ON session USING (
  EXISTS (SELECT 1 FROM station AS st JOIN pg_roles AS r ON r.rolname = 'operator_' || replace(st.site, '-', '_')
          WHERE st.id = session.station AND st.set_aside IS NULL AND pg_has_role(current_user, r.oid, 'MEMBER')));
GRANT SELECT (set_aside) ON station TO palpate_operator;

REVOKE ALL ON FUNCTION set_aside(text, text, text), left_of(station, bigint, text),
  forget(station, bigint, text, bigint), receipts(station, json) FROM PUBLIC;
