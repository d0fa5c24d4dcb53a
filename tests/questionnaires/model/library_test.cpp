#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "tests/questionnaires/shipped_instruments.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace questionnaires {
namespace library_test {

const std::filesystem::path kFolder = tests::repository() / "questionnaires/library";

using tests::isInstrument;
using tests::shipped;
using tests::visibleTexts;

TEST(Library, HoldsTheFilesOfItsFolder) {
  std::set<std::string> onDisk;
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    onDisk.insert(entry.path().filename().string());
  }
  std::set<std::string> embedded;
  for (const auto& file : libraryFiles()) {
    embedded.insert(std::string(file.name));
    EXPECT_EQ(file.content, tests::contentOf(kFolder / file.name)) << file.name;
  }
  EXPECT_EQ(embedded, onDisk);
}

TEST(Library, ReadsWithoutErrors) {
  for (const auto& file : libraryFiles()) {
    if (!isInstrument(file.name)) continue;
    Problems problems;
    EXPECT_TRUE(readInstrument(file.content, problems).has_value()) << file.name;
    EXPECT_FALSE(problems.hasErrors()) << file.name << "\n" << describe(problems.all());
  }
}

TEST(Library, WarnsOnlyOfComparisonsAndOfWhatIsToBeFilledIn) {
  for (const auto& [id, instrument] : shipped()) {
    for (const auto& problem : problemsOf(instrument).all()) {
      const bool isComparison = problem.path.find(".relative_to") != std::string::npos;
      const bool isPlaceholder =
          base::describe(problem.what).find("still to be filled in") != std::string::npos;
      EXPECT_TRUE(isPlaceholder || (isComparison && id == "punch-face-validity"))
          << id << "\n"
          << problem.path << " " << base::describe(problem.what);
    }
  }
}

TEST(Library, CallsEveryFileAfterItsInstrument) {
  for (const auto& file : libraryFiles()) {
    const std::string stem = std::filesystem::path(file.name).stem().string();
    EXPECT_TRUE(!isInstrument(file.name) || shipped().count(stem) == 1) << file.name;
  }
}

TEST(Library, IsCompleteInThreeLanguages) {
  const std::vector<std::string> languages{"en", "de", "nb"};
  // Terms of others, of which we know no established translation.
  const std::map<std::string, std::vector<std::string>> fewer{
      {"sim-tlx", {"en"}}, {"ssq", {"en"}}, {"ueq", {"en", "de"}}};
  for (const auto& [id, instrument] : shipped()) {
    const auto exception = fewer.find(id);
    EXPECT_EQ(instrument.languages, exception == fewer.end() ? languages : exception->second) << id;
    for (const auto& text : visibleTexts(instrument)) {
      for (const auto& language : instrument.languages) {
        EXPECT_TRUE(text.isEmpty() || text.has(language)) << id << ": " << text.in("en");
      }
    }
  }
}

TEST(Library, ShipsNoSentencesOfOthers) {
  for (const auto* id : {"sus", "ipq", "slater-usoh-steed"}) {
    const auto& instrument = shipped().at(id);
    EXPECT_FALSE(instrument.source.wordingFrom.empty()) << id;
    for (const auto& item : instrument.items) {
      EXPECT_TRUE(item.withholds(WordingField::Text)) << id << " " << item.id;
      EXPECT_TRUE(item.text.isEmpty()) << id << " " << item.id;
    }
  }
}

TEST(Library, SetsAThresholdForEveryAspectOfRealism) {
  for (const auto& item : shipped().at("simulator-realism").items) {
    EXPECT_EQ(item.acceptableFrom, 7.0) << item.id;
    EXPECT_EQ(item.scale.highest(), 10) << item.id;
    EXPECT_FALSE(item.isRequired) << item.id;
  }
}

TEST(Library, SaysWhereEverythingComesFrom) {
  for (const auto& [id, instrument] : shipped()) {
    EXPECT_FALSE(instrument.source.citation.empty()) << id;
    EXPECT_FALSE(instrument.source.licence.empty()) << id;
  }
  EXPECT_EQ(shipped().at("ueq-s").source.doi, "10.9781/ijimai.2017.09.001");
}

