#include "tests/study/report/section.h"

#include <array>

#include "analysis/data/vote_shares.h"
#include "protocols/changed_meaning.h"
#include "protocols/load_protocol.h"
#include "study/model/messages.h"

namespace tests {

using analysis::LikertCounts;
using study::CohortResult;

namespace {

/// Answers with these counts, assigned to @p people in turn. With six people the orders are
/// balanced; with fewer there is one order, and every method has its own statements.
analysis::AnswerTable dealt(
    std::size_t people,
    const std::vector<std::pair<std::string, std::vector<std::uint64_t>>>& counts) {
  analysis::AnswerTable table{
      .rounds = {"round-1", "round-2"}, .statements = {"1", "2", "3", "4", "5"}};
  for (std::size_t i = 0; i < people; ++i)
    table.participants.push_back("SIM-00" + std::to_string(i + 1));
  for (std::size_t method = 0; method < counts.size(); ++method) {
    table.methods.push_back(counts[method].first);
    std::size_t number = 0;
    for (std::size_t point = 0; point < counts[method].second.size(); ++point) {
      for (std::uint64_t i = 0; i < counts[method].second[point]; ++i, ++number) {
        const std::size_t turn = number / people;
        const bool isBalanced = people == 6;
        table.answers.push_back(
            {.participant = number % people,
             .method = method,
             .round = turn / 3,
             .statement = turn % 3 + (isBalanced ? 0 : method),
             .position =
                 static_cast<int>((method + (isBalanced ? number % people : 0)) % counts.size()) +
                 1,
             .score = static_cast<double>(point) + 1.0});
      }
    }
  }
  return table;
}

CohortResult cohort(
    const std::string& id,
    const std::vector<std::uint64_t>& a,
    const std::vector<std::uint64_t>& b,
    const std::vector<std::uint64_t>& c) {
  CohortResult result{.cohort = id, .conditions = {}, .comparisons = {}};
  result.table = dealt(
      id == "professional" ? 6 : 5, {{"interpolation", a}, {"finite-elements", b}, {"kalman", c}});
  result.conditions.push_back({"interpolation", LikertCounts(1, a)});
  result.conditions.push_back({"finite-elements", LikertCounts(1, b)});
  result.conditions.push_back({"kalman", LikertCounts(1, c)});
  const std::vector<analysis::DeclaredPair> pairs{
      {"interpolation", "finite-elements"},
      {"interpolation", "kalman"},
      {"kalman", "finite-elements"}};
  result.comparisons = analysis::comparePairwise(result.conditions, pairs, 0.05);
  result.within = analysis::compareWithin(result.table, pairs, {});
  result.checks = analysis::scaleChecks(result.table);
  result.position = analysis::positionEffect(result.table);
  result.flags = analysis::flagsOf(
      result.table,
      {.isDeclared = false,
       .tests = 3,
       .hasSameStatements = false,
       .felt = {{0, 0, 0, 1}, {1, 0, 0, 1}, {2, 0, 0, 1}},
       .comparativeStatements = {1},
       .pValues = {0.01668},
       .expected = {7, 7, 7},
       .trials = 9,
       .lateTrials = 2,
       .saturated = {{"Interpolation", 1, 3}},
       .otherScale = {protocols::inWords(protocols::ChangedMeaning::Aspect::Scale, 1, 6, "1.1")},
       .changes = {
           protocols::inWords(protocols::ChangedMeaning::Aspect::Key, 1, 6, "1.1"),
           protocols::inWords(protocols::ChangedMeaning::Aspect::Wording, 1, 6, "1.2")}});
  return result;
}

study::RenderedForceCurve curve(const std::string& condition, double force) {
  study::RenderedForceCurve curve{
      .condition = condition, .device = "punch", .trials = 4, .strokes = 13, .points = {}};
  for (int i = 0; i < 20; ++i) {
    curve.points.push_back({0.5 * i, force - 0.2, force, force + 0.2});
  }
  return curve;
}

/// One row of TABLE 4 of the punch paper.
study::VoteResult vote(
    const std::string& cohort, const std::string& round, const std::array<std::uint64_t, 3>& n) {
  analysis::VoteCounts votes({"interpolation", "finite-elements", "kalman"});
  std::vector<std::optional<analysis::Interval>> intervals;
  for (std::size_t i = 0; i < n.size(); ++i) {
    votes.add(votes.shares()[i].option, n[i]);
    intervals.push_back(analysis::wilsonInterval(n[i], n[0] + n[1] + n[2]));
  }
  return {
      .cohort = cohort,
      .phase = "preference-" + round,
      .block = "round-" + round,
      .votes = votes,
      .test = analysis::equalSharesTest(votes),
      .intervals = intervals};
}

study::report::ReportSection makeUpSection() {
  questionnaires::Problems problems;
  auto loaded = *protocols::loadProtocolFile("punch-face-validity", problems);
  loaded.protocol.study.title = "Cut & <script>alert(1)</script>";
  study::report::ReportSection section;
  for (auto& phase : loaded.protocol.phases) {
    phase.hasOptionalTrials = phase.id == "preference-2";
  }
  section.protocol = loaded.protocol;
  section.instruments = loaded.instruments;
  section.sources = loaded.sources;
  section.protocolHash = "abc";
  section.uuid = "def";
  section.commitment = "c0ffee00c0ffee00c0ffee00c0ffee00c0ffee00c0ffee00c0ffee00c0ffee00";
  section.trail = {812, "1a2b3c4d5e6f708192a3b4c5d6e7f8091a2b3c4d5e6f708192a3b4c5d6e7f809"};
  section.seed = 7;
  using Kind = study::FamilyChange::Kind;
  section.history = {
      .versions = 3,
      .versionsSinceBegun = 2,
      .changes =
          {{.title = "Realism",
            .keys =
                {"instrument",
                 "blocks",
                 "comparisons",
                 "test",
                 "correction",
                 "alpha",
                 "equivalence_bound"},
            .version = "2",
            .addedUtc = "2026-03-01T10:00:00.000Z"},
           {.title = "Effort",
            .kind = Kind::Added,
            .keys = {},
            .version = "3",
            .addedUtc = "2026-03-02T10:00:00.000Z"},
           {.title = "Ease",
            .kind = Kind::Removed,
            .keys = {},
            .version = "3",
            .addedUtc = "2026-03-02T10:00:00.000Z"},
           {.title = "Fun",
            .keys = {"alpha"},
            .version = "2",
            .addedUtc = "2026-03-01T10:00:00.000Z",
            .isHarmless = true},
           {.title = "Fun",
            .kind = Kind::Restored,
            .keys = {},
            .version = "3",
            .addedUtc = "2026-03-02T10:00:00.000Z",
            .isHarmless = true},
           {.title = "Ease",
            .kind = Kind::Restored,
            .keys = {},
            .version = "4",
            .addedUtc = "2026-03-03T10:00:00.000Z"}},
      .undeclared = {}};
  section.results.runMode = study::RunMode::Simulated;
  section.results.flow = {
      {.cohort = "professional", .enrolled = 7, .completed = 6, .withdrawn = 1},
      {.cohort = "non-professional", .enrolled = 5, .completed = 5}};
  section.results.families.push_back(
      {loaded.protocol.analysis.families.front(),
       true,
       {cohort("professional", {1, 3, 6, 9, 17}, {13, 7, 4, 4, 8}, {8, 5, 5, 8, 10}),
        cohort("non-professional", {0, 0, 0, 0, 5}, {0, 0, 5, 0, 0}, {0, 0, 0, 0, 5})}});
  section.results.votes = {
      vote("professional", "1", {4, 0, 2}),
      vote("non-professional", "1", {2, 1, 2}),
      vote("professional", "2", {3, 0, 2}),
      vote("non-professional", "2", {2, 0, 3})};
  section.curves = {curve("interpolation", 3.0), curve("finite-elements", 5.0)};
  section.quality = {
      .trials = 36, .optionalTrials = 2, .pass = 34, .warn = 1, .fail = 1, .cuts = 110};
  section.quality.worstLateness = 84.0;
  section.quality.rate = 1000.0;
  section.quality.conditions = {{"interpolation", 12, 37}, {"kalman", 12, 36}};
  section.quality.reasons = {{{study::message("trial.late", 3, 4000)}, 2}};
  section.quality.saturatedTrials = {{"interpolation", 12, {0.1, 0.125, 0.25}}};
  section.landmarks = {
      {"interpolation",
       "yield",
       analysis::summarise(std::vector{7.0, 7.4}),
       analysis::summarise(std::vector{4.0, 5.0})},
      {"interpolation",
       "opening",
       analysis::summarise(std::vector{7.8}),
       analysis::summarise(std::vector{5.2})},
      {"interpolation", "interception", {3, 0.0, 0.0, 0.0}, {3, -1e-15, 0.0, 0.0}},
      {"interpolation", "largest force", {}, {3, 5.5, 0.25, 0.5}}};
  section.warnings = problems.all();
  return section;
}

}  // namespace

study::report::ReportSection madeUpSection() {
  static const auto made = makeUpSection();  // its models take their time
  return made;
}

study::report::ReportSection madeUpSectionOfSites() {
  auto section = madeUpSection();
  section.results.siteFlow = {
      {"bergen", {.enrolled = 5, .completed = 5}},
      {"oslo", {.enrolled = 6, .completed = 5, .withdrawn = 1}},
      {"tromso", {.enrolled = 1, .completed = 1}}};
  for (auto& cohort : section.results.families.front().cohorts) {
    std::vector<std::string> sites;
    for (std::size_t i = 0; i < cohort.table.participants.size(); ++i) {
      sites.emplace_back(i == 4 ? "tromso" : i % 2 == 0 ? "bergen" : "oslo");
    }
    const std::vector<analysis::DeclaredPair> pairs{
        {"interpolation", "finite-elements"}, {"interpolation", "kalman"}};
    cohort.sites = analysis::compareSites(cohort.table, sites, pairs, 0.95);
  }
  return section;
}

}  // namespace tests
