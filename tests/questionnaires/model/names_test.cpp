#include <array>
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace names_test {

TEST(IsSoundId, AcceptsWhatFileAndColumnNamesAllow) {
  for (const auto* id : {"a", "1.1", "realism-common", "A_b", "9"})
    EXPECT_TRUE(isValidId(id)) << id;
  EXPECT_TRUE(isValidId(std::string(64, 'x')));
}

TEST(IsSoundId, RefusesWhatFileAndColumnNamesDoNotAllow) {
  for (const auto* id : {"", ".a", "-a", "_a", "a b", "a/b", "a,b", "ä", "a\n", "../a"}) {
    EXPECT_FALSE(isValidId(id)) << id;
  }
  EXPECT_FALSE(isValidId(std::string(65, 'x')));
}

TEST(Nearest, FindsAWordWithOneTypingError) {
  constexpr std::array<std::string_view, 3> kKnown{"title", "introduction", "scale"};
  for (const auto* slip : {"titel", "tite", "tittle", "tidle", "tltle"}) {
    EXPECT_EQ(nearest(slip, kKnown), "title") << slip;
  }
}

TEST(Nearest, FindsNothingForAnUnrelatedWord) {
  constexpr std::array<std::string_view, 2> kKnown{"id", "title"};
  EXPECT_FALSE(nearest("xy", kKnown).has_value());
  EXPECT_FALSE(nearest("", kKnown).has_value());
  EXPECT_FALSE(nearest(std::string(100'000, 'x'), kKnown).has_value());
}

TEST(Shown, CutsBetweenCharacters) {
  for (std::size_t padding = 0; padding < 4; ++padding) {
    const std::string cut = shown(
        std::string(padding, 'x') + std::string("😀😀😀😀😀😀😀😀😀😀😀"
                                                "😀😀😀😀😀😀😀😀😀😀😀"));
    EXPECT_TRUE(utf8CharacterCount(cut).has_value()) << padding;
    EXPECT_LT(cut.size(), 90U);
  }
}

TEST(Shown, IsOneSoundLine) {
  EXPECT_EQ(shown("a\nb\x1b[31m\x7f"), "a?b?[31m?");
  EXPECT_EQ(shown("caf\xE9"), "caf?");
  EXPECT_EQ(shown("café"), "café");
}

TEST(NumberInWords, HasNoNeedlessDigits) {
  EXPECT_EQ(shown(0.1), "0.1");
  EXPECT_EQ(shown(100.0), "100");
  EXPECT_EQ(shown(-1e9), "-1000000000");
  EXPECT_EQ(shown(1e300), "any size");
}

}  // namespace names_test
}  // namespace questionnaires
