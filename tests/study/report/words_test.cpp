#include "study/words/words.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include <gtest/gtest.h>

#include "study/report/html_report.h"
#include "study/report/study_parts.h"
#include "tests/study/made_study.h"
#include "tests/study/report/section.h"
#include "tests/support/test_data.h"

namespace study::words {
namespace words_test {

/// The places in a sentence where something is put in: "{}", "{:.2f}".
std::multiset<std::string> placesIn(const std::string& text) {
  std::multiset<std::string> places;
  for (auto at = text.find('{'); at != std::string::npos; at = text.find('{', at + 1)) {
    places.insert(text.substr(at, text.find('}', at) + 1 - at));
  }
  return places;
}

class WordsTest : public testing::TestWithParam<std::string> {};

TEST_P(WordsTest, SayEverySentenceOfAReport) {
  std::vector<report::ReportSection> sections{tests::madeUpSection()};
  auto& section = sections.front();
  section.words = wordsIn(GetParam());
  std::set<std::string_view> flags;
  for (const auto& cohort : section.results.families.front().cohorts) {
    for (const auto& flag : cohort.flags) flags.insert(flag.id);
  }
  EXPECT_EQ(flags.size(), 13U);  // every kind there is
  for (const bool isDeclared : {true, false}) {
    section.results.families.front().isDeclared = isDeclared;
    for (const auto test : {protocols::TestType::Welch, protocols::TestType::PairedT}) {
      section.results.families.front().family.test = test;
      report::asHtml(sections);
    }
  }
  section.results.runMode = RunMode::Pilot;
  section.history.changes.clear();
  report::asHtml(sections);
  section.history.versionsSinceBegun = 0;
  report::asHtml(sections);
  std::string missing;
  for (const auto& sentence : section.words.missing()) missing += "  " + sentence + "\n";
  EXPECT_EQ(missing, "");
}

TEST_P(WordsTest, PutTheSameThingsIn) {
  const auto words = wordsIn(GetParam());
  for (const auto& [english, translated] : words.catalogue()) {
    EXPECT_EQ(placesIn(english), placesIn(translated)) << english;
    EXPECT_FALSE(translated.empty()) << english;
  }
}

std::string sourceOf(const std::string& file) {
  std::ifstream stream(tests::repository() / file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Every sentence with which these kernels say why there is no number.
std::vector<std::string> reasonsIn(const std::string& file) {
  const std::regex assigned(R"re(reason =\s*((?:[^;"]*"[^"]*")+[^;"]*);)re");
  const std::regex literal(R"re("([^"]*)")re");
  const std::string source = sourceOf(file);
  std::vector<std::string> reasons;
  for (std::sregex_iterator found(source.begin(), source.end(), assigned), end; found != end;
       ++found) {
    const std::string right = (*found)[1];
    const bool isChoice = right.find('?') != std::string::npos;
    std::string whole;
    for (std::sregex_iterator part(right.begin(), right.end(), literal); part != end; ++part) {
      if (isChoice) reasons.push_back((*part)[1]);
      whole += (*part)[1];
    }
    if (!isChoice) reasons.push_back(whole);
  }
  return reasons;
}

TEST_P(WordsTest, KnowEveryReasonOfTheKernels) {
  const auto words = wordsIn(GetParam());
  std::size_t seen = 0;
  for (const auto* kernel :
       {"tests/friedman",
        "tests/paired_t",
        "tests/sign_flip",
        "tests/signed_rank",
        "tests/equivalence",
        "models/linear_mixed_model",
        "models/cumulative_link_mixed_model",
        "tests/repeated_measures_anova",
        "summary/position_effect",
        "summary/within_analysis"}) {
    for (const auto& reason : reasonsIn("analysis/" + std::string(kernel) + ".cpp")) {
      EXPECT_NE(words.known(reason), reason) << kernel;
      ++seen;
    }
  }
  EXPECT_GT(seen, 20U);
}

TEST_P(WordsTest, PutNumbersAndNamesIntoWhatOthersSay) {
  const auto words = wordsIn(GetParam());
  const auto& pattern = words.catalogue().at("{} of {} ticks were late");
  const auto begin = pattern.find("{}");
  EXPECT_EQ(words.known("30 of 4000 ticks were late").find("30"), begin);
  for (const auto* said :
       {"passivity (b > KT/2) needs 0.0123 N·s/m of damping, the device has 5e-05, the rest is the "
        "hand's",
        "the dead-man switch was released (3×, 0.120 s)",
        "the fixed effect 'method kalman' cannot be told apart from the others: it is a "
        "combination of them",
        "group 1 has no values, and the test needs two in each group",
        "'participant' and 'round' group the answers alike: their variances cannot be told apart",
        "The punch paper's 0.017 for 0.05/3"}) {
    const auto translated = words.known(said);
    EXPECT_NE(translated, said);
    EXPECT_EQ(translated.find("{}"), std::string::npos) << translated;
  }
  EXPECT_NE(
      words.known("group 1 has no values, and the test needs two in each group").find("1"),
      std::string::npos);
  EXPECT_EQ(words.known("nobody ever said 5 of this"), "nobody ever said 5 of this");
  EXPECT_EQ(
      words.knownList("Fisher 1935; docs/statistics.md, planning"),
      "Fisher 1935; " + words.known("docs/statistics.md, planning"));
}

/// What is read in a page: without its marks, its style and what stands in code.
std::string readIn(std::string page) {
  for (const auto* hidden : {"<style>[^]*?</style>", "<code>[^]*?</code>", "<[^>]*>"}) {
    page = std::regex_replace(page, std::regex(hidden), " ");
  }
  return page;
}

/// Sentences of a page that have words in them which only English has.
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
    return warning.what.find("[[") != std::string::npos;  // quotes what is to be filled in
  });
  EXPECT_FALSE(section.warnings.empty());
  section.quality.reasons = {
      "30 of 4000 ticks were late, 2 of them because the machine itself stood still; "
      "1 sample was lost"};
  EXPECT_EQ(englishIn(report::asHtml(sections)), "");
  section.words = {};
  EXPECT_NE(englishIn(report::asHtml(sections)), "") << "or this test sees nothing";
}

