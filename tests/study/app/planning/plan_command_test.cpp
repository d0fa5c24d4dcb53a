// The command 'palpate plan'.
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/study/made_study.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace plan_command_test {

using nlohmann::json;
using tests::Finished;

Finished plan(std::vector<std::string> arguments) {
  std::vector<std::string> call{tests::program(), "plan"};
  call.insert(call.end(), arguments.begin(), arguments.end());
  return tests::run(call);
}

json planned(std::vector<std::string> arguments) {
  arguments.emplace_back("--json");
  const auto found = plan(arguments);
  EXPECT_EQ(found.status, 0) << found.error;
  return json::parse(found.out);
}

void expectPhrases(const std::string& text, const std::vector<std::string>& phrases) {
  for (const auto& phrase : phrases) {
    EXPECT_NE(text.find(phrase), std::string::npos) << phrase << "\nin\n" << text;
  }
}

TEST(PlanCommand, ReportsThatSixAndFivePeopleAreTooFew) {
  const auto found = plan({"punch-face-validity", "--studies", "200"});
  ASSERT_EQ(found.status, 0) << found.error;
  expectPhrases(
      found.out,
      {"the same order for everybody",
       "smallest exact p of a pair .03125: above .01667",
       "NO exact paired test can ever be significant",
       "At least 7 are needed",
       "power of a paired t-test for d_z = 1 at the strictest step of the correction: .27",
       "N for 0.8      45      20      14      11       8",
       "N for 0.9      57      25      17      13      10",
       "professional against non-professional: smallest exact p of Mann and Whitney's test .0043",
       "For an application to an ethics committee"});
}

/// The library's balanced protocol with its first family's test and correction changed.
std::string declared(
    const tests::ScratchFolder& scratch, const std::string& test, const std::string& correction) {
  auto protocol = json::parse(tests::libraryProtocol("punch-counterbalanced.json").text);
  protocol["analysis"]["families"][0]["test"] = test;
  protocol["analysis"]["families"][0]["correction"] = correction;
  const auto file = scratch / (test + ".json");
  std::ofstream(file) << protocol;
  return file;
}

TEST(PlanCommand, KnowsCorrectionsThatAskLessOfSeveralSmallP) {
  const tests::ScratchFolder scratch;
  const auto file = declared(scratch, "sign_flip", "hommel");
  const auto six = plan({file, "--participants", "6", "--studies", "0"});
  expectPhrases(
      six.out,
      {"Hommel within 0.05, so alpha = .01667 to .05 each, depending on the others",
       "can find something only if others of the family do, too",
       "can reach significance only together with others of the family"});
  const auto five = plan({file, "--participants", "5", "--studies", "0"});
  expectPhrases(five.out, {"above .05, so that NO exact", "At least 6 are needed"});
}

TEST(PlanCommand, SimulatesTheDeclaredTest) {
  const tests::ScratchFolder scratch;
  const auto file = declared(scratch, "sign_flip", "bonferroni");
  const auto found = planned({file, "--participants", "6", "--studies", "200"});
  const auto& family = found["families"][0];
  EXPECT_EQ(family["declared_test"], "sign_flip");
  EXPECT_EQ(family["participants_for_power_balanced"], 18);
  EXPECT_EQ(family["prospects"][0]["simulated"]["sign_flip"]["rate"], 0.0);
  EXPECT_GT(family["declared_test_found_if_balanced"]["rate"], 0.7);
  const auto text = plan({file, "--participants", "6", "--studies", "200"}).out;
  expectPhrases(
      text,
      {"Declared test: exact sign-flip test of participants' means.",
       "The declared test is the exact sign-flip test of participants' means. With 6 participants "
       "it finds this difference in .00 of simulated studies. The declared test finds it with 18"});
}

TEST(PlanCommand, CountsThePointsOfItemsWithSteps) {
  const tests::ScratchFolder scratch;
  auto protocol = json::parse(tests::libraryProtocol("punch-counterbalanced.json").text);
  protocol["analysis"]["families"][0]["instrument"] = "guess";
  protocol["analysis"]["families"][0]["items"] = {"force"};
  protocol["instrument_files"] = {"guess.json"};
  for (auto& phase : protocol["phases"]) {
    if (phase["type"] == "block") phase["questionnaires"] = {{{"instrument", "guess"}}};
  }
  const auto planOf = [&](const std::string& step) {
    const std::string scale = R"("least": 0, "most": 20, "step": )" + step;
    std::ofstream(scratch / "guess.json")
        << R"({"$schema": "instrument-1.schema.json", "id": "guess", "version": "1",
              "title": "Guess", "source": {"citation": "Own wording.", "licence": "CC0-1.0"},
              "languages": ["en"],
              "items": [{"id": "force", "type": "number", "text": "?", )"
        << scale << "}]}";
    std::ofstream(scratch / "guessed.json") << protocol;
    return plan({scratch / "guessed.json", "--studies", "0"}).out;
  };
  expectPhrases(planOf("0.5"), {"about each condition, on 41 points"});
  expectPhrases(planOf("0"), {"about each condition, on a scale without steps"});
}

TEST(PlanCommand, CountsTheScoresOfFormsWhereAFamilyComparesAScore) {
  auto json = tests::libraryProtocol("punch-counterbalanced.json").text;
  const std::string asked = R"("instrument": "realism-common",)";
  json.insert(json.find(asked, json.find("\"families\"")), R"("score": "realism", )");
  const tests::ScratchFolder scratch;
  const auto file = scratch / "scored.json";
  std::ofstream(file) << json;
  const auto found = plan({file, "--participants", "12", "--studies", "0"});
  expectPhrases(found.out, {"Each participant gives 2 scores about each condition, on "});
}

TEST(PlanCommand, ReportsHowManyParticipantsBalanceTheOrders) {
  const auto found = plan({"punch-counterbalanced", "--participants", "14", "--studies", "0"});
  ASSERT_EQ(found.status, 0) << found.error;
  expectPhrases(
      found.out,
      {"balanced for every multiple of 6",
       "14 participants do NOT balance every block; 12 or 18 do",
       "14 participants a cohort; 18 balance the orders as well"});
  EXPECT_EQ(found.out.find("simulated:"), std::string::npos);
  const auto twelve = planned({"punch-counterbalanced", "--participants", "12", "--studies", "0"});
  EXPECT_EQ(twelve["balanced_by"], 6);
  EXPECT_TRUE(twelve["cohorts"][0]["balanced"]);
}

TEST(PlanCommand, TakesEffectAlphaAndPowerFromTheCall) {
  const auto found = planned(
      {"punch-face-validity",
       "--participants",
       "20",
       "--effect",
       "0.8",
       "--alpha",
       "0.05",
       "--power",
       "0.9",
       "--studies",
       "0"});
  const auto& family = found["families"][0];
  EXPECT_EQ(family["participants_for_power"], 25);
  EXPECT_EQ(family["answers"], 6);  // three statements, two rounds
  EXPECT_EQ(family["points"], 5);
  EXPECT_NEAR(family["alpha_per_test"], 0.05 / 3.0, 1e-15);
  EXPECT_EQ(family["prospects"][0]["participants"], 20);
  EXPECT_NEAR(family["prospects"][0]["power"], 0.818383298514, 1e-9);
  EXPECT_TRUE(family["prospects"][0]["can_find_pairs"]);
  EXPECT_TRUE(family["prospects"][0]["simulated"].is_null());
}

TEST(PlanCommand, SimulatesTheSameForTheSameSeed) {
  const std::vector<std::string> call{"punch-face-validity", "--studies", "300", "--seed", "4"};
  const auto first = planned(call);
  EXPECT_EQ(first, planned(call));
  const auto& simulated = first["families"][0]["prospects"][0]["simulated"];
  EXPECT_EQ(simulated["signed_rank"]["rate"], 0.0);  // six people
  EXPECT_NEAR(simulated["paired_t"]["rate"], 0.27, 0.1);
}

TEST(PlanCommand, SimulatesTheErrorRateOfPooledAnswers) {
  const auto found =
      planned({"punch-face-validity", "--participants", "6", "--shares", "0.1", "0.4", "0.5"});
  const auto& none = found["families"][0]["prospects"][0]["simulated_without_effect"];
  EXPECT_GT(none["any_pooled_welch"]["rate"], 0.25);
  EXPECT_LT(none["any_paired_t"]["rate"], 0.08);
}

TEST(PlanCommand, PlansSeveralSites) {
  const std::vector<std::string> call{
      "punch-counterbalanced", "--participants", "24", "--effect", "0.8", "--studies", "200"};
  auto atSites = call;
  for (const char* more : {"--sites", "4", "--site-sd", "0.5"}) atSites.emplace_back(more);
  const auto found = planned(atSites);
  EXPECT_EQ(found["sites"], 4);
  EXPECT_NEAR(found["site_icc"], 0.2, 1e-12);
  const auto& prospect = found["families"][0]["prospects"][0];
  EXPECT_NEAR(prospect["at_sites"]["design_effect"], 2.0, 1e-12);
  EXPECT_LT(prospect["at_sites"]["power"], prospect["power"]);
  EXPECT_GT(prospect["at_sites"]["simulated_without_effect"]["any_paired_t"]["rate"], 0.08);
  EXPECT_GT(prospect["at_sites"]["simulated"]["median_half_width"], 0.2);
  EXPECT_TRUE(found["families"][0].contains("participants_for_power_at_sites"));
  const auto text = plan(atSites).out;
  expectPhrases(
      text,
      {"at 4 sites, between which the effect has a standard deviation of 0.5 d_z: design effect "
       "2.00",
       "found by the pooled difference",
       "Each site draws orders of its own",
       "They come from 4 sites."});
  // All else is as without sites.
  auto others = found;
  for (const char* key : {"sites", "site_sd_dz", "site_icc", "ethics"}) others.erase(key);
  for (auto& family : others["families"]) {
    family.erase("participants_for_power_at_sites");
    family.erase("participants_for_power_at_sites_balanced");
    for (auto& one : family["prospects"]) one.erase("at_sites");
  }
  auto without = planned(call);
  without.erase("ethics");
  EXPECT_EQ(others, without);
}

TEST(PlanCommand, RecommendsAsManyParticipantsAtEachSite) {
  const auto found = planned({"punch-counterbalanced", "--studies", "0", "--sites", "4"});
  const auto& family = found["families"][0];
  const int enough = family["participants_for_power_at_sites"];
  const int recommended = family["participants_for_power_at_sites_balanced"];
  EXPECT_EQ(recommended % (4 * 6), 0);  // six balance the orders of a site
  EXPECT_GE(recommended, enough);
  EXPECT_LT(recommended, enough + 4 * 6);
}

TEST(PlanCommand, SaysWhenTooFewParticipantsAreAtEachSite) {
  const auto found =
      plan({"punch-counterbalanced", "--participants", "6", "--sites", "4", "--studies", "0"});
  ASSERT_EQ(found.status, 0) << found.error;
  expectPhrases(found.out, {"at 4 sites: too few. A site needs two participants to be pooled, 8"});
  EXPECT_EQ(plan({"punch-counterbalanced", "--site-sd", "0.1"}).status, 2);
}

TEST(PlanCommand, AddsUpTheDurationOfASession) {
  const auto usual = planned({"punch-counterbalanced", "--studies", "0"});
  const auto& session = usual["session"];
  double sum = 0.0;
  for (const auto& part : session["parts"]) sum += part["seconds"].get<double>();
  EXPECT_NEAR(session["seconds"], sum, 1e-9);
  EXPECT_DOUBLE_EQ(session["seconds_of_force"], 18 * 8.0);  // two rounds of three, three cuts each
  const auto slower =
      planned({"punch-counterbalanced", "--studies", "0", "--seconds-per-cut", "18"});
  EXPECT_NEAR(
      slower["session"]["seconds"].get<double>() - session["seconds"].get<double>(),
      (18 + 3) * 10.0,  // including those with the real tool
      1e-9);
}

TEST(PlanCommand, ReportsHowManyVotesAreSignificant) {
  const auto found = planned({"punch-face-validity", "--studies", "0"});
  EXPECT_EQ(found["votes"][0]["votes"], 6);
  EXPECT_EQ(found["votes"][0]["to_win"], 6);  // 5 of 6 have p = 39/729
  const auto few = plan({"punch-face-validity", "--participants", "2", "--studies", "0"});
  expectPhrases(few.out, {"too few: not even all votes for one"});
  const auto many = planned({"punch-face-validity", "--participants", "200", "--studies", "0"});
  EXPECT_GT(many["votes"][0]["to_win"], 67);
  EXPECT_LT(many["votes"][0]["to_win"], 90);
}

TEST(PlanCommand, ReportsInvalidInput) {
  const auto nowhere = plan({"nowhere.json"});
  EXPECT_EQ(nowhere.status, 1);
  expectPhrases(nowhere.error, {"nowhere.json"});
  const auto shares = plan({"punch-face-validity", "--shares", "0.5", "0.5", "0.5"});
  EXPECT_EQ(shares.status, 1);
  expectPhrases(shares.error, {"add up to 1"});
  EXPECT_EQ(plan({"punch-face-validity", "--effect", "nan"}).status, 2);
  tests::ScratchFolder folder;
  const auto file = folder.write("bad.json", R"({"$schema": "protocol-1.schema.json"})");
  const auto bad = plan({file});
  EXPECT_EQ(bad.status, 1);
  expectPhrases(bad.error, {"'conditions'"});
}

}  // namespace plan_command_test
