#include "questionnaires/reading/wording.h"

#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/questionnaires/shipped_instruments.h"

namespace questionnaires {
namespace wording_test {

using Files = std::map<std::string, std::string>;

/// The template of @p instrument with "words of …" wherever words are missing.
std::string filledIn(const Instrument& instrument, const std::string& language) {
  std::string json = wordingTemplate(instrument, language);
  for (const auto& place : missingTexts(instrument, language)) {
    const std::string empty = "\"" + place + "\": \"\"";
    json.replace(json.find(empty), empty.size(), "\"" + place + "\": \"words of " + place + "\"");
  }
  const std::string source = "\"source\": \"\"";
  return json.replace(json.find(source), source.size(), "\"source\": \"the paper\"");
}

/// Everything that is said when @p instrument is completed from @p files.
std::string completed(
    Instrument& instrument, const Files& files, const std::vector<std::string>& alsoIn = {}) {
  Problems problems;
  const auto find = [&](const std::string& name) -> std::optional<std::string> {
    const auto file = files.find(name);
    return file == files.end() ? std::nullopt : std::optional(file->second);
  };
  completeWording(instrument, alsoIn, find, "$.phases[0].instrument", problems);
  return describe(problems.all());
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  return text.replace(text.find(what), what.size(), with);
}

Instrument sus() {
  return tests::shipped().at("sus");
}

TEST(Wording, OfASoundInstrumentIsThereAlready) {
  auto instrument = tests::shipped().at("nasa-tlx-raw");
  EXPECT_TRUE(missingTexts(instrument, "en").empty());
  EXPECT_EQ(completed(instrument, {}), "");
  EXPECT_EQ(instrument.languages, (std::vector<std::string>{"en", "de", "nb"}));
}

TEST(Wording, IsMissingWhereItIsWithheld) {
  EXPECT_EQ(missingTexts(sus(), "en").size(), 10U);
  EXPECT_EQ(missingTexts(sus(), "en").front(), "items/1/text");
  EXPECT_EQ(missingTexts(tests::shipped().at("ipq"), "en").size(), 3U * 14U);
  EXPECT_EQ(missingTexts(tests::shipped().at("slater-usoh-steed"), "en").size(), 3U * 6U);
}

TEST(Wording, IsRefusedWhereItIsMissingAndSaysWhatToDo) {
  auto instrument = sus();
  const std::string said = completed(instrument, {});
  EXPECT_EQ(said.find("error   $.phases[0].instrument: the words of 'sus' do not come with"), 0U);
  EXPECT_NE(
      said.find("palpate instrument wording sus --language en --out wording/sus/en.json"),
      std::string::npos);
  EXPECT_NE(said.find("Brooke's chapter"), std::string::npos);
}

TEST(Wording, HasATemplateWithIdsKeysAndCitation) {
  const std::string json = wordingTemplate(sus(), "en");
  EXPECT_NE(json.find("\"instrument\": \"sus\""), std::string::npos);
  EXPECT_NE(json.find("\"2\": -1"), std::string::npos);
  EXPECT_NE(json.find("\"items/10/text\": \"\""), std::string::npos);
  EXPECT_NE(json.find("Brooke, J. (1996)"), std::string::npos);
  EXPECT_NE(json.find("https://doi.org/10."), std::string::npos);
}

TEST(Wording, IsPutInWhereItIsComplete) {
  auto instrument = sus();
  EXPECT_EQ(completed(instrument, {{"wording/sus/en.json", filledIn(sus(), "en")}}), "");
  EXPECT_EQ(instrument.items[3].text.in("en"), "words of items/4/text");
  EXPECT_EQ(instrument.languages, std::vector<std::string>{"en"});
  EXPECT_FALSE(instrument.title.has("de"));
  EXPECT_TRUE(problemsOf(instrument).all().empty()) << describe(problemsOf(instrument).all());
}

TEST(Wording, FillsAnchorsIntoTheScaleOfTheirItem) {
  auto ipq = tests::shipped().at("ipq");
  EXPECT_EQ(completed(ipq, {{"wording/ipq/en.json", filledIn(ipq, "en")}}), "");
  EXPECT_EQ(ipq.item("SP3")->scale.lowLabel.in("en"), "words of items/SP3/low_label");
  EXPECT_EQ(ipq.item("SP4")->scale.highLabel.in("en"), "words of items/SP4/high_label");
  EXPECT_FALSE(problemsOf(ipq).hasErrors());
}

TEST(Wording, BringsEveryLanguageThatIsThere) {
  auto instrument = sus();
  const Files files{
      {"wording/sus/en.json", filledIn(sus(), "en")},
      {"wording/sus/nb.json", filledIn(sus(), "nb")}};
  EXPECT_EQ(completed(instrument, files), "");
  EXPECT_EQ(instrument.languages, (std::vector<std::string>{"en", "nb"}));
  EXPECT_TRUE(instrument.items[0].text.has("nb"));
}

TEST(Wording, TranslatesAWholeInstrument) {
  auto ssq = tests::shipped().at("ssq");
  const auto places = missingTexts(ssq, "de");
  EXPECT_EQ(places.size(), 2U + 4U + 16U);  // head, points, symptoms
  EXPECT_EQ(completed(ssq, {{"wording/ssq/de.json", filledIn(ssq, "de")}}, {"de"}), "");
  EXPECT_EQ(ssq.languages, (std::vector<std::string>{"en", "de"}));
  EXPECT_EQ(ssq.items[7].text.in("de"), "words of items/8-nausea/text");
  EXPECT_EQ(ssq.items[7].scale.pointLabels[3].in("de"), "words of scale/point_labels/4");
  EXPECT_EQ(ssq.items[7].scale.highLabel.in("de"), "words of scale/point_labels/4");
  EXPECT_TRUE(problemsOf(ssq).all().empty()) << describe(problemsOf(ssq).all());
}

TEST(Wording, TranslatesPairsAndOptions) {
  auto ueq = tests::shipped().at("ueq");
  EXPECT_EQ(missingTexts(ueq, "nb").size(), 2U + 2U * 26U);
  EXPECT_EQ(
      missingTexts(tests::shipped().at("nasa-tlx-weighted"), "fr").back(),
      "items/pair-15/options/frustration");
}

/// What is said of a wording file of the SUS in which @p what is replaced by @p with.
std::string problemsAfter(const std::string& what, const std::string& with) {
  auto instrument = sus();
  const std::string json = replaced(filledIn(sus(), "en"), what, with);
  return completed(instrument, {{"wording/sus/en.json", json}});
}

TEST(Wording, IsRefusedWhereAWordIsStillMissing) {
  EXPECT_EQ(
      problemsAfter("words of items/7/text", " "),
      "error   wording/sus/en.json $.texts.items/7/text: this text is still empty; write the "
      "published words\n");
  EXPECT_NE(
      problemsAfter("words of items/7/text", "[[name]]").find("a placeholder"), std::string::npos);
}

TEST(Wording, IsRefusedWhereNothingIsFilledIn) {
  auto instrument = sus();
  const std::string said =
      completed(instrument, {{"wording/sus/en.json", wordingTemplate(sus(), "en")}});
  EXPECT_NE(said.find("wording/sus/en.json $.source: this text is empty"), std::string::npos);
}

TEST(Wording, IsRefusedWhereItWasWrittenForSomethingElse) {
  EXPECT_NE(problemsAfter("\"sus\"", "\"ipq\"").find("not of 'sus'"), std::string::npos);
  EXPECT_NE(
      problemsAfter("\"version\": \"1\"", "\"version\": \"2\"").find("version 2"),
      std::string::npos);
  EXPECT_NE(problemsAfter("\"2\": -1", "\"2\": 1").find("the other key"), std::string::npos);
  EXPECT_NE(problemsAfter("\"2\": -1", "\"12\": -1").find("no such item"), std::string::npos);
  EXPECT_NE(
      problemsAfter("\"language\": \"en\"", "\"language\": \"de\"").find("are in 'de'"),
      std::string::npos);
  EXPECT_NE(
      problemsAfter("wording-1", "wording-2").find("written for 'wording-2'"), std::string::npos);
  EXPECT_NE(
      problemsAfter("items/7/text\": ", "items/11/text\": ").find("no such text"),
      std::string::npos);
}

TEST(Wording, IsRefusedInAnyLanguageWhereItsFileIsWrong) {
  auto instrument = sus();
  const Files files{{"wording/sus/en.json", filledIn(sus(), "en")}, {"wording/sus/de.json", "{"}};
  EXPECT_EQ(completed(instrument, files).find("error   wording/sus/de.json $"), 0U);
}

TEST(Wording, LeavesTheInstrumentAloneWhereItIsRefused) {
  auto instrument = sus();
  Problems problems;
  applyWording({.instrument = "sus", .version = "1", .language = "en"}, instrument, problems);
  EXPECT_EQ(problems.all().size(), 10U);
  EXPECT_TRUE(instrument.items[0].text.isEmpty());
}

}  // namespace wording_test
}  // namespace questionnaires
