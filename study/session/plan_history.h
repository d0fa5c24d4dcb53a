#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "study/session/study.h"

namespace study {

/// What a version of the protocol did to a family of comparisons after the first live participant
/// had begun: whoever did it may have seen data.
struct FamilyChange {
  /// PutBack: it then stood again as it had when the first live participant began.
  enum class Kind { Added, Changed, Removed, PutBack };

  std::string family;  ///< its id
  std::string title;
  Kind kind = Kind::Changed;
  std::vector<std::string_view> keys;  ///< Changed: which of its keys in the protocol
  std::string version;                 ///< of the protocol, as its authors name it
  std::string addedUtc;                ///< when that version came into the study, ISO 8601
  /// Changed, Added: whether its family is declared all the same, as it was put back in time.
  /// PutBack: whether no live participant had begun with a version in which it was otherwise.
  bool isHarmless = false;
};

/// What became of the analysis plan since it was first kept.
struct PlanHistory {
  std::size_t versions = 1;             ///< of the protocol
  std::size_t versionsSinceBegun = 0;   ///< of these, after the first live participant had begun
  std::vector<FamilyChange> changes;    ///< the oldest first
  std::vector<std::string> undeclared;  ///< families that were not declared as they now stand

  /// Whether @p family stands in the protocol as it did in every version with which a live
  /// participant began, or nobody has begun yet: only then its declared test is confirmatory. One
  /// that was changed and put back before anybody took part in between is declared; otherwise it is
  /// not, since some of the data came under another plan, and whoever put it back had two plans to
  /// choose from with more data at hand.
  bool isDeclared(std::string_view family) const;
};

/// @throws storage::StorageError
PlanHistory planHistory(Study& study);

/// In which keys two families differ; their titles do not count, nor the order of comparisons.
std::vector<std::string_view> differingKeys(
    const protocols::Family& before, const protocols::Family& after);

}  // namespace study
