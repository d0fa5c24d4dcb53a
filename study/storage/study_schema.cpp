#include "study/storage/study_schema.h"

#include <array>
#include <string_view>

namespace study::storage {
namespace {

// Step n converts a database from version n to version n + 1. Steps are added and never changed,
// because studies of every version exist.
constexpr std::array<std::string_view, 10> kStudySteps{
    R"sql(
      CREATE TABLE study (
        id             INTEGER PRIMARY KEY CHECK (id = 1),
        uuid           TEXT NOT NULL,
        seed           TEXT NOT NULL,
        random_version INTEGER NOT NULL,
        app_version    TEXT NOT NULL,
        created_utc    TEXT NOT NULL
      ) STRICT;

      CREATE TABLE protocol (
        id         INTEGER PRIMARY KEY,
        sha256     TEXT NOT NULL,
        text       TEXT NOT NULL,
        reason     TEXT NOT NULL,
        added_utc  TEXT NOT NULL,
        frozen_utc TEXT
      ) STRICT;

      CREATE TABLE protocol_file (
        protocol_id INTEGER NOT NULL REFERENCES protocol (id),
        name        TEXT NOT NULL,
        sha256      TEXT NOT NULL,
        text        TEXT NOT NULL,
        PRIMARY KEY (protocol_id, name)
      ) STRICT;

      CREATE TRIGGER a_frozen_protocol_stays_as_it_is
      BEFORE UPDATE OF sha256, text, reason, added_utc ON protocol WHEN old.frozen_utc IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TABLE participant (
        id          INTEGER PRIMARY KEY,
        code        TEXT NOT NULL UNIQUE CHECK (length(code) BETWEEN 1 AND 64),
        cohort      TEXT NOT NULL,
        run_mode    TEXT NOT NULL CHECK (run_mode IN ('live', 'pilot', 'simulated')),
        created_utc TEXT NOT NULL
      ) STRICT;

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

      -- A place in a design is held once; a pilot or a simulation never holds a participant's.
      CREATE UNIQUE INDEX a_slot_is_held_once ON session (protocol_id, run_mode, cohort, slot)
      WHERE slot_state <> 'released';

      -- The order as realised.
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

      -- Which condition an alternative is: kept apart from everything that is exported blinded.
      CREATE TABLE allocation (
        session_id INTEGER NOT NULL,
        step       INTEGER NOT NULL,
        condition  TEXT NOT NULL,
        PRIMARY KEY (session_id, step),
        FOREIGN KEY (session_id, step) REFERENCES step (session_id, step)
      ) STRICT;

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

      -- Everything that happened, chained: whoever changes a line changes all that follow.
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
      CREATE INDEX events_of_a_session ON event (session_id);

      CREATE TRIGGER an_event_is_never_changed BEFORE UPDATE ON event
      BEGIN SELECT RAISE(ABORT, 'events are never changed'); END;
      CREATE TRIGGER an_event_is_never_removed BEFORE DELETE ON event
      BEGIN SELECT RAISE(ABORT, 'events are never removed'); END;

      -- Who is running a session just now: two operators, one study.
      CREATE TABLE lease (
        session_id INTEGER PRIMARY KEY REFERENCES session (id),
        station    TEXT NOT NULL,
        pid        INTEGER NOT NULL,
        process    TEXT NOT NULL,
        taken_utc  TEXT NOT NULL
      ) STRICT;
    )sql",
    R"sql(
      -- What the tables said about the event's session (or the study) after it.
      ALTER TABLE event ADD COLUMN content_hash BLOB CHECK (length(content_hash) = 32);

      -- REPLACE removes without asking the trigger above.
      CREATE TRIGGER an_event_is_added_at_the_end BEFORE INSERT ON event
      WHEN new.seq <> (SELECT coalesce(max(seq), 0) + 1 FROM event)
      BEGIN SELECT RAISE(ABORT, 'events are only ever added at the end'); END;

      CREATE TRIGGER a_frozen_protocol_stays_frozen
      BEFORE UPDATE OF frozen_utc ON protocol WHEN old.frozen_utc IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TRIGGER a_frozen_protocol_is_not_removed
      BEFORE DELETE ON protocol WHEN old.frozen_utc IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TRIGGER a_protocol_is_not_replaced
      BEFORE INSERT ON protocol WHEN EXISTS (SELECT 1 FROM protocol WHERE id = new.id)
      BEGIN SELECT RAISE(ABORT, 'there is a protocol of that id'); END;

