#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/wire/crc32.h"
#include "haptics/wire/punch_frame.h"

namespace haptics::wire {
namespace cobs_test {

using Bytes = std::vector<uint8_t>;

Bytes stuffed(const Bytes& plain) {
  Bytes out(largestCobsSize(plain.size()));
  out.resize(cobsEncode(plain.data(), plain.size(), out.data()));
  return out;
}

Bytes plainOf(const Bytes& coded) {
  Bytes out(coded.size() + 1);
  out.resize(cobsDecode(coded.data(), coded.size(), out.data()));
  return out;
}

TEST(Crc32, IsThatOfZlib) {
  const char* digits = "123456789";
  EXPECT_EQ(crc32(reinterpret_cast<const uint8_t*>(digits), 9), 0xCBF43926U);
  EXPECT_EQ(crc32(nullptr, 0), 0U);
  const auto* bytes = reinterpret_cast<const uint8_t*>(digits);
  EXPECT_EQ(crc32(bytes + 4, 5, crc32(bytes, 4)), 0xCBF43926U);
}

// The examples of the paper and of RFC-like collections: (plain, coded).
TEST(Cobs, HasThePublishedEncodings) {
  EXPECT_EQ(stuffed({0x00}), (Bytes{0x01, 0x01}));
  EXPECT_EQ(stuffed({0x00, 0x00}), (Bytes{0x01, 0x01, 0x01}));
  EXPECT_EQ(stuffed({0x00, 0x11, 0x00}), (Bytes{0x01, 0x02, 0x11, 0x01}));
  EXPECT_EQ(stuffed({0x11, 0x22, 0x00, 0x33}), (Bytes{0x03, 0x11, 0x22, 0x02, 0x33}));
  EXPECT_EQ(stuffed({0x11, 0x22, 0x33, 0x44}), (Bytes{0x05, 0x11, 0x22, 0x33, 0x44}));
  EXPECT_EQ(stuffed({0x11, 0x00, 0x00, 0x00}), (Bytes{0x02, 0x11, 0x01, 0x01, 0x01}));
  Bytes full;
  for (int i = 1; i <= 254; ++i) full.push_back(static_cast<uint8_t>(i));
  EXPECT_EQ(stuffed(full).size(), 255U);
  EXPECT_EQ(stuffed(full)[0], 0xFF);
}

TEST(Cobs, RoundTripsEveryLengthWithManyZerosAndNone) {
  std::mt19937 random(7);
  for (size_t length = 1; length < 1100; ++length) {
    for (const int share : {0, 2, 50, 100}) {
      Bytes plain(length);
      for (auto& byte : plain) {
        const bool isZero = static_cast<int>(random() % 100) < share;
        byte = isZero ? uint8_t{0} : static_cast<uint8_t>(1 + random() % 255);
      }
      const Bytes coded = stuffed(plain);
      ASSERT_LE(coded.size(), largestCobsSize(length));
      for (const auto byte : coded) ASSERT_NE(byte, 0);
      ASSERT_EQ(plainOf(coded), plain) << length << " bytes, " << share << " % zeros";
    }
  }
}

TEST(Cobs, RefusesRunsThatLeaveTheFrame) {
  EXPECT_TRUE(plainOf({0x05, 0x11}).empty());
  EXPECT_TRUE(plainOf({0x02, 0x00}).empty());
  EXPECT_TRUE(plainOf({0x00}).empty());
}

}  // namespace cobs_test
}  // namespace haptics::wire
