// What a report claims, and what it says against its claims.
#include <algorithm>

#include <gtest/gtest.h>

#include "analysis/summary/flags.h"
#include "analysis/summary/within_analysis.h"
#include "protocols/model/messages.h"
#include "study/report/html_report.h"
#include "study/report/study_parts.h"
#include "tests/study/report/section.h"

namespace study::report {
namespace claims_test {

bool has(const std::string& page, const std::string& words) {
  return page.find(words) != std::string::npos;
}

/// The comparison of @p family in @p cohort between its methods @p first and @p second.
analysis::TestRow& pairedT(
    FamilyResult& family, std::size_t cohort, const std::string& first, const std::string& second) {
  for (auto& row : family.cohorts[cohort].within.rows) {
    if (row.group1 != first || row.group2 != second) continue;
    return *std::ranges::find(row.tests, "paired_t", &analysis::TestRow::id);
  }
  throw std::logic_error("no such pair");
}

/// The entries in the list of weaknesses.
std::vector<std::string> weaknessesOf(const ReportSection& section) {
  std::vector<std::string> points;
  const auto list = weaknessesAsHtml(section);
  for (auto at = list.find("<li>"); at != std::string::npos; at = list.find("<li>", at + 1)) {
    points.push_back(list.substr(at + 4, list.find("</li>", at) - at - 4));
  }
  return points;
}

TEST(Claims, CallsNoPooledResultSignificantWithoutTheResultWithinPeople) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  pairedT(family, 0, "interpolation", "finite-elements") = {.id = "paired_t"};
  pairedT(family, 0, "interpolation", "kalman").isSignificant = false;
  const auto answer = verdictOf(section);
  EXPECT_TRUE(has(
      answer,
      ". Compared within people (paired t-test of participants’ means, exploratory), this does not "
      "hold for KF, cannot be tested for FEM. "))
      << answer;
  family.family.test = protocols::TestType::PairedT;
  EXPECT_FALSE(has(verdictOf(section), "independent"));
  EXPECT_TRUE(
      has(verdictOf(section), "By the declared test (paired t-test of participants’ means), "));
}

/// Where cohorts differ, a result within people counts only in a cohort with a pooled one.
TEST(Claims, ConfirmsAPooledResultOnlyInItsOwnCohort) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.cohorts[1] = family.cohorts[0];
  family.cohorts[1].cohort = "non-professional";
  for (auto& cohort : family.cohorts) {
    const bool isFirst = &cohort == &family.cohorts.front();
    for (auto& row : cohort.comparisons.rows) row.isSignificant = isFirst;
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = !isFirst;
    }
  }
  const auto [finding, more, caveats] = conclusionOf(section);
  EXPECT_TRUE(has(finding, " (finite elements) and KF (Kalman filter) in 1 of 2 cohorts. "))
      << finding;
  EXPECT_TRUE(has(finding, "no difference from it is significant. ")) << finding;
  EXPECT_TRUE(has(more, "Whether cohorts differ in these differences was not tested. ")) << more;
}

TEST(Claims, TellsSignificantDifferencesThatTheBestAlternativeHasNoPartIn) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  auto& row = pairedT(family, 0, "kalman", "finite-elements");
  row.estimate = {"difference", 0.8};
  row.p = 0.01;
  row.isSignificant = false;
  EXPECT_FALSE(has(verdictOf(section), "KF was rated"));
  row.isSignificant = true;
  EXPECT_TRUE(has(
      verdictOf(section), " KF was rated significantly higher than FEM (Orthopaedic surgeons)."))
      << verdictOf(section);
}

TEST(Claims, SaysThatNoMethodIsHighestWhereMeansAreEqual) {
  auto section = tests::madeUpSection();
  section.results.votes.clear();
  auto& family = section.results.families.front();
  family.isDeclared = false;
  for (auto& cohort : family.cohorts) {
    for (auto& one : cohort.conditions) one.answers = cohort.conditions.front().answers;
  }
  EXPECT_EQ(
      verdictOf(section),
      "On average no method was rated higher than all others (11 participants). All comparisons "
      "are exploratory.");
}

TEST(Claims, SaysWhyTheDeclaredTestHasNoResult) {
  auto section = tests::madeUpSection();
  section.results.votes.clear();
  for (auto& cohort : section.results.families.front().cohorts) {
    for (auto& row : cohort.comparisons.rows) {
      row.p.reset();
      row.reason = analysis::reason("two_values_needed");
    }
  }
  EXPECT_EQ(
      verdictOf(section),
      "On average Interpolation was rated highest (11 participants). By the declared test (Welch’s "
      "t-test of all answers, pooled), nothing can be compared: variance and interval need two "
      "values in each group.");
}

