#pragma once

namespace haptics::firmware {

/// A simulated handle and hand, for a board without hardware: a mass between the force of the motor
/// and a hand that repeatedly closes and opens. The hand is a spring to a point on a minimum-jerk
/// path.
/// Parameters are those of the simulated punch (devices::punchKind()); single precision, no
/// library.
class BenchHandle {
 public:
  /// Advances by @p dt [s] against @p force [N]; returns the travel [travel units].
  float step(float force, float dt) noexcept {
    constexpr float kMass = 0.004F;          // [N·s²/travel unit]
    constexpr float kDamping = 0.05F;        // [N·s/travel unit]
    constexpr float kStopStiffness = 80.0F;  // [N/travel unit]
    constexpr float kGripStiffness = 3.0F;   // [N/travel unit]
    constexpr float kGripDamping = 0.12F;    // [N·s/travel unit]
    constexpr float kEndStop = 11.0F;        // [travel units]
    constexpr int kSubsteps = 8;             // sub-steps; 1 ms would be unstable
    const float part = dt / kSubsteps;
    for (int i = 0; i < kSubsteps; ++i) {
      time_ += part;
      const float beyond = travel_ > kEndStop ? travel_ - kEndStop
                           : travel_ < 0.0F   ? travel_
                                              : 0.0F;
      const float push = kGripStiffness * (target() - travel_) - kGripDamping * velocity_;
      velocity_ += part * (push - force - kDamping * velocity_ - kStopStiffness * beyond) / kMass;
      travel_ += part * velocity_;
    }
    return travel_;
  }

 private:
  /// The travel that the hand aims at [travel units]: 0.4 s open, 0.6 s closing, 0.15 s closed, 0.5
  /// s opening.
  float target() noexcept {
    constexpr float kClosed = 13.8F;
    constexpr float kWhole = 1.65F;
    if (time_ >= kWhole) time_ -= kWhole;
    if (time_ < 0.4F) return 0.0F;
    if (time_ < 1.0F) return kClosed * minimumJerk((time_ - 0.4F) / 0.6F);
    if (time_ < 1.15F) return kClosed;
    return kClosed * (1.0F - minimumJerk((time_ - 1.15F) / 0.5F));
  }

  static float minimumJerk(float t) noexcept {
    return t * t * t * (10.0F + t * (6.0F * t - 15.0F));
  }

  float time_ = 0.0F;
  float travel_ = 0.0F;
  float velocity_ = 0.0F;
};

}  // namespace haptics::firmware
