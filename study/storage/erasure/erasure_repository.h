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
  Answers,   ///< answers, scores, votes, texts, traces; what the audit trail says of them
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

/// The record of an erasure. Besides it only code, cohort and times of the participant are left.
struct Erasure {
  std::int64_t id = 0;
  std::string participant;  ///< code
  ErasureLevel level = ErasureLevel::All;
  std::string reason;
  std::string utc;
  /// std::nullopt: the work in other files is not finished.
  std::optional<std::string> finishedUtc;
};

/// The table of erasures in study.db. It is empty in a file of an older format.
class ErasureRepository {
 public:
  explicit ErasureRepository(Database& database) : database_(database) {}

  /// Inside the caller's transaction. @return  its id
  std::int64_t add(const Erasure& erasure);
  /// One transaction.
  void finish(std::int64_t id, const std::string& utc);

  /// In order of time.
  std::vector<Erasure> all() const;
  /// Whether the answers of a participant were erased.
  bool hasErasedAnswersOf(const std::string& participant) const;
  /// Erasures whose work in other files is not finished.
  std::vector<Erasure> unfinished() const;

 private:
  Database& database_;
};

}  // namespace study::storage
