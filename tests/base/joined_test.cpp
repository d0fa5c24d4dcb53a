#include "base/joined.h"

#include <vector>

#include <gtest/gtest.h>

namespace base {
namespace joined_test {

using Texts = std::vector<std::string>;

TEST(Joined, PutsTheSeparatorBetweenTexts) {
  EXPECT_EQ(joined(Texts{"a", "b", "c"}, ", "), "a, b, c");
  EXPECT_EQ(joined(Texts{"a"}, ", "), "a");
  EXPECT_EQ(joined(Texts{}, ", "), "");
}

TEST(Joined, PutsNoSeparatorBeforeTheFirstTextThatIsNotEmpty) {
  EXPECT_EQ(joined(Texts{"", "a", "", "b"}, ","), "a,,b");
}

struct Condition {
  std::string id;
};

TEST(Joined, TakesWhatAFunctionOrAMemberMakesOfEachElement) {
  EXPECT_EQ(joined(std::vector<Condition>{{"fem"}, {"kf"}}, " ", &Condition::id), "fem kf");
  const auto doubled = [](int number) { return std::to_string(2 * number); };
  EXPECT_EQ(joined(std::vector{1, 2}, " and ", doubled), "2 and 4");
}

}  // namespace joined_test
}  // namespace base