TEST(Claims, CountsSignificantDifferencesBetweenMethodsThatTheSentencesLeaveOut) {
  auto section = tests::madeUpSection();
  for (auto& cohort : section.results.families.front().cohorts) {
    for (auto& row : cohort.comparisons.rows) {
      row.isSignificant = row.group1 != "interpolation" && row.group2 != "interpolation";
    }
  }
  const auto answer = answerAsHtml(section);
  EXPECT_TRUE(has(answer, "on average; none of its differences is significant. ")) << answer;
  EXPECT_TRUE(has(answer, ". Also significant: KF was rated higher than FEM.</p>")) << answer;
}

TEST(Claims, CallsNoAbsenceOfSignificanceAlikeness) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  for (const auto* other : {"finite-elements", "kalman"}) {
    for (const std::size_t cohort : {0U, 1U}) {
      auto& row = pairedT(family, cohort, "interpolation", other);
      row.estimate = {"difference", 0.5};
      row.p = 0.3;
      row.isSignificant = false;
    }
  }
  EXPECT_TRUE(
      has(verdictOf(section),
          "Interpolation was rated neither significantly higher nor lower than FEM (finite "
          "elements) and KF (Kalman filter) in any cohort. That does not show that they are alike "
          "(0.50 points, at most 6 people)."))
      << verdictOf(section);
  for (auto& cohort : family.cohorts) {
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = false;
    }
  }
  EXPECT_TRUE(has(
      verdictOf(section),
      "By the declared test (paired t-test of participants’ means), none of the 3 differences "
      "(0.50 to 0.56 points) was significant in any cohort (5 to 6 people each). That does not "
      "show that they are alike. Interpolation was named most often: 11 of 21 votes (in 2 rounds; "
      "exploratory; not significant in any cohort). Interpolation was rated highest in each "
      "cohort. The votes answer “Which "))
      << verdictOf(section);
  EXPECT_TRUE(has(headAsHtml(section), "FEM (finite elements) and KF (Kalman filter) are compared"))
      << "introduced where the sentences before do not name them";
}

TEST(Claims, CountsThePeopleOfEachComparisonWhereAnswersAreMissing) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  auto& part = family.cohorts.front();
  std::erase_if(part.table.answers, [](const auto& answer) {
    const auto person = answer.participant;
    return (answer.method == 1 && person < 2) || (answer.method == 2 && person > 2);
  });
  part.within = analysis::compareWithin(
      part.table,
      std::vector<analysis::DeclaredPair>{
          {"interpolation", "finite-elements"},
          {"interpolation", "kalman"},
          {"kalman", "finite-elements"}},
      {});
  for (auto& cohort : family.cohorts) {
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = false;
    }
  }
  const auto verdict = verdictOf(section);
  EXPECT_TRUE(has(verdict, "none of the 2 differences (")) << verdict;
  EXPECT_TRUE(has(verdict, " points) was significant (3 to 4 people each")) << verdict;
  const auto answer = answerAsHtml(section);
  EXPECT_TRUE(
      has(answer, "<p>Orthopaedic surgeons (3 to 4 participants): no difference is significant."))
      << "without averages, which would be of other people: " << answer;
  EXPECT_TRUE(has(withinAsHtml(section, family, {}), "Orthopaedic surgeons, 3 to 4 participants"));
  EXPECT_TRUE(has(withinAsHtml(section, family, {}), ". 1 of 6 participants judged all methods;"));
  EXPECT_TRUE(has(answer, " 1 comparison could not be tested.</p>")) << answer;
  EXPECT_TRUE(has(
      answer,
      "<td>KF vs. FEM</td><td class=\"words\" colspan=\"4\">not defined: a comparison needs two "
      "participants, and has one</td>"))
      << answer;
  EXPECT_TRUE(has(answer, "p is corrected for the comparisons under one heading that were tested"));
  const std::string correction = "A comparison that could not be tested does not count in the ";
  EXPECT_TRUE(has(methodsAsHtml(section), correction));
  EXPECT_FALSE(has(methodsAsHtml(tests::madeUpSection()), correction));
}

