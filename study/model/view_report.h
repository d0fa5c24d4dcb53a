#pragma once

#include <cstdint>
#include <string>

#include "base/message.h"

namespace study {

/// How smoothly the scene of a trial was shown on the display.
struct ViewReport {
  std::string renderer;  ///< what drew: a graphics card, a driver, or our software renderer
  std::int64_t frames = 0;
  std::int64_t dropped = 0;  ///< refreshes, at the display's nominal rate, without a new picture
  double rate = 0.0;         ///< from the first frame to the last [1/s]
  double frameMedian = 0.0;  ///< from one frame to the next [ms]
  double frameP99 = 0.0;     ///< [ms]
  double latencyMedian =
      0.0;                  ///< from reading the device to handing the picture to the display [ms]
  double latencyP99 = 0.0;  ///< [ms]
  double period = 0.0;      ///< nominal, of the frames [ms]
  std::int64_t lostChanges = 0;  ///< changes of a bone that were never drawn
};

/// The same as named values: {"frames", 512}, {"dropped", 3}, …
base::NamedArguments valuesOf(const ViewReport& view);

}  // namespace study
