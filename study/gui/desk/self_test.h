#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "haptics/engine/realtime_loop.h"
#include "protocols/model/protocol.h"
#include "study/gui/widgets/findings_table.h"
#include "study/model/progress.h"
#include "study/storage/local_disk.h"

namespace study::gui {

/// The scope of a self-test.
struct SelfTestOptions {
  std::filesystem::path study;  ///< a study's folder; empty: the computer only
  std::string deviceFile;       ///< empty: the study's own, if any
  double seconds = 2.0;         ///< duration for the clock, and for each device [s]
};

/// Tests devices, clock and database. Blocks for some seconds. Can be called from any thread.
std::vector<FindingLine> testComputer(const SelfTestOptions& options, const Progress& progress);

/// Tests the screens. Call it from the GUI thread.
std::vector<FindingLine> testScreens();

/// Compare measurements with what a study needs.
FindingLine evaluateTiming(
    const haptics::engine::RealtimeLoop::Report& report, bool isRealtime, double rate);
FindingLine evaluateCommitTimes(const storage::CommitTimes& times, const std::string& folder);

}  // namespace study::gui
