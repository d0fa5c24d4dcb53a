#pragma once

#include <string>

namespace haptics::recordings {

/// A number for a sentence: so many digits after a decimal point, whatever the locale.
std::string decimal(double value, int digits);

}  // namespace haptics::recordings
