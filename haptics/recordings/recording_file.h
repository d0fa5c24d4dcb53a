#pragma once

#include <cstdint>
#include <filesystem>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// No recording of a minute of cutting is larger than this [bytes].
inline constexpr std::uintmax_t kLargestRecording = 200'000'000;

/// Reads a recording from a file; see readRecording(). Its source is the file's name without its
/// folder.
///
/// @throws Error  if the file is missing, is a folder or anything else but a plain file, cannot be
///     read or is larger than kLargestRecording; and wherever readRecording() does.
Recording readRecordingFile(const std::filesystem::path& path);

}  // namespace haptics::recordings
