// Words in texts for participants: in braces that nothing fills in, and names of conditions.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace text_warnings_test {

/// What is said of a text of a break.
std::string saidOf(const std::string& words) {
  const auto text = tests::with(
      tests::withPhases({R"({"id": "rest", "type": "break", "text": ")" + words + "\"}"}),
      "\"Firm\"",
      "\"Yields at 6 N\"");
  const auto loading = tests::load(text);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::string said;
  for (const auto& problem : loading.problems) {
    if (problem.path != "$.phases[2].text") continue;
    said += base::describe(problem.what) + "; " + base::describe(problem.fix) + "\n";
  }
  return said;
}

TEST(TextWarnings, LeaveWordsThatAreFilledInAlone) {
  EXPECT_EQ(saidOf("Rest before the next {label}. {Label}: at least {minimum_cuts}"), "");
  EXPECT_EQ(saidOf("{ no word } {} {{"), "");
}

TEST(TextWarnings, WarnOfAWordInBracesThatNothingFillsIn) {
  EXPECT_EQ(
      saidOf("Rest before the next {lable}, {lable}."),
      "nothing fills in {lable}: participants read it as it stands; write {label}, or leave the "
      "braces out\n");
}

TEST(TextWarnings, WarnOfAConditionsTitle) {
  EXPECT_EQ(
      saidOf("Next it Yields at 6 N."),
      "participants read 'Yields at 6 N' here, which tells of the condition 'firm'; call what is "
      "felt by its label\n");
}

TEST(TextWarnings, TakeEverydayWordsForNoNames) {
  EXPECT_EQ(saidOf("Hold the handle soft or firm. Soft is best."), "");
}

TEST(TextWarnings, FindNoNameInsideAnotherWord) {
  EXPECT_EQ(saidOf("It Yields at 6 Newton."), "");
}

TEST(TextWarnings, AreGivenOnceForEachTextOfAQuestionnaire) {
  const std::string form = R"({"$schema": "instrument-1.schema.json", "id": "mine", "version": "1",
    "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
    "scale": {"points": 5, "low_label": "no", "high_label": "yes"},
    "items": [{"id": "i", "type": "likert", "text": "The {lable} felt real."},
              {"id": "j", "type": "likert", "text": "The {label} felt odd."}]})";
  auto text = tests::with(tests::usualProtocol(), "realism-cuts", "mine");
  text = tests::with(
      text, "\"conditions\": [\n", "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
  const auto loading = tests::load(text, [&](const std::string& name) {
    return name == "mine.json" ? std::optional(form) : std::nullopt;
  });
  std::vector<std::string> places;
  for (const auto& problem : loading.problems) {
    if (problem.what.key() == "braces_not_known") places.push_back(problem.path);
  }
  EXPECT_EQ(places, std::vector<std::string>{"mine $.items.i.text"}) << loading.describe();
}

}  // namespace text_warnings_test
}  // namespace protocols
