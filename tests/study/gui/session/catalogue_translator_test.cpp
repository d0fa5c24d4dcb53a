#include "study/gui/session/catalogue_translator.h"

#include <filesystem>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study::gui {
namespace catalogue_translator_test {

namespace fs = std::filesystem;

/// The texts that a source hands to tr(), with the parts of a broken line joined.
std::set<std::string> textsIn(const std::string& source) {
  static const std::regex call(R"re(\btr\(\s*((?:"[^"]*"\s*)+))re");
  static const std::regex part(R"re("([^"]*)")re");
  std::set<std::string> texts;
  for (std::sregex_iterator at(source.begin(), source.end(), call), end; at != end; ++at) {
    const std::string parts = (*at)[1];
    std::string text;
    for (std::sregex_iterator one(parts.begin(), parts.end(), part); one != end; ++one) {
      text += (*one)[1];
    }
    texts.insert(text);
  }
  return texts;
}

std::set<std::string> textsOfTheParticipantsWindows() {
  const auto gui = tests::repository() / "study" / "gui";
  auto texts = textsIn(tests::contentOf(gui / "session" / "screen_lock.cpp"));
  for (const auto& entry : fs::directory_iterator(gui / "participant")) {
    if (entry.path().extension() == ".cpp") texts.merge(textsIn(tests::contentOf(entry.path())));
  }
  return texts;
}

class CatalogueTranslatorTest : public testing::TestWithParam<std::string> {};

TEST_P(CatalogueTranslatorTest, HasEveryTextOfTheParticipantsWindowsAndNoOther) {
  std::set<std::string> translated;
  const auto words = words::wordsIn(GetParam());
  for (const auto& [window, texts] : words.catalogue().windows) {
    for (const auto& [english, text] : texts) {
      translated.insert(english);
      EXPECT_FALSE(text.empty()) << window << ": " << english;
      for (const std::string place : {"%1", "%2", "%3", "%4", "%5", "%6"}) {
        const bool isPutIn = english.find(place) != std::string::npos;
        EXPECT_EQ(isPutIn, text.find(place) != std::string::npos) << english;
      }
    }
  }
  EXPECT_EQ(translated, textsOfTheParticipantsWindows());
}

INSTANTIATE_TEST_SUITE_P(Languages, CatalogueTranslatorTest, testing::Values("de", "nb"));

TEST(CatalogueTranslator, TranslatesTheParticipantsWindowsAndLeavesTheOperatorsInEnglish) {
  CatalogueTranslator translator;
  translator.speak("de");
  EXPECT_FALSE(translator.isEmpty());
  const auto said = [&](const char* window, const char* english) {
    return translator.translate(window, english, nullptr, -1);
  };
  EXPECT_EQ(said("study::gui::ParticipantWindow", "Next"), QStringLiteral("Weiter"));
  EXPECT_TRUE(said("study::gui::OperatorWindow", "Next").isNull());
  EXPECT_TRUE(said("study::gui::ParticipantWindow", "no such text").isNull());
}

TEST(CatalogueTranslator, LeavesEnglishInALanguageWithoutACatalogue) {
  CatalogueTranslator translator;
  translator.speak("de");
  for (const auto* language : {"en", "tlh"}) {
    translator.speak(language);
    EXPECT_TRUE(translator.isEmpty()) << language;
    EXPECT_TRUE(
        translator.translate("study::gui::ParticipantWindow", "Next", nullptr, -1).isNull());
  }
}

}  // namespace catalogue_translator_test
}  // namespace study::gui