/// The made-up study with a paired t-test that finds nothing, and a bound.
ReportSection withBound(double bound) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  family.family.equivalenceBound = bound;
  section.protocol.analysis.families.front().equivalenceBound = bound;
  for (auto& cohort : family.cohorts) {
    const std::vector<analysis::DeclaredPair> pairs{
        {"interpolation", "finite-elements"},
        {"interpolation", "kalman"},
        {"kalman", "finite-elements"}};
    cohort.within = analysis::compareWithin(cohort.table, pairs, {.equivalenceBound = bound});
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = false;
    }
  }
  return section;
}

TEST(Claims, SaysWhichDifferencesAreBelowTheDeclaredBound) {
  const auto wide = withBound(4.0);
  const auto verdict = verdictOf(wide);
  EXPECT_TRUE(
      has(verdict,
          " was significant (6 people). Negligible as declared, smaller than 4 points (TOST, p ≤ "
          "0.05): Interpolation and FEM (Orthopaedic surgeons), Interpolation and KF "))
      << verdict;
  EXPECT_FALSE(has(verdict, "That does not show")) << verdict;
  EXPECT_TRUE(has(answerAsHtml(wide), "; TOST p &lt; .001)")) << answerAsHtml(wide);
  const auto narrow = verdictOf(withBound(0.01));
  EXPECT_TRUE(has(narrow, "That does not show that they are alike.")) << narrow;
  EXPECT_FALSE(has(narrow, "Negligible")) << narrow;
}

TEST(Claims, NamesTheUnitThatAllItemsHave) {
  auto section = withBound(1.0);
  EXPECT_TRUE(has(methodsAsHtml(section), "Differences below 1 point count as none."));
  for (auto& instrument : section.instruments) {
    for (auto& item : instrument.items) item.unit = "N";
  }
  EXPECT_TRUE(has(answerAsHtml(section), "\u00a0N higher than ")) << answerAsHtml(section);
  EXPECT_TRUE(has(verdictOf(section), "\u00a0N) was significant (6 people)")) << verdictOf(section);
}

TEST(Claims, SaysNotSignificantOfComparisonsThatWereNotDeclared) {
  auto section = withBound(1.0);
  section.results.families.front().isDeclared = false;
  const auto answer = answerAsHtml(section);
  EXPECT_TRUE(has(answer, "no difference is significant.")) << answer;
  EXPECT_TRUE(has(answer, "The comparisons: means, and p")) << answer;
}

TEST(Claims, SaysWhoseIntervalsStandBesideAnExactTest) {
  auto section = withBound(1.0);
  EXPECT_FALSE(has(answerAsHtml(section), "Intervals are Student’s"));
  section.results.families.front().family.test = protocols::TestType::SignFlip;
  EXPECT_TRUE(has(answerAsHtml(section), "Intervals are Student’s")) << answerAsHtml(section);
}

TEST(Claims, NamesNoCohortWhereThereIsOne) {
  auto section = withBound(0.01);
  section.results.flow.resize(1);
  for (auto& vote : section.results.votes) vote.test.exactP = 0.5;
  EXPECT_TRUE(has(verdictOf(section), "exploratory; not significant)")) << verdictOf(section);
}

TEST(Claims, NamesItsFamilyAndCountsTheFindingsOfTheOthers) {
  auto section = tests::madeUpSection();
  auto& families = section.results.families;
  EXPECT_TRUE(verdictOf(section).starts_with("By the declared test"));
  families.push_back(families.front());
  families.front().family.title = "Realism";
  families.back().family.title = "Effort";
  for (auto& cohort : families.back().cohorts) {
    for (auto& row : cohort.comparisons.rows)
      row.isSignificant = &row == &cohort.comparisons.rows[1];
  }
  const auto verdict = verdictOf(section);
  EXPECT_TRUE(has(limitationsAsHtml(section), "“Realism”: ")) << limitationsAsHtml(section);
  EXPECT_TRUE(has(limitationsAsHtml(section), "“Effort”: "));
  EXPECT_TRUE(has(methodsAsHtml(section), " (“Realism”)"));
  EXPECT_TRUE(verdict.starts_with("“Realism”: By the declared test")) << verdict;
  EXPECT_TRUE(
      has(verdict, "Significant differences otherwise: 1 of 3 in “Effort” (all answers pooled)."))
      << verdict;
  families.back().isDeclared = false;
  EXPECT_FALSE(has(verdictOf(section), "Effort")) << "exploratory";
}

