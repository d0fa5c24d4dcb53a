#pragma once

#include <string>

namespace tests {

/// The program 'palpate' that is tested from outside: of this build, or the one that the environment
/// variable PALPATE_PROGRAM names.
std::string program();

/// The windows, 'palpate-studio': of this build, or the one in PALPATE_STUDIO_PROGRAM.
std::string studio();

/// The punch's own program for its microcontroller; empty where it was not built.
std::string punchFirmware();

/// The program that is running: the tests themselves.
std::string thisProgram();

}  // namespace tests
