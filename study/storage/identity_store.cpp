#include "study/storage/identity_store.h"

#include <algorithm>
#include <set>
#include <span>

#include <fmt/format.h>

#include "study/storage/hasher.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

using Place = IdentityStore::Place;

void bindPlace(Statement& statement, const Place& place, const std::string& item) {
  statement.bindAll(place.participant, place.sessionNumber, place.step, place.attempt, item);
}

/// A row of identifying_answer.
struct NameRow {
  Place place;
  std::string item;
  std::string text;  ///< empty if the text is sealed
  std::string utc;
  std::vector<std::byte> sealed;
  std::vector<std::byte> writtenHash = {};  ///< empty if format 1 wrote the row

  Hash hash() const {
    Hasher hasher;
    hasher.add(place.participant);
    for (const int number : {place.sessionNumber, place.step, place.attempt}) {
      hasher.add(std::optional(std::int64_t{number}));
    }
    hasher.add(item);
    hasher.add(text);
    hasher.add(utc);
    // Left out if empty: older formats were hashed without it.
    if (!sealed.empty()) hasher.add(std::span<const std::byte>(sealed));
    return hasher.finish();
  }

  void seal(const SealingKey& key) {
    sealed = key.seal(text, place.rowOf(item));
    text.clear();
  }

  /// std::nullopt if the text is sealed and cannot be unsealed.
  std::optional<std::string> opened(const std::optional<SealingKey>& key) const {
    if (sealed.empty()) return text;
    return key ? key->open(sealed, place.rowOf(item)) : std::nullopt;
  }
};

std::vector<NameRow> nameRows(
    const Database& database, const std::optional<std::string>& participant) {
  // A file of an older format that was opened for reading only lacks the column `sealed`.
  const std::string sealed = database.hasTable("participant_key") ? "sealed" : "NULL";
  Statement select(
      database,
      "SELECT participant, session_number, step, attempt, item, text, saved_utc, hash, " + sealed +
          " FROM identifying_answer" + (participant ? " WHERE participant = ?" : "") +
          " ORDER BY participant, session_number, step, attempt, item");
  if (participant) select.bindAll(*participant);
  std::vector<NameRow> rows;
  while (select.step()) {
    rows.push_back(
        {.place =
             {.participant = select.text(0),
              .sessionNumber = static_cast<int>(select.number(1)),
              .step = static_cast<int>(select.number(2)),
              .attempt = static_cast<int>(select.number(3))},
         .item = select.text(4),
         .text = select.text(5),
         .utc = select.text(6),
         .sealed = select.blob(8),
         .writtenHash = select.blob(7)});
  }
  return rows;
}

void insert(Database& database, const NameRow& row) {
  Statement statement(
      database,
      "INSERT OR REPLACE INTO identifying_answer "
      "(participant, session_number, step, attempt, item, text, saved_utc, hash, sealed) VALUES "
      "(?,?,?,?,?,?,?,?,?)");
  bindPlace(statement, row.place, row.item);
  const Hash hash = row.hash();
  statement.bind(6, row.text).bind(7, row.utc).bind(8, std::span<const std::byte>(hash));
  if (!row.sealed.empty()) statement.bind(9, std::span<const std::byte>(row.sealed));
  statement.run();
}

void insertSecret(Database& database, const std::string& table, const BlindingSecret& secret) {
  Transaction transaction(database);
  Statement insert(database, "INSERT INTO " + table + " (id, bytes) VALUES (1, ?)");
  insert.bindAll(std::as_bytes(std::span(secret.bytes())));
  insert.run();
  transaction.commit();
}

/// The secret in a table; std::nullopt also in a file of an older format that was opened for
/// reading only, which lacks the table.
std::optional<BlindingSecret> secretIn(const Database& database, const std::string& table) {
  if (!database.hasTable(table)) return std::nullopt;
  Statement select(database, "SELECT bytes FROM " + table + " WHERE id = 1");
  if (!select.step()) return std::nullopt;
  const auto bytes = fixedBytes<BlindingSecret::Bytes>(select.blob(0));
  return bytes ? std::optional(BlindingSecret(*bytes)) : std::nullopt;
}

std::optional<SealingKey> keyFrom(std::span<const std::byte> stored) {
  const auto bytes = fixedBytes<SealingKey::Bytes>(stored);
  return bytes ? std::optional(SealingKey(*bytes)) : std::nullopt;
}

/// The associated data of a participant's sealed Identity key.
std::string placeOf(const std::string& participant) {
  return participant + "/key of names";
}

std::vector<std::byte> sealedKey(
    const SealingKey& names, const SealingKey& key, const std::string& participant) {
  const std::string_view bytes(
      reinterpret_cast<const char*>(key.bytes().data()), key.bytes().size());
  return names.seal(bytes, placeOf(participant));
}

