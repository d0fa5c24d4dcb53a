#include "haptics/recordings/recording.h"

#include <algorithm>
#include <cstddef>

namespace haptics::recordings {

Sampling samplingOf(const Recording& recording) {
  constexpr double kSecondsPerMillisecond = 1e-3;
  const std::vector<Recording::Row>& rows = recording.rows;
  if (rows.size() < 2 || !(rows.back().time > rows.front().time)) return {};

  double least = rows[1].time - rows[0].time;
  double most = least;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const double step = rows[i].time - rows[i - 1].time;
    least = std::min(least, step);
    most = std::max(most, step);
  }
  const double duration = (rows.back().time - rows.front().time) * kSecondsPerMillisecond;
  const auto steps = static_cast<double>(rows.size() - 1);
  return {
      .rate = steps / duration,
      .stepMin = least * kSecondsPerMillisecond,
      .stepMax = most * kSecondsPerMillisecond,
      .stepMean = duration / steps};
}

}  // namespace haptics::recordings
