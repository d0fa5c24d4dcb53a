#pragma once

#include <string>

namespace tests {

/// The program 'palpate' of this build, with its sanitizers.
std::string program();

/// The release program, for tests that start it hundreds of times: named by the environment
/// variable PALPATE_RELEASE_PROGRAM; without it, the program of this build.
std::string releaseProgram();

/// The windows' program, 'palpate-studio', of this build.
std::string studio();

/// The release program of the windows, beside releaseProgram(), for tests that draw for seconds.
std::string releaseStudio();

/// The punch's firmware for its microcontroller; empty if it was not built.
std::string punchFirmware();

/// The running program: the tests themselves.
std::string thisProgram();

}  // namespace tests
