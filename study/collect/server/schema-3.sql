-- The schema palpate, step 3: the ways out. A pull returns the map of conditions as well: with a reason, which is
-- kept.

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
  SELECT s.id, s.uuid, s.site, s.label, s.key, s.have FROM station AS s
  WHERE s.study = opened(ticket) AND s.set_aside IS NULL ORDER BY s.label;
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
RETURNS TABLE (number bigint, as_of bigint, sha256 bytea, facts text, has_samples boolean)
LANGUAGE sql STABLE SECURITY DEFINER SET search_path = palpate, pg_temp AS $$
  SELECT x.number, x.as_of, x.sha256, x.facts,
         EXISTS (SELECT 1 FROM chunk AS c WHERE c.station = x.station AND c.session = x.number)
  FROM session AS x JOIN station AS s ON s.id = x.station
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

-- Points alone: numbers and words may identify a person. Stations that were set aside have no answers, so that nothing
-- has to be looked up of a station where a query does not ask for it: PostgreSQL leaves out a LEFT JOIN whose
-- columns are not used.
CREATE VIEW answers AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, a.phase, a.instrument,
       a.alternative, a.item, a.point, a.code
FROM answer AS a
JOIN session AS s ON s.station = a.station AND s.number = a.number
LEFT JOIN station AS st ON st.id = a.station
WHERE a.counts AND a.point IS NOT NULL;

CREATE VIEW sessions AS
SELECT st.study, st.site, st.label AS station, s.participant, s.cohort, s.run_mode, s.state, s.language,
       left(s.started_utc, 10) AS day
FROM session AS s JOIN station AS st ON st.id = s.station
WHERE st.set_aside IS NULL;

-- An operator sees the own site: a member of operator_oslo what is of "oslo".
CREATE FUNCTION operates(site text) RETURNS boolean
LANGUAGE sql STABLE SET search_path = palpate, pg_temp AS $$
  SELECT EXISTS (SELECT 1 FROM pg_roles AS r
                 WHERE r.rolname = 'operator_' || replace(site, '-', '_') AND pg_has_role(r.oid, 'MEMBER'));
$$;

CREATE VIEW stations AS
SELECT s.study, d.name AS study_name, s.site, s.label AS station, s.have AS events, s.enrolled, s.first_contact,
       s.last_contact, s.revoked,
       (SELECT count(*) FROM session AS x WHERE x.station = s.id) AS sessions,
       (SELECT count(*) FROM incident AS i WHERE i.station = s.id) AS incidents,
       s.set_aside
FROM station AS s JOIN study AS d ON d.uuid = s.study
WHERE pg_has_role('palpate_owner', 'MEMBER') OR pg_has_role('palpate_analyst', 'MEMBER')
   OR pg_has_role('palpate_unblinder', 'MEMBER') OR operates(s.site);

ALTER TABLE session ENABLE ROW LEVEL SECURITY;
CREATE POLICY own_site ON session FOR SELECT TO palpate_operator USING (
  EXISTS (SELECT 1 FROM station AS st
          WHERE st.id = session.station AND st.set_aside IS NULL AND operates(st.site)));

-- ---------------------------------------------------------------------------------------------------------------------
-- What people say about themselves is seen as an export tells it: numbers in bands, choices as they are, no words.

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
WHERE a.counts;

REVOKE ALL ON ALL TABLES IN SCHEMA palpate FROM PUBLIC;
REVOKE ALL ON ALL FUNCTIONS IN SCHEMA palpate FROM PUBLIC;
GRANT SELECT ON answers, backgrounds, sessions, stations TO palpate_analyst;
GRANT EXECUTE ON FUNCTION band(double precision, double precision, boolean) TO palpate_analyst;
GRANT SELECT (id, study, site, label, set_aside) ON station TO palpate_operator;
GRANT SELECT (station, number, participant, cohort, run_mode, language, state, started_utc, ended_utc, received)
ON session TO palpate_operator;
GRANT SELECT ON stations TO palpate_unblinder, palpate_operator;
GRANT EXECUTE ON FUNCTION operates(text) TO palpate_analyst, palpate_unblinder, palpate_operator;
GRANT EXECUTE ON FUNCTION unblind(text, text), pull_study(bigint), pull_protocols(bigint), pull_stations(bigint),
  pull_events(bigint, integer, bigint, integer), pull_sessions(bigint, integer, bigint, integer),
  pull_keys(bigint, integer), pull_traces(bigint, integer, bigint) TO palpate_unblinder;
