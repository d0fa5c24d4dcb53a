#include "study/gui/scene/frame_statistics.h"

#include <algorithm>
#include <cmath>

namespace study::gui::scene {
namespace {

constexpr double kPerMicrosecond = 1e-3;  // µs in a nanosecond
constexpr double kMillisecond = 1e-3;     // ms in a microsecond

}  // namespace

void FrameStatistics::add(std::int64_t shown, std::int64_t sampled) {
  if (sampled > 0) latencies_.add(kPerMicrosecond * static_cast<double>(shown - sampled));
  if (frames_++ == 0) {
    first_ = last_ = shown;
    return;
  }
  const auto interval = static_cast<double>(shown - last_);
  intervals_.add(kPerMicrosecond * interval);
  dropped_ += std::max<std::int64_t>(0, std::llround(interval / static_cast<double>(period_)) - 1);
  last_ = shown;
}

double FrameStatistics::longest() const noexcept {
  return kMillisecond * intervals_.largest();
}

ViewReport FrameStatistics::report() const {
  ViewReport report{.frames = frames_, .dropped = dropped_};
  report.period = 1e-6 * static_cast<double>(period_);
  const double seconds = 1e-9 * static_cast<double>(last_ - first_);
  if (seconds > 0.0) report.rate = static_cast<double>(frames_ - 1) / seconds;
  report.frameMedian = kMillisecond * intervals_.quantile(0.5);
  report.frameP99 = kMillisecond * intervals_.quantile(0.99);
  report.latencyMedian = kMillisecond * latencies_.quantile(0.5);
  report.latencyP99 = kMillisecond * latencies_.quantile(0.99);
  return report;
}

}  // namespace study::gui::scene
