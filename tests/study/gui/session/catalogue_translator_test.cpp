#include "study/gui/session/catalogue_translator.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QRegularExpression>

#include "haptics/devices/device.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/messages.h"
#include "study/model/messages.h"
#include "study/model/run_mode.h"
#include "study/model/session_plan.h"
#include "study/model/session_state.h"
#include "study/model/storage_error.h"
#include "study/model/trial_record.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace study::gui {
namespace catalogue_translator_test {

namespace fs = std::filesystem;

// Possessive: a literal is never tried again in another way.
const std::string kLiteral = R"re((?:"(?:[^"\\]|\\.)*+"\s*+)++)re";

/// What a pattern finds in a text, or its @p group. Sources are long: std::regex would need more
/// stack than a test has.
std::vector<std::string> foundIn(
    const std::string& text, const std::string& pattern, int group = 0) {
  const QRegularExpression wanted(QString::fromStdString(pattern));
  EXPECT_TRUE(wanted.isValid()) << pattern;
  std::vector<std::string> found;
  auto matches = wanted.globalMatch(QString::fromStdString(text));
  while (matches.hasNext()) found.push_back(matches.next().captured(group).toStdString());
  return found;
}

/// The text of a literal, with the parts of a broken line joined.
std::string textOf(const std::string& literal) {
  std::string text;
  for (const auto& part : foundIn(literal, R"re("((?:[^"\\]|\\.)*+)")re", 1)) text += part;
  for (const auto& [written, meant] :
       {std::pair{"\\n", "\n"}, std::pair{"\\t", "\t"}, std::pair{"\\\"", "\""}}) {
    for (auto at = text.find(written); at != std::string::npos; at = text.find(written, at + 1)) {
      text.replace(at, 2, meant);
    }
  }
  return text;
}

/// The texts that a source hands to one of the functions @p names, "tr|deskText".
std::set<std::string> textsIn(const std::string& source, const std::string& names) {
  std::set<std::string> texts;
  for (const auto& one : foundIn(source, "\\b(?:" + names + ")\\(\\s*(" + kLiteral + ")", 1)) {
    texts.insert(textOf(one));
  }
  return texts;
}

bool isForParticipants(const fs::path& source) {
  return source.parent_path().filename() == "participant" || source.stem() == "screen_lock";
}

std::vector<fs::path> sourcesIn(const fs::path& folder) {
  std::vector<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".cpp") sources.push_back(entry.path());
  }
  return sources;
}

std::set<std::string> textsOfWindows(bool areForParticipants) {
  std::set<std::string> texts;
  for (const auto& source : sourcesIn(tests::repository() / "study" / "gui")) {
    if (isForParticipants(source) != areForParticipants) continue;
    texts.merge(textsIn(tests::contentOf(source), "tr|translated|deskText|inWords"));
  }
  return texts;
}

/// All that sources put between quotation marks, as it is shown: states of sessions without their
/// underscores.
std::set<std::string> literalsOfTheProgram() {
  std::set<std::string> texts;
  for (const auto* room : {"study", "haptics"}) {
    for (const auto& path : sourcesIn(tests::repository() / room)) {
      for (const auto& literal : foundIn(tests::contentOf(path), kLiteral)) {
        auto text = textOf(literal);
        texts.insert(text);
        std::replace(text.begin(), text.end(), '_', ' ');
        texts.insert(text);
      }
    }
  }
  return texts;
}

class CatalogueTranslatorTest : public testing::TestWithParam<std::string> {
 protected:
  void expectSamePlaces(const std::string& english, const std::string& text) {
    EXPECT_FALSE(text.empty()) << english;
    for (const auto& place : foundIn(english, R"(%\d+|\{[^}]*\})")) {
      EXPECT_NE(text.find(place), std::string::npos) << english;
    }
  }
};

TEST_P(CatalogueTranslatorTest, HasEveryTextOfTheParticipantsWindowsAndNoOther) {
  std::set<std::string> translated;
  const auto words = words::wordsIn(GetParam());
  for (const auto& [window, texts] : words.catalogue().windows) {
    for (const auto& [english, text] : texts) {
      translated.insert(english);
      expectSamePlaces(english, text);
    }
  }
  EXPECT_EQ(translated, textsOfWindows(true));
}

TEST_P(CatalogueTranslatorTest, HasEveryTextOfTheOperatorsWindowsAndNoOther) {
  const auto words = words::wordsIn(GetParam());
  const auto& desk = words.catalogue().desk;
  for (const auto& english : textsOfWindows(false)) {
    EXPECT_TRUE(desk.contains(english)) << "no text for '" << english << "'";
  }
  for (const auto& row : messages()) {
    for (const std::string text :
         {row.title,
          row.headline,
          row.data,
          row.advice,
          row.safe,
          row.action,
          row.label,
          row.missing}) {
      EXPECT_TRUE(text.empty() || desk.contains(text)) << "no text for '" << text << "'";
    }
  }
  const auto literals = literalsOfTheProgram();
  for (const auto& [english, text] : desk) {
    expectSamePlaces(english, text);
    EXPECT_TRUE(literals.contains(english)) << "nothing says '" << english << "'";
  }
}

template <typename Kind>
void expectNamesIn(const words::Catalogue& catalogue, int count) {
  for (int i = 0; i < count; ++i) {
    std::string name(nameOf(static_cast<Kind>(i)));
    std::replace(name.begin(), name.end(), '_', ' ');
    EXPECT_TRUE(catalogue.desk.contains(name)) << name;
  }
}

TEST_P(CatalogueTranslatorTest, HasWhatTheOperatorReadsOfStatesAndSteps) {
  const auto words = words::wordsIn(GetParam());
  const auto& catalogue = words.catalogue();
  expectNamesIn<RunMode>(catalogue, 3);
  expectNamesIn<Verdict>(catalogue, 3);
  expectNamesIn<StepKind>(catalogue, 9);
  for (int state = 0; state <= static_cast<int>(SessionState::Erased); ++state) {
    std::string status(statusOf(static_cast<SessionState>(state)));
    std::replace(status.begin(), status.end(), '_', ' ');
    EXPECT_TRUE(catalogue.desk.contains(status)) << status;
  }
}

std::vector<std::string> translations() {
  auto all = words::languages();
  all.erase(all.begin());  // English
  return all;
}
INSTANTIATE_TEST_SUITE_P(Languages, CatalogueTranslatorTest, testing::ValuesIn(translations()));

TEST(CatalogueTranslator, TranslatesTheParticipantsWindowsAndNoOther) {
  CatalogueTranslator translator;
  translator.setLanguage("de");
  EXPECT_FALSE(translator.isEmpty());
  const auto textOf = [&](const char* window, const char* english) {
    return translator.translate(window, english, nullptr, -1);
  };
  EXPECT_EQ(textOf("study::gui::ParticipantWindow", "Next"), QStringLiteral("Weiter"));
  EXPECT_TRUE(textOf("study::gui::OperatorWindow", "Next").isNull());
  EXPECT_TRUE(textOf("study::gui::ParticipantWindow", "no such text").isNull());
}

TEST(CatalogueTranslator, LeavesEnglishInALanguageWithoutACatalogue) {
  CatalogueTranslator translator;
  translator.setLanguage("de");
  for (const auto* language : {"en", "tlh"}) {
    translator.setLanguage(language);
    EXPECT_TRUE(translator.isEmpty()) << language;
    EXPECT_TRUE(
        translator.translate("study::gui::ParticipantWindow", "Next", nullptr, -1).isNull());
  }
}

class DeskLanguage : public testing::Test {
 protected:
  void TearDown() override { setDeskLanguage("en"); }

  static QString shown(const char* window, const char* english) {
    return QCoreApplication::translate(window, english);
  }
};

TEST_F(DeskLanguage, IsThatOfTheOperatorsWindowsOnly) {
  setDeskLanguage("de");
  EXPECT_EQ(deskLanguage(), "de");
  EXPECT_EQ(shown("study::gui::OperatorWindow", "Next"), QStringLiteral("Weiter"));
  EXPECT_EQ(shown("study::gui::HomeWindow", "Studies"), QStringLiteral("Studien"));
  EXPECT_EQ(deskText("live"), QStringLiteral("echt"));
  EXPECT_EQ(translated("{} warnings", 3), "3 Warnungen");
  // A session in English beside a German desk.
  EXPECT_EQ(shown("study::gui::ParticipantWindow", "Next"), QStringLiteral("Next"));
}

TEST_F(DeskLanguage, LeavesParticipantsTheLanguageOfTheirSession) {
  CatalogueTranslator session;
  session.setLanguage("nb");
  QCoreApplication::installTranslator(&session);
  setDeskLanguage("de");
  EXPECT_EQ(shown("study::gui::ParticipantWindow", "Next"), QStringLiteral("Neste"));
  EXPECT_EQ(shown("study::gui::HomeWindow", "Studies"), QStringLiteral("Studien"));
  QCoreApplication::removeTranslator(&session);
}

TEST_F(DeskLanguage, IsThatOfWhatTheStorageSays) {
  setDeskLanguage("de");
  const storage::StorageError full(
      message("storage.disk_full", "study.db"), storage::StorageError::Kind::DiskFull);
  EXPECT_TRUE(deskText(full).startsWith(
      QStringLiteral("study.db ließ sich nicht schreiben: Der Datenträger ist voll.")))
      << deskText(full).toStdString();
}

TEST_F(DeskLanguage, IsThatOfStepsThatAreCalledAsWhatTheyAre) {
  setDeskLanguage("de");
  const protocols::Labels labels;
  EXPECT_EQ(
      describe({.kind = StepKind::Consent, .phase = "consent"}, labels),
      QStringLiteral("Einwilligung"));
  EXPECT_EQ(
      describe({.kind = StepKind::Consent, .phase = "your-consent"}, labels),
      QStringLiteral("Your consent"));
}

TEST_F(DeskLanguage, IsEnglishWithoutACatalogue) {
  setDeskLanguage("tlh");
  EXPECT_EQ(deskLanguage(), "en");
  EXPECT_EQ(shown("study::gui::HomeWindow", "Studies"), QStringLiteral("Studies"));
  EXPECT_EQ(translated("{} warnings", 3), "3 warnings");
}

}  // namespace catalogue_translator_test
}  // namespace study::gui