/// The paragraphs of a file in Debian's format that are about files: per path, its other lines.
std::map<std::string, std::string> licencesIn(const std::filesystem::path& file) {
  std::map<std::string, std::string> licences;
  std::istringstream lines(tests::contentOf(file));
  std::vector<std::string> paths;
  bool areFiles = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) paths.clear();
    if (line.empty() || line[0] != ' ') areFiles = line.rfind("Files: ", 0) == 0;
    if (!areFiles) {
      for (const auto& path : paths) licences[path] += line + "\n";
      continue;
    }
    std::istringstream words(line.substr(line[0] == ' ' ? 0 : std::string("Files:").size()));
    for (std::string path; words >> path;) paths.push_back(path);
  }
  return licences;
}

TEST(Library, HasTheLicencesThatThePackageAndReuseGiveIt) {
  const auto reuse = licencesIn(tests::repository() / ".reuse/dep5");
  EXPECT_EQ(licencesIn(tests::repository() / "study/app/install/copyright"), reuse);
  for (const auto& [id, instrument] : shipped()) {
    const auto found = reuse.find("questionnaires/library/" + id + ".json");
    ASSERT_NE(found, reuse.end()) << id << " is under the licence of the program";
    const auto& terms = found->second;
    const bool isAllOurs = instrument.source.licence.rfind("CC0-1.0", 0) == 0;
    const std::string holder = "Copyright: 2026 The Palpate authors";
    EXPECT_EQ(terms.rfind(holder + (isAllOurs ? "\n" : ", for what is theirs\n"), 0), 0U)
        << id << ": " << instrument.source.licence << "\n"
        << terms;
    EXPECT_NE(terms.find("License: CC0-1.0\n"), std::string::npos) << id << "\n" << terms;
  }
}

/// Table 1 of the punch paper; the sign says which statements the paper turned round.
const std::vector<std::tuple<std::string, int, std::string>> kTable1{
    {"1.1", 1, "The haptic rendering was similar to the benchmark cut."},
    {"1.2", -1, "The haptic rendering was too soft."},
    {"1.3", 1, "The haptic rendering provided a realistic representation."},
    {"2.1", -1, "The haptic rendering was not similar to the benchmark cut."},
    {"2.2", 1, "The haptic rendering provided a realistic representation."},
    {"2.3", 1, "The haptic rendering was more realistic than the previous cut."},
    {"3.1", -1, "The previous haptic rendering was more realistic than the current cut."},
    {"3.2", 1, "The haptic rendering was similar to the benchmark cut."},
    {"3.3", -1, "The haptic rendering did not provide a realistic representation."},
};

TEST(PunchFaceValidity, AsksTheStatementsOfTable1) {
  const auto& punch = shipped().at("punch-face-validity");
  ASSERT_EQ(punch.items.size(), kTable1.size());
  for (std::size_t i = 0; i < kTable1.size(); ++i) {
    const auto& [id, key, text] = kTable1[i];
    const Item& item = punch.items[i];
    EXPECT_EQ(item.id, id);
    EXPECT_EQ(item.key, key) << id;
    EXPECT_EQ(item.text.in("en"), text);
    EXPECT_EQ(item.set, id.substr(0, 1)) << id;
    EXPECT_EQ(item.type, ItemType::Likert);
    EXPECT_EQ(item.scale.lowest, 1);
    EXPECT_EQ(item.scale.highest(), 5);
    const bool isRelative = id == "2.3" || id == "3.1";
    EXPECT_EQ(item.comparedWith, isRelative ? Reference::Previous : Reference::None) << id;
  }
}

TEST(PunchFaceValidity, AgreesWithTheCodebookOfTheStudy) {
  Problems problems;
  const auto json =
      parseJson(tests::contentOf(tests::testData("stats/study/study_codebook.json")), problems);
  ASSERT_TRUE(json.has_value());
  const Node codebook(*json, "$", problems);
  const auto statements = codebook.requiredObject("statements")->members();
  EXPECT_EQ(statements.size(), 9U);
  for (const auto& [id, statement] : statements) {
    const Item* item = shipped().at("punch-face-validity").item(id);
    ASSERT_NE(item, nullptr) << id;
    EXPECT_EQ(item->key, statement.wholeNumber("key", -1, 1)) << id;
    EXPECT_EQ(item->text.in("en"), statement.text("text")) << id;
  }
}

