"""The audit trail's scheme, written again from the sources: what anyone needs who may write a study's folder and forges it.

'Forger' opens a study's files without the program, lets a test change what it likes, and computes the trail again, so
that every hash fits. It has all keys that lie in the folder. The one key that it has not is the station's.
"""
import ctypes
import ctypes.util
import hashlib
import os
import pathlib
import re
import sqlite3
import struct

SOURCES = pathlib.Path(__file__).resolve().parents[2] / "study" / "storage"
COLUMNS = ["seq", "session_id", "step", "attempt", "utc", "monotonic_ns", "actor", "kind", "detail", "hash", "content_hash"]
TO_SEAL, TO_HASH = 1, 2


def queries(name):
    """The SELECTs of a table in content_hash.cpp, or the one of that name."""
    text = (SOURCES / "content_hash.cpp").read_text(encoding="utf-8")
    found = re.search(rf"{name}(?:\{{|\s*=\s*)(.*?)(?:\}};|;\n)", text, re.S)
    if not found:
        return []
    entries = re.findall(r'(?:"[^"]*"\s*)+', found[1])
    return ["".join(re.findall(r'"([^"]*)"', entry)) for entry in entries]


def blake(data, key=b""):
    return hashlib.blake2b(data, digest_size=32, key=key).digest()


def field(data):
    return f"{len(data)}:".encode() + data


def number(value):
    return field(b"-" if value is None else str(value).encode())


def exact(value):
    if value is None:
        return b"n"
    if isinstance(value, int):
        return b"i" + str(value).encode()
    if isinstance(value, float):
        return b"r" + struct.pack("=d", value)
    return b"b" + value if isinstance(value, bytes) else b"t" + value.encode()


def derived(key, purpose):
    """crypto_kdf of libsodium."""
    return hashlib.blake2b(b"", digest_size=32, key=key, salt=struct.pack("<Q", purpose) + bytes(8),
                           person=b"palpate1" + bytes(8)).digest()


def sodium():
    return ctypes.CDLL(ctypes.util.find_library("sodium") or "libsodium.so.23")


def seal(text, place, key):
    nonce = os.urandom(24)
    out = ctypes.create_string_buffer(len(text) + 16)
    sodium().crypto_aead_xchacha20poly1305_ietf_encrypt(
        out, None, text, ctypes.c_ulonglong(len(text)), place, ctypes.c_ulonglong(len(place)), None, nonce,
        derived(key, TO_SEAL))
    return nonce + out.raw


def opened(sealed, place, key):
    text = ctypes.create_string_buffer(max(len(sealed) - 40, 1))
    code = sodium().crypto_aead_xchacha20poly1305_ietf_decrypt(
        text, None, None, sealed[24:], ctypes.c_ulonglong(len(sealed) - 24), place, ctypes.c_ulonglong(len(place)),
        sealed[:24], derived(key, TO_SEAL))
    if code != 0:
        raise ValueError("an event cannot be opened")
    return text.raw[:len(sealed) - 40]


class Forger:
    """A study's files, opened without the program."""

    def __init__(self, folder):
        self.study = sqlite3.connect(pathlib.Path(folder) / "study.db")
        self.identity = sqlite3.connect(pathlib.Path(folder) / "identity.db")
        self.traces = sqlite3.connect(pathlib.Path(folder) / "traces.db")
        self.is_sealed = any(row[1] == "sealed" for row in self.study.execute("PRAGMA table_info(event)"))
        self.events = [self.read(row) for row in self.study.execute(
            f"SELECT {', '.join(COLUMNS)}{', sealed' if self.is_sealed else ''} FROM event ORDER BY seq")]

    def key_of(self, session):
        """The content key of a session's participant, or None."""
        if session is None or not self.has_keys():
            return None
        code = self.study.execute("SELECT p.code FROM session s JOIN participant p ON p.id = s.participant_id "
                                  "WHERE s.id = ?", (session,)).fetchone()
        found = code and self.identity.execute("SELECT content FROM participant_key WHERE participant = ?", code).fetchone()
        return found[0] if found else None

    def has_keys(self):
        return self.identity.execute("SELECT 1 FROM sqlite_master WHERE name = 'participant_key'").fetchone() is not None

    def secret(self):
        """What fingerprints of names are made with."""
        return self.identity.execute("SELECT bytes FROM fingerprint_key").fetchone()[0]

    def read(self, row):
        event = dict(zip(COLUMNS, row))
        event["sealed"] = row[len(COLUMNS)] if self.is_sealed else None
        event["stays"] = False
        if event["sealed"]:
            key = self.key_of(event["session_id"])
            try:
                event["detail"] = opened(event["sealed"], f"{event['seq']}/{event['kind']}".encode(), key).decode()
            except ValueError:
                event["stays"] = True  # it needs the study's key besides, which is not in the folder
        return event

    def content(self, session):
        """The hash of what the tables hold of a session, or of the study itself."""
        data = b""
        for query in queries("kSessionQueries") if session is not None else queries("kStudyQueries"):
            for row in self.study.execute(query, (session,) if session is not None else ()):
                data += field(b"row") + b"".join(field(exact(value)) for value in row)
            data += field(b"end")
        for name in ("kSealedConditions", "kSealedTrials") if session is not None else ():
            sealed = self.study.execute(queries(name)[0], (session,)).fetchall()
            for row in sealed:
                data += field(b"row") + b"".join(field(exact(value)) for value in row)
            data += field(b"end") if sealed else b""
        key = self.key_of(session)
        return blake(data, derived(key, TO_HASH) if key else b"")

    def unguard(self, database, table=None):
        """Takes triggers away, and returns what puts them back."""
        triggers = database.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger' AND (? IS NULL OR tbl_name = ?)",
                                    (table, table)).fetchall()
        for name, _ in triggers:
            database.execute(f'DROP TRIGGER "{name}"')
        return [sql for _, sql in triggers]

    def write(self):
        """Computes the trail again, from the first event to the last, and stores everything."""
        guards = self.unguard(self.study)
        self.study.execute("DELETE FROM event")
        last = {event["session_id"]: index for index, event in enumerate(self.events)}
        previous = b""
        for index, event in enumerate(self.events):
            event["seq"] = index + 1
            if last[event["session_id"]] == index:
                event["content_hash"] = self.content(event["session_id"])
            previous = event["hash"] = self.insert(event, previous)
        for sql in guards:
            self.study.execute(sql)
        for database in (self.study, self.identity, self.traces):
            database.commit()
            database.close()

    def insert(self, event, previous):
        detail, sealed = event["detail"], None
        if event["stays"]:
            sealed = event["sealed"]
        elif event["sealed"]:
            sealed = seal(detail.encode(), f"{event['seq']}/{event['kind']}".encode(), self.key_of(event["session_id"]))
            detail = ""
        data = field(previous)
        data += b"".join(number(event[name]) for name in ("seq", "session_id", "step", "attempt"))
        data += field(event["utc"].encode()) + number(event["monotonic_ns"])
        data += b"".join(field(text.encode()) for text in (event["actor"], event["kind"], detail))
        if sealed:
            data += field(b"sealed") + field(sealed)
        if event["content_hash"]:
            data += field(event["content_hash"])
        digest = blake(data)
        values = [event[name] for name in COLUMNS[:8]] + [detail, digest, event["content_hash"]]
        marks = ", ".join("?" * (len(values) + self.is_sealed))
        self.study.execute(f"INSERT INTO event ({', '.join(COLUMNS)}{', sealed' if self.is_sealed else ''}) VALUES ({marks})",
                           values + ([sealed] if self.is_sealed else []))
        return digest
