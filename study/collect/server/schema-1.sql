-- The schema palpate, step 1. Run by 'palpate collect init' as the role palpate_owner, with search_path = palpate.
-- Steps are added and never changed, because there are servers at every one of them.

CREATE TABLE study (
  uuid    text PRIMARY KEY CHECK (uuid ~ '^[0-9a-f]{32}$'),
  name    text NOT NULL UNIQUE CHECK (length(name) BETWEEN 1 AND 64),
  title   text NOT NULL,
  seed    text NOT NULL,
  secret  bytea NOT NULL CHECK (length(secret) = 32),  -- of codes and orders; only whoever unblinds gets it
  created timestamptz NOT NULL DEFAULT now()
);

CREATE TABLE protocol (
  study  text NOT NULL REFERENCES study,
  sha256 text NOT NULL,
  text   text NOT NULL,
  files  json NOT NULL,
  added  timestamptz NOT NULL DEFAULT now(),
  PRIMARY KEY (study, sha256)
);

CREATE TABLE station (
  id             integer GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  study          text NOT NULL REFERENCES study,
  uuid           text NOT NULL UNIQUE CHECK (uuid ~ '^[0-9a-f]{32}$'),
  site           text NOT NULL,
  label          text NOT NULL,
  role           text NOT NULL,  -- that may write for it
  key            text NOT NULL CHECK (key ~ '^[0-9a-f]{64}$'),  -- with which it signs its audit trail
  enrolled       timestamptz NOT NULL DEFAULT now(),
  expires        timestamptz NOT NULL,  -- to be used first before this
  first_contact  timestamptz,
  last_contact   timestamptz,
  revoked        timestamptz,
  revoked_reason text,
  have           bigint NOT NULL DEFAULT 0,  -- all events up to this one are here
  UNIQUE (study, label)
);

-- The audit trail of each station, as it was written there.
CREATE TABLE event (
  station      integer NOT NULL REFERENCES station,
  seq          bigint NOT NULL CHECK (seq >= 1),
  session      bigint,
  step         integer,
  attempt      integer,
  utc          text NOT NULL,
  monotonic_ns bigint NOT NULL,
  actor        text NOT NULL,
  kind         text NOT NULL,
  detail       text NOT NULL,
  sealed       bytea,
  content_hash bytea,
  hash         bytea NOT NULL CHECK (length(hash) = 32),
  received     timestamptz NOT NULL DEFAULT now(),
  PRIMARY KEY (station, seq)
);
CREATE INDEX events_of_a_session ON event (station, session, seq) WHERE session IS NOT NULL;

CREATE FUNCTION events_stay() RETURNS trigger LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  RAISE EXCEPTION 'events are never changed and never removed';
END $$;
CREATE TRIGGER an_event_is_never_changed BEFORE UPDATE OR DELETE ON event
FOR EACH ROW EXECUTE FUNCTION events_stay();

-- What the tables of a station say of a session after the event as_of. The last such fact takes the place of the one
-- before; which facts there were is in fact.
CREATE TABLE session (
  station     integer NOT NULL REFERENCES station,
  number      bigint NOT NULL,
  as_of       bigint NOT NULL,
  facts       text NOT NULL,   -- all rows, as they were sent; the map of conditions is in here
  sha256      bytea NOT NULL,  -- of facts
  participant text NOT NULL,
  cohort      text NOT NULL,
  run_mode    text NOT NULL,
  protocol    text NOT NULL,
  language    text NOT NULL,
  state       text NOT NULL,
  started_utc text NOT NULL,
  ended_utc   text,
  received    timestamptz NOT NULL DEFAULT now(),
  PRIMARY KEY (station, number)
);

CREATE TABLE fact (
  station  integer NOT NULL,
  number   bigint NOT NULL,
  as_of    bigint NOT NULL,
  sha256   bytea NOT NULL,
  received timestamptz NOT NULL DEFAULT now(),
  PRIMARY KEY (station, number, as_of)
);

