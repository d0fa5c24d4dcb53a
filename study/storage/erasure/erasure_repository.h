#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/storage/database.h"

namespace study::storage {

/// What is erased of a participant.
enum class ErasureLevel {
  Identity,  ///< names and signatures
  Answers,   ///< answers, scores, votes, texts, traces, and their details in the audit trail
  All,       ///< both
};

inline constexpr bool erasesNames(ErasureLevel level) noexcept {
  return level != ErasureLevel::Answers;
}
inline constexpr bool erasesAnswers(ErasureLevel level) noexcept {
  return level != ErasureLevel::Identity;
}

/// "identity", "answers", "all"
std::string_view nameOf(ErasureLevel level) noexcept;
std::optional<ErasureLevel> erasureLevelNamed(std::string_view name) noexcept;

/// The record of an erasure. Beside it only the participant's code, cohort and times are kept.
struct Erasure {
  std::int64_t id = 0;
  std::string participant;  ///< code
  ErasureLevel level = ErasureLevel::All;
  std::string reason;
  std::string utc;
  /// std::nullopt: the erasure is not finished in the other files.
  std::optional<std::string> finishedUtc;
};

/// The table of erasures in study.db. It is empty in a file of an older format.
class ErasureRepository {
 public:
  explicit ErasureRepository(Database& database) : database_(database) {}

  /// Inserts a row, inside the caller's transaction. @return  the row's id
  std::int64_t add(const Erasure& erasure);
  /// Records that the erasure is finished in all files. One transaction.
  void finish(std::int64_t id, const std::string& utc);

  /// All erasures, the oldest first.
  std::vector<Erasure> all() const;
  /// Whether the answers of @p participant were erased.
  bool hasErasedAnswersOf(const std::string& participant) const;
  /// Erasures that are not finished in the other files.
  std::vector<Erasure> unfinished() const;

 private:
  Database& database_;
};

}  // namespace study::storage
