#pragma once

#include <string>
#include <vector>

#include "study/app/devices/device_report.h"

namespace study::app {

/// The result of a device check: `fit`, `problems` (none), and `devices`: a list of `id`, `fit`,
/// and `findings` with `finding`, `what`, `measured`, `mend`.
std::string checksAsJson(const std::vector<DeviceFindings>& found);

/// The same document for a check that was not possible; `problems` contains the reason.
std::string problemAsJson(const std::string& why);

}  // namespace study::app
