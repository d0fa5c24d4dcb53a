#include "study/gui/session/servo_health.h"

#include <algorithm>

#include "haptics/engine/force_limiter.h"

namespace study::gui {

void ServoHealth::add(const haptics::engine::TickSample& sample) {
  using haptics::engine::ForceLimiter;
  using haptics::engine::TickSample;
  const double lateness = std::max(0.0, static_cast<double>(sample.lateness));
  histogram_.add(lateness);
  const auto* const edge = std::lower_bound(kEdges.begin(), kEdges.end(), lateness);
  ++bars_[static_cast<std::size_t>(edge - kEdges.begin())];
  ++ticks_;
  if ((sample.interventions & ForceLimiter::Saturated) != 0) ++saturated_;
  if ((sample.marks & TickSample::Invalid) != 0) ++invalid_;
  leaps_ = std::max(leaps_, sample.leaps);  // 0 in samples of a device that has failed
  energy_ = sample.energy;
  leastEnergy_ = std::min(leastEnergy_, sample.energy);
}

}  // namespace study::gui
