#include "study/session/analysis_plan_history.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/search.h"
#include "study/storage/records.h"

namespace study {
namespace {

using protocols::AnalysisPlan;
using protocols::Family;

std::set<std::set<std::string>> pairsOf(const Family& family) {
  std::set<std::set<std::string>> pairs;
  for (const auto& pair : family.comparisons) pairs.insert({pair.first, pair.second});
  return pairs;
}

/// Whether both plans have family @p id with equal declarations.
bool isAlikeIn(const AnalysisPlan& one, const AnalysisPlan& other, const std::string& id) {
  const auto* first = base::withId(one.families, id);
  const auto* second = base::withId(other.families, id);
  return first != nullptr && second != nullptr && differingKeys(*first, *second).empty();
}

/// Collects the changes of the analysis plan over the versions since the first live participant
/// began.
class PlanTracker {
 public:
  explicit PlanTracker(const AnalysisPlan& declared) : declared_(declared) {}

  /// Adds the changes that one version makes to the plan of the previous version.
  /// @param isUsed  whether a live participant began with this version
  void addVersion(
      const AnalysisPlan& before,
      const protocols::Protocol& after,
      const std::string& addedUtc,
      std::size_t participants,
      bool isUsed) {
    participants_ = participants;
    for (const auto& family : after.analysis.families) {
      const auto* earlier = base::withId(before.families, family.id);
      auto keys =
          earlier == nullptr ? std::vector<std::string_view>{} : differingKeys(*earlier, family);
      if (earlier != nullptr && keys.empty()) continue;
      auto kind = earlier == nullptr ? FamilyChange::Kind::Added : FamilyChange::Kind::Changed;
      if (isAlikeIn(declared_, after.analysis, family.id)) kind = FamilyChange::Kind::Restored;
      add(family, kind, after.study.version, addedUtc);
      if (kind != FamilyChange::Kind::Changed) continue;
      changes_.back().keys = std::move(keys);
      changes_.back().before = *earlier;
      changes_.back().after = family;
    }
    for (const auto& family : before.families) {
      if (base::withId(after.analysis.families, family.id) != nullptr) continue;
      add(family, FamilyChange::Kind::Removed, after.study.version, addedUtc);
    }
    if (!isUsed) return;
    for (const auto& family : declared_.families) {
      if (!isAlikeIn(declared_, after.analysis, family.id)) usedInOtherForm_.insert(family.id);
    }
  }

  /// Adds to @p history the families of @p now whose present form was not declared, and the changes
  /// to all families.
  void finish(const AnalysisPlan& now, AnalysisPlanHistory& history) {
    for (const auto& family : now.families) {
      const bool isKept = isAlikeIn(declared_, now, family.id);
      if (!isKept || usedInOtherForm_.contains(family.id)) history.undeclared.push_back(family.id);
    }
    for (auto& change : changes_) {
      if (change.kind == FamilyChange::Kind::Restored) continue;
      change.isHarmless =
          base::withId(now.families, change.family) != nullptr && history.isDeclared(change.family);
    }
    history.changes = std::move(changes_);
  }

 private:
  void add(
      const Family& family,
      FamilyChange::Kind kind,
      const std::string& version,
      const std::string& addedUtc) {
    changes_.push_back(
        {.family = family.id,
         .title = family.title,
         .kind = kind,
         .keys = {},
         .version = version,
         .addedUtc = addedUtc,
         .participants = participants_,
         .isHarmless =
             kind == FamilyChange::Kind::Restored && !usedInOtherForm_.contains(family.id)});
  }

  const AnalysisPlan& declared_;
  std::vector<FamilyChange> changes_;
  std::size_t participants_ = 0;  ///< who had begun before the version
  /// Families that differed from the declared plan in a version with which a live participant
  /// began.
  std::set<std::string> usedInOtherForm_;
};

}  // namespace

bool AnalysisPlanHistory::isDeclared(std::string_view family) const {
  return std::ranges::find(undeclared, family) == undeclared.end();
}

std::vector<std::string_view> differingKeys(const Family& before, const Family& after) {
  std::vector<std::string_view> keys;
  const auto note = [&](bool differs, std::string_view key) {
    if (differs) keys.push_back(key);
  };
  note(before.instrument != after.instrument, "instrument");
  note(before.items != after.items, "items");
  note(before.score != after.score, "score");
  note(before.blocks != after.blocks, "blocks");
  note(pairsOf(before) != pairsOf(after), "comparisons");
  note(before.test != after.test, "test");
  note(before.correction != after.correction, "correction");
  note(before.alpha != after.alpha, "alpha");
  note(before.equivalenceBound != after.equivalenceBound, "equivalence_bound");
  return keys;
}

AnalysisPlanHistory analysisPlanHistory(Study& study) {
  const auto ids = study.protocols().all();
  AnalysisPlanHistory history{.versions = ids.size(), .changes = {}, .undeclared = {}};
  const auto isFrozen = [&](ProtocolId id) {
    return study.protocols().load(id).frozenUtc.has_value();
  };
  const auto first = std::ranges::find_if(ids, isFrozen);
  if (first == ids.end()) return history;
  PlanTracker plan(study.protocol(*first).protocol.analysis);
  std::map<ProtocolId, std::size_t> begun;  // live participants of each version
  const storage::Records records(study.database(), storage::Records::Conditions::LeftOut);
  for (const auto& session : records.sessions()) {
    if (session.runMode == RunMode::Live) ++begun[session.protocol];
  }
  std::size_t participants = 0;
  for (auto id = first + 1; id != ids.end(); ++id) {
    ++history.versionsSinceBegun;
    participants += begun[*(id - 1)];
    const auto stored = study.protocols().load(*id);
    plan.addVersion(
        study.protocol(*(id - 1)).protocol.analysis,
        study.protocol(*id).protocol,
        stored.addedUtc,
        participants,
        stored.frozenUtc.has_value());
  }
  plan.finish(study.protocol().protocol.analysis, history);
  return history;
}

}  // namespace study
