-- The schema palpate, step 2: the way in. Any fault raises PC001: the batch is undone as a whole, and ingest()
-- keeps an incident.

CREATE FUNCTION refuse(what text, detail text) RETURNS void LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  RAISE EXCEPTION USING ERRCODE = 'PC001', MESSAGE = what, DETAIL = detail;
END $$;

CREATE FUNCTION take_events(me station, said jsonb) RETURNS bigint
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  other bigint; lowest bigint; most bigint; many bigint; first bigint; before text;
BEGIN
  SELECT min(n.seq), min(n.seq) FILTER (WHERE n.seq > me.have), max(n.seq) FILTER (WHERE n.seq > me.have),
         count(*) FILTER (WHERE n.seq > me.have)
    INTO first, lowest, most, many FROM jsonb_to_recordset(said->'events') AS n (seq bigint);
  IF first <= me.have THEN  -- some are here already
    SELECT n.seq INTO other FROM jsonb_to_recordset(said->'events') AS n (seq bigint, hash text)
      JOIN event AS e ON e.station = me.id AND e.seq = n.seq
      WHERE e.hash <> decode(n.hash, 'hex') ORDER BY 1 LIMIT 1;
    IF FOUND THEN PERFORM refuse('fork', format('event %s is here with another hash', other)); END IF;
  END IF;
  IF first > me.have + 1 OR (many > 0 AND (lowest <> me.have + 1 OR most <> me.have + many)) THEN
    PERFORM refuse('gap', format('events %s to %s came after event %s', first, most, me.have));
  END IF;
  SELECT encode(hash, 'hex') INTO before FROM event WHERE station = me.id AND seq = first - 1;
  IF FOUND AND before IS DISTINCT FROM said->>'after' THEN
    PERFORM refuse('fork', format('event %s is here with another hash', first - 1));
  END IF;
  IF coalesce(many, 0) = 0 THEN RETURN me.have; END IF;

  WITH taken AS (
    INSERT INTO event (station, seq, session, step, attempt, utc, monotonic_ns, actor, kind, detail, sealed,
                       content_hash, hash)
    SELECT me.id, n.seq, n.session, n.step, n.attempt, n.utc, n.monotonic_ns, n.actor, n.kind, n.detail,
           decode(n.sealed, 'hex'), decode(n.content_hash, 'hex'), decode(n.hash, 'hex')
    FROM jsonb_to_recordset(said->'events')
      AS n (seq bigint, session bigint, step integer, attempt integer, utc text, monotonic_ns bigint, actor text,
            kind text, detail text, sealed text, content_hash text, hash text)
    WHERE n.seq > me.have RETURNING session, seq)
  INSERT INTO progress (station, number, last)
  SELECT me.id, t.session, max(t.seq) FROM taken AS t WHERE t.session IS NOT NULL GROUP BY t.session
  ON CONFLICT (station, number) DO UPDATE SET last = greatest(progress.last, excluded.last);
  RETURN most;
END $$;

CREATE FUNCTION take_traces(me station, said jsonb, traces bytea[]) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  wrong text;
BEGIN
  IF coalesce(jsonb_array_length(said->'traces'), 0) <> coalesce(array_length(traces, 1), 0) THEN
    PERFORM refuse('damaged', 'as many traces as descriptions are needed');
  END IF;
  SELECT t.what::text INTO wrong FROM jsonb_array_elements(said->'traces') WITH ORDINALITY AS t (what, place)
    WHERE sha256(traces[t.place]) <> decode(t.what->>'sha256', 'hex') LIMIT 1;
  IF FOUND THEN PERFORM refuse('damaged', wrong); END IF;
  SELECT t.what::text INTO wrong FROM jsonb_array_elements(said->'traces') AS t (what)
    JOIN chunk AS c ON c.station = me.id AND c.session = (t.what->>'session')::bigint
      AND c.step = (t.what->>'step')::integer AND c.attempt = (t.what->>'attempt')::integer
      AND c.number = (t.what->>'number')::integer
    WHERE c.hash <> decode(t.what->>'hash', 'hex') LIMIT 1;
  IF FOUND THEN PERFORM refuse('fork', 'a trace is here with another hash: ' || wrong); END IF;

  INSERT INTO chunk (station, session, step, attempt, number, samples, layout, data, hash)
  SELECT me.id, (t.what->>'session')::bigint, (t.what->>'step')::integer, (t.what->>'attempt')::integer,
         (t.what->>'number')::integer, (t.what->>'samples')::integer, (t.what->>'layout')::integer,
         traces[t.place], decode(t.what->>'hash', 'hex')
  FROM jsonb_array_elements(said->'traces') WITH ORDINALITY AS t (what, place)
  WHERE NOT EXISTS (SELECT 1 FROM tombstone AS x
                    WHERE x.station = me.id AND x.number = (t.what->>'session')::bigint)
  ON CONFLICT DO NOTHING;
END $$;

