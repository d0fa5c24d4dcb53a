#pragma once

#include <istream>
#include <string>

namespace base {

/// All bytes from here to the end. A stream that cannot be read to its end is `bad()` afterwards.
std::string readAll(std::istream& stream);

}  // namespace base
