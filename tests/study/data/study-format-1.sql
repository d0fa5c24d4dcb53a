PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE study (
        id             INTEGER PRIMARY KEY CHECK (id = 1),
        uuid           TEXT NOT NULL,
        seed           TEXT NOT NULL,
        random_version INTEGER NOT NULL,
        app_version    TEXT NOT NULL,
        created_utc    TEXT NOT NULL
      ) STRICT;
INSERT INTO study VALUES(1,'917faf37134b78a8b44fb944cecc40b6','42',1,'0.1.0','2026-11-21T02:15:23.959Z');
CREATE TABLE protocol (
        id         INTEGER PRIMARY KEY,
        sha256     TEXT NOT NULL,
        text       TEXT NOT NULL,
        reason     TEXT NOT NULL,
        added_utc  TEXT NOT NULL,
        frozen_utc TEXT
      ) STRICT;
INSERT INTO protocol VALUES(1,'f656769bd6bf162309839e4dddf9896e3ecf1bffc801351362320e6fd8e0f69c',replace('{"$schema": "protocol-1.schema.json",\n "study": {"id": "format-1", "title": "A study of format 1", "version": "1"},\n "languages": ["en"],\n "seed": 42,\n "cohorts": [{"id": "surgeons", "title": "Surgeons"}],\n "devices": [{"id": "punch", "kind": "punch", "max_force_n": 8.0, "max_force_rate_n_per_s": 500.0}],\n "conditions": [{"id": "soft", "title": "Soft", "scene": {"device": "punch", "model": "finite-elements",\n   "parameters": {"elements": 5, "contact_travel": 4.0, "yield_force_n": 7.0}}}],\n "labels": {"policy": "position", "prefix": "Alternative"},\n "phases": [{"id": "consent", "type": "consent", "instrument": "consent-punch"},\n   {"id": "preset", "type": "form", "instrument": "presence-single-item"},\n   {"id": "felt", "type": "block", "order": {"type": "fixed"}, "minimum_cuts": 1, "conditions": ["soft"]}]}\n','\n',char(10)),'the study was made','2026-11-21T02:15:23.959Z','2026-11-21T02:15:23.970Z');
CREATE TABLE protocol_file (
        protocol_id INTEGER NOT NULL REFERENCES protocol (id),
        name        TEXT NOT NULL,
        sha256      TEXT NOT NULL,
        text        TEXT NOT NULL,
        PRIMARY KEY (protocol_id, name)
      ) STRICT;
CREATE TABLE participant (
        id          INTEGER PRIMARY KEY,
        code        TEXT NOT NULL UNIQUE CHECK (length(code) BETWEEN 1 AND 64),
        cohort      TEXT NOT NULL,
        run_mode    TEXT NOT NULL CHECK (run_mode IN ('live', 'pilot', 'simulated')),
        created_utc TEXT NOT NULL
      ) STRICT;
INSERT INTO participant VALUES(1,'Q1','surgeons','live','2026-11-21T02:15:23.970Z');
CREATE TABLE session (
        id             INTEGER PRIMARY KEY,
        participant_id INTEGER NOT NULL REFERENCES participant (id),
        number         INTEGER NOT NULL CHECK (number >= 1),
        protocol_id    INTEGER NOT NULL REFERENCES protocol (id),
        run_mode       TEXT NOT NULL CHECK (run_mode IN ('live', 'pilot', 'simulated')),
        cohort         TEXT NOT NULL,
        language       TEXT NOT NULL,
        slot           INTEGER NOT NULL CHECK (slot >= 0),
        slot_state     TEXT NOT NULL CHECK (slot_state IN ('reserved', 'consumed', 'released')),
        state          TEXT NOT NULL,
        step           INTEGER NOT NULL CHECK (step >= 0),
        attempt        INTEGER NOT NULL CHECK (attempt >= 1),
        app_version    TEXT NOT NULL,
        started_utc    TEXT NOT NULL,
        ended_utc      TEXT,
        end_reason     TEXT,
        UNIQUE (participant_id, number)
      ) STRICT;
INSERT INTO session VALUES(1,1,1,1,'live','surgeons','en',0,'reserved','consented',2,1,'0.1.0','2026-11-21T02:15:23.970Z',NULL,NULL);
CREATE TABLE step (
        session_id INTEGER NOT NULL REFERENCES session (id),
        step       INTEGER NOT NULL,
        kind       TEXT NOT NULL,
        phase      TEXT NOT NULL,
        instrument TEXT NOT NULL,
        item_set   TEXT NOT NULL,
        position   INTEGER NOT NULL,
        label      INTEGER NOT NULL,
        PRIMARY KEY (session_id, step)
      ) STRICT;
