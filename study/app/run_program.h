#pragma once

#include "study/app/commands.h"

namespace study::app {

/// The main function of a program with commands: parses the call and runs the action. Prints errors
/// to standard error, with the program's name before them.
/// @param program  sets @p action during parsing.
/// @return the exit status: 0; 1 after an error or a negative result; 2 for a wrong call.
int runProgram(CLI::App& program, const Action& action, int argc, char** argv);

}  // namespace study::app
