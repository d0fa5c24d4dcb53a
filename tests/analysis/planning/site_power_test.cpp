#include "analysis/planning/site_power.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include "analysis/summary/site_comparison.h"

namespace site_power_test {

using analysis::PowerSimulation;
using analysis::simulateSitePower;
using analysis::SitePlan;

TEST(SitePower, HasTheDesignEffectOfClusters) {
  const SitePlan plan{.sites = 4, .deviation = 0.5};
  EXPECT_NEAR(plan.intraclassCorrelation(), 0.2, 1e-15);
  EXPECT_NEAR(plan.designEffect(24), 1.0 + 5.0 * 0.2, 1e-14);
}

TEST(SitePower, OfThePooledDifferenceIsThatOfANoncentralT) {
  struct Case {
    double dz = 0.0;
    std::uint64_t participants = 0;
    SitePlan plan;
    double alpha = 0.0;
    double power = 0.0;
  };
  // R 4.2.2: d <- sqrt((tau^2 + k / n) / k); tc <- qt(1 - alpha / 2, k - 1)
  //          pt(-tc, k - 1, dz / d) + pt(tc, k - 1, dz / d, lower.tail = FALSE)
  for (const auto& [dz, participants, plan, alpha, power] :
       {Case{0.8, 24, {.sites = 4, .deviation = 0.2}, 0.05, 0.656025792630},
        Case{1.0, 40, {.sites = 8, .deviation = 0.5}, 0.05 / 3.0, 0.823296309713},
        Case{0.5, 30, {.sites = 2, .deviation = 0.0}, 0.05, 0.170247823401}}) {
    EXPECT_NEAR(analysis::pooledSitesPower(dz, participants, plan, alpha), power, 1e-8) << dz;
  }
}

/// Who ignores sites takes the variance of the mean for smaller than it is, by the design effect:
/// the rate of false alarms is 2 Φ(−1.96 / √DE'), DE' = DE / (1 − (DE − 1) / (N − 1)) because the
/// differences within the sample vary less, too (Kish 1965). No scale of points is finer than the
/// effect here, so that the model is nearly normal.
TEST(SitePower, MakesAnAnalysisThatIgnoresSitesFindTooMuchByTheDesignEffect) {
  const SitePlan plan{.sites = 10, .deviation = 0.5};
  PowerSimulation simulation{
      .participants = 200, .alpha = 0.05, .alphaPerTest = 0.05, .studies = 400, .seed = 3};
  simulation.model.points = 101;
  simulation.model.conditions = 2;
  simulation.model.dz = 0.0;
  const auto found = simulateSitePower(simulation, plan);
  const double effect = plan.designEffect(200);
  const double apparent = effect / (1.0 - (effect - 1.0) / 199.0);
  const double expected = std::erfc(1.959964 / std::sqrt(apparent) / std::sqrt(2.0));
  EXPECT_NEAR(expected, 0.376, 0.001);
  EXPECT_NEAR(found.pairedT.rate, expected, 0.08);
  EXPECT_NEAR(found.pooled.rate, 0.05, 0.035);
}

TEST(SitePower, AgreesWithMetafor) {
  struct Case {
    SitePlan plan;
    std::uint64_t participants = 0;
    double dz = 0.0;
    double alpha = 0.0;
    double pooled = 0.0;
    double pairedT = 0.0;
  };
  // tests/data/stats/sites/simulate_power.R: 4,000 studies each, with its own random numbers,
  // rma(test = "adhoc") and t.test().
  for (const auto& [plan, participants, dz, alpha, pooled, pairedT] :
       {Case{{.sites = 4, .deviation = 0.2}, 24, 0.8, 0.05, 0.5633, 0.9283},
        Case{{.sites = 6, .deviation = 0.5}, 24, 1.2, 0.05 / 3.0, 0.6753, 0.9732},
        Case{{.sites = 3, .deviation = 0.5}, 30, 0.0, 0.05, 0.0135, 0.2335}}) {
    PowerSimulation simulation{
        .participants = participants,
        .alpha = alpha,
        .alphaPerTest = alpha,
        .studies = 600,
        .seed = 5};
    simulation.model.conditions = 2;
    simulation.model.dz = dz;
    const auto found = simulateSitePower(simulation, plan);
    EXPECT_NEAR(found.pooled.rate, pooled, 0.06) << plan.sites;
    EXPECT_NEAR(found.pairedT.rate, pairedT, 0.06) << plan.sites;
  }
}

/// The same answers, drawn once more, through the analysis of studies.
TEST(SitePower, ComparesAndPoolsAsTheStatisticsOfAStudyDo) {
  const SitePlan plan{.sites = 3, .deviation = 0.4};
  PowerSimulation simulation{.participants = 11, .alphaPerTest = 0.05, .studies = 1, .seed = 9};
  simulation.model.conditions = 2;
  analysis::LikertCohort cohort(simulation.model, simulation.seed);
  analysis::AnswerTable table{
      .methods = {"a", "b"}, .rounds = {"1"}, .statements = std::vector<std::string>(6, "s")};
  std::vector<std::string> sites;
  for (const int people : {4, 4, 3}) {
    const auto shifts = cohort.drawSiteShifts(plan.deviation);
    for (int i = 0; i < people; ++i) {
      const auto answers = cohort.next(shifts);
      for (std::size_t method = 0; method < 2; ++method) {
        for (std::size_t statement = 0; statement < 6; ++statement) {
          table.answers.push_back(
              {.participant = sites.size(),
               .method = method,
               .statement = statement,
               .position = static_cast<int>(method) + 1,
               .score = double(answers[method][statement])});
        }
      }
      sites.push_back("site " + std::to_string(people) + std::to_string(shifts[0]));
      table.participants.push_back("P" + std::to_string(sites.size()));
    }
  }
  const std::vector<analysis::DeclaredPair> pair{{"a", "b"}};
  const auto row = analysis::compareSites(table, sites, pair, 0.95).rows.front();
  ASSERT_TRUE(row.pooled.has_value());
  const auto& interval = row.pooled->knappHartung.interval;
  const auto found = simulateSitePower(simulation, plan);
  EXPECT_NEAR(found.medianHalfWidth.value(), 0.5 * (interval.high - interval.low), 1e-5);
  EXPECT_EQ(found.pooled.rate, row.pooled->knappHartung.p <= 0.05 ? 1.0 : 0.0);
}

TEST(SitePower, NeedsMoreSitesWhereNoNumberOfParticipantsIsEnough) {
  EXPECT_FALSE(analysis::participantsForPower(0.8, {.sites = 2, .deviation = 0.5}, 0.05, 0.8));
  const SitePlan eight{.sites = 8, .deviation = 0.5};
  const auto enough = analysis::participantsForPower(0.8, eight, 0.05, 0.8).value();
  EXPECT_GE(analysis::pooledSitesPower(0.8, enough, eight, 0.05), 0.8);
  EXPECT_LT(analysis::pooledSitesPower(0.8, enough - 1, eight, 0.05), 0.8);
  EXPECT_FALSE(analysis::participantsForPower(0.0, eight, 0.05, 0.8));
  // Two at each site are the fewest, whatever the effect.
  EXPECT_EQ(analysis::participantsForPower(50.0, eight, 0.05, 0.8), 16U);
}

TEST(SitePower, RejectsInvalidArguments) {
  const SitePlan two{.sites = 2};
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(analysis::pooledSitesPower(1.0, 3, two, 0.05), std::invalid_argument);
  EXPECT_THROW(analysis::pooledSitesPower(kNone, 8, two, 0.05), std::invalid_argument);
  EXPECT_THROW(SitePlan{.sites = 1}.check(), std::invalid_argument);
  EXPECT_THROW((SitePlan{.sites = 2, .deviation = -0.1}.check()), std::invalid_argument);
  EXPECT_THROW((SitePlan{.sites = 2, .deviation = kNone}.check()), std::invalid_argument);
  EXPECT_THROW(simulateSitePower({.participants = 3}, two), std::invalid_argument);
}

}  // namespace site_power_test
