#include <vector>

#include <gtest/gtest.h>

#include "analysis/data/csv_table.h"

namespace nearest_name_test {

using analysis::enumerated;
using analysis::nearestName;
using Names = std::vector<std::string>;

TEST(NearestName, NeedsTheFewestEdits) {
  const Names names{"participant", "cohort", "method", "score"};
  EXPECT_EQ(nearestName("scores", names), "score");
  EXPECT_EQ(nearestName("mehtod", names), "method");
  EXPECT_EQ(nearestName("COHORT", names), "cohort");
}

TEST(NearestName, IsTheFirstOfSeveral) {
  EXPECT_EQ(nearestName("cat", Names{"bat", "rat"}), "bat");
}

TEST(NearestName, IsNoneIfAllAreFarFromWhatWasMeant) {
  EXPECT_EQ(nearestName("nosuch", Names{"welch", "conover"}), std::nullopt);
  EXPECT_EQ(nearestName("x", Names{"a", ""}), std::nullopt);
  EXPECT_EQ(nearestName("", Names{"score"}), std::nullopt);
}

TEST(EnumeratedNames, AreJoinedAsInASentence) {
  EXPECT_EQ(enumerated(Names{}), "");
  EXPECT_EQ(enumerated(Names{"a"}), "'a'");
  EXPECT_EQ(enumerated(Names{"a", "b"}), "'a' and 'b'");
  EXPECT_EQ(enumerated(Names{"a", "b", "c"}), "'a', 'b' and 'c'");
}

TEST(EnumeratedNames, AreAtMostEight) {
  EXPECT_EQ(enumerated(Names(10, "n")), "'n', 'n', 'n', 'n', 'n', 'n', 'n', 'n' and 2 more");
}

}  // namespace nearest_name_test
