#pragma once

namespace protocols {

/// What a protocol means where it says nothing. A study keeps the defaults of the release under
/// which its protocol came into it, so that an update of the program changes no rendering.
enum class Defaults {
  Release01,  ///< a filter's recording fades out beyond its ends; seen tissue follows the force
  Current     ///< a filter takes no measurement there; seen tissue follows the penetration
};

}  // namespace protocols
