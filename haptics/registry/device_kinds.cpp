#include "haptics/registry/device_kinds.h"

#include <algorithm>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/paddle/paddle_kind.h"
#include "haptics/devices/punch/punch_kind.h"

namespace haptics {

const std::vector<const devices::DeviceKind*>& deviceKinds() {
  static const std::vector<const devices::DeviceKind*> kinds{
      &devices::punchKind(),
      &devices::reamerKind(),
      &devices::paddleKind(),
  };
  return kinds;
}

const devices::DeviceKind* deviceKindNamed(std::string_view name) {
  const auto& kinds = deviceKinds();
  const auto found =
      std::ranges::find_if(kinds, [&](const auto* kind) { return kind->name == name; });
  return found == kinds.end() ? nullptr : *found;
}

}  // namespace haptics
