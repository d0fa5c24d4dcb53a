// What a protocol plans: families, the course of a session, what two conditions or cohorts share.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/scratch_folder.h"

namespace protocols {
namespace plan_warnings_test {

/// The paths at which @p json is warned of @p key.
std::vector<std::string> placesOf(
    std::string_view key, const std::string& json, const FileFinder& find = {}) {
  const auto loading = tests::load(json, find);
  EXPECT_TRUE(loading.loaded.has_value()) << loading.describe();
  std::vector<std::string> places;
  for (const auto& problem : loading.problems) {
    if (problem.what.key() == key) places.push_back(problem.path);
  }
  return places;
}

using Places = std::vector<std::string>;

/// What is said of @p json as a new file.
std::string verdictOnFile(const std::string& json) {
  const tests::ScratchFolder folder;
  questionnaires::Problems problems;
  const bool isUsable = loadProtocolFile(folder.write("protocol.json", json), problems).has_value();
  return (isUsable ? "usable " : "refused ") + questionnaires::describe(problems.all());
}

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(PlanWarnings, WarnOfALargeAlpha) {
  const auto withAlpha = [](const std::string& alpha) {
    return tests::with(tests::usualProtocol(), "\"alpha\": 0.05", "\"alpha\": " + alpha);
  };
  EXPECT_EQ(placesOf("alpha_large", withAlpha("0.2")), Places{});
  EXPECT_EQ(placesOf("alpha_large", withAlpha("0.5")), Places{"$.analysis.families[0].alpha"});
}

/// usualProtocol() with a second family.
std::string withFamily(const std::string& test) {
  return tests::with(
      tests::usualProtocol(),
      "\"families\": [",
      R"("families": [
      {"id": "more", "title": "More", "instrument": "realism-cuts",
       "comparisons": [{"first": "firm", "second": "soft"}], "test": ")" +
          test + R"(",
       "correction": "holm", "alpha": 0.05},)");
}

TEST(PlanWarnings, WarnOfTwoFamiliesThatTestTheSame) {
  EXPECT_EQ(placesOf("same_family", withFamily("sign_flip")), Places{});
  EXPECT_EQ(placesOf("same_family", withFamily("paired_t")), Places{"$.analysis.families[1]"});
}

/// An instrument with a score of two items, of which the second is asked only after "yes".
std::string conditionalForm(const std::string& score) {
  return R"({"$schema": "instrument-1.schema.json", "id": "mine", "version": "1",
    "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
    "scale": {"points": 5, "low_label": "no", "high_label": "yes"},
    "items": [
      {"id": "real", "type": "likert", "text": "It felt real."},
      {"id": "odd", "type": "single_choice", "text": "Was it odd?",
       "options": [{"id": "yes", "text": "yes"}, {"id": "no", "text": "no"}]},
      {"id": "how", "type": "likert", "text": "It felt very odd.",
       "show_if": {"item": "odd", "is": ["yes"]}}],
    "scores": [{"id": "all", "title": "All", "items": ["real", "how"])" +
         score + "}]}";
}

TEST(PlanWarnings, WarnOfAScoreWhoseItemsAreNotAlwaysAsked) {
  auto text = tests::with(
      tests::usualProtocol(),
      "\"conditions\": [\n",
      "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
  text = tests::with(text, "\"instrument\": \"realism-cuts\"", "\"instrument\": \"mine\"");
  text = tests::with(text, "\"test\": ", "\"score\": \"all\", \"test\": ");
  const auto warned = [&](const std::string& score) {
    return placesOf("score_not_always_asked", text, [&](const std::string& name) {
      return name == "mine.json" ? std::optional(conditionalForm(score)) : std::nullopt;
    });
  };
  EXPECT_EQ(warned(R"(, "aggregate": "mean")"), Places{"$.analysis.families[0].score"});
  EXPECT_EQ(warned(R"(, "aggregate": "mean", "least_answered": 1)"), Places{});
}

TEST(PlanWarnings, WarnOfQuestionsBeforeConsent) {
  const auto form = [](const std::string& before) {
    return tests::with(
        tests::usualProtocol(),
        "\"phases\": [" + before,
        "\"phases\": [" + before + R"({"id": "me", "type": "form", "instrument": "background"},)");
  };
  const std::string consent = R"(
    { "id": "consent", "type": "consent", "instrument": "consent-punch" },)";
  EXPECT_EQ(placesOf("asked_before_consent", form("")), Places{"$.phases[0]"});
  EXPECT_EQ(placesOf("asked_before_consent", form(consent)), Places{});
}

TEST(PlanWarnings, WarnOfTrialsAfterTheDebriefing) {
  const std::string thanks = R"({"id": "thanks", "type": "debrief", "instrument": "debrief"})";
  EXPECT_EQ(placesOf("felt_after_debriefing", tests::withPhases({thanks})), Places{});
  const auto early = tests::with(
      tests::usualProtocol(),
      R"("instrument": "consent-punch" },)",
      R"("instrument": "consent-punch" },)" + thanks + ",");
  EXPECT_EQ(placesOf("felt_after_debriefing", early), Places{"$.phases[2]"});
}

TEST(PlanWarnings, WarnOfADateThatIsNone) {
  const auto dated = [](const std::string& date) {
    return tests::with(
        tests::usualProtocol(), "\"version\": \"1\"", R"("version": "1", "date": ")" + date + "\"");
  };
  for (const auto* date : {"2026", "2026-11", "2026-11-20"}) {
    EXPECT_EQ(placesOf("date_not_iso", dated(date)), Places{}) << date;
  }
  for (const auto* date : {"20.11.2026", "2026/11/20", "2026-1-20", "soon"}) {
    EXPECT_EQ(placesOf("date_not_iso", dated(date)), Places{"$.study.date"}) << date;
  }
}

TEST(PlanWarnings, WarnOfLanguagesThatTheWindowsLack) {
  const auto in = [](const std::string& languages) {
    return tests::with(tests::usualProtocol(), R"(["en"])", languages);
  };
  EXPECT_EQ(placesOf("language_of_windows", in(R"(["en", "de-CH", "nb"])")), Places{});
  EXPECT_EQ(placesOf("language_of_windows", in(R"(["en", "de", "fr"])")), Places{"$.languages"});
}

TEST(NewFiles, MayNotHaveTwoConditionsOrCohortsOfOneTitle) {
  const auto conditions = tests::with(tests::usualProtocol(), "\"Firm\"", "\"Soft\"");
  const auto said = verdictOnFile(conditions);
  EXPECT_TRUE(
      has(said, "refused error   $.conditions[1].title: two conditions have the title 'Soft'"))
      << said;
  EXPECT_TRUE(tests::load(conditions).loaded.has_value()) << "an existing study has to open";
  const auto cohorts = tests::with(
      tests::usualProtocol(),
      R"({ "id": "anyone", "title": "Anyone" })",
      R"({ "id": "anyone", "title": "Anyone" }, { "id": "more", "title": {"en": "Anyone"} })");
  EXPECT_TRUE(has(verdictOnFile(cohorts), "$.cohorts[1].title: two cohorts have"));
}

TEST(NewFiles, MayNotHaveAMarginAsWideAsTheScale) {
  const auto margin = [](const std::string& bound) {
    return verdictOnFile(tests::with(
        tests::usualProtocol(),
        "\"alpha\": ",
        "\"equivalence_bound\": " + bound + ", \"alpha\": "));
  };
  EXPECT_TRUE(has(margin("0.5"), "usable "));
  EXPECT_TRUE(
      has(margin("4"), "refused error   $.analysis.families[0].equivalence_bound: no difference"));
}

TEST(NewFiles, AreToldOfLimitsBesideOtherErrors) {
  auto text = tests::with(
      tests::usualProtocol(), R"("title": "Anyone" })", R"("title": "Anyone", "planned": "8" })");
  text = tests::with(text, "\"max_force_n\": 8", "\"max_force_n\": 80");
  const auto said = verdictOnFile(text);
  EXPECT_TRUE(has(said, "$.cohorts[0].planned")) << said;
  EXPECT_TRUE(has(said, "$.devices[0].max_force_n: a punch gives 8 N")) << said;
}

TEST(NewFiles, AreNotToldOfLimitsThatCouldNotBeRead) {
  const auto text =
      tests::with(tests::usualProtocol(), "\"max_force_n\": 8", "\"max_force_n\": \"8\"");
  EXPECT_FALSE(has(verdictOnFile(text), "max_force_rate_n_per_s")) << verdictOnFile(text);
}

}  // namespace plan_warnings_test
}  // namespace protocols
