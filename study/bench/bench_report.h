#pragma once

#include <functional>
#include <string>
#include <vector>

#include "haptics/bench/measurement_text.h"
#include "haptics/bench/servo.h"
#include "haptics/bench/stability.h"
#include "study/bench/bench_recorder.h"
#include "study/report/document.h"

namespace study::app {

/// What was measured with: a table of two columns.
DataTable machineTable();

/// A target, what came out, and whether it was reached.
struct Target {
  std::string id;  ///< "splines"
  std::string what;
  double measured = 0.0;
  double wanted = 0.0;
  bool isAtMost = false;  ///< at most what is wanted; else at least
  bool isReached() const { return isAtMost ? measured <= wanted : measured >= wanted; }
};

DataTable targetTable(const std::vector<Target>& targets);
void printTargets(const std::vector<Target>& targets);

/// Error against run time: all measurements as tables, figures and targets.
report::Document accuracyReport(const std::vector<haptics::bench::Repeated>& measured);
std::vector<Target> accuracyTargets(const std::vector<haptics::bench::Repeated>& measured);

/// Extreme cases: all checks as tables, figures.
report::Document stabilityReport(const haptics::bench::StabilityResult& result);

/// How punctual the loop is, and what recording costs.
struct ServoMeasurement {
  std::vector<haptics::bench::ServoRun> runs;
  std::vector<RecorderRun> recorders;  ///< ours first, a raw file last
  RecorderLoop loop;
};
report::Document servoReport(const ServoMeasurement& measured);
std::vector<Target> servoTargets(const ServoMeasurement& measured);

}  // namespace study::app
