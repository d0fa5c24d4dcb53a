#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

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

/// Reads a recording of the punch: five numbers per line – force reading, grams, potentiometer,
/// travel, time [ms] – between tabs or blanks, without a heading.
///
/// Lines end with LF, and what stands before it is taken off: CR, backslash (residue of an RTF
/// export), and after these closing braces. A lone CR is a blank. What remains must be five
/// numbers within the range of their column, with a decimal point; anything else that is not
/// empty is refused and counted, never guessed. That goes for a last row that was cut off, too:
/// one that lacks columns, or whose line does not end and whose time lies before the row above.
///
/// @param source  what messages and provenance call it.
/// @throws Error  if there is nothing in it, if it is no text, if no line of it is a row (a file
///     of four columns lacks the raw potentiometer and is told so), or if time runs backwards.
Recording readRecording(std::string_view text, std::string_view source = "the recording");

}  // namespace haptics::recordings
