#include "study/gui/desk/study_summary.h"

#include <algorithm>
#include <filesystem>

#include "base/joined.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/authoring/checked_protocol.h"
#include "study/gui/session/station_push.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/session/study.h"
#include "study/session/study_key.h"

namespace study::gui {
namespace {

constexpr RunMode kRunModes[]{RunMode::Live, RunMode::Pilot, RunMode::Simulated};

void fillCohorts(Study& study, StudySummary& summary) {
  const auto rows = study.sessions().all();
  for (const auto& cohort : study.protocol().protocol.cohorts) {
    const auto completed = std::ranges::count_if(rows, [&](const auto& row) {
      return row.runMode == RunMode::Live && row.cohort == cohort.id &&
             row.state == SessionState::Completed;
    });
    summary.cohorts.push_back(
        {.title = cohort.title.in(deskLanguage()),
         .completed = static_cast<int>(completed),
         .planned = cohort.planned});
  }
  const auto mode = defaultRunMode(summary);
  if (mode == RunMode::Simulated) return;  // their times are virtual
  for (const auto& row : rows) {
    if (row.runMode == mode)
      summary.lastSessionUtc = std::max(summary.lastSessionUtc, row.startedUtc);
  }
}

void fillArrivals(Study& study, StudySummary& summary) {
  if (study.station().isNone()) return;
  const auto last = lastPush(study.uuid(), study.station().uuid);
  summary.arrivals = arrivalsBy(study, last.lastEvent);
  summary.pushProblem = last.problem;
}

void fill(StudySummary& summary) {
  auto study = Study::open(summary.folder, storage::Database::Access::ReadOnly);
  const auto current = study.protocols().current();
  const auto& metadata = study.protocol().protocol.study;
  summary.title = metadata.title;
  const auto name = metadata.id + " " + metadata.version;
  summary.protocol = current.frozenUtc
                         ? translated(
                               "Protocol: {}, in use since {}; a change makes a new version",
                               name,
                               current.frozenUtc->substr(0, 10))
                         : translated("Protocol: {}, can still be changed", name);
  for (const auto& row : study.sessions().all()) {
    if (row.state == SessionState::Erased) continue;
    ++summary.sessions[row.runMode];
    if (row.state == SessionState::Completed) ++summary.completed[row.runMode];
  }
  summary.unfinished = unfinishedSessions(study);
  summary.lacksKeyBackup = hasOnlyCopyOfKey(study);
  summary.isOpenLabel = study.protocol().protocol.isOpenLabel;
  summary.blanks = blanksLeft(study.protocol());
  fillCohorts(study, summary);
  fillArrivals(study, summary);
}

/// "Pilot: 0 of 1 completed".
std::string modeInWords(const StudySummary& summary, RunMode mode) {
  return translated(
      "{}: {} of {} completed",
      capitalised(deskText(nameOf(mode))).toStdString(),
      countIn(summary.completed, mode),
      countIn(summary.sessions, mode));
}

}  // namespace

int countIn(const std::map<RunMode, int>& counts, RunMode mode) {
  const auto found = counts.find(mode);
  return found == counts.end() ? 0 : found->second;
}

StudySummary summaryOf(const std::string& folder) {
  StudySummary summary{.folder = folder};
  std::error_code ignored;
  summary.isFolderMissing = !std::filesystem::is_directory(folder, ignored);
  if (summary.isFolderMissing) {
    summary.problem = translated(
        "The folder is not there. Was it moved, or is its disk not connected? Open it where it "
        "is now, or remove it from the list.");
    return summary;
  }
  try {
    fill(summary);
  } catch (const std::exception& error) {
    summary.problem = error.what();
  }
  return summary;
}

PlanProgress progressOf(const StudySummary& summary) {
  PlanProgress progress;
  for (const auto& cohort : summary.cohorts) {
    if (cohort.planned == 0) continue;
    progress.completed += std::min(cohort.completed, cohort.planned);
    progress.planned += cohort.planned;
  }
  return progress;
}

std::string sessionsInWords(const StudySummary& summary) {
  if (!summary.problem.empty())
    return translated(summary.isFolderMissing ? "gone" : "cannot be opened");
  if (summary.sessions.empty()) return translated("no sessions yet");
  std::vector<std::string> parts;
  const auto [completed, planned] = progressOf(summary);
  if (planned > 0) {
    parts.push_back(translated("{} of {} completed", completed, planned));
  } else if (countIn(summary.sessions, RunMode::Live) > 0) {
    parts.push_back(modeInWords(summary, RunMode::Live));
  }
  const auto others = otherSessionsInWords(summary);
  if (!others.empty()) parts.push_back(others);
  if (!summary.unfinished.empty()) {
    parts.push_back(translated("{} unfinished", summary.unfinished.size()));
  }
  return base::joined(parts, " · ");
}

std::string otherSessionsInWords(const StudySummary& summary) {
  std::vector<std::string> parts;
  for (const auto mode : {RunMode::Pilot, RunMode::Simulated}) {
    if (countIn(summary.sessions, mode) > 0) parts.push_back(modeInWords(summary, mode));
  }
  return base::joined(parts, " · ");
}

std::string arrivalsInWords(const StudySummary& summary) {
  return summary.arrivals ? arrivalsInWords(*summary.arrivals, summary.pushProblem) : std::string();
}

bool isArrivalOverdue(const StudySummary& summary) {
  return summary.arrivals && isOverdue(*summary.arrivals);
}

RunMode defaultRunMode(const StudySummary& summary) {
  for (const auto mode : kRunModes) {
    if (countIn(summary.sessions, mode) > 0) return mode;
  }
  return RunMode::Live;
}

}  // namespace study::gui
