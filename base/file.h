#pragma once

#include <istream>
#include <string>

namespace base {

/// All bytes from the current position to the end of @p stream. If reading fails, the stream is
/// `bad()` afterwards.
std::string readAll(std::istream& stream);

}  // namespace base
