#pragma once

#include <memory>

#include "study/app/commands.h"

namespace study::app {

/// The command line of palpate. Parsing sets @p action to the action of the command that was
/// called.
/// @param action  must outlive the program.
std::unique_ptr<CLI::App> makeProgram(Action& action);

}  // namespace study::app
