#include "study/export/public_history.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include "base/text_table.h"
#include "study/export/public_people.h"
#include "study/export/public_tables.h"
#include "study/storage/evidence/trail_heads.h"
#include "study/storage/station_store.h"
#include "study/storage/stored_values.h"
#include "study/words/counted.h"

namespace study {
namespace {

/// A public export that was made earlier.
struct EarlierExport {
  std::size_t k = 0;
  std::set<SessionId> completed;  ///< sessions that were completed before that export
};

/// The list of this account with the public exports of collected studies: each folder that is
/// pulled begins a trail of its own.
std::string listOf(Study& study) {
  return "public-" + study.uuid();
}

std::string trailOf(Study& study) {
  return storage::TrailHeads(study.database()).firstHash();
}

std::vector<EarlierExport> exportsOfOtherFolders(Study& study, RunMode mode) {
  std::vector<EarlierExport> exports;
  const auto store = storage::StationStore::find(storage::StationStore::defaultFolder());
  if (!study.isCollected() || !store) return exports;
  std::map<std::string_view, SessionId> sessions;  // by participant
  const auto rows = study.sessions().all();
  for (const auto& row : rows) sessions.emplace(row.participant, row.id);
  for (const auto& line : store->lines(listOf(study))) {
    const auto words = base::splitText(line, "\t");
    if (words.size() < 3 || words[0] == trailOf(study) || words[1] != nameOf(mode)) continue;
    EarlierExport one{.k = base::numberFrom<std::size_t>(words[2]).value_or(0)};
    for (const auto& person : std::span(words).subspan(3)) {
      const auto session = sessions.find(person);
      if (session != sessions.end()) one.completed.insert(session->second);
    }
    exports.push_back(std::move(one));
  }
  return exports;
}

std::vector<EarlierExport> earlierExports(Study& study, RunMode mode) {
  std::vector<EarlierExport> exports;
  std::set<SessionId> completed;
  for (const auto& event : study.events().read()) {
    if (event.kind == EventKind::FinishedSession && event.visit) {
      completed.insert(event.visit->session);
    }
    if (event.kind != EventKind::PublicExport) continue;
    // release 0.1 did not store the run mode
    const auto name = storage::storedValue<std::string>(event.values, "run_mode");
    if (name && *name != nameOf(mode)) continue;
    const auto number = storage::storedValue<std::int64_t>(event.values, "k");
    const auto smallest = number ? std::size_t(*number) : kSmallestPublicClassSize;
    exports.push_back({smallest, completed});
  }
  std::ranges::move(exportsOfOtherFolders(study, mode), std::back_inserter(exports));
  return exports;
}

/// The values of the people with these indices.
Values valuesOfPeople(const Values& values, const std::vector<std::size_t>& people) {
  Values these;
  for (const auto person : people) these.push_back(values[person]);
  return these;
}

/// A column that says whether a person was in an earlier export, and the columns that it released.
/// The latter are empty for people who were not in that export.
std::vector<ReleasedColumn> columnsOfEarlierExport(
    const EarlierExport& earlier,
    const PublicPeople& people,
    const std::vector<QuasiIdentifier>& identifiers) {
  std::vector<std::size_t> earlierPeople;
  for (std::size_t person = 0; person < people.count(); ++person) {
    if (earlier.completed.count(people.sessions()[person].id) > 0) earlierPeople.push_back(person);
  }
  ReleasedColumn wasThere{"", 0, Values(people.count(), "new")};
  for (const auto person : earlierPeople) wasThere.values[person] = "there";
  std::vector<ReleasedColumn> columns{wasThere};
  std::vector<QuasiIdentifier> theirIdentifiers;
  for (const auto& identifier : identifiers) {
    QuasiIdentifier one{identifier.name, valuesOfPeople(identifier.exact, earlierPeople), {}};
    for (const auto& level : identifier.levels)
      one.levels.push_back(valuesOfPeople(level, earlierPeople));
    theirIdentifiers.push_back(std::move(one));
  }
  const auto release = computeRelease(theirIdentifiers, earlierPeople.size(), earlier.k);
  if (!release) return columns;
  for (const auto& column : release->columns) {
    if (!column.level) continue;
    ReleasedColumn releasedColumn{column.name, column.level, Values(people.count())};
    for (std::size_t i = 0; i < earlierPeople.size(); ++i)
      releasedColumn.values[earlierPeople[i]] = column.values[i];
    columns.push_back(std::move(releasedColumn));
  }
  return columns;
}

}  // namespace

void rememberPublicExport(Study& study, RunMode mode, std::size_t k) {
  if (!study.isCollected() || mode == RunMode::Simulated) return;
  auto line = trailOf(study) + "\t" + std::string(nameOf(mode)) + "\t" + std::to_string(k);
  for (const auto& row : study.sessions().all()) {
    if (row.runMode == mode && row.state == SessionState::Completed) line += "\t" + row.participant;
  }
  storage::StationStore::openOrCreate(storage::StationStore::defaultFolder())
      .append(listOf(study), line);
}

ExportHistory exportHistory(Study& study, const ExportOptions& options) {
  const auto mode = options.runMode.value_or(RunMode::Live);
  const auto k = options.publicClassSize.value_or(kSmallestPublicClassSize);
  if (mode == RunMode::Simulated) return {};
  const auto earlier = earlierExports(study, mode);
  if (earlier.empty()) return {};
  const PublicPeople people(study, mode);
  const auto identifiers = people.identifiers();
  std::vector<ReleasedColumn> columns;
  for (const auto& column : publicRelease(study, options).columns) {
    if (column.level) columns.push_back(column);
  }
  ExportHistory history{.earlier = earlier.size(), .newPeople = people.count()};
  std::set<SessionId> known;
  for (const auto& one : earlier) {
    for (auto& column : columnsOfEarlierExport(one, people, identifiers))
      columns.push_back(std::move(column));
    known.insert(one.completed.begin(), one.completed.end());
  }
  for (const auto& session : people.sessions()) history.newPeople -= known.count(session.id);
  history.combinedClasses = classSizes(columns, people.count(), k);
  return history;
}

void requireSafeFromDifferencing(Study& study, const ExportOptions& options) {
  const auto history = exportHistory(study, options);
  if (history.combinedClasses.peopleInSmallClasses == 0) return;
  const auto k = options.publicClassSize.value_or(kSmallestPublicClassSize);
  throw storage::StorageError(
      "This study was published before, in " + words::counted(history.earlier, "public export") +
      ". A reader of both matches people by their answers, and could single out " +
      words::counted(history.combinedClasses.peopleInSmallClasses, "person", "people") + " (" +
      std::to_string(history.newPeople) + " of them new) in a class of fewer than " +
      std::to_string(k) + ". Nothing was written. Wait until at least " + std::to_string(k) +
      " more people who are alike took part, and keep the same --k; or do not publish again.");
}

}  // namespace study
