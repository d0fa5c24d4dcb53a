#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/engine/realtime_loop.h"
#include "protocols/model/protocol.h"
#include "study/model/progress.h"
#include "study/storage/own_disk.h"

namespace study::gui {

/// One line of a self-test: the part and its finding, in everyday words.
struct SelfTestLine {
  std::string part;  ///< "timing"
  haptics::devices::CheckResult found;
  std::string details;  ///< what was measured, for readers who know the units; may be empty
};

/// The scope of a self-test.
struct SelfTestOptions {
  std::filesystem::path study;  ///< a study's folder; empty: the computer only
  std::string deviceFile;       ///< empty: the study's own, if any
  double seconds = 2.0;         ///< duration for the clock, and for each device [s]
};

/// Tests devices, clock and database. Blocks for some seconds. Can be called from any thread.
std::vector<SelfTestLine> testComputer(const SelfTestOptions& order, const Progress& progress);

/// Tests the screens. Call it from the GUI thread.
std::vector<SelfTestLine> testScreens();

/// Compare measurements with what a study needs.
SelfTestLine judgeClock(
    const haptics::engine::RealtimeLoop::Report& report, bool isRealtime, double rate);
SelfTestLine judgeCommits(const storage::CommitTimes& times, const std::string& folder);

}  // namespace study::gui
