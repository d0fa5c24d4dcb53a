#include "haptics/engine/sample_ring.h"

#include <thread>

#include <gtest/gtest.h>

namespace haptics::engine {
namespace sample_ring_test {

TEST(SampleRing, HandsOverInOrder) {
  SampleRing<int, 8> ring;
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(ring.push(i));
  int sample = -1;
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(ring.pop(sample));
    EXPECT_EQ(sample, i);
  }
  EXPECT_FALSE(ring.pop(sample));
}

TEST(SampleRing, CountsWhatItCannotHold) {
  SampleRing<int, 4> ring;
  for (int i = 0; i < 7; ++i) ring.push(i);
  EXPECT_EQ(ring.lost(), 3U);
  int sample = -1;
  EXPECT_TRUE(ring.pop(sample));
  EXPECT_EQ(sample, 0);  // what was there first stays
}

TEST(SampleRing, LosesNothingBetweenTwoThreads) {
  constexpr int kCount = 200'000;
  SampleRing<int, 1024> ring;
  std::jthread writer([&] {
    for (int i = 0; i < kCount;) {
      if (ring.push(i)) {
        ++i;
      } else {
        std::this_thread::yield();
      }
    }
  });
  int expected = 0;
  int sample = 0;
  while (expected < kCount) {
    if (!ring.pop(sample)) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(sample, expected++);
  }
}

}  // namespace sample_ring_test
}  // namespace haptics::engine