      CREATE TRIGGER a_frozen_file_stays_as_it_is BEFORE UPDATE ON protocol_file
      WHEN EXISTS (SELECT 1 FROM protocol WHERE id = old.protocol_id AND frozen_utc IS NOT NULL)
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TRIGGER a_frozen_file_is_not_removed BEFORE DELETE ON protocol_file
      WHEN EXISTS (SELECT 1 FROM protocol WHERE id = old.protocol_id AND frozen_utc IS NOT NULL)
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TRIGGER a_frozen_protocol_gets_no_file BEFORE INSERT ON protocol_file
      WHEN EXISTS (SELECT 1 FROM protocol WHERE id = new.protocol_id AND frozen_utc IS NOT NULL)
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;
    )sql",
    R"sql(
      -- What is asked, as one number: an item of an instrument, in a phase, about a condition (''
      -- where nothing was felt). Follows from step and allocation; 'palpate study verify' looks.
      CREATE TABLE question (
        id         INTEGER PRIMARY KEY,
        kind       TEXT NOT NULL,
        phase      TEXT NOT NULL,
        instrument TEXT NOT NULL,
        condition  TEXT NOT NULL,
        item       TEXT NOT NULL,
        UNIQUE (kind, phase, instrument, condition, item)
      ) STRICT;

      CREATE TRIGGER a_question_is_never_changed BEFORE UPDATE ON question
      BEGIN SELECT RAISE(ABORT, 'questions are never changed'); END;
      CREATE TRIGGER a_question_is_never_removed BEFORE DELETE ON question
      BEGIN SELECT RAISE(ABORT, 'questions are never removed'); END;
      CREATE TRIGGER a_question_is_not_replaced BEFORE INSERT ON question
      WHEN EXISTS (
        SELECT 1 FROM question AS q
        WHERE q.id = new.id OR (q.kind = new.kind AND q.phase = new.phase
          AND q.instrument = new.instrument AND q.condition = new.condition AND q.item = new.item))
      BEGIN SELECT RAISE(ABORT, 'there is that question'); END;

      ALTER TABLE answer ADD COLUMN question INTEGER REFERENCES question (id);

      INSERT INTO question (kind, phase, instrument, condition, item)
      SELECT DISTINCT s.kind, s.phase, s.instrument, coalesce(a.condition, ''), x.item
      FROM answer AS x JOIN step AS s ON s.session_id = x.session_id AND s.step = x.step
      LEFT JOIN allocation AS a ON a.session_id = x.session_id AND a.step = x.step
      ORDER BY 1, 2, 3, 4, 5;

      UPDATE answer SET question = (
        SELECT q.id FROM step AS s
        LEFT JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step
        JOIN question AS q ON q.kind = s.kind AND q.phase = s.phase
          AND q.instrument = s.instrument AND q.condition = coalesce(a.condition, '')
        WHERE s.session_id = answer.session_id AND s.step = answer.step AND q.item = answer.item);

