#include "questionnaires/reading/instrument_file.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "tests/support/complaint.h"
#include "tests/support/refused_files.h"
#include "tests/support/says.h"
#include "tests/support/test_data.h"

namespace questionnaires {
namespace instrument_file_test {

std::filesystem::path corpus(const std::string& kind) {
  return tests::repository() / "tests/questionnaires/data" / kind;
}

std::set<std::string> filesIn(const std::string& kind) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(corpus(kind))) {
    names.insert(entry.path().stem().string());
  }
  return names;
}

struct Reading {
  std::optional<Instrument> instrument;
  Problems problems;
};

Reading read(const std::string& kind, const std::string& name) {
  Reading reading;
  const std::string json = readTextFile((corpus(kind) / (name + ".json")).string());
  reading.instrument = readInstrument(json, reading.problems);
  return reading;
}

Instrument good(const std::string& name) {
  auto reading = read("good", name);
  EXPECT_TRUE(reading.instrument.has_value()) << name << "\n" << describe(reading.problems.all());
  return reading.instrument.value_or(Instrument{});
}

/// Refused, with the problem that is expected, where it is expected, and how to correct it.
void expectRefusals(const std::string& kind) {
  for (const auto& file : tests::refusedFiles(corpus(kind))) {
    const auto reading = read(kind, file.name);
    EXPECT_FALSE(reading.instrument.has_value()) << file.name;
    tests::expectProblem(file, reading.problems.all());
  }
}

TEST(InstrumentFile, ReportsStructuralProblemsWithTheirFix) {
  expectRefusals("bad");
}

TEST(InstrumentFile, ReportsWhatNoSchemaCanCheck) {
  expectRefusals("semantic");
}

TEST(InstrumentFile, SaysNothingTwice) {
  for (const auto& refusal : tests::refusedFiles(corpus("bad"))) {
    const auto reading = read("bad", refusal.name);
    std::set<std::pair<std::string, std::string>> said;
    for (const auto& problem : reading.problems.all()) {
      EXPECT_TRUE(said.insert({problem.path, base::describe(problem.what)}).second) << refusal.name;
    }
    EXPECT_LE(said.size(), 3U) << refusal.name << "\n" << describe(reading.problems.all());
  }
}

TEST(InstrumentFile, ReadsEverySoundFile) {
  for (const auto& name : filesIn("good")) {
    const auto reading = read("good", name);
    EXPECT_TRUE(reading.instrument.has_value()) << name << "\n" << describe(reading.problems.all());
    EXPECT_FALSE(reading.problems.hasErrors()) << name;
  }
}

TEST(InstrumentFile, ReportsAllProblemsAtOnce) {
  Problems problems;
  const auto instrument = readInstrument(
      R"({"$schema": "instrument-2.schema.json", "id": "my id", "version": 1, "titel": "T",
          "source": {"citation": "c"}, "languages": ["en", "de"],
          "items": [{"id": "a", "type": "likert", "text": {"en": "A", "de": "A"}, "key": 3},
                    {"id": "a", "type": "slider", "text": "B", "options": []}],
          "scores": [{"id": "s", "title": "S", "items": ["a", "nobody"], "factor": "2"}]})",
      problems);
  EXPECT_FALSE(instrument.has_value());
  std::vector<std::string> places;
  for (const auto& problem : problems.all())
    places.push_back(problem.path + " " + base::describe(problem.what));
  const std::vector<std::string> expected{
      "$.titel unknown key 'titel'",
      "$.$schema this is written for 'instrument-2.schema.json'",
      "$.id 'my id' cannot be an id",
      "$.version a text is expected here, not a number",
      "$ 'title' is missing",
      "$.source 'licence' is missing",
      "$.items[0].key this number is out of range",
      "$.items[0] 'scale' is missing, here and at the top of the file",
      "$.items[1].options 'options' means nothing to an item of type 'slider'",
      "$.items[1] 'left_label' is missing",
      "$.items[1] 'right_label' is missing",
      "$.scores[0].factor a number is expected here, not a text",
      "$.items[1].id two items share the id 'a'",
      "$.items[1].text.de the text in 'de' is missing",
      "$.scores[0].items[1] there is no item 'nobody'",
  };
  EXPECT_EQ(places, expected);
}

TEST(InstrumentFile, WarnsOnceNothingIsWorse) {
  Problems problems;
  EXPECT_TRUE(readInstrument(
                  R"({"$schema": "instrument-1.schema.json", "id": "a", "version": "1",
                      "title": "T", "introduction": "[[name]]", "languages": ["en"],
                      "source": {"citation": "c", "licence": "l"}, "items": []})",
                  problems)
                  .has_value());
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].severity, Severity::Warning);
}

