#include "study/session/arrivals.h"

#include <exception>
#include <sstream>

#include "study/storage/station_store.h"
#include "study/storage/transfer/session_facts.h"

namespace study {
namespace {

std::string listOf(const std::string& study) {
  return "collected-" + study;
}

}  // namespace

Arrivals arrivalsBy(Study& study, std::int64_t event) {
  const auto marks = storage::sessionMarks(study.database());
  Arrivals arrivals{
      .all = static_cast<std::int64_t>(marks.size()), .arrived = 0, .waitingSince = {}};
  for (const auto& mark : marks) {
    if (mark.lastEvent <= event) {
      ++arrivals.arrived;
    } else if (arrivals.waitingSince.empty() || mark.utc < arrivals.waitingSince) {
      arrivals.waitingSince = mark.utc;
    }
  }
  return arrivals;
}

NotedPush lastPush(const std::string& study, const std::string& station) {
  const auto store = storage::StationStore::find(storage::StationStore::usualFolder());
  NotedPush last;
  if (!store) return last;
  for (const auto& line : store->lines(listOf(study))) {
    std::istringstream words(line);
    NotedPush noted;
    std::string of;
    if (!(words >> noted.utc >> of >> noted.have) || of != station) continue;
    words >> noted.problem;
    last = noted;
  }
  return last;
}

void notePush(
    const std::string& study, const std::string& station, const NotedPush& push) noexcept {
  try {
    auto line = push.utc + " " + station + " " + std::to_string(push.have);
    if (!push.problem.empty()) line += " " + push.problem;
    storage::StationStore::findOrMake(storage::StationStore::usualFolder())
        .append(listOf(study), line);
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace study
