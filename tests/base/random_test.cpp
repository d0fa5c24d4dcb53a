#include "base/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/base/reference_generators.h"

namespace base {
namespace random_test {

/// The first numbers of a stream of version 1. They were computed from the description in the
/// header by an independent implementation (Python 3, integers of any size). They never change,
/// because orders of studies have been drawn from these streams.
struct Golden {
  std::uint64_t seed;
  std::uint64_t index;
  std::string purpose;
  std::array<std::uint64_t, 4> bits;
  double uniform;
  double normal;
  std::vector<int> dice;      ///< below(6), five times
  std::vector<int> shuffled;  ///< 0 … 7
};

const std::vector<Golden> kGolden{
    {0,
     0,
     "",
     {0xd4e9384e6f5a37c4, 0x98f31a73738390ff, 0x4853b0223447cbcf, 0xfb0d1d227f304676},
     0.8316836539737344,
     1.165662416110627,
     {2, 5, 1, 0, 2},
     {3, 5, 6, 7, 0, 1, 2, 4}},
    {0,
     0,
     "order",
     {0x649ff8f02a7f45b1, 0x7b95673a031fde1f, 0xf76e79455c1f0330, 0x0034dd068ca8cce9},
     0.39306598533084713,
     -2.441924979766777,
     {1, 3, 4, 1, 2},
     {7, 2, 3, 0, 6, 4, 5, 1}},
    {1,
     0,
     "order",
     {0x502381055f12f44c, 0xa6dd83c0de80aad2, 0x3d92f58636be6274, 0xef6414562b333489},
     0.313041747866986,
     -1.3269699244168542,
     {4, 0, 0, 5, 4},
     {7, 1, 2, 5, 3, 6, 0, 4}},
    {0,
     1,
     "order",
     {0xa7a6a4baa4582799, 0x7bc14417c16b3ea5, 0x8006ad03e5e387d1, 0xb145a864370823ad},
     0.6548865276020881,
     2.1475579335249178,
     {5, 1, 3, 5, 0},
     {5, 7, 2, 6, 0, 3, 4, 1}},
    {42,
     0,
     "rows/felt/professional",
     {0xd8f2499268a74e36, 0x31aeb420a6e4897f, 0xcc513306d7ec7c73, 0x27db2322901c0887},
     0.8474470121806493,
     0.41656720550302206,
     {0, 1, 3, 3, 1},
     {4, 0, 5, 1, 2, 3, 7, 6}},
    {9007199254740992,
     719,
     "simulated/x/leniency",
     {0xd6413cd12208a791, 0x9b7d046bc3d13ce5, 0xdbc2e3e248d76064, 0xb01420b1462f9d56},
     0.836932946260307,
     1.1214740139604222,
     {5, 1, 2, 0, 4},
     {3, 4, 7, 5, 0, 6, 2, 1}},
    {0xffffffffffffffff,
     0xffffffffffffffff,
     "é",
     {0x244f2d4dab932526, 0xcc4c6360d401f33b, 0xba7d3b334aff9145, 0x983588321c2629bd},
     0.14183314462895824,
     -0.40826653660752155,
     {0, 3, 1, 3, 3},
     {7, 4, 0, 5, 2, 1, 3, 6}},
};

RandomStream streamOf(const Golden& golden) {
  return {golden.seed, golden.index, golden.purpose};
}

TEST(RandomStream, StartsLikeVersionOneInEveryRelease) {
  EXPECT_EQ(kRandomVersion, 1);
  for (const auto& golden : kGolden) {
    auto stream = streamOf(golden);
    for (const auto expected : golden.bits) EXPECT_EQ(stream.bits(), expected) << golden.purpose;
  }
}

TEST(RandomStream, DrawsAndShufflesLikeVersionOneInEveryRelease) {
  for (const auto& golden : kGolden) {
    auto dice = streamOf(golden);
    for (const int expected : golden.dice) {
      EXPECT_EQ(dice.below(6), static_cast<std::uint64_t>(expected)) << golden.purpose;
    }
    std::vector<int> values(8);
    std::iota(values.begin(), values.end(), 0);
    streamOf(golden).shuffle(values);
    EXPECT_EQ(values, golden.shuffled) << golden.purpose;
    EXPECT_EQ(streamOf(golden).uniform(), golden.uniform) << golden.purpose;
    // The last digit of the logarithm depends on the machine.
    EXPECT_NEAR(streamOf(golden).normal(), golden.normal, 1e-14) << golden.purpose;
  }
}

TEST(ReferenceGenerators, GiveThePublishedValues) {
  // rand_xoshiro 0.6, made with its authors' C program: state 1, 2, 3, 4.
  tests::ReferenceXoshiro xoshiro{{1, 2, 3, 4}};
  for (const std::uint64_t expected :
       {11520ULL,
        0ULL,
        1509978240ULL,
        1215971899390074240ULL,
        1216172134540287360ULL,
        607988272756665600ULL,
        16172922978634559625ULL,
        8476171486693032832ULL,
        10595114339597558777ULL,
        2904607092377533576ULL}) {
    EXPECT_EQ(xoshiro.next(), expected);
  }
  // Rosetta Code, "Pseudo-random numbers/Splitmix64": seed 1234567.
  std::uint64_t state = 1234567;
  for (const std::uint64_t expected :
       {6457827717110365317ULL,
        3203168211198807973ULL,
        9817491932198370423ULL,
        4593380528125082431ULL,
        16408922859458223821ULL}) {
    EXPECT_EQ(tests::referenceSplitMix(state), expected);
  }
  // The test vectors of the FNV page.
  EXPECT_EQ(tests::referenceFnv1a(""), 0xcbf29ce484222325U);
  EXPECT_EQ(tests::referenceFnv1a("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(tests::referenceFnv1a("foobar"), 0x85944171f73967e8U);
}

TEST(SplitMix64, IsTheGeneratorItsHeaderNames) {
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1234567}, ~std::uint64_t{0}}) {
    SplitMix64 ours(seed);
    std::uint64_t state = seed;
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(ours.bits(), tests::referenceSplitMix(state));
  }
}

TEST(SplitMix64, GivesTheNumbersOfItsDescription) {
  // Computed in Python 3 from the description in the header, with the seed of Rosetta Code.
  SplitMix64 uniform(1234567);
  for (const double expected : {0.3500795420214081, 0.17364409667091263, 0.5322073040624192})
    EXPECT_EQ(uniform.uniform(), expected);
  SplitMix64 normal(1234567);
  // The last digits of logarithm and cosine depend on the machine.
  for (const double expected : {0.4284879007349292, 0.007685698515048663, -1.858684499989007})
    EXPECT_NEAR(normal.normal(), expected, 1e-14);
}

TEST(RandomStream, IsTheGeneratorItsHeaderNames) {
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{7}, ~std::uint64_t{0}}) {
    for (const std::uint64_t index : {std::uint64_t{0}, std::uint64_t{599}}) {
      for (const auto* purpose : {"", "order/felt/surgeons", "labels/x"}) {
        RandomStream ours(seed, index, purpose);
        auto reference = tests::referenceStream(seed, index, purpose);
        for (int i = 0; i < 1000; ++i) ASSERT_EQ(ours.bits(), reference.next()) << purpose << i;
      }
    }
  }
}