-- The last event of each session that is here: the session's facts may still be on their way.
CREATE TABLE progress (
  station integer NOT NULL,
  number  bigint NOT NULL,
  last    bigint NOT NULL,
  PRIMARY KEY (station, number)
);

-- The answers of these facts, for those who count. No column tells a condition.
CREATE TABLE answer (
  station     integer NOT NULL,
  number      bigint NOT NULL,
  step        integer NOT NULL,
  attempt     integer NOT NULL,
  item        text NOT NULL,
  phase       text NOT NULL,
  instrument  text NOT NULL,
  alternative integer NOT NULL,
  counts      boolean NOT NULL,  -- the visit was finished, and not repeated
  kind        text NOT NULL,
  point       integer,
  value       double precision,
  words       text,
  PRIMARY KEY (station, number, step, attempt, item),
  FOREIGN KEY (station, number) REFERENCES session (station, number) ON DELETE CASCADE
);

CREATE TABLE chunk (
  station integer NOT NULL REFERENCES station,
  session bigint NOT NULL,
  step    integer NOT NULL,
  attempt integer NOT NULL,
  number  integer NOT NULL,
  samples integer NOT NULL CHECK (samples > 0),
  layout  integer NOT NULL,
  data    bytea NOT NULL,
  hash    bytea NOT NULL CHECK (length(hash) = 32),
  PRIMARY KEY (station, session, step, attempt, number)
);
-- Samples are noise to a compressor: it costs ten times what writing costs.
ALTER TABLE chunk ALTER COLUMN data SET STORAGE EXTERNAL;

-- With which the events of a participant are read. Destroyed by an erasure.
CREATE TABLE content_key (
  station     integer NOT NULL REFERENCES station,
  participant text NOT NULL,
  key         bytea NOT NULL CHECK (length(key) = 32),
  PRIMARY KEY (station, participant)
);

CREATE TABLE tombstone (
  station     integer NOT NULL REFERENCES station,
  number      bigint NOT NULL,
  participant text NOT NULL,
  as_of       bigint NOT NULL,
  erased      timestamptz NOT NULL DEFAULT now(),
  PRIMARY KEY (station, number)
);

-- What was refused, and who looked at what.
CREATE TABLE incident (
  id      bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  at      timestamptz NOT NULL DEFAULT now(),
  role    text NOT NULL DEFAULT session_user,
  station integer REFERENCES station,
  what    text NOT NULL,
  detail  text NOT NULL
);
CREATE TABLE access (
  id     bigint GENERATED ALWAYS AS IDENTITY PRIMARY KEY,
  at     timestamptz NOT NULL DEFAULT now(),
  role   text NOT NULL DEFAULT session_user,
  study  text NOT NULL REFERENCES study,
  reason text NOT NULL CHECK (length(reason) > 0)
);

-- ---------------------------------------------------------------------------------------------------------------------
-- Taking in. Whatever is wrong raises PC001: the batch is undone as a whole, and ingest() keeps an incident.

CREATE FUNCTION refuse(what text, detail text) RETURNS void LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  RAISE EXCEPTION USING ERRCODE = 'PC001', MESSAGE = what, DETAIL = detail;
END $$;

