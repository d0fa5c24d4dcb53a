#include "protocols/schedule.h"

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace {

Protocol libraryProtocol(const char* name) {
  questionnaires::Problems problems;
  auto loaded = loadProtocolFile(name, problems);
  EXPECT_TRUE(loaded) << questionnaires::inWords(problems.all());
  return loaded->protocol;
}

std::vector<std::string> conditionsOf(const PlannedBlock& block) {
  std::vector<std::string> conditions;
  for (const auto& trial : block.trials) conditions.push_back(trial.condition);
  return conditions;
}

using Names = std::vector<std::string>;

TEST(Schedule, IsThePapersInThePublishedStudyForEverybody) {
  const auto protocol = libraryProtocol("punch-face-validity");
  for (std::uint64_t slot = 0; slot < 6; ++slot) {
    const auto schedule = scheduleFor(protocol, 99, "professional", slot);
    const auto* first = schedule.block("round-1");
    const auto* second = schedule.block("round-2");
    EXPECT_EQ(conditionsOf(*first), (Names{"interpolation", "finite-elements", "kalman"}));
    EXPECT_EQ(conditionsOf(*second), (Names{"kalman", "finite-elements", "interpolation"}));
    for (const auto& trial : second->trials) EXPECT_EQ(trial.label, 4 - trial.position);
  }
}

TEST(Schedule, BalancesTheShippedStudiesWhereItSaysSo) {
  for (const auto* name : {"punch-counterbalanced", "reaming-hardness"}) {
    const auto protocol = libraryProtocol(name);
    for (const auto& phase : protocol.phases) {
      if (phase.type != PhaseType::Block) continue;
      for (const auto& cohort : protocol.cohorts) {
        const auto one = balanceOf(protocol, phase, 5, cohort.id, 1);
        const auto full = balanceOf(protocol, phase, 5, cohort.id, one.multipleOf);
        EXPECT_TRUE(full.isBalanced) << name;
        std::set<int> counts;
        for (const auto& row : full.atPosition) counts.insert(row.begin(), row.end());
        EXPECT_EQ(counts.size(), 1U) << name << " " << phase.id;
        EXPECT_FALSE(balanceOf(protocol, phase, 5, cohort.id, one.multipleOf + 1).isBalanced);
      }
    }
  }
}

TEST(Schedule, IsPlannedForNumbersThatBalanceTheReamingStudy) {
  const auto protocol = libraryProtocol("reaming-hardness");
  for (const auto& phase : protocol.phases) {
    if (phase.type != PhaseType::Block) continue;
    for (const auto& cohort : protocol.cohorts) {
      const auto participants = static_cast<std::size_t>(cohort.planned);
      EXPECT_TRUE(balanceOf(protocol, phase, 1, cohort.id, participants).isBalanced) << cohort.id;
    }
  }
}

TEST(Schedule, StaysAsItIsWhenAPhaseOrAQuestionnaireIsAdded) {
  const std::string before = tests::usualProtocol();
  const auto plain = tests::soundProtocol(before);
  auto longer = plain;
  Phase rest;
  rest.id = "a-rest";
  rest.type = PhaseType::Break;
  longer.phases.insert(longer.phases.begin() + 1, rest);
  for (auto& phase : longer.phases) phase.trials.questionnaires.push_back({"presence", {}});
  for (const auto& cohort : plain.cohorts) {
    for (std::uint64_t slot = 0; slot < 20; ++slot) {
      const auto here = scheduleFor(plain, 3, cohort.id, slot);
      const auto there = scheduleFor(longer, 3, cohort.id, slot);
      ASSERT_EQ(here.blocks.size(), there.blocks.size());
      for (std::size_t i = 0; i < here.blocks.size(); ++i) {
        EXPECT_EQ(conditionsOf(here.blocks[i]), conditionsOf(there.blocks[i]));
      }
    }
  }
}

/// The labels of the first block's conditions, by condition.
std::map<std::string, int> labels(Protocol protocol, LabelPolicy policy, std::uint64_t slot) {
  protocol.labels.policy = policy;
  std::map<std::string, int> result;
  const auto schedule = scheduleFor(protocol, 3, protocol.cohorts.at(0).id, slot);
  for (const auto& trial : schedule.blocks.at(0).trials) result[trial.condition] = trial.label;
  return result;
}

TEST(Schedule, LabelsByConditionByPositionOrByChance) {
  const auto protocol = libraryProtocol("punch-counterbalanced");
  std::set<std::map<std::string, int>> byCondition;
  std::set<std::map<std::string, int>> byChance;
  for (std::uint64_t slot = 0; slot < 60; ++slot) {
    byCondition.insert(labels(protocol, LabelPolicy::Condition, slot));
    byChance.insert(labels(protocol, LabelPolicy::Random, slot));
    auto byPosition = protocol;
    byPosition.labels.policy = LabelPolicy::Position;
    const auto schedule = scheduleFor(byPosition, 3, protocol.cohorts.at(0).id, slot);
    for (const auto& trial : schedule.blocks.at(0).trials) EXPECT_EQ(trial.label, trial.position);
  }
  EXPECT_EQ(byCondition.size(), 1U);
  EXPECT_EQ(byChance.size(), 6U);  // all orders of three labels come up
}

TEST(Schedule, CallsAConditionTheSameInEveryBlockOfASession) {
  const auto protocol = libraryProtocol("punch-counterbalanced");
  for (std::uint64_t slot = 0; slot < 20; ++slot) {
    const auto schedule = scheduleFor(protocol, 3, protocol.cohorts.at(0).id, slot);
    std::map<std::string, int> label;
    for (const auto& block : schedule.blocks) {
      for (const auto& trial : block.trials) {
        EXPECT_EQ(label.emplace(trial.condition, trial.label).first->second, trial.label);
      }
    }
  }
}

}  // namespace
}  // namespace protocols
