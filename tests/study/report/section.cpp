#include "tests/study/report/section.h"

#include "protocols/loaded_protocol.h"

namespace tests {

using analysis::LikertCounts;
using study::CohortResult;

namespace {

CohortResult cohort(
    const std::string& id, const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b,
    const std::vector<std::uint64_t>& c) {
  CohortResult result{.cohort = id, .conditions = {}, .comparisons = {}};
  result.conditions.push_back({"interpolation", LikertCounts(1, a)});
  result.conditions.push_back({"finite-elements", LikertCounts(1, b)});
  result.conditions.push_back({"kalman", LikertCounts(1, c)});
  const std::vector<analysis::DeclaredPair> pairs{
      {"interpolation", "finite-elements"}, {"interpolation", "kalman"}, {"kalman", "finite-elements"}};
  result.comparisons = analysis::comparePairwise(result.conditions, pairs, 0.05);
  return result;
}

study::FeltCurve curve(const std::string& condition, double force) {
  study::FeltCurve curve{
      .condition = condition, .device = "punch", .travelUnit = "travel_unit", .trials = 4, .points = {}};
  for (int i = 0; i < 20; ++i) {
    curve.points.push_back({0.5 * i, force - 0.2, force, force + 0.2});
  }
  return curve;
}

}  // namespace

study::report::ReportSection madeUpSection() {
  questionnaires::Problems problems;
  auto loaded = *protocols::loadProtocolFile("punch-face-validity", problems);
  loaded.protocol.study.title = "Cut & <script>alert(1)</script>";
  study::report::ReportSection section;
  section.protocol = loaded.protocol;
  section.instruments = loaded.instruments;
  section.protocolHash = "abc";
  section.uuid = "def";
  section.seed = 7;
  section.results.runMode = study::RunMode::Simulated;
  section.results.flow = {{.cohort = "professional", .enrolled = 7, .completed = 6, .withdrawn = 1},
                          {.cohort = "non-professional", .enrolled = 5, .completed = 5}};
  section.results.families.push_back(
      {loaded.protocol.analysis.families.front(),
       {cohort("professional", {1, 3, 6, 9, 17}, {13, 7, 4, 4, 8}, {8, 5, 5, 8, 10}),
        cohort("non-professional", {0, 0, 0, 0, 5}, {0, 0, 5, 0, 0}, {0, 0, 0, 0, 5})}});
  analysis::VoteCounts votes({"interpolation", "finite-elements", "kalman"});
  votes.add("interpolation", 4);
  votes.add("kalman", 2);
  section.results.votes.push_back({"professional", "preference-1", "round-1", votes});
  section.curves = {curve("interpolation", 3.0), curve("finite-elements", 5.0)};
  section.quality = {.trials = 36, .pass = 34, .warn = 1, .fail = 1, .cuts = 110};
  section.quality.reasons = {"3 of 4000 ticks were late"};
  section.warnings = problems.all();
  return section;
}

}  // namespace tests
