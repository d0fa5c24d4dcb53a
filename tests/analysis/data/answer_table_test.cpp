#include "analysis/data/answer_table.h"

#include <gtest/gtest.h>

namespace answer_table_test {

using analysis::AnswerTable;

AnswerTable three() {
  AnswerTable table;
  table.participants = {"P1", "P2", "P3"};
  table.methods = {"a", "b"};
  table.answers = {
      {.participant = 0, .method = 0, .score = 1},
      {.participant = 0, .method = 0, .score = 2},
      {.participant = 0, .method = 0, .score = 2},
      {.participant = 0, .method = 1, .score = 5},
      {.participant = 1, .method = 0, .score = 4},
      {.participant = 2, .method = 0, .score = 3},
      {.participant = 2, .method = 1, .score = 4}};
  return table;
}

TEST(AnswerTable, AveragesByParticipantAndMethod) {
  const auto means = three().participantMeans();
  EXPECT_EQ(means[0][0], 5.0 / 3.0);
  EXPECT_EQ(means[0][1], 5.0);
  EXPECT_EQ(means[1][0], 4.0);
  EXPECT_EQ(means[1][1], std::nullopt);
}

TEST(AnswerTable, CountsAllAnswersAboutAMethod) {
  const auto counts = *three().sampleOf(0).points();
  EXPECT_EQ(counts.total(), 5U);
  EXPECT_EQ(counts.counts()[1], 2U);
}

TEST(AnswerTable, LeavesOutParticipantsWhoLackAMethod) {
  const auto complete = analysis::completeCaseMeans(three(), {1, 0});
  EXPECT_EQ(complete.participants, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(complete.excludedParticipants, std::vector<std::size_t>{1});
  EXPECT_EQ(complete.of(0), (std::vector<double>{5.0, 4.0}));
  EXPECT_EQ(complete.of(1), (std::vector<double>{5.0 / 3.0, 3.0}));
}

TEST(AnswerTable, KnowsTheLowestAnswerAboveTheMiddle) {
  const auto lowestPointAboveMiddle = [](int lowest, int highest) {
    analysis::AnswerTable table;
    table.lowest = lowest;
    table.highest = highest;
    return table.lowestPointAboveMiddle();
  };
  EXPECT_EQ(lowestPointAboveMiddle(1, 5), 4);
  EXPECT_EQ(lowestPointAboveMiddle(1, 4), 3);
  EXPECT_EQ(lowestPointAboveMiddle(0, 20), 11);
  EXPECT_EQ(lowestPointAboveMiddle(-3, 3), 1);
  EXPECT_EQ(lowestPointAboveMiddle(-4, -1), -2);
}

}  // namespace answer_table_test
