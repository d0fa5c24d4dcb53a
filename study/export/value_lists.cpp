#include "study/export/value_lists.h"

#include <algorithm>
#include <set>

#include "questionnaires/model/instrument.h"
#include "study/export/condition_codes.h"
#include "study/model/trial_record.h"
#include "study/storage/records.h"

namespace study {
namespace {

/// The levels of enumerators whose names are also their labels.
template <typename Value>
std::vector<Level> levelsNamed(
    std::initializer_list<Value> values, std::string_view (*nameOfValue)(Value) noexcept) {
  std::vector<Level> levels;
  for (const auto value : values) {
    const std::string name(nameOfValue(value));
    levels.push_back({name, name});
  }
  return levels;
}

std::vector<Level> itemTypeLevels() {
  std::vector<Level> levels;
  for (const auto& type : questionnaires::kItemTypes) {
    levels.push_back({std::string(type.name), std::string(type.name)});
  }
  return levels;
}

/// All versions of the study's protocol, the newest first.
std::vector<const protocols::Protocol*> versionsOf(Study& study) {
  std::vector<const protocols::Protocol*> versions;
  for (const auto id : study.protocols().all()) versions.push_back(&study.protocol(id).protocol);
  std::ranges::reverse(versions);
  return versions;
}

/// Adds a value unless the list has it already. Versions of the protocol are added the newest
/// first, so that the newest one gives the label.
void addLevel(std::vector<Level>& levels, const std::string& value, const std::string& label) {
  const bool isThere =
      std::ranges::any_of(levels, [&](const auto& level) { return level.value == value; });
  if (!isThere) levels.push_back({value, label});
}

std::set<std::string> sitesOf(Study& study, const std::optional<RunMode>& mode) {
  std::set<std::string> sites;
  for (const auto& session : storage::Records(study.database()).sessions()) {
    if (!mode || session.runMode == *mode) sites.insert(session.site);
  }
  return sites;
}

}  // namespace

ValueLists valueListsOf(Study& study, const ExportOptions& options) {
  ValueLists lists{
      {ValueList::RunModes,
       levelsNamed({RunMode::Live, RunMode::Pilot, RunMode::Simulated}, nameOf)},
      {ValueList::Statuses,
       levelsNamed(
           {SessionState::Consented,  // exported for every session in progress
            SessionState::Completed,
            SessionState::Declined,
            SessionState::Withdrawn,
            SessionState::Rejected,
            SessionState::AbortedHardware,
            SessionState::Erased},
           statusOf)},
      {ValueList::Verdicts, levelsNamed({Verdict::Pass, Verdict::Warn, Verdict::Fail}, nameOf)},
      {ValueList::ItemTypes, itemTypeLevels()}};
  if (const auto sites = sitesOf(study, options.runMode); sites.size() > 1) {
    for (const auto& site : sites) addLevel(lists[ValueList::Sites], site, site);
  }
  // With several run modes, a code stands for a different condition in each mode and gets no label.
  const auto byCondition =
      conditionCodes(study, options.runMode.value_or(RunMode::Live), options.codes);
  const bool isNamed = !options.isBlinded && options.runMode;
  auto& codes = lists[ValueList::ConditionCodes];
  for (const auto* protocol : versionsOf(study)) {
    for (const auto& cohort : protocol->cohorts) {
      addLevel(lists[ValueList::Cohorts], cohort.id, cohort.title.in("en"));
    }
    for (const auto& phase : protocol->phases)
      addLevel(lists[ValueList::Blocks], phase.id, phase.id);
    for (const auto& condition : protocol->conditions) {
      const auto& code = byCondition.at(condition.id);
      addLevel(codes, code, isNamed ? condition.title : code);
      if (!options.isBlinded) addLevel(lists[ValueList::Conditions], condition.id, condition.title);
    }
  }
  std::ranges::sort(codes, [](const auto& a, const auto& b) {
    return a.value.size() != b.value.size() ? a.value.size() < b.value.size() : a.value < b.value;
  });
  return lists;
}

std::string itemTypesInWords() {
  std::string words;
  for (const auto& type : questionnaires::kItemTypes) {
    const bool isLast = &type == &questionnaires::kItemTypes.back();
    words.append(words.empty() ? "" : isLast ? " or " : ", ").append(type.name);
  }
  return words;
}

}  // namespace study
