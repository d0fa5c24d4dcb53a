#pragma once

#include <string>
#include <vector>

namespace study::app {

/// The path of another program in this program's folder, in which all programs are installed.
std::string siblingProgram(const std::string& name);

/// Replaces this process by another program in this program's folder; does not return.
/// @throws UserError  if the program cannot be started.
[[noreturn]] void replaceProcessBy(
    const std::string& name, const std::vector<std::string>& arguments);

}  // namespace study::app