TEST(Claims, SaysWhichScoreAndWhichRoundsAreCompared) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front().family;
  family.blocks = {"round-2"};
  EXPECT_TRUE(has(headAsHtml(section), " reversed) in round 2 (also seen); scale from 1 (strongly"))
      << headAsHtml(section);
  family.score = "face-validity-1";
  EXPECT_TRUE(has(headAsHtml(section), "Compared is the score “")) << headAsHtml(section);
  EXPECT_TRUE(has(headAsHtml(section), "” of 3 questions (")) << headAsHtml(section);
}

TEST(Claims, SayWhichScoresAreOfOtherStatementsAndWhichAreLeftOut) {
  auto section = tests::madeUpSection();
  const auto score = [](const char* id, const char* condition) {
    return ScoreSummary{
        .score = id, .cohort = "professional", .condition = condition, .values = {3.0, 4.0}};
  };
  auto& all = section.results.instruments;
  all = {
      {.instrument = "punch-face-validity",
       .scores =
           {score("face-validity-1", "interpolation"), score("face-validity-2", "finite-elements")},
       .forms = 4}};
  const std::string left = "could be worked out: Face validity, set 3</p>";
  const std::string own = "asks different statements about each alternative";
  EXPECT_FALSE(has(instrumentsAsHtml(section), "worked out")) << "of several people";
  section.results.flow = {{.cohort = "professional", .enrolled = 1, .completed = 1}};
  section.history.versions = 1;
  EXPECT_TRUE(has(instrumentsAsHtml(section), left)) << instrumentsAsHtml(section);
  EXPECT_TRUE(has(instrumentsAsHtml(section), own));
  all.front().scores[1].score = "face-validity-1";
  EXPECT_FALSE(has(instrumentsAsHtml(section), own));
  all.front().forms = 0;
  EXPECT_FALSE(has(instrumentsAsHtml(section), "worked out")) << "nobody was asked";
}

TEST(Claims, CountsALaboratorysOwnWordingAsUnpublished) {
  auto section = tests::madeUpSection();
  for (auto& one : section.instruments) one.source.citation = "An article.";
  EXPECT_TRUE(has(validityAsHtml(section), " 0 of them without a published source"));
  for (auto& one : section.instruments) one.source.citation = "Own wording.";
  EXPECT_FALSE(has(validityAsHtml(section), " 0 of them without a published source"));
}

TEST(Claims, NamesDifferencesThatOnlyUndeclaredTestsFind) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  EXPECT_FALSE(has(limitationsAsHtml(section), "not declared (exploratory)")) << "pooled";
  family.family.test = protocols::TestType::PairedT;
  for (auto& cohort : family.cohorts) {
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = false;
    }
  }
  EXPECT_FALSE(has(limitationsAsHtml(section), "not declared (exploratory)"));
  for (auto& test : family.cohorts.front().within.rows.front().tests) {
    if (test.id != "mixed_model") continue;
    test.isSignificant = true;
    test.adjusted = 0.035;
  }
  EXPECT_TRUE(
      has(limitationsAsHtml(section),
          "1 difference is significant only by tests that were not declared (exploratory): "
          "Interpolation − FEM (Orthopaedic surgeons: Mixed model "))
      << limitationsAsHtml(section);
}

TEST(Claims, NamesSignificantResultsThatNoExactTestFinds) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  family.isDeclared = true;
  for (auto& cohort : family.cohorts) {
    for (auto& row : cohort.within.rows) {
      for (auto& test : row.tests) test.isSignificant = test.id == "sign_flip";
    }
  }
  pairedT(family, 0, "interpolation", "kalman").isSignificant = true;
  EXPECT_FALSE(has(limitationsAsHtml(section), "either exact test")) << "one of them finds it";
  for (auto& row : family.cohorts[0].within.rows) {
    for (auto& test : row.tests) test.isSignificant = test.id == "paired_t";
  }
  EXPECT_TRUE(
      has(limitationsAsHtml(section),
          "3 of 3 significant differences are not significant by either exact test (exploratory): "
          "Interpolation − FEM (Orthopaedic surgeons: "))
      << limitationsAsHtml(section);
}

TEST(Claims, SaysWhichChecksCouldNotBeMade) {
  auto section = tests::madeUpSection();
  section.warnings.clear();
  for (auto& cohort : section.results.families.front().cohorts) cohort.flags.clear();
  section.quality.worstLateness.reset();
  EXPECT_TRUE(has(limitationsAsHtml(section), "Could not be looked for: A late force loop."))
      << limitationsAsHtml(section);
  EXPECT_TRUE(has(weaknessesAsHtml(section), "None of 14 checks"));
  section.quality.worstLateness = 12.0;
  EXPECT_FALSE(has(limitationsAsHtml(section), "Could not be looked for"));
}

