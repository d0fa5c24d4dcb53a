#include "haptics/wire/sequence_check.h"

#include <random>

#include <gtest/gtest.h>

namespace haptics::wire {
namespace sequence_check_test {

using Check = SequenceCheck<std::uint16_t>;
using Verdict = Check::Verdict;

TEST(SequenceCheck, CountsWhatIsLostDoubledAndOvertakenOverTheWrap) {
  Check check;
  std::uint64_t lost = 0;
  std::uint64_t doubled = 0;
  std::uint64_t late = 0;
  std::mt19937 random(3);
  std::uint16_t number = 65'000;
  for (int i = 0; i < 100; ++i) ASSERT_EQ(check.take(number++), Verdict::Fresh);
  for (int i = 0; i < 20'000; ++i) {
    switch (random() % 8) {
      case 0:
        ++number;
        ++lost;
        ASSERT_EQ(check.take(number++), Verdict::Fresh);
        break;
      case 1:
        ASSERT_EQ(check.take(number), Verdict::Fresh);
        ASSERT_EQ(check.take(number++), Verdict::Doubled);
        ++doubled;
        break;
      case 2:
        ASSERT_EQ(check.take(static_cast<std::uint16_t>(number + 1)), Verdict::Fresh);
        ASSERT_EQ(check.take(number), Verdict::Late);
        number = static_cast<std::uint16_t>(number + 2);
        ++late;
        break;
      default:
        ASSERT_EQ(check.take(number++), Verdict::Fresh);
    }
  }
  EXPECT_EQ(check.lost(), lost);
  EXPECT_EQ(check.duplicates(), doubled);
  EXPECT_EQ(check.late(), late);
  EXPECT_EQ(check.restarts(), 0U);
}

TEST(SequenceCheck, RecognisesASenderThatRestarts) {
  SequenceCheck<std::uint32_t> check;
  for (std::uint32_t i = 5000; i < 5100; ++i) check.take(i);
  EXPECT_EQ(check.take(0), SequenceCheck<std::uint32_t>::Verdict::Restart);
  EXPECT_EQ(check.take(1), SequenceCheck<std::uint32_t>::Verdict::Fresh);
  EXPECT_EQ(check.lost(), 0U);
  EXPECT_EQ(check.restarts(), 1U);
}

TEST(SequenceCheck, LosesUpToAThousandAtATime) {
  SequenceCheck<std::uint32_t> check;
  check.take(10);
  EXPECT_EQ(check.take(1010), SequenceCheck<std::uint32_t>::Verdict::Fresh);
  EXPECT_EQ(check.lost(), 999U);
}

}  // namespace sequence_check_test
}  // namespace haptics::wire
