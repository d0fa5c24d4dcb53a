#include "study/storage/erasure/erasure_repository.h"

#include <algorithm>
#include <array>

#include "study/model/named_value.h"
#include "study/storage/session_repository.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr std::array<std::string_view, 3> kLevels{"identity", "answers", "all"};

}  // namespace

std::string_view nameOf(ErasureLevel level) noexcept {
  return kLevels[static_cast<std::size_t>(level)];
}

std::optional<ErasureLevel> erasureLevelNamed(std::string_view name) noexcept {
  return valueNamed<ErasureLevel>(kLevels, name);
}

std::int64_t ErasureRepository::add(const Erasure& erasure) {
  Statement insert(
      database_,
      "INSERT INTO erasure (participant, level, reason, erased_utc, finished_utc) "
      "VALUES (?, ?, ?, ?, ?)");
  insert.bindAll(
      erasure.participant, nameOf(erasure.level), erasure.reason, erasure.utc, erasure.finishedUtc);
  insert.run();
  return database_.lastInsertedId();
}

void ErasureRepository::finish(std::int64_t id, const std::string& utc) {
  Transaction transaction(database_);
  Statement update(database_, "UPDATE erasure SET finished_utc = ? WHERE id = ?");
  update.bindAll(utc, id);
  update.run();
  transaction.commit();
}

std::vector<Erasure> ErasureRepository::all() const {
  std::vector<Erasure> erasures;
  if (!database_.hasTable("erasure")) return erasures;
  Statement select(
      database_,
      "SELECT id, participant, level, reason, erased_utc, finished_utc FROM erasure ORDER BY id");
  while (select.step()) {
    erasures.push_back(
        {.id = select.number(0),
         .participant = select.text(1),
         .level = requireKnown(erasureLevelNamed(select.text(2)), select.text(2)),
         .reason = select.text(3),
         .utc = select.text(4),
         .finishedUtc = select.optionalText(5)});
  }
  return erasures;
}

bool ErasureRepository::hasErasedAnswersOf(const std::string& participant) const {
  return std::ranges::any_of(all(), [&](const Erasure& erasure) {
    return erasure.participant == participant && erasesAnswers(erasure.level);
  });
}

std::vector<Erasure> ErasureRepository::unfinished() const {
  auto erasures = all();
  std::erase_if(erasures, [](const Erasure& erasure) { return erasure.finishedUtc.has_value(); });
  return erasures;
}

}  // namespace study::storage