      CREATE TRIGGER an_answer_finds_its_question AFTER INSERT ON answer
      WHEN new.question IS NULL
      BEGIN
        INSERT INTO question (kind, phase, instrument, condition, item)
        SELECT s.kind, s.phase, s.instrument, coalesce(a.condition, ''), new.item FROM step AS s
        LEFT JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step
        WHERE s.session_id = new.session_id AND s.step = new.step AND NOT EXISTS (
          SELECT 1 FROM question AS q WHERE q.kind = s.kind AND q.phase = s.phase
          AND q.instrument = s.instrument AND q.condition = coalesce(a.condition, '')
          AND q.item = new.item);
        UPDATE answer SET question = (
          SELECT q.id FROM step AS s
          LEFT JOIN allocation AS a ON a.session_id = s.session_id AND a.step = s.step
          JOIN question AS q ON q.kind = s.kind AND q.phase = s.phase
            AND q.instrument = s.instrument AND q.condition = coalesce(a.condition, '')
          WHERE s.session_id = new.session_id AND s.step = new.step AND q.item = new.item)
        WHERE rowid = new.rowid;
      END;
      CREATE TRIGGER an_answer_keeps_its_question BEFORE UPDATE OF question ON answer
      WHEN old.question IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'an answer belongs to its question'); END;

      -- All that is counted, and what decides whether it counts, without a look at the rows.
      CREATE INDEX answers_to_be_counted ON answer (session_id, question, point)
      WHERE point IS NOT NULL;
      CREATE INDEX sessions_by_outcome ON session (run_mode, state, id, cohort);
      CREATE INDEX visits_that_do_not_count ON visit (session_id) WHERE status <> 'finished';
    )sql",
    R"sql(
      -- The same tables. From here on, event.detail and trial.verdict_reason may hold values in JSON
      -- where release 0.1 wrote English; that release would take such an answer for a changed one.
    )sql",
    R"sql(
      -- Answers are counted by the rows themselves (docs/decisions/0024). The numbers of questions
      -- that were written before stay: no row that is there is changed. Nothing reads them.
      DROP TRIGGER an_answer_finds_its_question;
      DROP TRIGGER an_answer_keeps_its_question;
      DROP TRIGGER a_question_is_never_changed;
      DROP TRIGGER a_question_is_never_removed;
      DROP TRIGGER a_question_is_not_replaced;
      DROP INDEX answers_to_be_counted;
      DROP INDEX sessions_by_outcome;
      DROP INDEX visits_that_do_not_count;
    )sql",
    R"sql(
      -- What an event says of a participant is sealed with that participant's content key, which is
      -- in identity.db; 'detail' is empty then (docs/decisions/0040). Events that older releases
      -- wrote stay as they are until the trail is sealed again.
      ALTER TABLE event ADD COLUMN sealed BLOB;

      -- Who was erased, from what, and why. Erasing ends in other files: finished_utc says that
      -- nothing is left to do.
      CREATE TABLE erasure (
        id           INTEGER PRIMARY KEY,
        participant  TEXT NOT NULL REFERENCES participant (code),
        level        TEXT NOT NULL CHECK (level IN ('identity', 'answers', 'all')),
        reason       TEXT NOT NULL,
        erased_utc   TEXT NOT NULL,
        finished_utc TEXT
      ) STRICT;

      CREATE TRIGGER an_erasure_is_never_removed BEFORE DELETE ON erasure
      BEGIN SELECT RAISE(ABORT, 'erasures are never removed'); END;
      CREATE TRIGGER an_erasure_is_never_changed
      BEFORE UPDATE OF id, participant, level, reason, erased_utc ON erasure
      BEGIN SELECT RAISE(ABORT, 'erasures are never changed'); END;
    )sql",
    R"sql(
      -- Which condition an alternative is, sealed with the study's key, which is not in its folder;
      -- 'condition' is empty then (docs/decisions/0049). Sessions of before stay open.
      ALTER TABLE allocation ADD COLUMN sealed BLOB;

      -- The same key, if it has a passphrase.
      CREATE TABLE wrapped_key (
        id         INTEGER PRIMARY KEY CHECK (id = 1),
        salt       BLOB NOT NULL CHECK (length(salt) = 16),
        operations INTEGER NOT NULL,
        memory     INTEGER NOT NULL,
        sealed     BLOB NOT NULL
      ) STRICT;
    )sql",
    R"sql(
      -- What was measured in a trial tells what was rendered: it is sealed where conditions are. The
      -- other columns of measurements are zero then, the verdict is 'PASS', and there is no cut.
      ALTER TABLE trial ADD COLUMN sealed BLOB;
    )sql",
    R"sql(
      -- Where a session took place; '' in a study of one machine. Each station draws its orders by
      -- itself, so that several of them can stand in one study (docs/decisions/0054).
      ALTER TABLE session ADD COLUMN site TEXT NOT NULL DEFAULT '';
      ALTER TABLE session ADD COLUMN station TEXT NOT NULL DEFAULT '';
      DROP INDEX a_slot_is_held_once;
      CREATE UNIQUE INDEX a_slot_is_held_once
      ON session (protocol_id, run_mode, station, cohort, slot) WHERE slot_state <> 'released';
    )sql",
    R"sql(
      -- Forms of the program's library are kept with the protocol that uses them
      -- (docs/decisions/0073). 'added': an older release stored the protocol, and its hash does not
      -- cover the copies. NULL: there is none yet.
      ALTER TABLE protocol ADD COLUMN forms TEXT CHECK (forms IN ('hashed', 'added'));

      DROP TRIGGER a_frozen_protocol_gets_no_file;
      CREATE TRIGGER a_frozen_protocol_gets_no_file BEFORE INSERT ON protocol_file
      WHEN EXISTS (SELECT 1 FROM protocol WHERE id = new.protocol_id AND frozen_utc IS NOT NULL
        AND (forms IS NOT NULL OR new.name NOT GLOB 'palpate-library/*'))
      BEGIN SELECT RAISE(ABORT, 'the protocol is frozen'); END;

      CREATE TRIGGER forms_are_copied_once BEFORE UPDATE OF forms ON protocol
      WHEN old.forms IS NOT NULL
      BEGIN SELECT RAISE(ABORT, 'the forms were copied already'); END;
    )sql",
};

