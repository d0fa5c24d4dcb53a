#pragma once

#include <stdint.h>

#include "haptics/models/fixed_point.h"
#include "haptics/models/response.h"

namespace haptics::models {

/// A force curve at equal distances of a power of two, in whole numbers: the index is a shift, and
/// nothing is searched or divided. How a microcontroller looks up a recorded cut.
///
/// @tparam kShift  the points lie 2^kShift / 65536 travel units apart.
template <int kPoints, int kShift>
class UniformCurve {
 public:
  static constexpr Fixed kStep = Fixed::fromRaw(int32_t{1} << kShift);

  constexpr explicit UniformCurve(Fixed start) noexcept : start_(start) {}

  constexpr Fixed travelAt(int i) const noexcept {
    return Fixed::fromRaw(start_.raw() + (i << kShift));
  }
  constexpr void set(int i, Fixed force) noexcept { forces_[i] = force.raw(); }

  /// By a straight line between two points; none, and undefined, outside.
  constexpr Response<Fixed> at(Fixed travel) const noexcept {
    if (travel < start_) return {};
    // The difference of two numbers of 32 bits fits only without a sign.
    const uint32_t from = static_cast<uint32_t>(travel.raw()) - static_cast<uint32_t>(start_.raw());
    const uint32_t i = from >> kShift;
    if (i >= static_cast<uint32_t>(kPoints - 1)) return {};
    const auto within = static_cast<int32_t>(from & static_cast<uint32_t>(kStep.raw() - 1));
    const int32_t rise = forces_[i + 1] - forces_[i];
    const auto across = static_cast<int32_t>((int64_t{rise} * within) >> kShift);
    const auto slope = static_cast<int32_t>((int64_t{rise} << Fixed::kFraction) >> kShift);
    return {Fixed::fromRaw(forces_[i] + across), Fixed::fromRaw(slope), true};
  }

 private:
  Fixed start_;
  int32_t forces_[kPoints] = {};
};

}  // namespace haptics::models
