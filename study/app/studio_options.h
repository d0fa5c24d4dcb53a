#pragma once

#include "study/app/command_reference.h"

namespace study::app {

/// The command line of palpate-studio, for its parser and its manual page.
CommandDescription describeStudio();

/// The longest name of an option, without dashes: "devices".
std::string nameOf(const OptionDescription& option);

}  // namespace study::app
