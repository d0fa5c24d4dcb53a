#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "study/session/study.h"

namespace study {

/// A change that a version of the protocol made to a family of comparisons after the first live
/// participant had begun. The author of that version may have seen data.
struct FamilyChange {
  /// Restored: the family became again what it had been when the first live participant began.
  enum class Kind { Added, Changed, Removed, Restored };

  std::string family;  ///< its id
  std::string title;
  Kind kind = Kind::Changed;
  std::vector<std::string_view> keys;  ///< Changed: the JSON keys whose values changed
  std::optional<protocols::Family> before = std::nullopt;  ///< Changed: as it was
  std::optional<protocols::Family> after = std::nullopt;   ///< Changed: as it is since then
  std::string version;                                     ///< of the protocol: its "version"
  std::string addedUtc;          ///< when that version was added to the study, ISO 8601
  std::size_t participants = 0;  ///< live ones who had begun with an older version
  /// Changed, Added: true if the family counts as declared nevertheless (see isDeclared()), because
  /// it was restored in time. Restored: true if no live participant had begun with a version in
  /// which the family differed.
  bool isHarmless = false;
};

/// All changes to the analysis plan since the first live participant began.
struct AnalysisPlanHistory {
  std::size_t versions = 1;             ///< of the protocol
  std::size_t versionsSinceBegun = 0;   ///< how many of them were added after the first live
                                        ///< participant had begun
  std::vector<FamilyChange> changes;    ///< the oldest first
  std::vector<std::string> undeclared;  ///< families that were not declared in time as they are now

  /// Whether the declared test of @p family is confirmatory. It is if no live participant has begun
  /// yet, or if the family is now as in every version with which a live participant began. A family
  /// that was changed and restored before any participant began in between is therefore
  /// confirmatory. Otherwise the test is exploratory: some of the data were collected under another
  /// plan, and the author of the present plan could choose between two plans with more data at
  /// hand.
  bool isDeclared(std::string_view family) const;
};

/// @throws storage::StorageError
AnalysisPlanHistory analysisPlanHistory(Study& study);

/// The keys in which two families differ. Titles and the order of comparisons are not compared.
std::vector<std::string_view> differingKeys(
    const protocols::Family& before, const protocols::Family& after);

}  // namespace study
