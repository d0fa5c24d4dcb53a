#pragma once

#include <QString>

#include "haptics/devices/device.h"

namespace study::gui {

/// In which unit an operator reads a device's travel.
struct TravelScale {
  double factor;         ///< from the device's unit to this one
  QString unit;          ///< "mm"
  QString suffix;        ///< behind a number where room is scarce: " mm", or nothing
  QString velocityUnit;  ///< "mm/s", "/s"
  QString energyUnit;    ///< of force times the device's own unit: "J"
};

TravelScale travelScaleOf(const haptics::devices::DeviceKind& device);

}  // namespace study::gui
