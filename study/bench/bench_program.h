#pragma once

#include <memory>

#include "study/app/commands.h"

namespace study::bench {

/// The command line of palpate-bench. Parsing it sets the action of the command that was called.
/// @param action  must outlive the program.
std::unique_ptr<CLI::App> makeBenchProgram(app::Action& action);

}  // namespace study::bench
