// What is merely unwise about a protocol is said, once, and leaves it usable.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/validation/validation.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace warnings_test {

using questionnaires::Severity;

/// What every reading of usualProtocol() says: its consent form ships as a template.
const std::string kTemplate =
    "consent-punch $.introduction.en: still to be filled in: [[duration]], [[delete_until]], "
    "[[institution]], [[contact]]; fill them in once for the whole study: 'Fill in the texts…' in "
    "the windows, or 'palpate protocol texts'";

/// All that is said about a sound protocol, without the template.
std::vector<std::string> warningsOf(std::string_view json, const FileFinder& find = {}) {
  const auto loading = tests::load(json, find);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::vector<std::string> said;
  for (const auto& problem : loading.problems) {
    EXPECT_EQ(problem.severity, Severity::Warning);
    said.push_back(
        problem.path + ": " + base::describe(problem.what) + "; " + base::describe(problem.fix));
  }
  std::erase(said, kTemplate);
  return said;
}

using Words = std::vector<std::string>;

/// An instrument as a file: one Likert item, with whatever else the item says.
std::string instrumentFile(const std::string& id, const std::string& more = "") {
  return R"({"$schema": "instrument-1.schema.json", "id": ")" + id + R"(", "version": "1",
    "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
    "items": [{"id": "i", "type": "likert", "text": "It felt real.",
      "scale": {"points": 5, "low_label": "no", "high_label": "yes"})" +
         more + "}]}";
}

/// One file beside the protocol, and no wording files.
FileFinder holding(const std::string& text) {
  return [text](const std::string& name) {
    return name.starts_with("wording/") ? std::nullopt : std::optional(text);
  };
}

/// usualProtocol() that asks what lies in "mine.json", under the id "mine", after each condition.
std::string askingMine() {
  const auto text = tests::with(tests::usualProtocol(), "realism-cuts", "mine");
  return tests::with(
      text, "\"conditions\": [\n", "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
}

TEST(ProtocolWarnings, GivesNoWarningForAGoodProtocol) {
  EXPECT_EQ(warningsOf(tests::usualProtocol()), Words{});
}

TEST(ProtocolWarnings, PassesOnWhatIsToBeFilledInInAnInstrumentOfTheLibrary) {
  const auto loading = tests::load(tests::usualProtocol());
  ASSERT_TRUE(loading.loaded.has_value());
  ASSERT_EQ(loading.problems.size(), 1U) << loading.describe();
  EXPECT_EQ(loading.describe(), "warning " + kTemplate + "\n");
}

TEST(ProtocolWarnings, WarnsOfATemplateOnce) {
  const auto text = tests::withPhases(
      {R"({"id": "end", "type": "debrief", "instrument": "debrief"})",
       R"({"id": "again", "type": "debrief", "instrument": "debrief"})"});
  const auto said = warningsOf(text);
  ASSERT_EQ(said.size(), 1U) << said.back();
  EXPECT_TRUE(said[0].starts_with("debrief $.introduction.en: still to be filled in: [[delete"));
}

TEST(ProtocolWarnings, WarnsOfPlaceholdersInAFileOfTheUserOnce) {
  const auto mine = tests::with(instrumentFile("mine"), "It felt real.", "As real as [[what]]?");
  EXPECT_EQ(
      warningsOf(askingMine(), holding(mine)),
      Words{"mine.json $.items[0].text.en: still to be filled in: [[what]]; write it into "
            "'texts' of the protocol, or into this file"});
}

TEST(ProtocolWarnings, WarnsOfComparisonsWithThePreviousOnlyForAFileOfTheUser) {
  const auto published = tests::with(
      tests::withBenchmark(tests::usualProtocol()), "realism-cuts", "punch-face-validity");
  for (const auto& words : warningsOf(published)) {
    EXPECT_EQ(words.find("this compares with what was felt just before"), std::string::npos);
    EXPECT_TRUE(words.starts_with("$.phases[2].questionnaires[0]: item ")) << words;
  }
  const auto mine = instrumentFile("mine", R"(, "relative_to": "previous")");
  EXPECT_EQ(
      warningsOf(askingMine(), holding(mine)).at(0),
      "mine.json $.items[0].relative_to: this compares with what was felt just before; an order "
      "must give it a predecessor: whatever is felt first has none");
}

TEST(ProtocolWarnings, WarnsOfTextsThatALanguageLacks) {
  auto text = tests::with(tests::usualProtocol(), R"(["en"])", R"(["en", "de"])");
  text = tests::with(
      text, R"({ "policy": "random" })", R"({ "policy": "random", "prefix": {"en": "Variant"} })");
  EXPECT_EQ(
      warningsOf(text),
      Words{"$.labels.prefix: there is no text in 'de'; English will be shown instead; add \"de\": "
            "\"…\""});
}

TEST(ProtocolWarnings, WarnsOfALanguageWithoutTheUsualLabel) {
  const auto said = warningsOf(tests::with(tests::usualProtocol(), R"(["en"])", R"(["en", "nb"])"));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].starts_with("$.labels.prefix: there is no text in 'nb'"));
}

