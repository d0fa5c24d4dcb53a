// What a design promises, counted; and what was drawn once is drawn for ever.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "base/random.h"
#include "protocols/orders/schedule.h"

namespace protocols {
namespace order_test {

bool isPermutation(Row row) {
  std::sort(row.begin(), row.end());
  Row identity(row.size());
  std::iota(identity.begin(), identity.end(), 0);
  return row == identity;
}

using Counts = std::map<std::pair<int, int>, int>;

/// How often each thing stands at each position.
Counts atPositions(const std::vector<Row>& rows) {
  Counts counts;
  for (const auto& row : rows) {
    for (std::size_t p = 0; p < row.size(); ++p) ++counts[{row[p], static_cast<int>(p)}];
  }
  return counts;
}

/// How often each thing comes right after each other one.
Counts successions(const std::vector<Row>& rows) {
  Counts counts;
  for (const auto& row : rows) {
    for (std::size_t p = 1; p < row.size(); ++p) ++counts[{row[p - 1], row[p]}];
  }
  return counts;
}

void expectAllEqual(const Counts& counts, std::size_t size, int each) {
  EXPECT_EQ(counts.size(), size);
  for (const auto& [place, count] : counts) {
    EXPECT_EQ(count, each) << place.first << " " << place.second;
  }
}

std::size_t square(int k) {
  return static_cast<std::size_t>(k) * static_cast<std::size_t>(k);
}

TEST(Orders, HaveEverythingOnceInEveryRow) {
  for (const auto type :
       {OrderType::Fixed,
        OrderType::LatinSquare,
        OrderType::BalancedLatinSquare,
        OrderType::Complete}) {
    for (int k = 1; k <= kMostConditionsForComplete; ++k) {
      for (const auto& row : rowsOf(type, k)) EXPECT_TRUE(isPermutation(row));
    }
  }
}

TEST(Orders, OfALatinSquareHaveEverythingEquallyOftenEverywhere) {
  for (int k = 2; k <= 12; ++k) {
    const auto rows = rowsOf(OrderType::LatinSquare, k);
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(k));
    expectAllEqual(atPositions(rows), square(k), 1);
  }
}

TEST(Orders, OfABalancedSquareFollowEachOtherEquallyOftenToo) {
  for (int k = 2; k <= 12; ++k) {
    SCOPED_TRACE(k);
    const auto rows = rowsOf(OrderType::BalancedLatinSquare, k);
    const int each = k % 2 == 0 ? 1 : 2;  // Williams: k rows for even k, 2k for odd
    EXPECT_EQ(rows.size(), static_cast<std::size_t>(each * k));
    expectAllEqual(atPositions(rows), square(k), each);
    expectAllEqual(successions(rows), square(k) - static_cast<std::size_t>(k), each);
  }
}

TEST(Orders, OfABalancedSquareOfFourAreThePublishedOnes) {
  // Williams, "Experimental Designs Balanced for the Estimation of Residual Effects of Treatments"
  // (1949): 0, 1, k − 1, 2, …, and every thing one further on from row to row.
  const std::vector<Row> published{{0, 1, 3, 2}, {1, 2, 0, 3}, {2, 3, 1, 0}, {3, 0, 2, 1}};
  EXPECT_EQ(rowsOf(OrderType::BalancedLatinSquare, 4), published);
}

TEST(Orders, OfAHundredAreBalancedAsThoseOfTen) {
  const auto rows = rowsOf(OrderType::BalancedLatinSquare, kMostConditions);
  expectAllEqual(atPositions(rows), square(kMostConditions), 1);
  expectAllEqual(successions(rows), square(kMostConditions) - std::size_t{kMostConditions}, 1);
}

TEST(Orders, OfAPlainSquareFollowEachOtherUnequally) {
  EXPECT_EQ(successions(rowsOf(OrderType::LatinSquare, 4)).size(), 4U);  // of 12 that there are
}

TEST(Orders, OfOneThingAreOne) {
  for (const auto type :
       {OrderType::LatinSquare, OrderType::BalancedLatinSquare, OrderType::Complete}) {
    EXPECT_EQ(rowsOf(type, 1), (std::vector<Row>{{0}}));
  }
}

TEST(Orders, OfACompleteDesignAreAllThereAre) {
  std::size_t factorial = 1;
  for (int k = 1; k <= kMostConditionsForComplete; ++k) {
    factorial *= static_cast<std::size_t>(k);
    const auto rows = rowsOf(OrderType::Complete, k);
    EXPECT_EQ(rows.size(), factorial);
    EXPECT_EQ(std::set<Row>(rows.begin(), rows.end()).size(), factorial);
  }
}

TEST(Orders, OfThreeAreTheSameBalancedOrComplete) {
  auto balanced = rowsOf(OrderType::BalancedLatinSquare, 3);
  std::sort(balanced.begin(), balanced.end());
  EXPECT_EQ(balanced, rowsOf(OrderType::Complete, 3));
}

TEST(Orders, AreAsWrittenForAllWhereTheyAreFixed) {
  for (std::uint64_t slot = 0; slot < 20; ++slot) {
    EXPECT_EQ(orderFor(OrderType::Fixed, 5, 7, slot, "b/c"), (Row{0, 1, 2, 3, 4}));
  }
}

TEST(Orders, HaveNoRowsWhereTheyAreDrawnOrTakenFromElsewhere) {
  EXPECT_TRUE(rowsOf(OrderType::Random, 3).empty());
  EXPECT_TRUE(rowsOf(OrderType::Reversed, 3).empty());
}

TEST(Orders, ThatAreDrawnHoldEverythingOnce) {
  for (const int k : {1, 2, 7, kMostConditions}) {
    for (std::uint64_t slot = 0; slot < 20; ++slot) {
      const auto row = orderFor(OrderType::Random, k, 7, slot, "b/c");
      EXPECT_EQ(row.size(), static_cast<std::size_t>(k));
      EXPECT_TRUE(isPermutation(row)) << k;
    }
  }
}

TEST(Orders, AreUsedEquallyOftenInEveryFullCycle) {
  for (const auto type :
       {OrderType::LatinSquare, OrderType::BalancedLatinSquare, OrderType::Complete}) {
    const std::size_t cycle = rowsOf(type, 4).size();
    for (std::uint64_t round = 0; round < 5; ++round) {
      std::set<Row> used;
      for (std::uint64_t i = 0; i < cycle; ++i) {
        used.insert(orderFor(type, 4, 7, round * cycle + i, "block/cohort"));
      }
      EXPECT_EQ(used.size(), cycle);
    }
  }
}

TEST(Orders, CannotBeForetoldFromTheCycleBefore) {
  std::set<std::vector<Row>> cycles;
  for (std::uint64_t round = 0; round < 20; ++round) {
    std::vector<Row> cycle;
    for (std::uint64_t i = 0; i < 6; ++i) {
      cycle.push_back(orderFor(OrderType::BalancedLatinSquare, 3, 7, round * 6 + i, "b/c"));
    }
    cycles.insert(cycle);
  }
  EXPECT_GE(cycles.size(), 18U);  // of 720 sequences, 20 draws
}

TEST(Orders, ThatAreDrawnAreAllEquallyProbable) {
  std::map<Row, int> counts;
  constexpr int kDraws = 24'000;
  for (std::uint64_t slot = 0; slot < kDraws; ++slot) {
    ++counts[orderFor(OrderType::Random, 4, 11, slot, "b/c")];
  }
  ASSERT_EQ(counts.size(), 24U);
  double chiSquare = 0.0;
  for (const auto& [row, count] : counts) chiSquare += (count - 1000.0) * (count - 1000.0) / 1000.0;
  EXPECT_LT(chiSquare, 49.73);  // R: qchisq(0.999, 23)
}

TEST(Orders, DependOnSeedPlaceAndPurposeOnly) {
  const auto draw = [](std::uint64_t seed, std::uint64_t slot, const char* purpose) {
    return orderFor(OrderType::Random, 10, seed, slot, purpose);
  };
  EXPECT_EQ(draw(1, 2, "a"), draw(1, 2, "a"));
  EXPECT_NE(draw(1, 2, "a"), draw(2, 2, "a"));
  EXPECT_NE(draw(1, 2, "a"), draw(1, 3, "a"));
  EXPECT_NE(draw(1, 2, "a"), draw(1, 2, "b"));
}

TEST(Orders, NeverChangeOnceTheyWereDrawn) {
  // Studies have been run in these: version 1 of the generator, seed 20221212.
  const auto draw = [](OrderType type, int k, std::uint64_t slot) {
    return orderFor(type, k, 20221212, slot, "round-1/professional");
  };
  EXPECT_EQ(draw(OrderType::BalancedLatinSquare, 3, 0), (Row{2, 1, 0}));
  EXPECT_EQ(draw(OrderType::BalancedLatinSquare, 3, 1), (Row{2, 0, 1}));
  EXPECT_EQ(draw(OrderType::BalancedLatinSquare, 4, 0), (Row{0, 1, 3, 2}));
  EXPECT_EQ(draw(OrderType::Random, 5, 0), (Row{1, 3, 0, 4, 2}));
  EXPECT_EQ(draw(OrderType::Complete, 4, 9), (Row{0, 2, 3, 1}));
}

/// The orders of the first participants of "round-1/surgeons" with seed 2026.
std::vector<Row> first(int participants, OrderType type, int k) {
  std::vector<Row> rows;
  for (std::uint64_t slot = 0; static_cast<int>(rows.size()) < participants; ++slot) {
    rows.push_back(orderFor(type, k, 2026, slot, "round-1/surgeons"));
  }
  return rows;
}

/// The values come from what the headers say about version 1, written out in another language
/// (Python 3), and were there before our program was asked.
TEST(Orders, AreThoseThatTheirDescriptionGives) {
  ASSERT_EQ(base::kRandomVersion, 1);
  EXPECT_EQ(
      first(8, OrderType::BalancedLatinSquare, 4),
      (std::vector<Row>{
          {3, 0, 2, 1},
          {2, 3, 1, 0},
          {1, 2, 0, 3},
          {0, 1, 3, 2},
          {0, 1, 3, 2},
          {2, 3, 1, 0},
          {1, 2, 0, 3},
          {3, 0, 2, 1}}));
  EXPECT_EQ(
      first(6, OrderType::BalancedLatinSquare, 3),
      (std::vector<Row>{{2, 1, 0}, {0, 2, 1}, {0, 1, 2}, {1, 2, 0}, {1, 0, 2}, {2, 0, 1}}));
  EXPECT_EQ(
      first(6, OrderType::LatinSquare, 3),
      (std::vector<Row>{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 1, 2}, {1, 2, 0}, {2, 0, 1}}));
  EXPECT_EQ(
      first(6, OrderType::Complete, 3),
      (std::vector<Row>{{1, 2, 0}, {2, 0, 1}, {0, 1, 2}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}));
  EXPECT_EQ(
      first(4, OrderType::Random, 5),
      (std::vector<Row>{{2, 4, 1, 0, 3}, {0, 4, 2, 1, 3}, {1, 3, 2, 4, 0}, {0, 1, 4, 3, 2}}));
}

}  // namespace order_test
}  // namespace protocols
