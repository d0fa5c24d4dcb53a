#pragma once

#include <stdint.h>

#include "haptics/models/response.h"

namespace haptics::models {

/// A Q16.16 fixed-point number: 32 bits, 16 of them after the point; from −32768 to 32767.99998 in
/// steps of 1/65536. For microcontrollers without a floating-point unit; results are bit-identical
/// on every computer.
///
/// Arithmetic saturates and never wraps around: a force that suddenly reverses its sign would jerk
/// the hand.
class Fixed {
 public:
  static constexpr int kFractionBits = 16;
  static constexpr int32_t kLargest = INT32_MAX;
  static constexpr int32_t kSmallest = INT32_MIN;

  constexpr Fixed() noexcept = default;
  constexpr explicit Fixed(int value) noexcept : raw_(saturated(int64_t{value} << kFractionBits)) {}
  /// Rounds to the nearest step; NaN becomes 0. Slow: for constants, not for the tick.
  constexpr explicit Fixed(double value) noexcept : raw_(nearest(value)) {}
  static constexpr Fixed fromRaw(int32_t raw) noexcept {
    Fixed result;
    result.raw_ = raw;
    return result;
  }

  constexpr int32_t raw() const noexcept { return raw_; }
  constexpr double asDouble() const noexcept { return raw_ / 65536.0; }

  friend constexpr Fixed operator+(Fixed a, Fixed b) noexcept {
    int32_t sum = 0;
    const bool isTooMuch = __builtin_add_overflow(a.raw_, b.raw_, &sum);
    return fromRaw(isTooMuch ? end(a.raw_) : sum);
  }
  friend constexpr Fixed operator-(Fixed a, Fixed b) noexcept {
    int32_t difference = 0;
    const bool isTooMuch = __builtin_sub_overflow(a.raw_, b.raw_, &difference);
    return fromRaw(isTooMuch ? end(a.raw_) : difference);
  }
  constexpr Fixed operator-() const noexcept { return fromRaw(saturated(-int64_t{raw_})); }
  /// Rounded to the nearest step.
  friend constexpr Fixed operator*(Fixed a, Fixed b) noexcept {
    constexpr int64_t kHalf = int64_t{1} << (kFractionBits - 1);
    const int64_t product = int64_t{a.raw_} * b.raw_ + kHalf;
    const auto high = static_cast<int32_t>(product >> 32);
    const bool fits = static_cast<uint32_t>(high) + 0x8000U <= 0xFFFFU;
    return fromRaw(fits ? static_cast<int32_t>(product >> kFractionBits) : end(high));
  }
  /// Rounds towards zero. Division by zero gives the largest number of the sign of @p a. Slow on a
  /// microcontroller.
  friend constexpr Fixed operator/(Fixed a, Fixed b) noexcept {
    if (b.raw_ == 0) return fromRaw(a.raw_ < 0 ? kSmallest : kLargest);
    return fromRaw(saturated((int64_t{a.raw_} * (int64_t{1} << kFractionBits)) / b.raw_));
  }
  constexpr Fixed& operator+=(Fixed other) noexcept { return *this = *this + other; }
  constexpr Fixed& operator-=(Fixed other) noexcept { return *this = *this - other; }
  constexpr Fixed& operator*=(Fixed other) noexcept { return *this = *this * other; }

  friend constexpr bool operator==(Fixed a, Fixed b) noexcept { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(Fixed a, Fixed b) noexcept { return a.raw_ != b.raw_; }
  friend constexpr bool operator<(Fixed a, Fixed b) noexcept { return a.raw_ < b.raw_; }
  friend constexpr bool operator>(Fixed a, Fixed b) noexcept { return a.raw_ > b.raw_; }
  friend constexpr bool operator<=(Fixed a, Fixed b) noexcept { return a.raw_ <= b.raw_; }
  friend constexpr bool operator>=(Fixed a, Fixed b) noexcept { return a.raw_ >= b.raw_; }

 private:
  /// The end of the range of numbers on the side of @p value's sign, where results saturate.
  static constexpr int32_t end(int32_t value) noexcept { return value < 0 ? kSmallest : kLargest; }
  static constexpr int32_t saturated(int64_t value) noexcept {
    if (value > kLargest) return kLargest;
    return value < kSmallest ? kSmallest : static_cast<int32_t>(value);
  }
  static constexpr int32_t nearest(double value) noexcept {
    const double scaled = value * 65536.0;
    if (!(scaled == scaled)) return 0;
    if (scaled >= 2147483647.0) return kLargest;
    if (scaled <= -2147483648.0) return kSmallest;
    return static_cast<int32_t>(scaled < 0.0 ? scaled - 0.5 : scaled + 0.5);
  }

  int32_t raw_ = 0;
};

/// A force curve at equidistant points whose distance is a power of two, in integers: the index is
/// a shift, without search or division. A microcontroller looks up a recorded cut with it.
///
/// @tparam kShift  the distance of two points is 2^kShift / 65536 travel units.
template <int kPoints, int kShift>
class UniformCurve {
 public:
  static constexpr Fixed kStep = Fixed::fromRaw(int32_t{1} << kShift);

  constexpr explicit UniformCurve(Fixed start) noexcept : start_(start) {}

  constexpr Fixed travelAt(int i) const noexcept {
    return Fixed::fromRaw(start_.raw() + (i << kShift));
  }
  constexpr void set(int i, Fixed force) noexcept { forces_[i] = force.raw(); }

  /// Linear interpolation between the points; undefined outside.
  constexpr Response<Fixed> at(Fixed travel) const noexcept {
    if (travel < start_) return {};
    // The difference of two 32-bit numbers fits only into an unsigned one.
    const uint32_t from = static_cast<uint32_t>(travel.raw()) - static_cast<uint32_t>(start_.raw());
    const uint32_t i = from >> kShift;
    if (i >= static_cast<uint32_t>(kPoints - 1)) return {};
    const auto within = static_cast<int32_t>(from & static_cast<uint32_t>(kStep.raw() - 1));
    const int32_t rise = forces_[i + 1] - forces_[i];
    const auto across = static_cast<int32_t>((int64_t{rise} * within) >> kShift);
    const auto slope = static_cast<int32_t>((int64_t{rise} << Fixed::kFractionBits) >> kShift);
    return {Fixed::fromRaw(forces_[i] + across), Fixed::fromRaw(slope), true};
  }

 private:
  Fixed start_;
  int32_t forces_[kPoints] = {};
};

}  // namespace haptics::models
