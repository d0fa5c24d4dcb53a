#include "study/plan_history.h"

#include <algorithm>
#include <set>

namespace study {
namespace {

using protocols::Family;

std::set<std::set<std::string>> pairsOf(const Family& family) {
  std::set<std::set<std::string>> pairs;
  for (const auto& pair : family.comparisons) pairs.insert({pair.first, pair.second});
  return pairs;
}

const Family* familyIn(const protocols::AnalysisPlan& plan, const std::string& id) {
  const auto found = std::find_if(
      plan.families.begin(), plan.families.end(), [&](const auto& f) { return f.id == id; });
  return found == plan.families.end() ? nullptr : &*found;
}

/// What one version did to the plan of the version before it.
void compareVersions(
    const protocols::AnalysisPlan& before,
    const protocols::Protocol& after,
    const std::string& addedUtc,
    std::vector<FamilyChange>& changes) {
  const auto add = [&](const Family& family, FamilyChange::Kind kind) {
    changes.push_back(
        {.family = family.id,
         .title = family.title,
         .kind = kind,
         .keys = {},
         .version = after.study.version,
         .addedUtc = addedUtc});
  };
  for (const auto& family : after.analysis.families) {
    const auto* earlier = familyIn(before, family.id);
    if (earlier == nullptr) {
      add(family, FamilyChange::Kind::Added);
    } else if (auto keys = differingKeys(*earlier, family); !keys.empty()) {
      add(family, FamilyChange::Kind::Changed);
      changes.back().keys = std::move(keys);
    }
  }
  for (const auto& family : before.families) {
    if (familyIn(after.analysis, family.id) == nullptr) add(family, FamilyChange::Kind::Removed);
  }
}

}  // namespace

bool PlanHistory::isDeclared(std::string_view family) const {
  return std::find(undeclared.begin(), undeclared.end(), family) == undeclared.end();
}

std::vector<std::string_view> differingKeys(const Family& before, const Family& after) {
  std::vector<std::string_view> keys;
  const auto note = [&](bool differs, std::string_view key) {
    if (differs) keys.push_back(key);
  };
  note(before.instrument != after.instrument, "instrument");
  note(before.blocks != after.blocks, "blocks");
  note(pairsOf(before) != pairsOf(after), "comparisons");
  note(before.test != after.test, "test");
  note(before.correction != after.correction, "correction");
  note(before.alpha != after.alpha, "alpha");
  note(before.equivalenceBound != after.equivalenceBound, "equivalence_bound");
  return keys;
}

PlanHistory planHistory(Study& study) {
  const auto ids = study.protocols().all();
  PlanHistory history{.versions = ids.size(), .changes = {}, .undeclared = {}};
  const auto isFrozen = [&](ProtocolId id) {
    return study.protocols().load(id).frozenUtc.has_value();
  };
  const auto first = std::find_if(ids.begin(), ids.end(), isFrozen);
  if (first == ids.end()) return history;
  for (auto id = first + 1; id != ids.end(); ++id) {
    ++history.versionsSinceBegun;
    compareVersions(
        study.protocol(*(id - 1)).protocol.analysis,
        study.protocol(*id).protocol,
        study.protocols().load(*id).addedUtc,
        history.changes);
  }
  const auto& declared = study.protocol(*first).protocol.analysis;
  for (const auto& family : study.protocol().protocol.analysis.families) {
    const auto* earlier = familyIn(declared, family.id);
    if (earlier == nullptr || !differingKeys(*earlier, family).empty()) {
      history.undeclared.push_back(family.id);
    }
  }
  return history;
}

}  // namespace study
