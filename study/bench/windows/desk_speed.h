#pragma once

#include <string>
#include <vector>

namespace study::bench {

/// The speed of the operator's live plots: three channels at 1 kHz, a frame every 16 ms.
struct PlotSpeed {
  double picturesPerSecond = 0.0;
  double processor = 0.0;  ///< share of one processor
};
PlotSpeed measurePlots(double seconds);

/// The time from pressing Next until the next page is drawn, with the answers stored first: every
/// page of 20 sessions in which trials are skipped. The study is made in @p folder and removed.
/// @return the times [ms].
/// @throws UserError  if the folder cannot hold a study.
std::vector<double> measurePageChanges(const std::string& folder);

}  // namespace study::bench
