#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "study/model/run_mode.h"
#include "study/session/arrivals.h"
#include "study/session/unfinished_sessions.h"

namespace study::gui {

/// The progress of a cohort.
struct CohortProgress {
  std::string title;
  int completed = 0;  ///< live sessions: pilots and simulated ones take no planned place
  int planned = 0;    ///< 0: the protocol plans no number
};

/// What the home page shows about a study. Contains no condition.
struct StudySummary {
  std::string folder;
  std::string title;
  std::string protocol;  ///< "Protocol: punch-face-validity 1.0, in use since …"
  std::map<RunMode, int> completed;
  std::map<RunMode, int> sessions;  ///< finished or not; without erased ones
  std::vector<CohortProgress> cohorts;
  std::string lastSessionUtc;   ///< when the latest session of defaultRunMode() began; empty if
                                ///< there is none, or if the sessions are simulated
  bool isOpenLabel = false;     ///< the study does not hide its conditions
  std::size_t blanks = 0;       ///< in texts for participants, still to be filled in
  bool lacksKeyBackup = false;  ///< no copy was made of the key with which conditions are sealed
  std::vector<UnfinishedSession> unfinished;
  std::optional<Arrivals> arrivals;  ///< at the server, as of the last push; of a station's study
  std::string pushProblem;           ///< why the last push did not succeed (PushRecord::problem)
  bool isFolderMissing = false;      ///< the folder no longer exists
  std::string problem;  ///< a message that says why the study cannot be opened; empty if it can
};

/// How many sessions of a mode there are in @p counts.
int countIn(const std::map<RunMode, int>& counts, RunMode mode);

/// Reads a study without changing it. Problems are returned in the summary.
StudySummary summaryOf(const std::string& folder);

/// How many of the planned live sessions are completed. More than a cohort's number do not count.
struct PlanProgress {
  int completed = 0;
  int planned = 0;  ///< 0: no number is planned
};
PlanProgress progressOf(const StudySummary& summary);

/// "11 of 12 completed · Simulated: 3 of 3 completed · 1 unfinished"; the first is of the planned
/// sessions, if their number is.
std::string sessionsInWords(const StudySummary& summary);

/// The sessions that take no planned place: "Pilot: 1 of 1 completed · Simulated: 3 of 3
/// completed".
std::string otherSessionsInWords(const StudySummary& summary);

/// "Sessions here: 23. Arrived: 21. Waiting since Tuesday: 2 (no network, or no server)"; empty for
/// a study of one computer.
std::string arrivalsInWords(const StudySummary& summary);

/// Whether data have been waiting for the server for more than a day.
bool isArrivalOverdue(const StudySummary& summary);

/// The run mode to offer first: live if there are live sessions, else pilot, else simulated; live
/// if there are none.
RunMode defaultRunMode(const StudySummary& summary);

}  // namespace study::gui
