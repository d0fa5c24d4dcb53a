#pragma once

#include <string>
#include <string_view>

namespace study::app {

/// Escapes control characters in text that came from a file or was typed, because a terminal would
/// execute them (clear the screen, set the title, insert input). They become JSON escapes,
/// "\u001b", so that JSON stays valid. Line feed, tab, and a carriage return before a line feed are
/// kept. Characters that reverse the direction of text (U+202A to U+202E, U+2066 to U+2069) are
/// escaped as well. Bytes that are not UTF-8 become U+FFFD.
class VisibleText {
 public:
  /// Escapes the next part of the text; a character may be divided between two parts.
  std::string operator()(std::string_view part);

 private:
  std::string pending_;  ///< the incomplete character at the end of the last part
};

/// Escapes all further output of this process to stdout and stderr as VisibleText does, also to
/// files and pipes, which may be shown on a terminal later.
void escapeControlCharactersInOutput();

}  // namespace study::app
