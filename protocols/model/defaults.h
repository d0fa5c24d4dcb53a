#pragma once

namespace protocols {

/// The meaning of keys that a protocol leaves out. A study keeps the defaults of the release under
/// which its protocol was added, so that an update of the program does not change the rendering.
enum class Defaults {
  /// A filter's recording fades out beyond its ends; seen tissue follows the force; a reamer
  /// removes
  /// all that it is pushed through.
  Release01,
  /// A filter takes no measurement there; seen tissue follows the penetration; a reamer removes
  /// what
  /// its teeth can take.
  Current
};

}  // namespace protocols
