#pragma once

namespace haptics::models {

/// What a tissue model answers at a position of the tool.
template <typename Scalar>
struct Response {
  Scalar force{};          ///< [N]; towards where the tool came from
  Scalar stiffness{};      ///< slope of the force over the position there [N per position unit]
  bool isDefined = false;  ///< false: the model says nothing here, and the force is none
};

}  // namespace haptics::models
