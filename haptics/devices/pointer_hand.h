#pragma once

#include <atomic>

#include "haptics/devices/hand.h"

namespace haptics::devices {

/// A hand that follows a pointer: the mouse or the keys of somebody who has no device. Another
/// thread says where to go.
class PointerHand final : public Hand {
 public:
  struct Grip {
    double stiffness = 3.0;  ///< [N / travel unit]
    double damping = 0.12;   ///< [N·s / travel unit]
    double speed = 40.0;     ///< how fast the grip follows at most [travel units / s]
  };

  explicit PointerHand(const Grip& grip) noexcept : grip_(grip) {}

  /// Any thread: where the hand means to be [travel unit].
  void moveTo(double travel) noexcept { wanted_.store(travel, std::memory_order_relaxed); }

  double push(double travel, double velocity, double dt) noexcept override;

 private:
  Grip grip_;
  std::atomic<double> wanted_{0.0};
  double position_ = 0.0;
};

}  // namespace haptics::devices
