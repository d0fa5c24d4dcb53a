#pragma once

#include "study/app/commands.h"

namespace study::app {

/// The main function of a program with commands: parses the call and does what it asks for. Errors
/// go to standard error with the program's name.
/// @param program  sets @p action when it is parsed.
/// @return the exit status: 0, or 1 where it could not be done, or 2 where the call is wrong.
int runProgram(CLI::App& program, const Action& action, int argc, char** argv);

}  // namespace study::app
