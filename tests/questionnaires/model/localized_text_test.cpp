#include <map>
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/model/instrument.h"

namespace questionnaires {
namespace localized_text_test {

const LocalizedText kThanks({{"en", "Thank you"}, {"de", "Danke"}});

TEST(LocalizedText, ReturnsTheRequestedLanguage) {
  EXPECT_EQ(kThanks.in("de"), "Danke");
}

TEST(LocalizedText, FallsBackToEnglish) {
  EXPECT_EQ(kThanks.in("nb"), "Thank you");
}

TEST(LocalizedText, IsSilentWhereItHasNeither) {
  EXPECT_EQ(LocalizedText().in("de"), "");
  const std::map<std::string, std::string> german{{"de", "Danke"}};
  EXPECT_EQ(LocalizedText(german).in("nb"), "");
}

}  // namespace localized_text_test
}  // namespace questionnaires
