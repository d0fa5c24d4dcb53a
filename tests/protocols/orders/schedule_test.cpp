#include "protocols/orders/schedule.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace schedule_test {

Protocol libraryProtocol(const char* name) {
  questionnaires::Problems problems;
  auto loaded = loadProtocolFile(name, problems);
  EXPECT_TRUE(loaded) << questionnaires::describe(problems.all());
  return loaded->protocol;
}

std::vector<std::string> conditionsOf(const PlannedBlock& block) {
  std::vector<std::string> conditions;
  for (const auto& trial : block.trials) conditions.push_back(trial.condition);
  return conditions;
}

using Names = std::vector<std::string>;

TEST(Schedule, IsThatOfThePaperInThePublishedStudyForEveryParticipant) {
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
        for (const auto& row : full.positionCounts) counts.insert(row.begin(), row.end());
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

TEST(Schedule, CallsAConditionTheSameInEveryBlockOfASessionWithRandomLabels) {
  auto protocol = libraryProtocol("punch-counterbalanced");
  protocol.labels.policy = LabelPolicy::Random;
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

/// usualProtocol() with a third condition, and with phases after its own.
Protocol ofThree(const std::vector<std::string>& phases = {}, const char* labels = "random") {
  auto text = tests::with(
      tests::withPhases(phases),
      "\"conditions\": [\n",
      "\"conditions\": [\n{\"id\": \"third\", \"title\": \"Third\", \"scene\": {\"device\": "
      "\"punch\", \"model\": \"interpolation\", \"parameters\": {}}},\n");
  text = tests::with(text, R"(["soft", "firm"])", R"(["soft", "firm", "third"])");
  text = tests::with(
      text, R"({ "policy": "random" })", R"({ "policy": ")" + std::string(labels) + R"(" })");
  return tests::soundProtocol(text);
}

/// A block of all three.
std::string block(const std::string& id, const std::string& order) {
  return R"({"id": ")" + id + R"(", "type": "block", "minimum_cuts": 1,
             "conditions": ["soft", "firm"], "order": )" +
         order + "}";
}

TEST(Schedule, TurnsABlockRoundForEachParticipantAndBackAgain) {
  const auto protocol = ofThree(
      {block("drawn", R"({"type": "random"})"),
       block("back", R"({"type": "reversed", "of": "drawn"})"),
       block("again", R"({"type": "reversed", "of": "back"})")});
  std::set<Names> drawn;
  for (std::uint64_t slot = 0; slot < 40; ++slot) {
    const auto schedule = scheduleFor(protocol, 3, "anyone", slot);
    auto order = conditionsOf(*schedule.block("drawn"));
    drawn.insert(order);
    EXPECT_EQ(conditionsOf(*schedule.block("again")), order);
    std::reverse(order.begin(), order.end());
    EXPECT_EQ(conditionsOf(*schedule.block("back")), order);
  }
  EXPECT_EQ(drawn.size(), 6U);
}

TEST(Schedule, DrawsBlocksAndCohortsIndependently) {
  const auto protocol = ofThree({block("other", R"({"type": "balancedLatinSquare"})")});
  int likeTheOtherBlock = 0;
  int likeTheOtherCohort = 0;
  constexpr int kPeople = 600;
  for (std::uint64_t slot = 0; slot < kPeople; ++slot) {
    const auto here = scheduleFor(protocol, 3, "anyone", slot);
    const auto there = scheduleFor(protocol, 3, "others", slot);
    const auto order = conditionsOf(*here.block("felt"));
    if (conditionsOf(*here.block("other")) == order) ++likeTheOtherBlock;
    if (conditionsOf(*there.block("felt")) == order) ++likeTheOtherCohort;
  }
  EXPECT_NEAR(likeTheOtherBlock, kPeople / 6.0, 37.0);  // four times √(600 · 1/6 · 5/6)
  EXPECT_NEAR(likeTheOtherCohort, kPeople / 6.0, 37.0);
}

TEST(Schedule, CountsPositionsAndLabelsFromOneToTheNumberOfConditions) {
  for (const auto* policy : {"condition", "position", "random"}) {
    const auto protocol = ofThree({}, policy);
    for (std::uint64_t slot = 0; slot < 20; ++slot) {
      std::set<int> labelsSeen;
      int position = 0;
      const auto schedule = scheduleFor(protocol, 3, "anyone", slot);
      for (const auto& trial : schedule.blocks.at(0).trials) {
        EXPECT_EQ(trial.position, ++position);
        labelsSeen.insert(trial.label);
      }
      EXPECT_EQ(labelsSeen, (std::set{1, 2, 3})) << policy;
    }
  }
}

TEST(Schedule, DrawsLabelsWithoutALookAtTheOrder) {
  const auto protocol = ofThree();
  int asFelt = 0;
  constexpr int kPeople = 600;
  for (std::uint64_t slot = 0; slot < kPeople; ++slot) {
    const auto trials = scheduleFor(protocol, 3, "anyone", slot).blocks.at(0).trials;
    if (trials[0].label == 1) ++asFelt;
  }
  EXPECT_NEAR(asFelt, kPeople / 3.0, 46.0);  // four times √(600 · 1/3 · 2/3)
}

TEST(Schedule, HasNoBlockOfAnotherName) {
  const auto schedule = scheduleFor(ofThree(), 3, "anyone", 0);
  EXPECT_EQ(schedule.block("consent"), nullptr);
  EXPECT_EQ(schedule.block(""), nullptr);
}

/// The values come from what the headers say about version 1, written out in another language
/// (Python 3). A study that was run is checked against them for ever.
TEST(Schedule, IsTheOneThatItsDescriptionGives) {
  const auto protocol = ofThree();
  const std::vector<std::pair<Names, std::vector<int>>> described{
      {{"firm", "soft", "third"}, {1, 3, 2}},
      {{"soft", "firm", "third"}, {1, 2, 3}},
      {{"third", "firm", "soft"}, {1, 3, 2}},
      {{"soft", "third", "firm"}, {1, 3, 2}},
  };
  for (std::size_t slot = 0; slot < described.size(); ++slot) {
    const auto schedule = scheduleFor(protocol, 7, "anyone", slot);
    const auto& trials = schedule.blocks.at(0).trials;
    EXPECT_EQ(conditionsOf(schedule.blocks.at(0)), described[slot].first) << slot;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      EXPECT_EQ(trials[i].label, described[slot].second[i]) << slot;
    }
  }
}

