#pragma once

#include <QString>

#include "haptics/devices/device.h"

namespace study::gui {

/// The unit in which an operator reads a device's travel.
struct TravelScale {
  double factor = 1.0;  ///< from the device's unit to the displayed unit
  QString unit;         ///< "mm"
  QString suffix;       ///< appended to a number in narrow columns: " mm", or empty
  QString energyUnit;   ///< force times the device's own travel unit: "J"
};

TravelScale travelScaleOf(const haptics::devices::DeviceKind& device);

}  // namespace study::gui
