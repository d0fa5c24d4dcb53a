#pragma once

namespace protocols {

/// The meaning of keys that a protocol leaves out. A study keeps the defaults of the release under
/// which its protocol was added, so that an update of the program does not change the rendering.
enum class Defaults {
  /// The parametric cut ends at its largest force; a filter's recording fades out beyond its ends;
  /// seen tissue follows the force; a reamer removes all that it is pushed through; questions about
  /// a
  /// benchmark need none.
  Release01,
  /// The parametric cut falls to zero; a filter takes no measurement beyond a recording; seen
  /// tissue
  /// follows the penetration; a reamer removes what its teeth can take.
  Current
};

}  // namespace protocols
