#pragma once

#include <functional>
#include <string>
#include <vector>

namespace study::app {

/// Runs this program once more with @p arguments, and hands on every line that it prints.
/// @throws NotNow  if it cannot be started, or does not end well.
void runAnotherOfUs(
    const std::vector<std::string>& arguments, const std::function<void(const std::string&)>& line);

}  // namespace study::app
