#include <gtest/gtest.h>

#include "questionnaires/model/instrument.h"

namespace questionnaires {
namespace range_test {

TEST(RangeOf, IsThatOfThePoints) {
  EXPECT_EQ(rangeOf({.type = ItemType::Likert}), (Range{1.0, 5.0}));
  EXPECT_EQ(
      rangeOf({.type = ItemType::SemanticDifferential, .scale = {.lowest = -3, .points = 7}}),
      (Range{-3.0, 3.0}));
}

TEST(RangeOf, IsThatOfTheNumbers) {
  EXPECT_EQ(rangeOf({.type = ItemType::Slider}), (Range{0.0, 100.0}));
  EXPECT_EQ(rangeOf({.type = ItemType::Number, .least = 2.0, .most = 3.0}), (Range{2.0, 3.0}));
}

TEST(RangeOf, IsNoneWhereAnswersAreNoNumbers) {
  for (const auto type :
       {ItemType::SingleChoice,
        ItemType::MultipleChoice,
        ItemType::PairwiseChoice,
        ItemType::ShortText,
        ItemType::LongText}) {
    EXPECT_FALSE(rangeOf({.type = type}).has_value());
  }
}

}  // namespace range_test
}  // namespace questionnaires
