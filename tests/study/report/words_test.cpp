#include "study/words/words.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "analysis/data/reason.h"
#include "analysis/summary/flags.h"
#include "haptics/devices/messages.h"
#include "haptics/recordings/import_messages.h"
#include "haptics/registry/device_kinds.h"
#include "protocols/changed_meaning.h"
#include "protocols/load_protocol.h"
#include "protocols/model/messages.h"
#include "questionnaires/reading/instrument_problems.h"
#include "study/model/messages.h"
#include "study/report/html_report.h"
#include "study/report/small_samples.h"
#include "study/report/study_parts.h"
#include "study/report/tables/plan_tables.h"
#include "study/report/tables/statistics_tables.h"
#include "tests/study/made_study.h"
#include "tests/study/report/section.h"
#include "tests/support/test_data.h"

namespace study::words {
namespace words_test {

/// The placeholders in a sentence: "{}", "{:.2f}".
std::multiset<std::string> placesIn(const std::string& text) {
  std::multiset<std::string> places;
  for (auto at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    places.insert(text.substr(at, text.find('}', at) + 1 - at));
  }
  return places;
}

class WordsTest : public testing::TestWithParam<std::string> {};

/// The section of the other tests, with something in every part of its page.
report::ReportSection withEveryPart() {
  auto section = tests::madeUpSection();
  const std::string asked = "punch-face-validity";
  const std::string form = "background-knee";
  for (auto& instrument : section.instruments) {
    if (instrument.id == asked) instrument.consistency.emplace();
  }
  section.results.instruments = {
      {.instrument = asked,
       .scores =
           {{.score = "face-validity-1",
             .cohort = "professional",
             .condition = "kalman",
             .values = {3.0},
             .mean = 3.0}},
       .acceptable = {{.cohort = "professional", .condition = "kalman"}},
       .forms = 3,
       .contradictory = 1},
      {.instrument = asked, .forms = 3, .contradictory = 2}};
  section.results.answers.items = {
      {.instrument = asked,
       .item = "1.1",
       .cohort = "professional",
       .condition = "kalman",
       .values = {3.0, 3.0},
       .mean = 3.0,
       .median = 3.0,
       .least = 3.0,
       .most = 3.0},
      {.instrument = form,
       .item = "handedness",
       .cohort = "professional",
       .answers = 4,
       .options = {{"left", 2}, {"right", 1}, {"both", 1}}}};
  section.results.answers.quotes = {{"preference", "why", "kalman", "It was softer."}};
  section.figures.items = {{asked, "1.1", "<svg/>"}, {form, "handedness", "<svg/>"}};
  return section;
}

TEST_P(WordsTest, TranslateEverySentenceOfAReport) {
  std::vector<report::ReportSection> sections{withEveryPart()};
  auto& section = sections.front();
  section.words = wordsIn(GetParam());
  std::set<std::string_view> flags;
  for (const auto& cohort : section.results.families.front().cohorts) {
    for (const auto& flag : cohort.flags) flags.insert(flag.id);
  }
  EXPECT_EQ(flags.size(), 15U);  // every kind there is
  for (const bool isDeclared : {true, false}) {
    section.results.families.front().isDeclared = isDeclared;
    for (const auto test : {protocols::TestType::Welch, protocols::TestType::PairedT}) {
      section.results.families.front().family.test = test;
      report::asHtml(sections);
    }
  }
  section.results.runMode = RunMode::Pilot;
  section.firstDay = section.lastDay = "2026-03-01";
  section.history.changes.clear();
  report::asHtml(sections);
  const protocols::LocalizedText text(std::map<std::string, std::string>{{"en", "x."}});
  section.lastDay = "2026-03-09";
  for (auto& method : section.results.families.front().cohorts.front().checks.methods) {
    method.alpha.respondents = 4;
  }
  report::leaveOutSmallSamples(section.results, section.instruments);
  section.protocol.texts = {{"institution", text}, {"ethics", text}};
  report::asHtml(sections);
  section.history.versionsSinceBegun = 0;
  section.results.changes = {
      protocols::inWords(protocols::ChangedMeaning::Aspect::Title, 1, 6, "kalman")};
  report::asHtml(sections);
  for (const auto mode : {RunMode::Live, RunMode::Pilot, RunMode::Simulated}) {
    section.results.runMode = mode;
    report::answerInWords(section);
  }
  for (const auto profile : {Profile::Declared, Profile::AsPublished, Profile::Recommended}) {
    report::statisticsTables(section, profile);
  }
  std::string missing;
  for (const auto& sentence : section.words.missing()) missing += "  " + sentence + "\n";
  EXPECT_EQ(missing, "");
}

/// So that TranslateEverySentenceOfAReport looks at all of them.
TEST(Words, AreLookedForInEveryPartOfAReport) {
  const auto section = withEveryPart();
  for (const auto& part : report::commonParts()) EXPECT_NE(part.html(section), "") << part.heading;
}

TEST_P(WordsTest, TranslateEverySentenceOnSites) {
  std::vector<report::ReportSection> sections{tests::madeUpSectionOfSites()};
  auto& words = sections.front().words = wordsIn(GetParam());
  report::asHtml(sections);
  report::statisticsTables(sections.front(), Profile::Recommended);
  EXPECT_EQ(words.missing(), (std::set<std::string, std::less<>>()));
}

TEST_P(WordsTest, TranslateEverySentenceOfAPlan) {
  const auto words = wordsIn(GetParam());
  questionnaires::Problems problems;
  for (const auto* id : {"punch-face-validity", "punch-counterbalanced", "two-devices"}) {
    const auto protocol = *protocols::loadProtocolFile(id, problems);
    for (const std::uint64_t participants : {2, 12}) {
      const auto plan = planOf(protocol, {.participants = participants, .studies = 10});
      report::planInWords(plan, words);
      report::planTables(plan, words);
    }
  }
  StudyPlan empty;
  report::planInWords(empty, words);
  EXPECT_EQ(words.missing(), (std::set<std::string, std::less<>>()));
}

TEST_P(WordsTest, HaveTheSamePlaceholders) {
  const auto words = wordsIn(GetParam());
  for (const auto& [english, translated] : words.catalogue().texts) {
    EXPECT_EQ(placesIn(english), placesIn(translated)) << english;
    EXPECT_FALSE(translated.empty()) << english;
  }
}

/// The messages of all rooms that a report may show.
std::map<std::string_view, std::string_view> allMessages() {
  std::map<std::string_view, std::string_view> all;
  const auto add = [&](const auto& table) {
    for (const auto& kind : table) {
      EXPECT_TRUE(all.emplace(kind.key, kind.english).second) << kind.key << " is there twice";
    }
  };
  add(analysis::kReasons);
  add(analysis::kFlagMessages);
  add(analysis::kWithinMessages);
  add(report::kSmallSampleMessages);
  add(questionnaires::kWarnings);
  add(protocols::kMessages);
  add(haptics::recordings::kImportMessages);
  add(haptics::devices::kDeviceMessages);
  add(kMessages);
  return all;
}

TEST_P(WordsTest, HaveEveryMessageWithItsArguments) {
  const auto all = allMessages();
  const auto words = wordsIn(GetParam());
  const auto& known = words.catalogue().messages;
  for (const auto& [key, english] : all) {
    const auto found = known.find(key);
    ASSERT_NE(found, known.end()) << key;
    EXPECT_EQ(placesIn(std::string(english)), placesIn(found->second)) << key;
  }
  EXPECT_EQ(known.size(), all.size()) << "one of them is in no table any more";
}

TEST_P(WordsTest, FillNumbersAndNamesIntoMessages) {
  const auto words = wordsIn(GetParam());
  const auto late = message("trial.late", 30, 4000);
  EXPECT_NE(words(late), base::describe(late));
  EXPECT_NE(words(late).find("30"), std::string::npos);
  EXPECT_NE(words(late).find("4000"), std::string::npos);
  const auto effect = analysis::reason("dependent_effect", "method kalman");
  EXPECT_NE(words(effect).find("'method kalman'"), std::string::npos) << words(effect);
  EXPECT_EQ(words(std::vector{late, late}), words(late) + "; " + words(late));
  EXPECT_EQ(words(base::Message()), "");
  EXPECT_EQ(words(base::Message::verbatim("5 of this")), "5 of this");
  EXPECT_TRUE(words.missing().empty());
}

/// The visible text of a page: without markup, style and code.
std::string readIn(std::string page) {
  for (const auto* hidden :
       {"<style>[^]*?</style>",
        "<code>[^]*?</code>",
        "<p class=\"reference\">[^]*?</p>",
        "<[^>]*>"}) {
    page = std::regex_replace(page, std::regex(hidden), " ");
  }
  return page;
}

/// Sentences of a page with words that exist in English only.
std::string englishIn(const std::string& page) {
  const std::regex english(
      R"re(\b(the|of|is|and|not|with|there|that|this|are|which|every|only|they|what|were|has)\b)re",
      std::regex::icase);
  const std::string read = readIn(page);
  std::string found;
  for (std::sregex_iterator word(read.begin(), read.end(), english), end; word != end; ++word) {
    const auto at = static_cast<std::size_t>(word->position());
    found += "  …" + read.substr(at < 40 ? 0 : at - 40, 90) + "…\n";
  }
  return found;
}

TEST_P(WordsTest, LeaveNoEnglishInAReport) {
  std::vector<report::ReportSection> sections{tests::madeUpSection()};
  auto& section = sections.front();
  section.words = wordsIn(GetParam());
  section.protocol.study = {.id = "x", .title = "x", .version = "1"};
  section.results.families.front().family.title = "x";
  for (auto& family : section.protocol.analysis.families) family.title = "x";
  for (auto& instrument : section.instruments) instrument.source.citation.clear();
  std::erase_if(section.warnings, [](const auto& warning) {
    return base::describe(warning.what).find("[[") != std::string::npos;  // a placeholder
  });
  EXPECT_FALSE(section.warnings.empty());
  section.quality.reasons = {
      {{message("trial.late.machine", 30, 4000, 2), message("trial.samples_lost.one", 1)}, 2}};
  EXPECT_EQ(englishIn(report::asHtml(sections)), "");
  section.words = {};
  EXPECT_NE(englishIn(report::asHtml(sections)), "") << "or this test sees nothing";
}

/// The short protocol, whose first condition has its own knee.
/// @param normal  of one of its surfaces, as OBJ; empty: no surface has any
/// @param show  "true" or "false", of all conditions
protocols::LoadedProtocol withAKnee(const std::string& normal, const std::string& show) {
  auto json = tests::shortProtocol();
  const std::string beyond = R"("beyond": "ramp-out"})";
  json.insert(json.find(beyond) + beyond.size(), R"(, "anatomy": "knee.obj")");
  json = std::regex_replace(
      json,
      std::regex(R"("device": "punch", "model")"),
      R"("device": "punch", "visualisation": )" + show + R"(, "model")");
  const std::string corners = "v -30 -2 30\nv 30 -2 30\nv 30 -2 -30\n";
  const std::string faces = normal.empty() ? "f 1 2 3\n" : "f 1//1 2//1 3//1\n";
  return tests::protocolFrom(
      json,
      {{"knee.obj",
        "o tibia\n" + corners + normal + faces + "o capsule\n" + corners + "vn 0 1 0\n" +
            (normal.empty() ? "f 4//1 5//1 6//1\n" : "f 4//2 5//2 6//2\n")}});
}

TEST_P(WordsTest, DescribeAKneeInTheReportsLanguage) {
  std::set<std::string_view> said;
  for (const auto& [normal, show] : {std::pair{"", "true"}, std::pair{"vn 0 0 0\n", "false"}}) {
    tests::MadeStudy study(withAKnee(normal, show));
    const auto section = report::gather(*study, RunMode::Simulated, wordsIn(GetParam()));
    for (const auto& warning : section.warnings) {
      EXPECT_NE(section.words(warning.what), base::describe(warning.what));
      EXPECT_NE(section.words(warning.fix), base::describe(warning.fix));
      said.insert(warning.what.key());
    }
    const auto page = report::methodsAsHtml(section);
    const auto& seen = section.words("What was seen came from:");
    ASSERT_NE(page.find(seen), std::string::npos) << page;
    const auto list = page.substr(page.find(seen));
    EXPECT_NE(
        list.find(
            section.words(protocols::message("source.tibia")) + ", " +
            section.words(protocols::message("source.capsule")) + ": The title of interp"),
        std::string::npos)
        << list;
    EXPECT_NE(list.find(section.words(protocols::message("source.knee"))), std::string::npos)
        << list;
    EXPECT_EQ(page.find(section.words("What was felt came from:") + "</p><ul></ul>"), page.npos);
    EXPECT_TRUE(section.words.missing().empty()) << *section.words.missing().begin();
    EXPECT_NE(section.words("anatomy"), "anatomy");
  }
  for (const auto* key :
       {"knee_never_seen", "no_normals", "normals_without_direction", "other_knee"}) {
    EXPECT_EQ(said.count(key), 1U) << key;
  }
}

std::vector<std::string> translations() {
  auto all = languages();
  all.erase(all.begin());  // English
  return all;
}
INSTANTIATE_TEST_SUITE_P(Languages, WordsTest, testing::ValuesIn(translations()));

TEST(Words, AreThereInEveryLanguageThatHasACatalogue) {
  std::set<std::string> expected{"en"};
  const auto library = tests::repository() / "study/words/library";
  for (const auto& file : std::filesystem::directory_iterator(library)) {
    expected.insert(file.path().stem().string());
  }
  const auto known = languages();
  EXPECT_EQ(known.front(), "en");
  EXPECT_EQ(std::set(known.begin(), known.end()), expected);
}

/// The English of what @p kind has sentences of its own for in @p language.
std::set<std::string_view> ownSentences(
    const haptics::devices::DeviceKind& kind, std::string_view language) {
  std::set<std::string_view> sentences;
  for (const auto& sentence : kind.sentences) {
    if (sentence.language == language) sentences.insert(sentence.english);
  }
  return sentences;
}

TEST_P(WordsTest, AreThereForEveryKindOfDevice) {
  for (const auto* kind : haptics::deviceKinds()) {
    for (const auto* text :
         {&kind->strokeName, &kind->strokesName, &kind->strokeHint, &kind->pointerHint}) {
      EXPECT_EQ(
          std::ranges::count(
              text->others(), GetParam(), &haptics::devices::Text::InLanguages::value_type::first),
          1)
          << kind->name << ": " << text->in("en");
    }
    EXPECT_EQ(ownSentences(*kind, GetParam()), ownSentences(*kind, "de")) << kind->name;
  }
}

TEST(Words, AreEnglishByDefault) {
  EXPECT_EQ(wordsIn("en")("Participants"), "Participants");
  EXPECT_EQ(wordsIn("de")("no such sentence"), "no such sentence");
  EXPECT_THROW(wordsIn("tlh"), std::invalid_argument);
}

}  // namespace words_test
}  // namespace study::words
