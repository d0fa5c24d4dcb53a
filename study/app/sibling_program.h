#pragma once

#include <string>
#include <vector>

namespace study::app {

/// The path of a program in the folder of this one: all programs are installed together.
std::string siblingProgram(const std::string& name);

/// Replaces this process by a program in the same folder. Returns only by an exception.
/// @throws UserError  if it cannot be started.
[[noreturn]] void handOver(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace study::app