TEST(Library, BalancesStatementsForAndAgainst) {
  for (const auto* id :
       {"realism-common",
        "realism-cuts",
        "reaming-quality",
        "reaming-realism",
        "training-capacity",
        "usability-short"}) {
    const auto& items = shipped().at(id).items;
    const auto against =
        std::count_if(items.begin(), items.end(), [](const Item& item) { return item.key == -1; });
    EXPECT_EQ(2 * static_cast<std::size_t>(against), items.size()) << id;
    EXPECT_TRUE(std::all_of(items.begin(), items.end(), [](const Item& item) {
      return item.comparedWith == Reference::None;
    })) << id;
  }
}

TEST(Library, MarksEveryQuestionAboutABenchmark) {
  for (const auto& [id, instrument] : shipped()) {
    for (const auto& item : instrument.items) {
      const bool isAboutOne = item.text.in("en").find("benchmark") != std::string::npos;
      EXPECT_EQ(item.neededFeature == StudyFeature::Benchmark, isAboutOne) << id << " " << item.id;
    }
  }
}

TEST(Library, MarksWhatFewScenesOfReamingRender) {
  const auto& realism = shipped().at("reaming-realism");
  EXPECT_EQ(realism.item("vibration")->neededFeature, StudyFeature::Vibration);
  EXPECT_EQ(realism.item("progress")->neededFeature, StudyFeature::Pace);
  EXPECT_EQ(realism.item("force-level")->neededFeature, StudyFeature::ForceSize);
  for (const auto* id : {"reaming-quality", "training-capacity", "usability-short"}) {
    for (const auto& item : shipped().at(id).items) {
      EXPECT_EQ(item.neededFeature, StudyFeature::None) << id << " " << item.id;
    }
  }
}

TEST(Library, AsksForConsentThatMayBeRefusedWithoutAName) {
  for (const auto* id : {"consent-punch-2", "consent-reaming-2"}) {
    const auto& consent = shipped().at(id);
    EXPECT_EQ(consent.item("consent")->consentOption, "yes") << id;
    EXPECT_TRUE(consent.item("consent")->isRequired) << id;
    EXPECT_FALSE(consent.item("video")->isRequired) << id;
    EXPECT_EQ(consent.item("video")->consentOption, "") << id;
    EXPECT_TRUE(consent.item("signature")->isIdentifying) << id;
    EXPECT_FALSE(consent.item("signature")->isRequired) << id;
  }
}

TEST(Library, AsksWhichAlternativeWasPreferredAndPerhapsWhy) {
  for (const auto* id : {"preference", "preference-cuts", "preference-reaming"}) {
    const auto& preference = shipped().at(id);
    EXPECT_EQ(preference.item("preferred")->optionSource, OptionSource::Alternatives) << id;
    EXPECT_TRUE(preference.item("preferred")->isRequired) << id;
    EXPECT_EQ(preference.item("why")->type, ItemType::LongText) << id;
    EXPECT_FALSE(preference.item("why")->isRequired) << id;
  }
}

TEST(Library, NamesPersonsOnlyInTheConsentForms) {
  for (const auto& [id, instrument] : shipped()) {
    const bool isConsent = id.rfind("consent-", 0) == 0;
    for (const auto& item : instrument.items) EXPECT_FALSE(item.isIdentifying && !isConsent) << id;
  }
}

TEST(Library, AsksNothingInInformation) {
  for (const auto* id : {"information-punch-2", "information-reaming-2", "debrief-2"}) {
    EXPECT_TRUE(shipped().at(id).items.empty()) << id;
    EXPECT_FALSE(shipped().at(id).introduction.isEmpty()) << id;
  }
}

}  // namespace library_test
}  // namespace questionnaires
