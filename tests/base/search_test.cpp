#include "base/search.h"

#include <array>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace base {
namespace search_test {

struct Named {
  std::string id;
  int number = 0;
};

TEST(Search, TellsWhetherAListContainsAValue) {
  const std::vector<std::string> words{"en", "de"};
  EXPECT_TRUE(contains(words, "de"));
  EXPECT_FALSE(contains(words, "nb"));
  EXPECT_FALSE(contains(std::array<int, 0>{}, 1));
}

TEST(Search, FindsTheFirstWithAnId) {
  const std::vector<Named> all{{"a", 1}, {"b", 2}, {"b", 3}};
  ASSERT_NE(withId(all, "b"), nullptr);
  EXPECT_EQ(withId(all, "b")->number, 2);
  EXPECT_EQ(withId(all, "c"), nullptr);
}

TEST(Search, CountsEdits) {
  EXPECT_EQ(editDistance("order", "order"), 0U);
  EXPECT_EQ(editDistance("", "abc"), 3U);
  EXPECT_EQ(editDistance("score", "scores"), 1U);
  EXPECT_EQ(editDistance("mehtod", "method"), 1U) << "a swap of neighbours is one edit";
  EXPECT_EQ(editDistance("kitten", "sitting"), 3U);
}

}  // namespace search_test
}  // namespace base
