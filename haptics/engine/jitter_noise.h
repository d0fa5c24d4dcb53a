#pragma once

#include <algorithm>
#include <cstdint>

#include "haptics/reaming/bone/chance.h"
#include "haptics/reaming/material/material.h"

namespace haptics::engine {

/// The jitter of a measured force as noise in time: a new normal number at every sample of the
/// measurement, straight from one to the next. It depends on time alone, so it adds no stiffness.
class JitterNoise {
 public:
  /// @param scale  of all forces of the scene.
  JitterNoise(const reaming::Jitter& jitter, double scale, std::uint64_t seed) noexcept
      : rms_(scale * jitter.rms), rate_(jitter.rate), seed_(seed), chance_(seed) {
    reset();
  }

  /// What is added to @p force [N] after @p dt [s]. Comes in with the force and never turns its
  /// sign.
  double step(double force, double dt) noexcept {
    if (!(rms_ > 0.0)) return 0.0;
    phase_ += std::min(rate_ * dt, 1.0);
    if (phase_ >= 1.0) {
      phase_ -= 1.0;
      last_ = next_;
      next_ = chance_.normal();
    }
    const double share = std::clamp(force / (kFull * rms_), 0.0, 1.0);
    const double noise = share * rms_ * (last_ + phase_ * (next_ - last_));
    return std::max(noise, -std::max(force, 0.0));
  }

  void reset() noexcept {
    chance_ = reaming::Chance(seed_);
    phase_ = 0.0;
    last_ = 0.0;
    next_ = rms_ > 0.0 ? chance_.normal() : 0.0;
  }

 private:
  static constexpr double kFull = 5.0;  ///< of its RMS: from this force on all of it is felt

  double rms_;   ///< [N]
  double rate_;  ///< [Hz]
  std::uint64_t seed_;
  reaming::Chance chance_;
  double phase_ = 0.0;  ///< between two samples, from 0 to 1
  double last_ = 0.0;
  double next_ = 0.0;
};

}  // namespace haptics::engine
