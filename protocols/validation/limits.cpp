#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::shown;

/// What hands and fingers stand without pain while they are held or pressed [N]: table A.2 of
/// ISO/TS 15066:2016, "Robots and robotic devices – Collaborative robots", quasi-static contact.
constexpr double kBearable = 140.0;

constexpr double kTick = 0.001;  // between two forces [s]

}  // namespace

void validateLimits(const Protocol& protocol, questionnaires::Problems& problems) {
  for (std::size_t i = 0; i < protocol.devices.size(); ++i) {
    const auto& device = protocol.devices[i];
    const std::string path = "$.devices[" + std::to_string(i) + "].";
    if (device.maxForce > kBearable) {
      problems.add(
          path + "max_force_n",
          "a hand stands " + shown(kBearable) +
              " N without pain (ISO/TS 15066:2016, table A.2, hands and fingers), and this is " +
              shown(device.maxForce) + " N",
          "write " + shown(kBearable) + " or less, and scale the scenes by 'force_scale'");
    }
    const double steepest = device.maxForce / kTick;
    if (device.maxForceRate > steepest) {
      problems.add(
          path + "max_force_rate_n_per_s",
          "a device is sent a force every 1 ms, and at " + shown(device.maxForceRate) +
              " N/s the largest one comes at once, as a blow",
          "write less than " + shown(steepest) + "; shipped protocols have 500 for 8 N");
    }
    if (device.maxForce > device.kind->simulatedForce) {
      problems.warn(
          path + "max_force_n",
          message("more_than_device", device.kind->name, device.kind->simulatedForce),
          message("more_than_device.fix"));
    }
  }
}

}  // namespace protocols
