#include "study/storage/identity_store.h"

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

}  // namespace

void IdentityStore::put(
    const Place& place, const std::string& item, const std::string& text, const std::string& utc) {
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT OR REPLACE INTO identifying_answer "
      "(participant, session_number, step, attempt, item, text, saved_utc) VALUES (?,?,?,?,?,?,?)");
  bindPlace(insert, place, item);
  insert.bind(6, text).bind(7, utc);
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

}  // namespace study::storage
