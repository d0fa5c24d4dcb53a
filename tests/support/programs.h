#pragma once

#include <string>

namespace tests {

/// The program 'palpate' of this build, with the sanitizers that it was built with.
std::string program();

/// The program as it is shipped, for tests that start it hundreds of times: the environment
/// variable PALPATE_RELEASE_PROGRAM names it; without it, the program of this build.
std::string releaseProgram();

/// The windows, 'palpate-studio', of this build.
std::string studio();

/// The windows as they are shipped, beside releaseProgram(); for tests that draw for seconds.
std::string releaseStudio();

/// The punch's own program for its microcontroller; empty where it was not built.
std::string punchFirmware();

/// The program that is running: the tests themselves.
std::string thisProgram();

}  // namespace tests
