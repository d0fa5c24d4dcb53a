#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/engine/realtime_loop.h"
#include "protocols/model/protocol.h"
#include "study/model/progress.h"
#include "study/storage/disk_check.h"

namespace study::gui {

/// One line of a self-test: of what part, and what was found there.
struct SelfTestLine {
  std::string part;  ///< "clock"
  haptics::devices::CheckResult found;
};

/// What is tested.
struct SelfTestOrder {
  std::filesystem::path study;  ///< its folder; empty: this computer alone
  std::string deviceFile;       ///< empty: the study's own, if it has one
  double seconds = 2.0;         ///< for the clock, and for each device
};

/// Devices, clock and database, as they are now. Blocks for some seconds; any thread.
std::vector<SelfTestLine> testComputer(const SelfTestOrder& order, const Progress& progress);

/// The screens. The window's thread.
std::vector<SelfTestLine> testScreens();

/// What measured numbers mean for a study.
SelfTestLine judgeClock(
    const haptics::engine::RealtimeLoop::Report& report, bool isRealtime, double rate);
SelfTestLine judgeCommits(const storage::CommitTimes& times, const std::string& folder);

}  // namespace study::gui
