#include "analysis/models/cumulative_link_mixed_model.h"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/analysis/study_answers.h"
#include "tests/support/test_data.h"

namespace cumulative_link_mixed_model_test {

using analysis::CumulativeLinkFit;
using analysis::Factor;
using analysis::FixedEffects;
using analysis::WaldEstimate;

void check(const char* what, double number, const std::string& truth, double gate) {
  const double digits = tests::correctDigits(number, truth);
  EXPECT_GE(digits, gate) << what << ": " << number << " is not " << truth;
}

struct Gates {
  double estimate = 0.0;
  double standardError = 0.0;
  double p = 0.0;
};

/// Thresholds first, then effects, as R prints them.
void check(const CumulativeLinkFit& fit, const nlohmann::json& golden, const Gates& gates) {
  std::vector<WaldEstimate> ours = fit.thresholds;
  ours.insert(ours.end(), fit.fixedEffects.begin(), fit.fixedEffects.end());
  ASSERT_EQ(ours.size(), golden.size());
  for (std::size_t i = 0; i < ours.size(); ++i) {
    SCOPED_TRACE(ours[i].name);
    const auto text = [&](const char* key) { return golden.at(i)[key].get<std::string>(); };
    check("estimate", ours[i].estimate, text("Estimate"), gates.estimate);
    check("SE", ours[i].standardError, text("Std..Error"), gates.standardError);
    check("z", ours[i].z, text("z.value"), gates.standardError);
    check("p", ours[i].p, text("Pr...z.."), gates.p);
    EXPECT_NEAR(ours[i].log10P, std::log10(ours[i].p), 1e-12);
    EXPECT_NEAR(ours[i].oddsRatio, std::exp(ours[i].estimate), 1e-12);
  }
}

class StudyOrdinal : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(StudyOrdinal, MatchesTheReferenceWithRandomIntercepts) {
  const auto answers = tests::studyAnswers(GetParam().first);
  const std::string key = GetParam().second;
  const auto golden = tests::statsJson("study/study_golden.json");
  FixedEffects fixed(answers.scores.size());
  fixed.add(answers.method);
  fixed.add(answers.round);

  const std::vector<Factor> random{
      interactionOf(answers.participant, answers.method), answers.participant};
  const auto result = analysis::fitCumulativeLinkMixedModel(answers.levels(), fixed, random);

  ASSERT_TRUE(result.fit) << base::describe(result.reason);
  // R's Hessian is taken by differences of a likelihood whose mode is found to 1e-4 only; ours is
  // checked against second differences in LaplaceLikelihood.HasTheDerivativesOfItsValue.
  check(*result.fit, golden["clmm_" + key], {.estimate = 3.0, .standardError = 2.6, .p = 1.5});
  for (std::size_t k = 0; k < 2; ++k) {
    const auto truth = golden["clmm_" + key + "_sd"].at(k).get<std::string>();
    check("sd", result.fit->components[k].standardDeviation, truth, 3.0);
  }
  const auto logLikelihood = golden["clmm_" + key + "_loglik"].get<std::string>();
  check("log likelihood", result.fit->logLikelihood, logLikelihood, 8.0);
}

TEST_P(StudyOrdinal, MatchesTheReferenceWithoutRandomIntercepts) {
  const auto answers = tests::studyAnswers(GetParam().first);
  const std::string key = GetParam().second;
  const auto golden = tests::statsJson("study/study_golden.json");
  FixedEffects fixed(answers.scores.size());
  fixed.add(answers.method);

  const auto result = analysis::fitCumulativeLinkMixedModel(answers.levels(), fixed, {});

  ASSERT_TRUE(result.fit) << base::describe(result.reason);
  check(*result.fit, golden["clm_" + key], {.estimate = 6.0, .standardError = 6.0, .p = 6.0});
  const auto logLikelihood = golden["clm_" + key + "_loglik"].get<std::string>();
  check("log likelihood", result.fit->logLikelihood, logLikelihood, 12.0);
}

INSTANTIATE_TEST_SUITE_P(
    CumulativeLinkMixedModel,
    StudyOrdinal,
    testing::Values(std::pair("professional", "prof"), std::pair("non-professional", "non")));

}  // namespace cumulative_link_mixed_model_test