constexpr std::array<std::string_view, 1> kTraceSteps{
    R"sql(
      CREATE TABLE chunk (
        session_id INTEGER NOT NULL,
        step       INTEGER NOT NULL,
        attempt    INTEGER NOT NULL,
        number     INTEGER NOT NULL CHECK (number >= 0),
        samples    INTEGER NOT NULL CHECK (samples > 0),
        layout     INTEGER NOT NULL,
        data       BLOB NOT NULL,
        hash       BLOB NOT NULL CHECK (length(hash) = 32),
        PRIMARY KEY (session_id, step, attempt, number)
      ) STRICT;
    )sql",
};

constexpr std::array<std::string_view, 6> kIdentitySteps{
    R"sql(
      CREATE TABLE identifying_answer (
        participant TEXT NOT NULL,
        session_number INTEGER NOT NULL,
        step        INTEGER NOT NULL,
        attempt     INTEGER NOT NULL,
        item        TEXT NOT NULL,
        text        TEXT NOT NULL CHECK (length(text) <= 1000000),
        saved_utc   TEXT NOT NULL,
        UNIQUE (participant, session_number, step, attempt, item)
      ) STRICT;
    )sql",
    R"sql(
      -- Of the row itself: the audit trail knows nothing that would name a person.
      ALTER TABLE identifying_answer
        ADD COLUMN hash BLOB CHECK (hash IS NULL OR length(hash) = 32);
    )sql",
    R"sql(
      -- What hides which condition a code stands for (docs/decisions/0038). Studies that were made
      -- before have none, and keep their codes.
      CREATE TABLE blinding_secret (
        id    INTEGER PRIMARY KEY CHECK (id = 1),
        bytes BLOB NOT NULL CHECK (length(bytes) = 32)
      ) STRICT;

      CREATE TRIGGER a_secret_is_never_changed BEFORE UPDATE ON blinding_secret
      BEGIN SELECT RAISE(ABORT, 'the secret is never changed'); END;
      CREATE TRIGGER a_secret_is_never_removed BEFORE DELETE ON blinding_secret
      BEGIN SELECT RAISE(ABORT, 'the secret is never removed'); END;
    )sql",
    R"sql(
      -- Names are sealed with the first key, what the audit trail says of a participant with the
      -- second (docs/decisions/0040). NULL: destroyed. Participants of older formats have no row.
      CREATE TABLE participant_key (
        participant TEXT PRIMARY KEY,
        identity    BLOB CHECK (identity IS NULL OR length(identity) = 32),
        content     BLOB CHECK (content IS NULL OR length(content) = 32)
      ) STRICT;

      -- The text, sealed; 'text' is empty then.
      ALTER TABLE identifying_answer ADD COLUMN sealed BLOB;
    )sql",
    R"sql(
      -- For the fingerprints of these rows in the audit trail, where the secret above is not in this
      -- file any more, but with the station that keeps the key (docs/decisions/0049).
      CREATE TABLE fingerprint_key (
        id    INTEGER PRIMARY KEY CHECK (id = 1),
        bytes BLOB NOT NULL CHECK (length(bytes) = 32)
      ) STRICT;
    )sql",
    R"sql(
      -- Where names are behind a passphrase (docs/decisions/0062), it opens this key, with which the
      -- keys of participants' names are sealed; 'identity' is NULL then.
      CREATE TABLE wrapped_key (
        id         INTEGER PRIMARY KEY CHECK (id = 1),
        salt       BLOB NOT NULL CHECK (length(salt) = 16),
        operations INTEGER NOT NULL,
        memory     INTEGER NOT NULL,
        sealed     BLOB NOT NULL
      ) STRICT;

      ALTER TABLE participant_key ADD COLUMN sealed_identity BLOB;
    )sql",
};

// SQLite's application ids of the files: the ASCII codes of the four characters beside each.
constexpr std::int32_t kStudyId = 0x50616c53;     // "PalS"
constexpr std::int32_t kTraceId = 0x50616c54;     // "PalT"
constexpr std::int32_t kIdentityId = 0x50616c49;  // "PalI"

}  // namespace

const Schema& studySchema() {
  static const Schema kSchema{kStudyId, "a palpate study", kStudySteps, 3};
  return kSchema;
}

const Schema& traceSchema() {
  static const Schema kSchema{kTraceId, "the traces of a palpate study", kTraceSteps};
  return kSchema;
}

const Schema& identitySchema() {
  static const Schema kSchema{kIdentityId, "the identities of a palpate study", kIdentitySteps, 2};
  return kSchema;
}

}  // namespace study::storage