CREATE FUNCTION take_keys(me station, said jsonb) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  INSERT INTO content_key (station, participant, key)
  SELECT me.id, k.participant, decode(k.key, 'hex')
  FROM jsonb_to_recordset(said->'keys') AS k (participant text, key text)
  WHERE NOT EXISTS (SELECT 1 FROM tombstone AS x WHERE x.station = me.id AND x.participant = k.participant)
  ON CONFLICT DO NOTHING;
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
CREATE FUNCTION receipts(me station, said jsonb) RETURNS json
LANGUAGE sql STABLE SET search_path = palpate, pg_temp AS $$
  SELECT coalesce(json_agg(json_build_object(
      'session', x.number, 'participant', x.participant, 'as_of', x.as_of,
      'utc', to_char(x.erased AT TIME ZONE 'UTC', 'YYYY-MM-DD"T"HH24:MI:SS.MS"Z"'),
      'left', left_of(me, x.number, x.participant)) ORDER BY x.number), '[]')
  FROM tombstone AS x
  WHERE x.station = me.id
    AND x.number IN (SELECT s.session FROM jsonb_to_recordset(said->'sessions') AS s (session bigint));
$$;

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

-- The sessions of a batch, each as it stood after its event as_of. The rows of all of them are taken by one statement a
-- table: statements cost more than rows. Arrays for each part, because a statement copies the arrays that it reads.
CREATE FUNCTION take_sessions(me station, said jsonb) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  which bigint; about text;
  numbers bigint[]; marks bigint[]; hashes bytea[]; texts text[]; read jsonb[]; heads jsonb[]; people text[];
BEGIN
  SELECT array_agg(s.session), array_agg(s.as_of), array_agg(decode(s.sha256, 'hex')), array_agg(s.facts)
    INTO numbers, marks, hashes, texts
    FROM jsonb_to_recordset(said->'sessions') AS s (session bigint, as_of bigint, sha256 text, facts text);
  IF numbers IS NULL THEN RETURN; END IF;
  SELECT s.number INTO which FROM unnest(numbers, hashes, texts) AS s (number, sha256, facts)
    WHERE sha256(convert_to(s.facts, 'UTF8')) IS DISTINCT FROM s.sha256 LIMIT 1;
  IF FOUND THEN PERFORM refuse('damaged', format('session %s', which)); END IF;
  SELECT s.number INTO which FROM unnest(numbers, marks, hashes) AS s (number, as_of, sha256)
    JOIN fact AS f ON f.station = me.id AND f.number = s.number AND f.as_of = s.as_of
    WHERE f.sha256 <> s.sha256 LIMIT 1;
  IF FOUND THEN PERFORM refuse('fork', format('session %s is here with other rows', which)); END IF;
  SELECT s.number INTO which FROM unnest(numbers, marks) AS s (number, as_of)
    LEFT JOIN progress AS p ON p.station = me.id AND p.number = s.number
    WHERE p.last IS NULL OR s.as_of IS NULL OR s.as_of > p.last LIMIT 1;
  IF FOUND THEN PERFORM refuse('gap', format('session %s came before its events', which)); END IF;

  SELECT array_agg(s.number), array_agg(s.as_of), array_agg(s.sha256), array_agg(s.facts), array_agg(s.facts::jsonb)
    INTO numbers, marks, hashes, texts, read
    FROM unnest(numbers, marks, hashes, texts) AS s (number, as_of, sha256, facts)
    LEFT JOIN session AS here ON here.station = me.id AND here.number = s.number
    WHERE here.as_of IS NULL OR here.as_of < s.as_of;
  IF numbers IS NULL THEN RETURN; END IF;
  SELECT array_agg(n.rows->'session' ORDER BY n.place), array_agg(n.rows->'participant'->>'code' ORDER BY n.place)
    INTO heads, people FROM unnest(read) WITH ORDINALITY AS n (rows, place);

  SELECT coalesce(n.head->>'protocol', '') INTO about FROM unnest(heads) AS n (head)
    WHERE NOT EXISTS (SELECT 1 FROM protocol AS p WHERE p.study = me.study AND p.sha256 = n.head->>'protocol') LIMIT 1;
  IF FOUND THEN PERFORM refuse('protocol', about); END IF;
  SELECT coalesce(n.code, '') INTO about FROM unnest(people) AS n (code)
    WHERE starts_with(n.code, me.label || '_') IS NOT TRUE LIMIT 1;
  IF FOUND THEN PERFORM refuse('code', about); END IF;
  SELECT format('session %s: %s, %s', n.number, n.head->>'site', n.head->>'station') INTO about
    FROM unnest(numbers, heads) AS n (number, head)
    WHERE n.head->>'site' IS DISTINCT FROM me.site OR n.head->>'station' IS DISTINCT FROM me.label LIMIT 1;
  IF FOUND THEN PERFORM refuse('place', about); END IF;
  SELECT format('session %s, step %s', n.number, t.step) INTO about
    FROM unnest(numbers, read) AS n (number, rows),
         jsonb_to_recordset(n.rows->'trial') AS t (step integer, attempt integer, trace_samples bigint)
    WHERE t.trace_samples <> coalesce((SELECT sum(c.samples) FROM chunk AS c WHERE c.station = me.id
      AND c.session = n.number AND c.step = t.step AND c.attempt = t.attempt), 0) LIMIT 1;
  IF FOUND THEN PERFORM refuse('traces', about); END IF;

  INSERT INTO fact (station, number, as_of, sha256)
  SELECT me.id, n.number, n.as_of, n.sha256 FROM unnest(numbers, marks, hashes) AS n (number, as_of, sha256);
  DELETE FROM answer AS a WHERE a.station = me.id AND a.number = ANY (numbers);
  DELETE FROM session AS s WHERE s.station = me.id AND s.number = ANY (numbers);
  INSERT INTO session (station, number, as_of, facts, sha256, participant, cohort, run_mode, protocol, language, state,
                       started_utc, ended_utc)
  SELECT me.id, n.number, n.as_of, n.facts, n.sha256, n.code, n.head->>'cohort', n.head->>'run_mode',
         n.head->>'protocol', n.head->>'language', n.head->>'state', n.head->>'started_utc', n.head->>'ended_utc'
  FROM unnest(numbers, marks, texts, hashes, people, heads) AS n (number, as_of, facts, sha256, code, head);
  INSERT INTO answer (station, number, step, attempt, item, phase, instrument, alternative, counts, kind, point, value,
                      words, code)
  SELECT me.id, n.number, a.step, a.attempt, a.item, a.phase, a.instrument, a.label, a.status = 'finished', a.kind,
         a.point, a.number, a.text, k.code
  FROM unnest(numbers, heads, read) AS n (number, head, rows)
  CROSS JOIN LATERAL (
    SELECT a.*, s.phase, s.instrument, s.label, v.status, c.condition FROM jsonb_to_recordset(n.rows->'answer')
      AS a (step integer, attempt integer, item text, kind text, point integer, number double precision, text text)
    JOIN jsonb_to_recordset(n.rows->'step') AS s (step integer, phase text, instrument text, label integer)
      ON s.step = a.step
    JOIN jsonb_to_recordset(n.rows->'visit') AS v (step integer, attempt integer, status text)
      ON v.step = a.step AND v.attempt = a.attempt
    LEFT JOIN jsonb_to_recordset(n.rows->'allocation') AS c (step integer, condition text) ON c.step = a.step) AS a
  LEFT JOIN condition_code AS k
    ON k.study = me.study AND k.run_mode = n.head->>'run_mode' AND k.condition = a.condition;
  PERFORM forget(me, n.number, n.code, n.as_of) FROM unnest(numbers, marks, people, heads) AS n (number, as_of, code, head)
  WHERE n.head->>'state' = 'erased';
