#include "study/storage/identity_store.h"

#include <algorithm>
#include <span>

#include "study/storage/hasher.h"
#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

void bindPlace(Statement& statement, const IdentityStore::Place& place, const std::string& item) {
  statement.bind(1, place.participant)
      .bind(2, std::int64_t{place.sessionNumber})
      .bind(3, std::int64_t{place.step})
      .bind(4, std::int64_t{place.attempt})
      .bind(5, item);
}

Hash hashOfRow(
    const IdentityStore::Place& place,
    const std::string& item,
    const std::string& text,
    const std::string& utc) {
  Hasher hasher;
  hasher.add(place.participant);
  for (const int number : {place.sessionNumber, place.step, place.attempt}) {
    hasher.add(std::optional(std::int64_t{number}));
  }
  hasher.add(item);
  hasher.add(text);
  hasher.add(utc);
  return hasher.finish();
}

}  // namespace

void IdentityStore::put(
    const Place& place, const std::string& item, const std::string& text, const std::string& utc) {
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT OR REPLACE INTO identifying_answer "
      "(participant, session_number, step, attempt, item, text, saved_utc, hash) VALUES "
      "(?,?,?,?,?,?,?,?)");
  const Hash hash = hashOfRow(place, item, text, utc);
  bindPlace(insert, place, item);
  insert.bind(6, text).bind(7, utc).bind(8, std::span<const std::byte>(hash));
  insert.run();
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

bool IdentityStore::has(const Place& place, const std::string& item) const {
  Statement select(
      database_,
      "SELECT 1 FROM identifying_answer WHERE participant = ? AND session_number = ? AND step = ? "
      "AND attempt = ? AND item = ? AND text <> ''");
  bindPlace(select, place, item);
  return select.step();
}

std::vector<std::string> IdentityStore::texts() const {
  Statement select(
      database_, "SELECT DISTINCT text FROM identifying_answer WHERE text <> '' ORDER BY text");
  std::vector<std::string> texts;
  while (select.step()) texts.push_back(select.text(0));
  return texts;
}

void IdentityStore::put(const BlindingSecret& secret) {
  Transaction transaction(database_);
  Statement insert(database_, "INSERT INTO blinding_secret (id, bytes) VALUES (1, ?)");
  insert.bind(1, std::as_bytes(std::span(secret.bytes())));
  insert.run();
  transaction.commit();
}

std::optional<BlindingSecret> IdentityStore::blindingSecret() const {
  // A file of format 2 that is only read does not have the table.
  Statement table(
      database_, "SELECT 1 FROM sqlite_schema WHERE type = 'table' AND name = 'blinding_secret'");
  if (!table.step()) return std::nullopt;
  Statement select(database_, "SELECT bytes FROM blinding_secret WHERE id = 1");
  if (!select.step()) return std::nullopt;
  const auto stored = select.blob(0);
  BlindingSecret::Bytes bytes{};
  if (stored.size() != bytes.size()) return std::nullopt;
  std::transform(stored.begin(), stored.end(), bytes.begin(), std::to_integer<unsigned char>);
  return BlindingSecret(bytes);
}

std::vector<std::string> IdentityStore::damaged() const {
  Statement select(
      database_,
      "SELECT participant, session_number, step, attempt, item, text, saved_utc, hash "
      "FROM identifying_answer WHERE hash IS NOT NULL ORDER BY rowid");
  std::vector<std::string> damaged;
  while (select.step()) {
    const Place place{
        .participant = select.text(0),
        .sessionNumber = static_cast<int>(select.number(1)),
        .step = static_cast<int>(select.number(2)),
        .attempt = static_cast<int>(select.number(3))};
    const auto hash = hashOfRow(place, select.text(4), select.text(5), select.text(6));
    if (select.blob(7) != asBytes(hash))
      damaged.push_back(place.participant + ", " + select.text(4));
  }
  return damaged;
}

}  // namespace study::storage