CREATE FUNCTION take_events(me station, said json) RETURNS bigint
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  other bigint; lowest bigint; most bigint; many bigint; first bigint; before text;
BEGIN
  SELECT n.seq INTO other FROM json_to_recordset(said->'events') AS n (seq bigint, hash text)
    JOIN event AS e ON e.station = me.id AND e.seq = n.seq
    WHERE e.hash <> decode(n.hash, 'hex') ORDER BY 1 LIMIT 1;
  IF FOUND THEN PERFORM refuse('fork', format('event %s is here with another hash', other)); END IF;

  SELECT min(n.seq), min(n.seq) FILTER (WHERE n.seq > me.have), max(n.seq) FILTER (WHERE n.seq > me.have),
         count(*) FILTER (WHERE n.seq > me.have)
    INTO first, lowest, most, many FROM json_to_recordset(said->'events') AS n (seq bigint);
  IF first > me.have + 1 OR (many > 0 AND (lowest <> me.have + 1 OR most <> me.have + many)) THEN
    PERFORM refuse('gap', format('events %s to %s came after event %s', first, most, me.have));
  END IF;
  SELECT encode(hash, 'hex') INTO before FROM event WHERE station = me.id AND seq = first - 1;
  IF FOUND AND before IS DISTINCT FROM said->>'after' THEN
    PERFORM refuse('fork', format('event %s is here with another hash', first - 1));
  END IF;
  IF coalesce(many, 0) = 0 THEN RETURN me.have; END IF;

  INSERT INTO event (station, seq, session, step, attempt, utc, monotonic_ns, actor, kind, detail, sealed,
                     content_hash, hash)
  SELECT me.id, n.seq, n.session, n.step, n.attempt, n.utc, n.monotonic_ns, n.actor, n.kind, n.detail,
         decode(n.sealed, 'hex'), decode(n.content_hash, 'hex'), decode(n.hash, 'hex')
  FROM json_to_recordset(said->'events')
    AS n (seq bigint, session bigint, step integer, attempt integer, utc text, monotonic_ns bigint, actor text,
          kind text, detail text, sealed text, content_hash text, hash text)
  WHERE n.seq > me.have;
  INSERT INTO progress (station, number, last)
  SELECT me.id, n.session, max(n.seq) FROM json_to_recordset(said->'events') AS n (seq bigint, session bigint)
  WHERE n.session IS NOT NULL GROUP BY n.session
  ON CONFLICT (station, number) DO UPDATE SET last = greatest(progress.last, excluded.last);
  RETURN most;
END $$;

CREATE FUNCTION take_traces(me station, said json, traces bytea[]) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
DECLARE
  wrong text;
BEGIN
  IF coalesce(json_array_length(said->'traces'), 0) <> coalesce(array_length(traces, 1), 0) THEN
    PERFORM refuse('damaged', 'as many traces as descriptions are needed');
  END IF;
  SELECT t.what::text INTO wrong FROM json_array_elements(said->'traces') WITH ORDINALITY AS t (what, place)
    WHERE sha256(traces[t.place]) <> decode(t.what->>'sha256', 'hex') LIMIT 1;
  IF FOUND THEN PERFORM refuse('damaged', wrong); END IF;
  SELECT t.what::text INTO wrong FROM json_array_elements(said->'traces') AS t (what)
    JOIN chunk AS c ON c.station = me.id AND c.session = (t.what->>'session')::bigint
      AND c.step = (t.what->>'step')::integer AND c.attempt = (t.what->>'attempt')::integer
      AND c.number = (t.what->>'number')::integer
    WHERE c.hash <> decode(t.what->>'hash', 'hex') LIMIT 1;
  IF FOUND THEN PERFORM refuse('fork', 'a trace is here with another hash: ' || wrong); END IF;

  INSERT INTO chunk (station, session, step, attempt, number, samples, layout, data, hash)
  SELECT me.id, (t.what->>'session')::bigint, (t.what->>'step')::integer, (t.what->>'attempt')::integer,
         (t.what->>'number')::integer, (t.what->>'samples')::integer, (t.what->>'layout')::integer,
         traces[t.place], decode(t.what->>'hash', 'hex')
  FROM json_array_elements(said->'traces') WITH ORDINALITY AS t (what, place)
  WHERE NOT EXISTS (SELECT 1 FROM tombstone AS x
                    WHERE x.station = me.id AND x.number = (t.what->>'session')::bigint)
  ON CONFLICT DO NOTHING;
END $$;

-- One session, as it stood after its event as_of.
CREATE FUNCTION take_session(me station, which bigint, said_of bigint, facts text, digest bytea) RETURNS void
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
  IF head->>'state' = 'erased' THEN
    DELETE FROM chunk WHERE station = me.id AND session = which;
    DELETE FROM content_key WHERE station = me.id AND participant = sent->'participant'->>'code';
    INSERT INTO tombstone (station, number, participant, as_of)
    VALUES (me.id, which, sent->'participant'->>'code', said_of) ON CONFLICT DO NOTHING;
  END IF;