/// A participant's stored Identity key, unsealed or sealed. Both members are empty if it was
/// destroyed or never drawn.
struct StoredKey {
  std::vector<std::byte> open;
  std::vector<std::byte> sealed;
};

std::optional<StoredKey> storedKey(const Database& database, const std::string& participant) {
  // A file of an older format that was opened for reading only lacks the column `sealed_identity`.
  const std::string sealed =
      database.hasColumn("participant_key", "sealed_identity") ? "sealed_identity" : "NULL";
  Statement select(
      database, "SELECT identity, " + sealed + " FROM participant_key WHERE participant = ?");
  select.bindAll(participant);
  if (!select.step()) return std::nullopt;
  return StoredKey{.open = select.blob(0), .sealed = select.blob(1)};
}

void requireUnlocked(const IdentityStore& store, const std::string& path) {
  if (!store.isLocked()) return;
  throw StorageError(
      "The names in " + path +
      " are behind a passphrase that was not given. Open the study again and type it; without it "
      "no session goes on.");
}

}  // namespace

std::string IdentityStore::Place::rowOf(const std::string& item) const {
  return fmt::format("{}/{}/{}/{}/{}", participant, sessionNumber, step, attempt, item);
}

void IdentityStore::put(
    const Place& place, const std::string& item, const std::string& text, const std::string& utc) {
  Transaction transaction(database_);
  NameRow row{.place = place, .item = item, .text = text, .utc = utc, .sealed = {}};
  if (const auto identity = key(Key::Identity, place.participant)) row.seal(*identity);
  insert(database_, row);
  transaction.commit();
}

void IdentityStore::remove(const Place& place, const std::string& item) {
  Transaction transaction(database_);
  Statement remove(
      database_,
      "DELETE FROM identifying_answer WHERE participant = ? AND session_number = ? AND step = ? "
      "AND attempt = ? AND item = ?");
  bindPlace(remove, place, item);
  remove.run();
  transaction.commit();
}

void IdentityStore::removeSession(const std::string& participant, int sessionNumber) {
  // With this setting SQLite overwrites deleted content with zeros; in Debian it is the default.
  database_.execute("PRAGMA secure_delete = ON");
  Transaction transaction(database_);
  Statement remove(
      database_, "DELETE FROM identifying_answer WHERE participant = ? AND session_number = ?");
  remove.bindAll(participant, sessionNumber).run();
  transaction.commit();
}

bool IdentityStore::has(const Place& place, const std::string& item) const {
  for (const auto& row : nameRows(database_, place.participant)) {
    if (row.place.rowOf(row.item) != place.rowOf(item)) continue;
    const auto text = row.opened(key(Key::Identity, place.participant));
    return text && !text->empty();
  }
  return false;
}

std::vector<IdentityStore::Name> IdentityStore::names(
    const std::optional<std::string>& participant) const {
  std::vector<Name> names;
  for (const auto& row : nameRows(database_, participant)) {
    auto text = row.opened(key(Key::Identity, row.place.participant));
    if (text && !text->empty()) {
      names.push_back({row.place.participant, row.item, std::move(*text)});
    }
  }
  return names;
}

std::vector<std::string> IdentityStore::texts() const {
  std::set<std::string> texts;
  for (auto& name : names()) texts.insert(std::move(name.text));
  return {texts.begin(), texts.end()};
}

std::size_t IdentityStore::count(const std::string& participant) const {
  return nameRows(database_, participant).size();
}

void IdentityStore::drawKeys(const std::string& participant) {
  requireUnlocked(*this, database_.path());
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT OR IGNORE INTO participant_key (participant, identity, content, sealed_identity) "
      "VALUES (?,?,?,?)");
  const auto identity = SealingKey::drawn();
  const auto content = SealingKey::drawn();
  insert.bind(1, participant).bind(3, std::as_bytes(std::span(content.bytes())));
  std::vector<std::byte> sealed;
  if (hasPassphrase()) {
    sealed = sealedKey(*database_.key(), identity, participant);
    insert.bind(4, std::span<const std::byte>(sealed));
  } else {
    insert.bind(2, std::as_bytes(std::span(identity.bytes())));
  }
  insert.run();
  transaction.commit();
}

bool IdentityStore::hasDrawnKeys(const std::string& participant) const {
  return storedKey(database_, participant).has_value();
}

void IdentityStore::drawMissingKey(Key kind, const std::string& participant) {
  if (kind == Key::Identity) requireUnlocked(*this, database_.path());
  if (key(kind, participant)) return;
  const auto drawn = SealingKey::drawn();
  const auto bytes = std::as_bytes(std::span(drawn.bytes()));
  std::vector<std::byte> stored(bytes.begin(), bytes.end());
  const char* column = kind == Key::Content ? "content" : "identity";
  if (kind == Key::Identity && hasPassphrase()) {
    column = "sealed_identity";
    stored = sealedKey(*database_.key(), drawn, participant);
  }
  Transaction transaction(database_);
  Statement insert(
      database_,
      fmt::format(
          "INSERT INTO participant_key (participant, {0}) VALUES (?, ?) "
          "ON CONFLICT (participant) DO UPDATE SET {0} = excluded.{0}",
          column));
  insert.bindAll(participant, stored).run();
  transaction.commit();
}

