#pragma once

#include <filesystem>
#include <istream>
#include <optional>
#include <string>

namespace base {

/// All bytes from the current position to the end of @p stream. If reading fails, the stream is
/// `bad()` afterwards.
std::string readAll(std::istream& stream);

/// All bytes of a file; std::nullopt if it cannot be opened or read to its end.
std::optional<std::string> readFile(const std::filesystem::path& path);

}  // namespace base
