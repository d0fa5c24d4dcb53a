#pragma once

#include <string>
#include <vector>

namespace study::bench {

/// The operator's live plots: three channels at 1 kHz, a picture every 16 ms.
struct PlotSpeed {
  double picturesPerSecond = 0.0;
  double processor = 0.0;  ///< share of one
};
PlotSpeed measurePlots(double seconds);

/// From pressing Next until the page after it is drawn, with the answers on the disk first: every
/// page of 20 sessions in which trials are skipped. The study is made in @p folder and removed.
/// @return each wait [ms].
/// @throws UserError  if the folder takes no study.
std::vector<double> measurePageChanges(const std::string& folder);

}  // namespace study::bench
