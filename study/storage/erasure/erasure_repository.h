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

/// That a participant was erased: what is left of a person besides code, cohort and times.
struct Erasure {
  std::int64_t id = 0;
  std::string participant;  ///< code
  ErasureLevel level = ErasureLevel::All;
  std::string reason;
  std::string utc;
  std::optional<std::string> finishedUtc;  ///< std::nullopt: something is left to do in other files
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
  /// Those in which something is left to do.
  std::vector<Erasure> unfinished() const;

 private:
  Database& database_;
};

}  // namespace study::storage