TEST(Claims, DrawsNoDifferenceOfCohortsFromDifferencesOfSignificance) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  for (const auto* other : {"finite-elements", "kalman"}) {
    for (const std::size_t cohort : {0U, 1U}) {
      auto& row = pairedT(family, cohort, "interpolation", other);
      row.estimate = {"difference", cohort == 0 ? 1.04 : 0.48};
      row.p = 0.01;
      row.isSignificant = cohort == 0;
    }
  }
  const auto answer = verdictOf(section);
  EXPECT_FALSE(has(answer, "only by")) << answer;
  EXPECT_TRUE(
      has(conclusionOf(section).finding,
          " higher than FEM (finite elements) and KF (Kalman filter) in 1 of 2 cohorts. "))
      << answer;
  EXPECT_TRUE(has(answer, ". Whether cohorts differ in these differences was not tested."))
      << answer;
}

TEST(Claims, SaysHowManyParticipantsWerePlannedAndWhoseAnswersItShows) {
  auto section = tests::madeUpSection();
  EXPECT_TRUE(
      has(participantsAsHtml(section),
          "11 of 12 enrolled participants completed their sessions (Orthopaedic surgeons 6 of 6 "
          "planned, Adults without surgical experience 5 of 5 planned)."));
  section.results.runMode = RunMode::Live;
  EXPECT_FALSE(has(participantsAsHtml(section), "hand it on"));
  section.results.flow = {
      {.cohort = "professional", .enrolled = 1, .completed = 1}, {.cohort = "non-professional"}};
  const auto one = participantsAsHtml(section);
  EXPECT_TRUE(
      has(one,
          "1 of 1 enrolled participant completed the session (Orthopaedic surgeons 1 of 6 planned, "
          "Adults without surgical experience 0 of 5 planned)."))
      << one;
  EXPECT_TRUE(
      has(one, "shows the answers of one person (Orthopaedic surgeons): do not hand it on"));
}

TEST(Claims, CountsParticipantsBySiteEvenIfAllCompleted) {
  auto section = tests::madeUpSectionOfSites();
  section.results.flow.front().enrolled = 6;
  EXPECT_TRUE(has(participantsAsHtml(section), "Who took part, by site"));
}

TEST(Claims, ClaimsNothingOfOneParticipant) {
  auto section = tests::madeUpSection();
  section.results.flow = {{.cohort = "professional", .enrolled = 1, .completed = 1}};
  EXPECT_EQ(verdictOf(section), "One participant so far: nothing can be compared.");
}

TEST(Claims, NamesTheHeaviestWeaknessesFirst) {
  auto section = tests::madeUpSection();
  const auto points = weaknessesOf(section);
  ASSERT_GT(points.size(), 4U);
  EXPECT_EQ(points[0], "Different statements about the methods");
  EXPECT_EQ(points[1], "Too few participants for an exact test to be significant");
  EXPECT_EQ(
      points[2], "Several answers of one person counted as independent: Orthopaedic surgeons");
  EXPECT_TRUE(points[4].starts_with("A reader of the protocol could tell conditions apart by the "))
      << points[4];
  section.results.flow.front().completed = 5;
  EXPECT_EQ(
      weaknessesOf(section).front(),
      "Fewer participants than planned: Orthopaedic surgeons 5 of 6");
}

/// The first page hides none of the points that the appendix explains.
TEST(Claims, ListsAllLimitationsInTheSameOrderAsTheAppendix) {
  const auto section = tests::madeUpSection();
  const auto page = limitationsAsHtml(section);
  std::vector<std::string> titles;
  for (auto at = page.find("<dt>"); at != std::string::npos; at = page.find("<dt>", at + 1)) {
    titles.push_back(page.substr(at + 4, page.find("</dt>", at) - at - 4));
  }
  const auto points = weaknessesOf(section);
  ASSERT_EQ(points.size(), titles.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_TRUE(points[i].starts_with(titles[i])) << points[i] << "\n" << titles[i];
  }
}

