#include "analysis/models/cluster_robust.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/analysis/digits.h"
#include "tests/analysis/golden_file.h"
#include "tests/analysis/study_answers.h"
#include "tests/support/test_data.h"

namespace cluster_robust_test {

using analysis::FixedEffects;

TEST(ClusterRobust, AgreesWithClubSandwich) {
  const auto golden = tests::statsJson("study/study_golden.json");
  for (const std::string key : {"professional", "non-professional"}) {
    const auto answers = tests::studyAnswers(key);
    FixedEffects fixed(answers.scores.size());
    fixed.add(answers.method);
    const auto result = analysis::clusterRobust(answers.scores, fixed, answers.participant);

    const auto& truth = golden[key == "professional" ? "cr2_prof" : "cr2_non"];
    ASSERT_EQ(result.fixedEffects.size(), truth.size()) << base::describe(result.reason);
    for (std::size_t j = 0; j < truth.size(); ++j) {
      SCOPED_TRACE(key + " " + result.fixedEffects[j].name);
      const auto& ours = result.fixedEffects[j];
      const auto digits = [&](double number, const char* what) {
        return tests::correctDigits(number, truth.at(j)[what].get<std::string>());
      };
      EXPECT_GE(digits(ours.estimate, "beta"), 13.0);
      EXPECT_GE(digits(ours.standardError, "SE"), 13.0);
      EXPECT_GE(digits(ours.t.value(), "t"), 13.0);
      EXPECT_GE(digits(ours.degreesOfFreedom.value(), "df"), 13.0);
      EXPECT_GE(digits(ours.p.value(), "p"), 12.0);
    }
  }
}

TEST(ClusterRobust, OfBalancedDataIsThePairedTTest) {
  const std::vector<double> y{1, 3, 2, 6, 4, 4, 1, 2, 5, 9};  // five pairs
  std::vector<std::string> method;
  std::vector<std::string> person;
  for (int i = 0; i < 10; ++i) {
    method.emplace_back(i % 2 == 0 ? "a" : "b");
    person.push_back(std::to_string(i / 2));
  }
  FixedEffects fixed(10);
  fixed.add(analysis::factorOf("method", method));
  const auto result = analysis::clusterRobust(y, fixed, analysis::factorOf("person", person));

  const auto& difference = result.fixedEffects.at(1);  // 2, 4, 0, 1, 4: mean 2.2, variance 3.2
  EXPECT_NEAR(difference.estimate, 2.2, 1e-14);
  EXPECT_NEAR(difference.t.value(), 2.2 / std::sqrt(3.2 / 5.0), 1e-13);
  EXPECT_NEAR(difference.degreesOfFreedom.value(), 4.0, 1e-12);
}

TEST(ClusterRobust, IsNotDefinedForOneParticipantOrConstantAnswers) {
  FixedEffects fixed(4);
  fixed.add(analysis::factorOf("method", std::vector<std::string>{"a", "b", "a", "b"}));
  const auto alone = analysis::factorOf("participant", std::vector<std::string>(4, "1"));
  const auto two = analysis::factorOf("participant", std::vector<std::string>{"1", "1", "2", "2"});

  const auto one = analysis::clusterRobust(std::vector<double>{1, 2, 4, 3}, fixed, alone);
  EXPECT_EQ(one.reason, analysis::reason("one_level", "participant"));
  EXPECT_TRUE(one.fixedEffects.empty());
  const auto constant = analysis::clusterRobust(std::vector<double>(4, 3.7), fixed, two);
  EXPECT_EQ(constant.reason.key(), "no_variance_beyond_fixed");
  EXPECT_THROW(
      analysis::clusterRobust(std::vector<double>{1, 2}, fixed, two), std::invalid_argument);
}

}  // namespace cluster_robust_test