TEST(InstrumentFile, KeepsWhatWasSaidBefore) {
  Problems problems;
  problems.add("$", "something else");
  const std::string json = readTextFile((corpus("good") / "smallest.json").string());
  EXPECT_TRUE(readInstrument(json, problems).has_value());
  EXPECT_EQ(problems.all().size(), 1U);
}

TEST(InstrumentFile, ReadsEveryKeyOfAnItem) {
  const auto against = good("statement-against-realism").items.at(0);
  EXPECT_EQ(against.key, -1);
  EXPECT_EQ(against.set, "1");
  EXPECT_EQ(against.comparedWith, Reference::Previous);
  EXPECT_FALSE(against.isRequired);
  EXPECT_EQ(against.scale.highLabel.in("en"), "high");

  const auto slider = good("slider-in-steps").items.at(0);
  EXPECT_EQ(slider.type, ItemType::Slider);
  EXPECT_EQ(slider.least, -1.0);
  EXPECT_EQ(slider.step, 0.1);
  EXPECT_EQ(slider.leftText.in("en"), "little");

  const auto number = good("number-with-unit").items.at(0);
  EXPECT_EQ(number.most, 500.5);
  EXPECT_EQ(number.unit, "N");

  const auto name = good("name").items.at(0);
  EXPECT_TRUE(name.isIdentifying);
  EXPECT_EQ(name.longestAnswer, 1);
  EXPECT_EQ(good("consent").items.at(0).consentOption, "b");
  EXPECT_EQ(good("consent").items.at(0).options.at(1).text.in("en"), "B");

  const auto why = good("asked-on-a-page-of-its-own").items.at(1);
  EXPECT_TRUE(why.startsPage);
  EXPECT_EQ(why.showIf.item, "role");
  EXPECT_EQ(why.showIf.wantedOptions, std::vector<std::string>{"surgeon"});
}

TEST(InstrumentFile, FillsInWhatIsUsual) {
  const auto why = good("smallest").items.at(0);
  EXPECT_TRUE(why.isRequired);
  EXPECT_FALSE(why.isIdentifying);
  EXPECT_FALSE(why.startsPage);
  EXPECT_FALSE(why.showIf.isSet());
  EXPECT_EQ(why.key, 1);
  EXPECT_EQ(why.longestAnswer, 100'000);

  const auto slider = good("slider-with-everything-usual").items.at(0);
  EXPECT_EQ(slider.least, 0.0);
  EXPECT_EQ(slider.most, 100.0);
  EXPECT_EQ(slider.step, 1.0);
}

TEST(InstrumentFile, PrefersAnItemsOwnScale) {
  EXPECT_EQ(good("agreement-on-a-shared-scale").items.at(0).scale.points, 5);
  EXPECT_EQ(good("agreement-on-a-scale-of-its-own").items.at(0).scale.highest(), 6);
}

TEST(InstrumentFile, NamesTheEndsAfterTheOuterPoints) {
  const auto scale = good("every-point-labelled").items.at(0).scale;
  EXPECT_EQ(scale.lowLabel.in("en"), "no");
  EXPECT_EQ(scale.highLabel.in("en"), "yes");
}

TEST(InstrumentFile, TakesOptionsFromTheAlternatives) {
  const auto item = good("one-of-the-alternatives").items.at(0);
  EXPECT_EQ(item.optionSource, OptionSource::Alternatives);
  EXPECT_TRUE(item.options.empty());
}

TEST(InstrumentFile, ReadsEveryKeyOfAScore) {
  const auto scores = good("scores").scores;
  EXPECT_EQ(scores.at(0).leastAnswered, 1U);
  EXPECT_EQ(scores.at(0).offset, -3.0);
  EXPECT_EQ(scores.at(0).factor, 2.5);
  EXPECT_TRUE(scores.at(0).reverseByKey);
  EXPECT_EQ(scores.at(1).aggregate, Score::Aggregate::Sum);
  EXPECT_FALSE(scores.at(1).reverseByKey);
}

TEST(InstrumentFile, ReadsTheSource) {
  const auto source = good("full-source").source;
  EXPECT_EQ(source.citation, "c");
  EXPECT_EQ(source.doi, "10.9781/ijimai.2017.09.001");
  EXPECT_EQ(source.licence, "l");
  EXPECT_EQ(source.note, "n");
}

TEST(InstrumentFile, ThrowsEverythingThatIsWrong) {
  const auto complaint = tests::complaintOf([] { readValidInstrument("{}", "mine.json"); });
  EXPECT_TRUE(complaint.starts_with("The questionnaire mine.json cannot be used:\n")) << complaint;
  EXPECT_TRUE(tests::says(complaint, "'id' is missing"));
  EXPECT_TRUE(tests::says(complaint, "'items' is missing"));
}

}  // namespace instrument_file_test
}  // namespace questionnaires
