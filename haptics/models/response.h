#pragma once

namespace haptics::models {

/// What a tissue model answers at a position of the tool.
template <typename Scalar>
struct Response {
  Scalar force{};          ///< [N]; towards where the tool came from
  Scalar stiffness{};      ///< slope of the force over the position there [N per position unit]
  bool isDefined = false;  ///< false: the model says nothing here, and the force is none
};

/// Whether a number is neither infinite nor NaN, for any scalar, in constant expressions too, and
/// without <cmath>: both minus themselves are NaN, which equals nothing.
template <typename Scalar>
constexpr bool isFinite(Scalar value) noexcept {
  return value - value == Scalar{0};  // NOLINT(misc-redundant-expression): see above
}

}  // namespace haptics::models
