#pragma once

namespace haptics::models {

/// The response of a tissue model at a position of the tool.
template <typename Scalar>
struct Response {
  Scalar force{};          ///< [N]; positive pushes the tool back (opens, withdraws)
  Scalar stiffness{};      ///< derivative of the force by the position [N per position unit]
  bool isDefined = false;  ///< false: the model defines no force at this position; force is then 0
};

/// Whether a number is neither infinite nor NaN, for any scalar, also in constant expressions, and
/// without <cmath>: infinity and NaN minus themselves are NaN, which equals no number.
template <typename Scalar>
constexpr bool isFinite(Scalar value) noexcept {
  return value - value == Scalar{0};  // NOLINT(misc-redundant-expression): see above
}

}  // namespace haptics::models
