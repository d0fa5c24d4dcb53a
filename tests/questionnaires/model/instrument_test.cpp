#include "questionnaires/model/instrument.h"

#include <gtest/gtest.h>

namespace questionnaires {
namespace instrument_test {

const Instrument kInstrument{
    .items = {{.id = "1.1", .set = "1"}, {.id = "2.1", .set = "2"}, {.id = "1.2", .set = "1"}}};

TEST(Instrument, FindsAnItemByItsId) {
  ASSERT_NE(kInstrument.item("2.1"), nullptr);
  EXPECT_EQ(kInstrument.item("2.1")->set, "2");
}

TEST(Instrument, FindsNothingWhereThereIsNothing) {
  EXPECT_EQ(kInstrument.item("3.1"), nullptr);
  EXPECT_EQ(kInstrument.item(""), nullptr);
}

TEST(Instrument, GivesASetInOrder) {
  const auto items = kInstrument.itemsOf("1");
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].id, "1.1");
  EXPECT_EQ(items[1].id, "1.2");
}

TEST(Instrument, GivesAllItemsWithoutASet) {
  EXPECT_EQ(kInstrument.itemsOf("").size(), 3U);
}

TEST(Instrument, GivesNoItemsOfAnUnknownSet) {
  EXPECT_TRUE(kInstrument.itemsOf("9").empty());
}

}  // namespace instrument_test
}  // namespace questionnaires