END $$;

-- The only way in. Takes a batch of one station in one transaction, and answers {"have": n}: all events up to n are
-- here, with what belongs to them. The same for a batch that came before. A batch that cannot be taken changes nothing
-- and is kept as an incident: {"have": n, "refused": …, "detail": …}. So is one that no program of ours would write: no
-- JSON, a number that is none, a hash of another length.
CREATE FUNCTION ingest(batch text, digest bytea, traces bytea[]) RETURNS json
LANGUAGE plpgsql SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
DECLARE
  said jsonb; me station; reached bigint; why text; about text; pending bigint;
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
    PERFORM take_sessions(me, said);
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

-- What is here of a station is not what it recorded: all of it stays under another name and is pulled no more, and the
-- station sends everything again. Its answers go: they are counted no more, and the facts have them. For the owner alone.
CREATE FUNCTION set_aside(of_study text, of_label text, because text) RETURNS boolean
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  me station;
BEGIN
  SELECT * INTO me FROM station WHERE study = of_study AND label = of_label FOR UPDATE;
  IF NOT FOUND THEN RETURN false; END IF;
  UPDATE station SET uuid = replace(gen_random_uuid()::text, '-', ''), label = me.label || '/' || me.id, was = me.uuid,
                     set_aside = now() WHERE id = me.id;
  DELETE FROM answer WHERE station = me.id;
  INSERT INTO station (study, uuid, site, label, role, key, enrolled, enrolled_by, expires, first_contact)
  VALUES (me.study, me.uuid, me.site, me.label, me.role, me.key, me.enrolled, me.enrolled_by, me.expires,
          coalesce(me.first_contact, now()));
  INSERT INTO incident (station, what, detail) VALUES (me.id, 'set_aside', because);
  RETURN true;
END $$;

REVOKE ALL ON ALL FUNCTIONS IN SCHEMA palpate FROM PUBLIC;
GRANT EXECUTE ON FUNCTION ingest(text, bytea, bytea[]) TO palpate_station;