END $$;

CREATE FUNCTION take_keys(me station, said json) RETURNS void
LANGUAGE plpgsql SET search_path = palpate, pg_temp AS $$
BEGIN
  INSERT INTO content_key (station, participant, key)
  SELECT me.id, k.participant, decode(k.key, 'hex')
  FROM json_to_recordset(said->'keys') AS k (participant text, key text)
  WHERE NOT EXISTS (SELECT 1 FROM tombstone AS x WHERE x.station = me.id AND x.participant = k.participant)
  ON CONFLICT DO NOTHING;
END $$;

-- The only way in. Takes a batch of one station in one transaction, and answers {"have": n}: all events up to n are
-- here, with what belongs to them. The same for a batch that came before. A batch that cannot be taken changes nothing
-- and is kept as an incident: {"have": n, "refused": …, "detail": …}.
CREATE FUNCTION ingest(batch text, digest bytea, traces bytea[]) RETURNS json
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
    IF me.role <> session_user AND NOT pg_has_role(session_user, 'palpate_owner', 'MEMBER') THEN PERFORM refuse('foreign', format('station %s', me.label)); END IF;
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
      (SELECT encode(hash, 'hex') FROM event WHERE station = me.id AND seq = reached));
  EXCEPTION WHEN SQLSTATE 'PC001' THEN
    GET STACKED DIAGNOSTICS why = MESSAGE_TEXT, about = PG_EXCEPTION_DETAIL;
  END;
  INSERT INTO incident (station, what, detail) VALUES (me.id, why, about);
  RETURN json_build_object('have', coalesce(me.have, 0), 'refused', why, 'detail', about);
END $$;

-- ---------------------------------------------------------------------------------------------------------------------
-- Taking out. Whoever pulls gets the map of conditions as well: with a reason, which is kept.

CREATE FUNCTION unblind(of_study text, because text) RETURNS bigint
LANGUAGE sql SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  INSERT INTO access (study, reason) VALUES (of_study, because) RETURNING id;
$$;

-- The study that a ticket of unblind() is for.
CREATE FUNCTION opened(ticket bigint) RETURNS text
LANGUAGE plpgsql STABLE SET search_path = palpate, pg_temp AS $$
DECLARE
  found_study text;
BEGIN
  SELECT study INTO found_study FROM access
  WHERE id = ticket AND role = session_user AND at > now() - interval '1 day';
  IF NOT FOUND THEN
    RAISE EXCEPTION 'nobody gave a reason for this' USING ERRCODE = 'insufficient_privilege';
  END IF;
  RETURN found_study;
END $$;

CREATE FUNCTION pull_study(ticket bigint, OUT uuid text, OUT name text, OUT seed text, OUT secret bytea, OUT created text)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT s.uuid, s.name, s.seed, s.secret, to_char(s.created AT TIME ZONE 'UTC', 'YYYY-MM-DD"T"HH24:MI:SS.MS"Z"')
  FROM study AS s WHERE s.uuid = opened(ticket);
$$;

CREATE FUNCTION pull_protocols(ticket bigint)
RETURNS TABLE (sha256 text, text text, files json)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT p.sha256, p.text, p.files FROM protocol AS p WHERE p.study = opened(ticket) ORDER BY p.added, p.sha256;
$$;

CREATE FUNCTION pull_stations(ticket bigint)
RETURNS TABLE (id integer, uuid text, site text, label text, key text, have bigint)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT s.id, s.uuid, s.site, s.label, s.key, s.have FROM station AS s WHERE s.study = opened(ticket) ORDER BY s.label;
$$;

CREATE FUNCTION pull_events(ticket bigint, of_station integer, after bigint, most integer)
RETURNS TABLE (seq bigint, session bigint, step integer, attempt integer, utc text, monotonic_ns bigint, actor text,
               kind text, detail text, sealed bytea, content_hash bytea, hash bytea)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT e.seq, e.session, e.step, e.attempt, e.utc, e.monotonic_ns, e.actor, e.kind, e.detail, e.sealed,
         e.content_hash, e.hash
  FROM event AS e JOIN station AS s ON s.id = e.station
  WHERE s.study = opened(ticket) AND e.station = of_station AND e.seq > after ORDER BY e.seq LIMIT most;
