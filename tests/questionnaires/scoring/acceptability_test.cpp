#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/scoring/scoring.h"
#include "tests/questionnaires/shipped_instruments.h"

namespace questionnaires {
namespace acceptability_test {

/// 1…5 each; the second is worded against realism.
const Instrument kTwo{
    .items = {
        {.id = "for", .acceptableFrom = 4.0},
        {.id = "against", .key = -1, .acceptableFrom = 4.0},
        {.id = "open"}}};

using Participants = std::vector<std::vector<Answer>>;

Participants answering(const std::string& id, const std::vector<std::int64_t>& points) {
  Participants participants;
  for (const auto point : points) participants.push_back({{id, point}});
  return participants;
}

TEST(Acceptability, IsTheShareAtOrAboveTheThresholdWithItsCount) {
  const auto items = acceptabilityOf(kTwo, answering("for", {3, 4, 5, 1, 4}));
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].itemId, "for");
  EXPECT_EQ(items[0].acceptableFrom, 4.0);
  EXPECT_EQ(items[0].acceptable, 3U);
  EXPECT_EQ(items[0].answered, 5U);
  EXPECT_EQ(items[0].share, 0.6);
}

TEST(Acceptability, ReversesItemsWordedAgainst) {
  const auto items = acceptabilityOf(kTwo, answering("against", {1, 2, 3, 5}));
  EXPECT_EQ(items[1].acceptable, 2U);  // 5, 4, 3, 1
  EXPECT_EQ(items[1].share, 0.5);
}

TEST(Acceptability, CountsOnlyThoseWhoAnswered) {
  auto participants = answering("for", {5, 3});
  participants.push_back({{"for", std::nullopt}});
  participants.push_back({});
  participants.push_back({{"for", std::int64_t{9}}});
  const auto items = acceptabilityOf(kTwo, participants);
  EXPECT_EQ(items[0].answered, 2U);
  EXPECT_EQ(items[0].share, 0.5);
}

TEST(Acceptability, IsUndefinedWithoutAnswers) {
  const auto items = acceptabilityOf(kTwo, {});
  EXPECT_FALSE(items[0].share.has_value());
  EXPECT_EQ(items[0].reason, "nobody answered this item");
  EXPECT_EQ(acceptabilityOf(Instrument{.items = {{.id = "open"}}}, {}).size(), 0U);
}

TEST(Acceptability, AsksTheShippedScaleItemByItem) {
  const auto& realism = tests::shipped().at("simulator-realism");
  const auto items = acceptabilityOf(realism, answering("soft-tissue", {7, 6, 10, 2}));
  ASSERT_EQ(items.size(), realism.items.size());
  EXPECT_EQ(items[3].itemId, "soft-tissue");
  EXPECT_EQ(items[3].acceptable, 2U);
  EXPECT_EQ(items[3].answered, 4U);
  EXPECT_FALSE(items[4].share.has_value());
}

}  // namespace acceptability_test
}  // namespace questionnaires
