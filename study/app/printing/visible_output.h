#pragma once

#include <string>
#include <string_view>

namespace study::app {

/// Escapes control characters in text from files or from users, because a terminal would execute
/// them (clear the screen, set the title, insert input). They become JSON escapes, "\u001b", so
/// that JSON stays valid. Line feeds, tabs, and carriage returns before line feeds are kept.
/// Characters that reverse the direction of text (U+202A to U+202E, U+2066 to U+2069) are escaped,
/// too. Bytes that are not UTF-8 become U+FFFD.
class VisibleText {
 public:
  /// Escapes the next part of a text. A character may be divided between two parts.
  std::string operator()(std::string_view part);

 private:
  std::string pending_;  ///< incomplete character at the end of the last part
};

/// From now on escapes everything that this process prints to stdout and stderr as VisibleText
/// does; also if they are files or pipes, which may be shown on a terminal later.
void escapeControlCharactersInOutput();

}  // namespace study::app