TEST(Schedule, SaysWhichBlocksAnotherVersionDrawsOtherwise) {
  const auto other = block("other", R"({"type": "random"})");
  const auto before = ofThree({other});
  const auto changedBlocks = [&](const Protocol& after) {
    EXPECT_EQ(blocksOrderedOtherwise(before, after), blocksOrderedOtherwise(after, before));
    return blocksOrderedOtherwise(before, after);
  };
  EXPECT_EQ(changedBlocks(ofThree({other})), Names{});
  EXPECT_EQ(changedBlocks(ofThree({block("other", R"({"type": "fixed"})")})), Names{"other"});
  EXPECT_EQ(changedBlocks(ofThree()), Names{"other"}) << "the block is gone";
  EXPECT_EQ(changedBlocks(ofThree({other}, "position")), (Names{"felt", "other"}));
  auto others = before;
  std::swap(others.conditions.front(), others.conditions.back());
  EXPECT_EQ(changedBlocks(others), (Names{"felt", "other"})) << "labels number conditions";
  auto seeded = before;
  seeded.seed = 4;
  EXPECT_EQ(changedBlocks(seeded), (Names{"felt", "other"}));
}

/// The balance of a block of three in some order, with so many participants.
Balance balanceWith(const std::string& order, std::size_t participants) {
  const auto protocol = ofThree({block("other", order)});
  return balanceOf(protocol, *protocol.phase("other"), 3, "anyone", participants);
}

TEST(Balance, KnowsTheMultipleOfEveryDesign) {
  EXPECT_EQ(balanceWith(R"({"type": "latinSquare"})", 0).multipleOf, 3U);
  EXPECT_EQ(balanceWith(R"({"type": "balancedLatinSquare"})", 0).multipleOf, 6U);
  EXPECT_EQ(balanceWith(R"({"type": "complete"})", 0).multipleOf, 6U);
  EXPECT_EQ(balanceWith(R"({"type": "random"})", 0).multipleOf, 0U);
  EXPECT_EQ(balanceWith(R"({"type": "reversed", "of": "felt"})", 0).multipleOf, 6U);
}

TEST(Balance, IsThereForNoNumberWhereTheOrderIsFixedOrDrawn) {
  for (const std::size_t participants : {1U, 6U, 60U}) {
    EXPECT_FALSE(balanceWith(R"({"type": "fixed"})", participants).isBalanced);
    EXPECT_FALSE(balanceWith(R"({"type": "random"})", participants).isBalanced);
  }
}

TEST(Balance, CountsWhatWasReallyDrawn) {
  const auto balance = balanceWith(R"({"type": "fixed"})", 7);
  EXPECT_EQ(balance.conditions, (Names{"soft", "firm", "third"}));
  EXPECT_EQ(
      balance.positionCounts, (std::vector<std::vector<int>>{{7, 0, 0}, {0, 7, 0}, {0, 0, 7}}));
  EXPECT_EQ(balance.after, (std::vector<std::vector<int>>{{0, 0, 0}, {7, 0, 0}, {0, 7, 0}}));
}

TEST(Balance, OfPositionsIsExactInAPlainSquareAndThatOfNeighboursIsNot) {
  const auto balance = balanceWith(R"({"type": "latinSquare"})", 9);
  EXPECT_TRUE(balance.isBalanced);
  EXPECT_EQ(
      balance.positionCounts, (std::vector<std::vector<int>>{{3, 3, 3}, {3, 3, 3}, {3, 3, 3}}));
  EXPECT_EQ(balance.after, (std::vector<std::vector<int>>{{0, 0, 6}, {6, 0, 0}, {0, 6, 0}}));
}

}  // namespace schedule_test
}  // namespace protocols
