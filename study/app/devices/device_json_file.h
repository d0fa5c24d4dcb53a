#pragma once

#include <string>
#include <vector>

#include "study/app/devices/device_report.h"

namespace study::app {

/// `fit`, `problems` (none), and `devices`: a list of `id`, `fit`, and `findings` with `finding`,
/// `what`, `measured`, `mend`.
std::string checksAsJson(const std::vector<DeviceFindings>& found);

/// The same document if nothing could be checked; `problems` has the reason.
std::string problemAsJson(const std::string& why);

}  // namespace study::app
