#include "study/app/printing/visible_output.h"

#include <gtest/gtest.h>

namespace study::app {
namespace visible_output_test {

std::string shown(std::string_view text) {
  return VisibleText()(text);
}

TEST(VisibleText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(shown("a\x1b[2Jb"), "a\\u001b[2Jb");
  EXPECT_EQ(shown("\a\b\x7f"), "\\u0007\\u0008\\u007f");
  EXPECT_EQ(shown(std::string_view("\0", 1)), "\\u0000");
  EXPECT_EQ(
      shown("\xc2\x9b"
            "31m"),
      "\\u009b31m");  // U+009B
  EXPECT_EQ(
      shown("\xe2\x80\xae"
            "abc"),
      "\\u202e"
      "abc");  // U+202E
}

TEST(VisibleText, KeepsTextAsItIs) {
  const std::string text =
      "Zeile\n\tSpalte – größer, 日本語, ‏עברית, 👩🏽‍⚕️\r\n";
  EXPECT_EQ(shown(text), text);
}

TEST(VisibleText, ShowsACarriageReturnThatWouldOverwriteALine) {
  EXPECT_EQ(shown("safe\rowned\n"), "safe\\u000downed\n");
}

TEST(VisibleText, ReplacesBytesThatAreNoUtf8) {
  EXPECT_EQ(
      shown("a\xff\x9b"
            "b"),
      "a\xef\xbf\xbd\xef\xbf\xbd"
      "b");
  EXPECT_EQ(shown("\xc0\x9b"), "\xef\xbf\xbd\xef\xbf\xbd");  // ESC-like, written too long
  EXPECT_EQ(shown("\xed\xa0\x80"), "\xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd");  // a surrogate
}

TEST(VisibleText, JoinsACharacterThatIsDividedBetweenTwoParts) {
  const std::string text =
      "é\xc2\x9b"
      "日\r\n";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    VisibleText visible;
    std::string shown = visible(text.substr(0, cut));
    shown += visible(text.substr(cut));
    EXPECT_EQ(shown, "é\\u009b日\r\n") << cut;
  }
}

}  // namespace visible_output_test
}  // namespace study::app