$$;

CREATE FUNCTION pull_sessions(ticket bigint, of_station integer, after bigint, most integer)
RETURNS TABLE (number bigint, as_of bigint, sha256 bytea, facts text)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT x.number, x.as_of, x.sha256, x.facts FROM session AS x JOIN station AS s ON s.id = x.station
  WHERE s.study = opened(ticket) AND x.station = of_station AND x.number > after ORDER BY x.number LIMIT most;
$$;

CREATE FUNCTION pull_keys(ticket bigint, of_station integer) RETURNS TABLE (participant text, key bytea)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT k.participant, k.key FROM content_key AS k JOIN station AS s ON s.id = k.station
  WHERE s.study = opened(ticket) AND k.station = of_station ORDER BY 1;
$$;

CREATE FUNCTION pull_traces(ticket bigint, of_station integer, of_session bigint)
RETURNS TABLE (step integer, attempt integer, number integer, samples integer, layout integer, data bytea, hash bytea)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT c.step, c.attempt, c.number, c.samples, c.layout, c.data, c.hash
  FROM chunk AS c JOIN station AS s ON s.id = c.station
  WHERE s.study = opened(ticket) AND c.station = of_station AND c.session = of_session ORDER BY 1, 2, 3;
$$;

-- ---------------------------------------------------------------------------------------------------------------------
-- What others may see. A view is read with the rights of its owner.

-- Points alone: numbers and words may tell who somebody is.
CREATE VIEW answers AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, a.phase, a.instrument,
       a.alternative, a.item, a.point
FROM answer AS a
JOIN session AS s ON s.station = a.station AND s.number = a.number
JOIN station AS st ON st.id = a.station
WHERE a.counts AND a.point IS NOT NULL;

CREATE VIEW sessions AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, s.language,
       left(s.started_utc, 10) AS day
FROM session AS s JOIN station AS st ON st.id = s.station;

CREATE VIEW stations AS
SELECT s.study, d.name AS study_name, s.site, s.label AS station, s.have AS events, s.enrolled, s.first_contact,
       s.last_contact, s.revoked,
       (SELECT count(*) FROM session AS x WHERE x.station = s.id) AS sessions,
       (SELECT count(*) FROM incident AS i WHERE i.station = s.id) AS incidents
FROM station AS s JOIN study AS d ON d.uuid = s.study;

-- An operator sees the sessions of the own site: a member of operator_oslo those of "oslo".
ALTER TABLE session ENABLE ROW LEVEL SECURITY;
CREATE POLICY own_site ON session FOR SELECT TO palpate_operator USING (
  EXISTS (SELECT 1 FROM station AS st JOIN pg_roles AS r ON r.rolname = 'operator_' || replace(st.site, '-', '_')
          WHERE st.id = session.station AND pg_has_role(current_user, r.oid, 'MEMBER')));

REVOKE ALL ON ALL TABLES IN SCHEMA palpate FROM PUBLIC;
REVOKE ALL ON ALL FUNCTIONS IN SCHEMA palpate FROM PUBLIC;
GRANT EXECUTE ON FUNCTION ingest(text, bytea, bytea[]) TO palpate_station;
GRANT SELECT ON answers, sessions, stations TO palpate_analyst;
GRANT SELECT (id, study, site, label) ON station TO palpate_operator;
GRANT SELECT (station, number, participant, cohort, run_mode, language, state, started_utc, ended_utc, received)
ON session TO palpate_operator;
GRANT SELECT ON stations TO palpate_unblinder;
GRANT EXECUTE ON FUNCTION unblind(text, text), pull_study(bigint), pull_protocols(bigint), pull_stations(bigint),
  pull_events(bigint, integer, bigint, integer), pull_sessions(bigint, integer, bigint, integer),
  pull_keys(bigint, integer), pull_traces(bigint, integer, bigint) TO palpate_unblinder;