INSERT INTO step VALUES(1,0,'consent','consent','consent-punch','',0,0);
INSERT INTO step VALUES(1,1,'form','preset','presence-single-item','',0,0);
INSERT INTO step VALUES(1,2,'trial','felt','','',1,1);
CREATE TABLE allocation (
        session_id INTEGER NOT NULL,
        step       INTEGER NOT NULL,
        condition  TEXT NOT NULL,
        PRIMARY KEY (session_id, step),
        FOREIGN KEY (session_id, step) REFERENCES step (session_id, step)
      ) STRICT;
INSERT INTO allocation VALUES(1,2,'soft');
CREATE TABLE visit (
        session_id INTEGER NOT NULL,
        step       INTEGER NOT NULL,
        attempt    INTEGER NOT NULL CHECK (attempt >= 1),
        status     TEXT NOT NULL
                   CHECK (status IN ('open', 'finished', 'skipped', 'repeated', 'broken_off')),
        began_utc  TEXT NOT NULL,
        ended_utc  TEXT,
        reason     TEXT,
        PRIMARY KEY (session_id, step, attempt),
        FOREIGN KEY (session_id, step) REFERENCES step (session_id, step)
      ) STRICT;
INSERT INTO visit VALUES(1,0,1,'finished','2026-11-21T02:15:23.970Z','2026-11-21T02:15:23.973Z','');
INSERT INTO visit VALUES(1,1,1,'finished','2026-11-21T02:15:23.973Z','2026-11-21T02:15:23.974Z','');
INSERT INTO visit VALUES(1,2,1,'open','2026-11-21T02:15:23.975Z',NULL,NULL);
CREATE TABLE answer (
        session_id    INTEGER NOT NULL,
        step          INTEGER NOT NULL,
        attempt       INTEGER NOT NULL,
        item          TEXT NOT NULL,
        item_order    INTEGER NOT NULL,
        kind          TEXT NOT NULL CHECK (kind IN ('point', 'number', 'text', 'choices')),
        point         INTEGER CHECK ((point IS NOT NULL) = (kind = 'point')),
        number        REAL CHECK ((number IS NOT NULL) = (kind = 'number')),
        text          TEXT CHECK ((text IS NOT NULL) = (kind IN ('text', 'choices')))
                      CHECK (text IS NULL OR length(text) <= 1000000),
        first_touch_s REAL NOT NULL CHECK (first_touch_s >= 0),
        response_s    REAL NOT NULL CHECK (response_s >= first_touch_s),
        changes       INTEGER NOT NULL CHECK (changes >= 0),
        language      TEXT NOT NULL,
        saved_utc     TEXT NOT NULL,
        UNIQUE (session_id, step, attempt, item),
        FOREIGN KEY (session_id, step, attempt) REFERENCES visit (session_id, step, attempt)
      ) STRICT;
INSERT INTO answer VALUES(1,0,1,'consent',1,'text',NULL,NULL,'yes',2.4338999999999998548e-05,2.4338999999999998548e-05,0,'en','2026-11-21T02:15:23.972Z');
INSERT INTO answer VALUES(1,1,1,'presence',1,'point',4,NULL,NULL,5.9129999999999999682e-06,5.9129999999999999682e-06,0,'en','2026-11-21T02:15:23.974Z');
CREATE TABLE trial (
        session_id      INTEGER NOT NULL,
        step            INTEGER NOT NULL,
        attempt         INTEGER NOT NULL,
        device          TEXT NOT NULL,
        ending          TEXT NOT NULL,
        verdict         TEXT NOT NULL CHECK (verdict IN ('PASS', 'WARN', 'FAIL')),
        verdict_reason  TEXT NOT NULL,
        force_unit      TEXT NOT NULL,
        travel_unit     TEXT NOT NULL,
        duration_s      REAL NOT NULL,
        ticks           INTEGER NOT NULL,
        nominal_rate_hz REAL NOT NULL,
        achieved_rate_hz REAL,
        lateness_p50_us REAL,
        lateness_p99_us REAL,
        lateness_max_us REAL,
        late_ticks      INTEGER,
        lost_samples    INTEGER NOT NULL,
        invalid_ticks   INTEGER NOT NULL,
        saturated_s     REAL NOT NULL,
        slewed_s        REAL NOT NULL,
        undefined_s     REAL NOT NULL,
        contact_s       REAL NOT NULL,
        largest_force_n REAL NOT NULL,
        cuts            INTEGER NOT NULL,
        trace_samples   INTEGER NOT NULL,
        PRIMARY KEY (session_id, step, attempt),
        FOREIGN KEY (session_id, step, attempt) REFERENCES visit (session_id, step, attempt)
      ) STRICT;
