#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace study::app {

/// Runs this program once more with @p arguments, and hands on every line that it prints.
/// @throws UserError  if it cannot be started, or does not end well.
void runAnotherOfUs(
    const std::vector<std::string>& arguments, const std::function<void(const std::string&)>& line);

/// Runs a program that is looked for where programs are, and hands on every line that it prints.
/// @return its exit status; nothing where there is no such program, or a signal ended it.
/// @throws UserError  if no process can be started at all.
std::optional<int> runProgram(
    const std::string& program,
    const std::vector<std::string>& arguments,
    const std::function<void(const std::string&)>& line);

}  // namespace study::app