TEST(ProtocolWarnings, FindsPlaceholdersInTheProtocolsTextsInEveryLanguage) {
  auto text = tests::withPhases({R"({"id": "rest", "type": "break",
           "text": {"en": "Rest.", "de": "Ruhen Sie sich [[wie lange]] aus."}})"});
  text = tests::with(text, R"(["en"])", R"(["en", "de"])");
  text = tests::with(
      text,
      R"({ "policy": "random" })",
      R"({ "policy": "random", "prefix": {"en": "[[prefix]]", "de": "Variante"} })");
  EXPECT_EQ(
      warningsOf(text),
      (Words{
          "$.labels.prefix: still to be filled in ('en'): [[prefix]]; write it into 'texts' of the "
          "protocol",
          "$.phases[2].text: still to be filled in ('de'): [[wie lange]]; write it into "
          "'texts' of the protocol"}));
}

TEST(ProtocolWarnings, NamesATextForWhichThereIsNoBlank) {
  const auto text = tests::with(
      tests::usualProtocol(),
      "\"conditions\": [\n",
      "\"texts\": {\"x\": \"y\"}, \"conditions\": [\n");
  EXPECT_EQ(
      warningsOf(text),
      Words{"$.texts.x: no text has the blank [[x]]; remove it, or correct the name"});
}

TEST(ProtocolWarnings, WarnsOfALanguageThatAnInstrumentLacks) {
  auto text = tests::with(askingMine(), R"(["en"])", R"(["en", "de"])");
  text = tests::with(
      text,
      R"({ "policy": "random" })",
      R"({ "policy": "random", "prefix": {"en": "Variant", "de": "Variante"} })");
  EXPECT_EQ(
      warningsOf(text, holding(instrumentFile("mine"))),
      Words{"$.phases[1].questionnaires[0].instrument: 'mine' has no texts in 'de'; English will "
            "be shown instead; 'palpate instrument wording mine.json --language de --out "
            "wording/mine/de.json', in the folder of the protocol, writes a file for them"});
}

TEST(ProtocolWarnings, FindsAFileThatNothingAsks) {
  const auto text =
      tests::with(askingMine(), R"("instrument": "mine")", R"("instrument": "realism-cuts")");
  EXPECT_EQ(
      warningsOf(text, holding(instrumentFile("mine"))),
      Words{"$.instrument_files[0]: nothing asks 'mine'; name it in a phase, or remove the file"});
}

TEST(ProtocolWarnings, WarnsOfAFileThatReplacesOneOfTheLibrary) {
  const auto text =
      tests::with(askingMine(), R"("instrument": "mine")", R"("instrument": "realism-cuts")");
  EXPECT_EQ(
      warningsOf(text, holding(instrumentFile("realism-cuts"))),
      Words{"$.instrument_files[0]: 'realism-cuts' takes the place of the instrument of this "
            "name in the library; give it an id of its own, so that nobody takes one for the "
            "other"});
}

TEST(ProtocolWarnings, FindsADeviceThatNoConditionUses) {
  const auto text = tests::with(
      tests::usualProtocol(),
      "\"devices\": [\n",
      "\"devices\": [\n{\"id\": \"spare\", \"kind\": \"reamer\", \"max_force_n\": 1, "
      "\"max_force_rate_n_per_s\": 1},\n");
  EXPECT_EQ(
      warningsOf(text),
      Words{"$.devices[0]: no condition uses 'spare'; it will not be opened; remove it"});
}

TEST(ProtocolWarnings, FindsAConditionThatNoBlockUses) {
  const auto text = tests::with(
      tests::usualProtocol(),
      "\"conditions\": [\n",
      "\"conditions\": [\n{\"id\": \"lost\", \"title\": \"Lost\", \"scene\": {\"device\": "
      "\"punch\", \"model\": \"interpolation\", \"parameters\": {}}},\n");
  EXPECT_EQ(
      warningsOf(text),
      Words{"$.conditions[0]: no block uses 'lost'; nobody will feel it; remove it"});
}

TEST(ProtocolWarnings, GivesNoWarningsWhileThereAreErrors) {
  auto text = tests::with(tests::usualProtocol(), "balancedLatinSquare", "fixed");
  text = tests::with(text, "\"alpha\": 0.05", "\"alpha\": 5");
  const auto loading = tests::load(text);
  ASSERT_EQ(loading.problems.size(), 1U) << loading.describe();
  EXPECT_EQ(loading.problems[0].severity, Severity::Error);
}

}  // namespace warnings_test
}  // namespace protocols
