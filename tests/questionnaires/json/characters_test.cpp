#include <string>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace characters_test {

TEST(CharactersIn, CountsCodePoints) {
  EXPECT_EQ(utf8CharacterCount(""), 0U);
  EXPECT_EQ(utf8CharacterCount("abc"), 3U);
  EXPECT_EQ(utf8CharacterCount("größe"), 5U);
  EXPECT_EQ(utf8CharacterCount("e\xCC\x81"), 2U);  // e and a combining accent
  EXPECT_EQ(utf8CharacterCount("مرحبا"), 5U);
  EXPECT_EQ(utf8CharacterCount("👍🏽"), 2U);  // a thumb and its skin tone
  EXPECT_EQ(utf8CharacterCount(std::string_view("a\0b", 3)), 3U);
}

TEST(CharactersIn, TakesTheEndsOfEveryLength) {
  for (const auto* text :
       {"\x7F",
        "\xC2\x80",
        "\xDF\xBF",
        "\xE0\xA0\x80",
        "\xED\x9F\xBF",
        "\xEE\x80\x80",
        "\xEF\xBF\xBF",
        "\xF0\x90\x80\x80",
        "\xF4\x8F\xBF\xBF"}) {
    EXPECT_EQ(utf8CharacterCount(text), 1U);
  }
}

TEST(CharactersIn, KnowsWhatIsNoUnicode) {
  for (const auto* text :
       {"\x80",
        "\xC0\x80",
        "\xC1\xBF",
        "\xC2",
        "\xC2!",
        "\xE0\x9F\xBF",
        "\xED\xA0\x80",
        "\xE1\x80",
        "\xF0\x8F\xBF\xBF",
        "\xF4\x90\x80\x80",
        "\xF5\x80\x80\x80",
        "\xFF",
        "ab\xE9"}) {
    EXPECT_FALSE(utf8CharacterCount(text).has_value());
  }
}

}  // namespace characters_test
}  // namespace questionnaires
