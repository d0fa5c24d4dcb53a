#include "study/gui/operator/travel_scale.h"

namespace study::gui {

TravelScale travelScaleOf(haptics::devices::DeviceKind device) {
  if (device == haptics::devices::DeviceKind::Reamer) {
    constexpr double kMillimetres = 1000.0;
    return {
        kMillimetres,
        QStringLiteral("mm"),
        QStringLiteral(" mm"),
        QStringLiteral("mm/s"),
        QStringLiteral("J")};
  }
  return {1.0, QStringLiteral("units"), {}, QStringLiteral("/s"), QStringLiteral("N·units")};
}

}  // namespace study::gui
