#pragma once

namespace haptics::models {

/// Whether a number is neither infinite nor NaN, for any scalar, in constant expressions too, and
/// without <cmath>: both minus themselves are NaN, which equals nothing.
template <typename Scalar>
constexpr bool isFinite(Scalar value) noexcept {
  return value - value == Scalar{0};  // NOLINT(misc-redundant-expression): see above
}

}  // namespace haptics::models
