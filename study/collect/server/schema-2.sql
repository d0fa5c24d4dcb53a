-- The schema palpate, step 2: what is forged is refused with an incident, and not with an error that undoes the incident.

-- The only way in. Takes a batch of one station in one transaction, and answers {"have": n}: all events up to n are
-- here, with what belongs to them. The same for a batch that came before. A batch that cannot be taken changes nothing
-- and is kept as an incident: {"have": n, "refused": …, "detail": …}. So is one that no program of ours would write: no
-- JSON, a number that is none, a hash of another length.
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
      (SELECT encode(hash, 'hex') FROM event WHERE station = me.id AND seq = reached));
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
