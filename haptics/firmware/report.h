#pragma once

#include <stdint.h>

#include "haptics/firmware/punch_step.h"

namespace haptics::firmware {

/// The travel of three cuts, from 0 to 11 travel units and back, in steps of 1/16, which single
/// precision represents exactly [2⁻¹⁶ travel units].
inline constexpr int kSteps = 3 * 2 * 176;
inline constexpr int32_t kTravelStep = 4096;

constexpr int32_t travelAt(int step) noexcept {
  constexpr int kWay = 176;
  const int within = step % (2 * kWay);
  return kTravelStep * (within < kWay ? within : 2 * kWay - within);
}

inline uint32_t bitsOf(float value) noexcept {
  uint32_t bits = 0;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

/// Runs the same steps on every platform, to compare results and instructions. Say receives a name,
/// the number of a step, and 32 bits; Start begins to count instructions, and Count returns their
/// number.
template <typename Say, typename Start, typename Count>
class Report {
 public:
  Report(Say say, Start start, Count count)
      : reportValue_(say), startCounting_(start), instructionCount_(count) {}

  void run() {
    floats<5>("float-5", "instructions-float-5");
    floats<15>("float-15", "instructions-float-15");
    cost<InterpolationPunch<5>>("instructions-interpolation-5");
    cost<InterpolationPunch<10>>("instructions-interpolation-10");
    cost<InterpolationPunch<15>>("instructions-interpolation-15");
    cost<ElementsPunch<5>>("instructions-elements-5");
    cost<ElementsPunch<10>>("instructions-elements-10");
    cost<ElementsPunch<15>>("instructions-elements-15");
    cost<FloatPunch<10>>("instructions-float-10");
  }

 private:
  template <int kElements>
  void floats(const char* name, const char* cost) {
    FloatPunch<kElements> punch;
    uint32_t most = 0;
    for (int i = 0; i < kSteps; ++i) {
      const float travel = static_cast<float>(travelAt(i)) / 65536.0F;
      startCounting_();
      const float force = punch.step(travel);
      const uint32_t spent = instructionCount_();
      if (spent > most) most = spent;
      reportValue_(name, i, bitsOf(force));
    }
    reportValue_(cost, 0, most);
  }

  /// Reports the largest number of instructions of a step.
  template <typename Punch>
  void cost(const char* name) {
    Punch punch;
    uint32_t most = 0;
    for (int i = 0; i < kSteps; ++i) {
      const float travel = static_cast<float>(travelAt(i)) / 65536.0F;
      startCounting_();
      force_ = punch.step(travel);
      mesh_ = punch.displacements()[0];
      const uint32_t spent = instructionCount_();
      if (spent > most) most = spent;
    }
    reportValue_(name, 0, most);
  }

  volatile float force_ = 0.0F;  ///< volatile, so that the compiler does not remove the computation
  volatile float mesh_ = 0.0F;
  Say reportValue_;
  Start startCounting_;
  Count instructionCount_;
};

}  // namespace haptics::firmware
