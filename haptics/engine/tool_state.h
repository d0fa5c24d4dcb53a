#pragma once

namespace haptics::engine {

/// Where the tool is along its device's axis, and how fast it goes. The unit of travel is the
/// device's: travel units for the punch (0 open, 10 closed), metres for the reamer.
struct ToolState {
  double travel = 0.0;    ///< [device's travel unit]
  double velocity = 0.0;  ///< [device's travel unit / s]
  double dt = 0.001;      ///< since the tick before [s], > 0
};

}  // namespace haptics::engine