CREATE TABLE cut (
        session_id           INTEGER NOT NULL,
        step                 INTEGER NOT NULL,
        attempt              INTEGER NOT NULL,
        number               INTEGER NOT NULL CHECK (number >= 1),
        interception_travel  REAL, interception_n REAL,
        yield_travel         REAL, yield_n        REAL,
        bottom_out_travel    REAL, bottom_out_n   REAL,
        opening_travel       REAL, opening_n      REAL,
        peak_n               REAL NOT NULL,
        PRIMARY KEY (session_id, step, attempt, number),
        FOREIGN KEY (session_id, step, attempt) REFERENCES trial (session_id, step, attempt)
      ) STRICT;
CREATE TABLE event (
        seq          INTEGER PRIMARY KEY,
        session_id   INTEGER REFERENCES session (id),
        step         INTEGER,
        attempt      INTEGER,
        utc          TEXT NOT NULL,
        monotonic_ns INTEGER NOT NULL,
        actor        TEXT NOT NULL CHECK (actor IN ('participant', 'operator', 'program')),
        kind         TEXT NOT NULL,
        detail       TEXT NOT NULL,
        hash         BLOB NOT NULL CHECK (length(hash) = 32)
      ) STRICT;
INSERT INTO event VALUES(1,NULL,NULL,NULL,'2026-11-21T02:15:23.959Z',9491377339740,'program','made_study','format-1',X'79fc5f5ce88742b41ddd087c487b625dba068669fbc471b2488fa8bd9e340ace');
INSERT INTO event VALUES(2,1,0,1,'2026-11-21T02:15:23.970Z',9491388346448,'program','enrolled','Q1 surgeons live, place 1',X'61bfa9f13374ddda9b02d99364675d0f41850da461b8e5ee0062cd78f92c0ee9');
INSERT INTO event VALUES(3,1,0,1,'2026-11-21T02:15:23.973Z',9491390702733,'participant','answered','consent = ''yes''',X'09f9371d089dcf60534433e660322b0c2ce96a0aa57e8d9732443d9a0b117415');
INSERT INTO event VALUES(4,1,0,1,'2026-11-21T02:15:23.973Z',9491391401997,'participant','gave_consent','consent',X'5717e600a7e82c5abfec46f768772b61bb4d48843dec0607e9ab9ba6d9588c0a');
INSERT INTO event VALUES(5,1,1,1,'2026-11-21T02:15:23.974Z',9491392065574,'participant','answered','presence = 4',X'ffe14e822b61b210b476ee7eeeed07d1fdb4b02606395288ae7ed6f58f0e4919');
INSERT INTO event VALUES(6,1,1,1,'2026-11-21T02:15:23.975Z',9491392639885,'participant','finished_step','preset',X'de44b040e74a56780e8588fb88d272ffe8def7e6c2c65b89feb93ab4d6f6f2be');
CREATE TABLE lease (
        session_id INTEGER PRIMARY KEY REFERENCES session (id),
        station    TEXT NOT NULL,
        pid        INTEGER NOT NULL,
        process    TEXT NOT NULL,
        taken_utc  TEXT NOT NULL
      ) STRICT;
CREATE TRIGGER a_frozen_protocol_stays_as_it_is
      BEFORE UPDATE OF sha256, text, reason, added_utc ON protocol WHEN old.frozen_utc IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;
CREATE UNIQUE INDEX a_slot_is_held_once ON session (protocol_id, run_mode, cohort, slot)
      WHERE slot_state <> 'released';
CREATE INDEX events_of_a_session ON event (session_id);
CREATE TRIGGER an_event_is_never_changed BEFORE UPDATE ON event
      BEGIN SELECT RAISE(ABORT, 'events are never changed'); END;
CREATE TRIGGER an_event_is_never_removed BEFORE DELETE ON event
      BEGIN SELECT RAISE(ABORT, 'events are never removed'); END;
COMMIT;
