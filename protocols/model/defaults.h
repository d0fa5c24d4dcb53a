#pragma once

namespace protocols {

/// The meaning of keys that a protocol leaves out. A study keeps the defaults of the release under
/// which its protocol was added, so that an update of the program does not change the rendering.
enum class Defaults {
  Release01,  ///< a filter's recording fades out beyond its ends; seen tissue follows the force
  Current     ///< a filter takes no measurement there; seen tissue follows the penetration
};

}  // namespace protocols
