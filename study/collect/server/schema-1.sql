-- The schema palpate, step 1: what is kept. Run by 'palpate collect init' as the role palpate_owner, with search_path =
-- palpate. Once a release has a step it is never changed, because there are servers at every one of them.

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
  enrolled_by    text NOT NULL DEFAULT session_user,
  expires        timestamptz NOT NULL,  -- to be used first before this
  first_contact  timestamptz,
  last_contact   timestamptz,
  revoked        timestamptz,
  revoked_reason text,
  revoked_by     text,
  set_aside      timestamptz,
  was            text,  -- of one that was set aside: the uuid of the station that goes on in its place
  have           bigint NOT NULL DEFAULT 0,  -- all events up to this one are here
  UNIQUE (study, label)
);

-- The audit trail of each station, as it was written there. Here and in answer no foreign key: ingest() alone writes, and
-- holds the station's row; a third of its time went into looking for that row, and a session's, once for each of
-- theirs.
CREATE TABLE event (
  station      integer NOT NULL,
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
-- Most of what is stored. LZ4, where the server was built with it, is several times as fast as PostgreSQL's own method.
DO $$ BEGIN
  ALTER TABLE session ALTER COLUMN facts SET COMPRESSION lz4;
EXCEPTION WHEN feature_not_supported THEN
  NULL;
END $$;
-- Without it PostgreSQL takes one session in ten to be another one, and looks for the answers of each by its key; with it
-- it reads all answers once, which counts need anyway.
CREATE STATISTICS each_is_another (ndistinct) ON station, number FROM session;

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

-- The answers of these facts, for those who count. They are what counts read as a whole: what is there more often than
-- once for each answer is in the row of the session. A condition is given by its code only.
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
  code        text,              -- of the condition; NULL: it is about none
  PRIMARY KEY (station, number, step, attempt, item)
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

-- The questions that are about the person. 'palpate collect init' writes them for the study's protocol.
CREATE TABLE background_item (
  study text NOT NULL REFERENCES study,
  phase text NOT NULL,
  item  text NOT NULL,
  width double precision CHECK (width > 0),  -- of the bands of a number; NULL: a choice, or a number of few
  whole boolean NOT NULL,                    -- "20 to 24", otherwise "20 to <25"
  PRIMARY KEY (study, phase, item)
);

REVOKE ALL ON ALL TABLES IN SCHEMA palpate FROM PUBLIC;
REVOKE ALL ON ALL FUNCTIONS IN SCHEMA palpate FROM PUBLIC;
