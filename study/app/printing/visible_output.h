#pragma once

#include <string>
#include <string_view>

namespace study::app {

/// Makes text visible that came from a file or was typed: a terminal would obey the control
/// characters in it (clear the screen, set the title, answer as if someone typed). They are shown
/// as JSON escapes, "\u001b", so that JSON stays valid. Kept are line feed, tab, and a carriage
/// return before a line feed. Also escaped are the characters that reverse the direction of text
/// (U+202A to U+202E, U+2066 to U+2069). Bytes that are no UTF-8 become U+FFFD.
class VisibleText {
 public:
  /// The next part of the text; a character may be divided between two parts.
  std::string operator()(std::string_view part);

 private:
  std::string pending_;  ///< the beginning of a character
};

/// From now on all that this process prints to stdout and stderr is visible text, whether it goes
/// to a terminal, or to a file or a pipe, which may be shown on one later.
void printOnlyVisibleText();

}  // namespace study::app
