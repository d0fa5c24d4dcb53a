// What is asked after a condition should be analysed, or the protocol's author be told.
#include <string>

#include <gtest/gtest.h>

#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace item_warnings_test {

/// A slider beside the statement that a family compares.
std::string instrumentWith(const std::string& more, const std::string& scores = "") {
  return R"({"$schema": "instrument-1.schema.json", "id": "mine", "version": "1",
    "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
    "items": [{"id": "real", "type": "likert", "text": "It felt real.",
      "scale": {"points": 5, "low_label": "no", "high_label": "yes"}},
      {"id": "vas", "type": "slider", "text": "How real?", "left_label": "not", "right_label": "very")" +
         more + R"(}, {"id": "why", "type": "short_text", "text": "Why?"}])" + scores + "}";
}

/// The warnings of @p protocol about items that nothing analyses, if 'mine' is @p instrument.
std::string toldOf(const std::string& instrument, const std::string& protocol) {
  auto json = tests::with(
      protocol,
      "\"conditions\": [\n",
      "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
  const auto loading = tests::load(json, [&](const std::string& name) {
    return name.starts_with("wording/") ? std::nullopt : std::optional(instrument);
  });
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::string told;
  for (const auto& problem : loading.problems) {
    if (problem.what.key() != "items_not_analysed") continue;
    told += problem.path + ": " + base::describe(problem.what) + "\n";
  }
  return told;
}

/// … of usualProtocol() that asks it after every condition.
std::string toldOf(const std::string& instrument) {
  return toldOf(instrument, tests::with(tests::usualProtocol(), "realism-cuts", "mine"));
}

TEST(ItemWarnings, NameNumbersThatNothingIsComputedFrom) {
  EXPECT_NE(
      toldOf(instrumentWith(""))
          .find("no family, score or threshold uses these answers to 'mine': vas\n"),
      std::string::npos)
      << toldOf(instrumentWith(""));
}

TEST(ItemWarnings, AreSilentAboutScoresAndThresholds) {
  EXPECT_EQ(toldOf(instrumentWith(R"(, "acceptable_from": 60)")), "");
  EXPECT_EQ(
      toldOf(instrumentWith(
          "", R"(, "scores": [{"id": "s", "title": "S", "items": ["vas"], "aggregate": "mean"}])")),
      "");
}

TEST(ItemWarnings, NameChoices) {
  const auto choice = R"(, "acceptable_from": 60}, {"id": "which", "type": "single_choice",
      "text": "Which?", "options": [{"id": "a", "text": "A"}, {"id": "b", "text": "B"}])";
  EXPECT_NE(toldOf(instrumentWith(choice)).find("'mine': which\n"), std::string::npos)
      << toldOf(instrumentWith(choice));
}

TEST(ItemWarnings, NameAnswersToFormsAfterTheFirstBlockOnly) {
  const std::string form = R"({"id": "form", "type": "form", "instrument": "mine"})";
  const std::string consent = R"("instrument": "consent-punch" },)";
  const auto before = tests::with(tests::usualProtocol(), consent, consent + form + ",");
  EXPECT_EQ(toldOf(instrumentWith(""), before), "");
  const auto told = toldOf(instrumentWith(""), tests::withPhases({form}));
  EXPECT_NE(told.find(".instrument: no family"), std::string::npos) << told;
}

}  // namespace item_warnings_test
}  // namespace protocols
