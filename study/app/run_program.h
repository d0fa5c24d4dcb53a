#pragma once

#include "study/app/commands.h"

namespace study::app {

/// The main function of a program with commands: parses the call and runs its action. Errors are
/// printed to standard error after the program's name.
/// @param program  sets @p action while it parses the call.
/// @return the exit status: 0, 1 after an error or a negative result, 2 if the call is wrong.
int runProgram(CLI::App& program, const Action& action, int argc, char** argv);

}  // namespace study::app