bool IdentityStore::hasPassphrase() const {
  // A file of an older format that was opened for reading only lacks the table.
  if (!database_.hasTable("wrapped_key")) return false;
  return Statement(database_, "SELECT 1 FROM wrapped_key").step();
}

bool IdentityStore::hasUnsealedNames() const {
  const auto rows = nameRows(database_, std::nullopt);
  return std::ranges::any_of(rows, [](const auto& row) { return row.sealed.empty(); });
}

std::set<std::string> IdentityStore::sealUnsealedNames() {
  std::set<std::string> sealed;
  Transaction transaction(database_);
  for (auto& row : nameRows(database_, std::nullopt)) {
    const auto identity = key(Key::Identity, row.place.participant);
    if (!row.sealed.empty() || !identity) continue;
    row.seal(*identity);
    insert(database_, row);
    sealed.insert(row.place.participant);
  }
  transaction.commit();
  return sealed;
}

void IdentityStore::sealKeysWith(const SealingKey& key) {
  std::vector<std::string> participants;
  Statement open(database_, "SELECT participant FROM participant_key WHERE identity IS NOT NULL");
  while (open.step()) participants.push_back(open.text(0));
  open.reset();
  for (const auto& participant : participants) {
    const auto identity = this->key(Key::Identity, participant);
    if (!identity) continue;
    Statement update(
        database_,
        "UPDATE participant_key SET identity = NULL, sealed_identity = ? WHERE participant = ?");
    const auto sealed = sealedKey(key, *identity, participant);
    update.bindAll(sealed, participant).run();
  }
}

void IdentityStore::putContentKey(const std::string& participant, const SealingKey& key) {
  Statement insert(
      database_, "INSERT INTO participant_key (participant, identity, content) VALUES (?,NULL,?)");
  insert.bindAll(participant, std::as_bytes(std::span(key.bytes())));
  insert.run();
}

std::optional<SealingKey> IdentityStore::key(Key kind, const std::string& participant) const {
  if (!database_.hasTable("participant_key")) return std::nullopt;
  if (kind == Key::Content) {
    Statement select(database_, "SELECT content FROM participant_key WHERE participant = ?");
    select.bindAll(participant);
    return select.step() ? keyFrom(select.blob(0)) : std::nullopt;
  }
  const auto stored = storedKey(database_, participant);
  if (!stored) return std::nullopt;
  if (stored->sealed.empty()) return keyFrom(stored->open);
  requireUnlocked(*this, database_.path());
  const auto bytes = database_.key()->open(stored->sealed, placeOf(participant));
  return bytes ? keyFrom(std::as_bytes(std::span(*bytes))) : std::nullopt;
}

void IdentityStore::destroy(Key kind, const std::string& participant) {
  // With this setting SQLite overwrites deleted content with zeros; in Debian it is the default.
  database_.execute("PRAGMA secure_delete = ON");
  Transaction transaction(database_);
  Statement key(
      database_,
      std::string("UPDATE participant_key SET ") +
          (kind == Key::Identity ? "identity = NULL, sealed_identity = NULL" : "content = NULL") +
          " WHERE participant = ?");
  key.bindAll(participant).run();
  if (kind == Key::Identity) {
    Statement names(database_, "DELETE FROM identifying_answer WHERE participant = ?");
    names.bindAll(participant).run();
  }
  transaction.commit();
}

void IdentityStore::put(const BlindingSecret& secret) {
  insertSecret(database_, "blinding_secret", secret);
}

std::optional<BlindingSecret> IdentityStore::blindingSecret() const {
  return secretIn(database_, "blinding_secret");
}

void IdentityStore::storeFingerprintSecret(const BlindingSecret& secret) {
  insertSecret(database_, "fingerprint_key", secret);
}

std::optional<BlindingSecret> IdentityStore::fingerprintSecret() const {
  return secretIn(database_, "fingerprint_key");
}

std::vector<std::string> IdentityStore::damaged() const {
  std::vector<std::string> damaged;
  for (const auto& row : nameRows(database_, std::nullopt)) {
    const bool isSound = row.writtenHash.empty() || row.writtenHash == asBytes(row.hash());
    const bool isOpened =
        isLocked() || row.opened(key(Key::Identity, row.place.participant)).has_value();
    if (!isSound || !isOpened) {
      damaged.push_back(row.place.participant + ", " + row.item);
    }
  }
  return damaged;
}

}  // namespace study::storage
