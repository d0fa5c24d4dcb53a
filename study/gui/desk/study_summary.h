#pragma once

#include <map>
#include <string>
#include <vector>

#include "study/model/run_mode.h"
#include "study/session/unfinished_sessions.h"

namespace study::gui {

/// What stands about a study on the home page. Knows no condition.
struct StudySummary {
  std::string folder;
  std::string title;
  std::string protocol;  ///< "punch-face-validity 1.0, frozen 2026-11-20 …"
  std::map<RunMode, int> completed;
  std::map<RunMode, int> sessions;  ///< all of them, however they ended
  std::vector<UnfinishedSession> unfinished;
  bool isGone = false;  ///< there is no such folder any more
  std::string problem;  ///< why it cannot be opened, in words; empty where it can
};

/// Looks at a study without changing it. What is wrong with it stands in the summary.
StudySummary summaryOf(const std::string& folder);

/// "12 live completed, 1 unfinished; 3 simulated".
std::string sessionsInWords(const StudySummary& summary);

/// The run mode that most likely is meant: live where anybody took part, or else what there is.
RunMode likelyRunMode(const StudySummary& summary);

}  // namespace study::gui