TEST(RandomStream, DiffersForEverySeedIndexAndPurpose) {
  std::set<std::uint64_t> first;
  std::size_t streams = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    for (std::uint64_t index = 0; index < 100; ++index) {
      for (const auto* purpose : {"order", "labels", "orders", "order ", "sledar"}) {
        first.insert(RandomStream(seed, index, purpose).bits());
        ++streams;
      }
    }
  }
  EXPECT_EQ(first.size(), streams);  // 50,000 of 2⁶⁴: two alike once in 15 thousand million
  EXPECT_NE(RandomStream(1, 2, "x").bits(), RandomStream(2, 1, "x").bits());
}

TEST(RandomStream, DiffersInHalfOfItsBitsForNeighbouringIndices) {
  int bits = 0;
  constexpr int kPairs = 1000;
  for (std::uint64_t i = 0; i < kPairs; ++i) {
    bits += std::popcount(
        RandomStream(42, i, "order").bits() ^ RandomStream(42, i + 1, "order").bits());
  }
  EXPECT_NEAR(bits / double{kPairs}, 32.0, 0.5);  // standard error 4/√1000 = 0.13
}

/// Σ (counted − expected)² / expected
template <typename Counts>
double chiSquare(const Counts& counts, double expected) {
  double sum = 0.0;
  for (const double count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

TEST(RandomStream, DrawsEveryNumberBelowABoundEquallyOften) {
  // R: qchisq(0.999, c(1, 2, 5, 9, 719))
  const std::map<std::uint64_t, double> limits{
      {2, 10.83}, {3, 13.82}, {6, 20.52}, {10, 27.88}, {720, 841.7}};
  for (const auto& [bound, limit] : limits) {
    RandomStream stream(2026, bound, "chi-square");
    std::vector<int> counts(bound, 0);
    constexpr int kDraws = 100'000;
    for (int i = 0; i < kDraws; ++i) ++counts.at(stream.below(bound));
    EXPECT_LT(chiSquare(counts, kDraws / static_cast<double>(bound)), limit) << bound;
  }
}

TEST(RandomStream, IsUniformBelowABoundThatDoesNotDivideItsRange) {
  // Of 64 bits taken modulo 3·2⁶², the lower third would come twice as often as the others.
  constexpr std::uint64_t kThird = std::uint64_t{1} << 62;
  RandomStream stream(2026, 0, "thirds");
  std::array<int, 3> counts{};
  constexpr int kDraws = 30'000;
  for (int i = 0; i < kDraws; ++i) ++counts.at(stream.below(3 * kThird) / kThird);
  EXPECT_LT(chiSquare(counts, kDraws / 3.0), 13.82);  // R: qchisq(0.999, 2)
}

TEST(RandomStream, ReturnsZeroBelowOne) {
  RandomStream stream(1, 1, "one");
  for (int i = 0; i < 100; ++i) EXPECT_EQ(stream.below(1), 0U);
}

TEST(RandomStream, IsUniformFromZeroToJustBelowOne) {
  RandomStream stream(2026, 0, "uniform");
  std::array<int, 20> counts{};
  constexpr int kDraws = 100'000;
  for (int i = 0; i < kDraws; ++i) {
    const double number = stream.uniform();
    ASSERT_GE(number, 0.0);
    ASSERT_LT(number, 1.0);
    ASSERT_EQ(std::ldexp(number, 53), std::floor(std::ldexp(number, 53)));
    ++counts.at(static_cast<std::size_t>(number * 20.0));
  }
  EXPECT_LT(chiSquare(counts, kDraws / 20.0), 43.82);  // R: qchisq(0.999, 19)
}

TEST(RandomStream, IsUniformBetweenTwoNumbers) {
  RandomStream stream(2026, 0, "between");
  double sum = 0.0;
  for (int i = 0; i < 10'000; ++i) {
    const double number = stream.uniform(-2.0, 6.0);
    ASSERT_GE(number, -2.0);
    ASSERT_LE(number, 6.0);
    sum += number;
  }
  EXPECT_NEAR(sum / 10'000, 2.0, 0.1);  // standard error 8/√12/100 = 0.023
}

TEST(RandomStream, IsNormalWithMeanZeroAndDeviationOne) {
  RandomStream stream(2026, 0, "normal");
  constexpr int kDraws = 200'000;
  std::array<double, 4> moments{};
  int beyondTwo = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double number = stream.normal();
    ASSERT_TRUE(std::isfinite(number));
    for (std::size_t k = 0; k < moments.size(); ++k) {
      moments[k] += std::pow(number, static_cast<double>(k + 1)) / kDraws;
    }
    if (std::abs(number) > 1.959964) ++beyondTwo;
  }
  EXPECT_NEAR(moments[0], 0.0, 0.01);                     // standard error 0.0022
  EXPECT_NEAR(moments[1], 1.0, 0.015);                    // 0.0032
  EXPECT_NEAR(moments[2], 0.0, 0.04);                     // 0.0087
  EXPECT_NEAR(moments[3], 3.0, 0.1);                      // 0.022
  EXPECT_NEAR(beyondTwo / double{kDraws}, 0.05, 0.0025);  // R: 2 * pnorm(-1.959964); 0.0005
}

TEST(RandomStream, ShufflesIntoEveryOrderEquallyOften) {
  std::map<std::vector<int>, int> counts;
  constexpr int kShuffles = 48'000;
  for (std::uint64_t i = 0; i < kShuffles; ++i) {
    std::vector<int> values{0, 1, 2, 3};
    RandomStream(2026, i, "shuffle").shuffle(values);
    ++counts[values];
  }
  ASSERT_EQ(counts.size(), 24U);
  std::vector<int> numbers;
  for (const auto& [order, count] : counts) numbers.push_back(count);
  EXPECT_LT(chiSquare(numbers, kShuffles / 24.0), 49.73);  // R: qchisq(0.999, 23)
}

TEST(RandomStream, ShufflesListsOfNoneAndOneElement) {
  RandomStream stream(1, 1, "few");
  std::vector<int> none;
  stream.shuffle(none);
  EXPECT_TRUE(none.empty());
  std::vector<int> one{7};
  stream.shuffle(one);
  EXPECT_EQ(one, std::vector<int>{7});
}

}  // namespace random_test
}  // namespace base