/// The short protocol, whose first condition alone has a knee of its own.
/// @param normal  of one of its surfaces, as OBJ; empty: neither has any
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

TEST_P(WordsTest, TellOfAKneeInTheReportsLanguage) {
  std::set<std::string> said;
  for (const auto& [normal, show] : {std::pair{"", "true"}, std::pair{"vn 0 0 0\n", "false"}}) {
    tests::MadeStudy study(withAKnee(normal, show));
    const auto section = report::gather(*study, RunMode::Simulated, wordsIn(GetParam()));
    for (const auto& warning : section.warnings) {
      EXPECT_NE(section.words.known(warning.what), warning.what);
      EXPECT_NE(section.words.known(warning.fix), warning.fix);
      said.insert(warning.what);
    }
    const auto page = report::methodsAsHtml(section);
    const auto& seen = section.words("What was seen came from:");
    ASSERT_NE(page.find(seen), std::string::npos) << page;
    const auto list = page.substr(page.find(seen));
    EXPECT_NE(
        list.find(
            section.words("tibia") + ", " + section.words("capsule") + ": The title of interp"),
        std::string::npos)
        << list;
    EXPECT_NE(list.find(section.words("The knee that is seen")), std::string::npos) << list;
    EXPECT_EQ(page.find(section.words("What was felt came from:") + "</p><ul></ul>"), page.npos);
    EXPECT_TRUE(section.words.missing().empty()) << *section.words.missing().begin();
    EXPECT_NE(section.words.known("anatomy"), "anatomy");
  }
  for (const auto* what :
       {"it is never seen",
        "it has no normals",
        "of its normals have no direction",
        "shows another knee than"}) {
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [&](const auto& one) {
      return one.find(what) != std::string::npos;
    })) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Languages, WordsTest, testing::Values("de", "nb"));

TEST(Words, AreEnglishWhereNothingElseIsSaid) {
  EXPECT_EQ(wordsIn("en")("Participants"), "Participants");
  EXPECT_EQ(wordsIn("de")("no such sentence"), "no such sentence");
  EXPECT_EQ(languages(), (std::vector<std::string>{"en", "de", "nb"}));
  EXPECT_THROW(wordsIn("tlh"), std::invalid_argument);
}

}  // namespace words_test
}  // namespace study::words