/// What the check of the protocol says stands where the same is explained.
TEST(Claims, PutsRemarksOnTheDesignBelowTheLimitationThatTheyAreAbout) {
  auto section = tests::madeUpSection();
  section.warnings = {
      {.path = "$.phases[0]",
       .what = protocols::message("unlike_statements", "round-1"),
       .fix = {}},
      {.path = "$.phases[0]", .what = protocols::message("order_tells", "round-1"), .fix = {}}};
  EXPECT_TRUE(has(limitationsAsHtml(section), ")</span></p><ul><li>conditions answer different "));
  EXPECT_TRUE(has(limitationsAsHtml(section), "<li>the position in ‘round 1 (felt only)’ says "));
  EXPECT_FALSE(has(limitationsAsHtml(section), "on the design"));
  for (auto& cohort : section.results.families.front().cohorts) cohort.flags.clear();
  EXPECT_TRUE(has(limitationsAsHtml(section), "<dt>1 remark on the design</dt>"));
  EXPECT_TRUE(has(limitationsAsHtml(section), "<li>conditions answer different statements in "));
}

TEST(Claims, SaysThatOneParticipantIsOneAndNothingOfTests) {
  auto section = tests::madeUpSection();
  section.results.flow = {
      {.cohort = "professional", .enrolled = 1, .completed = 1}, {.cohort = "non-professional"}};
  section.results.families.front().cohorts[1] = {.cohort = "non-professional"};
  const auto points = weaknessesOf(section);
  EXPECT_EQ(points[0], "One participant only");
  EXPECT_EQ(
      points[1],
      "Fewer participants than planned: Orthopaedic surgeons 1 of 6, Adults without surgical "
      "experience 0 of 5");
  for (const auto& point : points) EXPECT_FALSE(has(point, "independent")) << point;
  for (const auto& point : points) EXPECT_FALSE(has(point, "(Orthopaedic surgeons)")) << point;
}

TEST(Claims, ExplainsEachLimitationOnce) {
  const auto page = asHtml({tests::madeUpSection()});
  for (const auto* explained : {"In 2 of 9 trials the force loop was late", "In 1 of 9 trials"}) {
    const auto first = page.find(explained);
    ASSERT_NE(first, std::string::npos) << explained;
    EXPECT_EQ(page.find(explained, first + 1), std::string::npos) << explained;
  }
}

TEST(Claims, SaysWhatWasLookedForAndNotFound) {
  auto section = tests::madeUpSection();
  section.warnings.clear();
  for (auto& cohort : section.results.families.front().cohorts) cohort.flags.clear();
  section.quality.worstLateness = 12.0;
  EXPECT_TRUE(has(
      weaknessesAsHtml(section), "None of 15 checks of the trials and of the compared answers"));
  const auto all = limitationsAsHtml(section);
  for (const auto& kind : analysis::kFlagMessages) {
    if (!kind.key.ends_with(".title")) continue;
    EXPECT_TRUE(has(all, std::string(kind.english))) << kind.key;
  }
}

TEST(Claims, SaysHowLikelyAFalseFindingIsInAnyOfItsAnalyses) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  family.family.test = protocols::TestType::PairedT;
  family.cohorts[1] = family.cohorts[0];
  family.cohorts[1].cohort = "non-professional";
  family.cohorts.push_back(family.cohorts[0]);
  section.protocol.cohorts.push_back({.id = "third"});
  family.cohorts[2].cohort = "third";
  // 1 - 0.95³ = 0.143
  EXPECT_TRUE(has(limitationsAsHtml(section), "within each of 3 analyses"))
      << limitationsAsHtml(section);
  EXPECT_TRUE(has(limitationsAsHtml(section), "in up to 14 % of such studies"));
  family.cohorts.resize(1);
  EXPECT_FALSE(has(limitationsAsHtml(section), "analyses"));
}

TEST(Claims, TellsCohortsApartWhoseTitlesContainEachOther) {
  auto section = tests::madeUpSection();
  const auto titled = [](const std::string& text) {
    return protocols::LocalizedText(std::map<std::string, std::string>{{"en", text}});
  };
  section.protocol.cohorts[0].title = titled("Senior residents");
  section.protocol.cohorts[1].title = titled("residents");
  auto& cohorts = section.results.families.front().cohorts;
  const auto isTooFew = [](const auto& flag) { return flag.id == "n_below_minimum_for_alpha"; };
  const auto flag = *std::ranges::find_if(cohorts[1].flags, isTooFew);
  cohorts[0].flags = {flag};
  cohorts[1].flags.clear();
  EXPECT_TRUE(has(limitationsAsHtml(section), "<p>Senior residents: With "))
      << limitationsAsHtml(section);
  cohorts[1].flags = {flag};
  EXPECT_TRUE(has(limitationsAsHtml(section), "<p>In each cohort: With "));
}

}  // namespace claims_test
}  // namespace study::report
