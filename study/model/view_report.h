#pragma once

#include <cstdint>
#include <string>

#include "base/message.h"

namespace study {

/// How well a trial was to be seen, where it was visualised.
struct ViewReport {
  std::string renderer;  ///< who drew: a graphics card, a driver, or our own rasteriser
  std::int64_t frames = 0;
  std::int64_t dropped = 0;  ///< refreshes of the display, as it was meant, without a new picture
  double rate = 0.0;         ///< frames a second, from the first to the last [1/s]
  double frameMedian = 0.0;  ///< from one frame to the next [ms]
  double frameP99 = 0.0;     ///< [ms]
  double latencyMedian =
      0.0;                  ///< from reading the device to handing the picture to the display [ms]
  double latencyP99 = 0.0;  ///< [ms]
  double period = 0.0;      ///< of the frames as they were meant [ms]
  std::int64_t lostChanges = 0;  ///< of a bone, that never came to be seen
};

/// For the record: {"frames", 512}, {"dropped", 3}, …
base::NamedArguments valuesOf(const ViewReport& view);

}  // namespace study
