#include "study/storage/hasher.h"

#include <gtest/gtest.h>

namespace study::storage {
namespace hasher_test {

std::span<const std::byte> bytesOf(const std::string& text) {
  return std::as_bytes(std::span(text));
}

TEST(Base64, IsThatOfTheStandard) {
  // RFC 4648, section 10
  EXPECT_EQ(inBase64(bytesOf("")), "");
  EXPECT_EQ(inBase64(bytesOf("f")), "Zg==");
  EXPECT_EQ(inBase64(bytesOf("fo")), "Zm8=");
  EXPECT_EQ(inBase64(bytesOf("foobar")), "Zm9vYmFy");
  EXPECT_EQ(inBase64(bytesOf("\xfb\xff")), "+/8=");
}

TEST(Base64, ReadsWhatItWrote) {
  std::string bytes;
  for (int size = 0; size < 300; ++size) {
    const auto read = fromBase64(inBase64(bytesOf(bytes)));
    ASSERT_TRUE(read) << size;
    ASSERT_EQ(std::string(reinterpret_cast<const char*>(read->data()), read->size()), bytes);
    bytes += static_cast<char>(size * 37);
  }
}

TEST(Base64, RefusesWhatIsDamaged) {
  for (const auto* text : {"Zg=", "Zg", "Zm9v!", "Zm9v Zm9v", "Zm9v\n", "=", "Zg==Zg=="}) {
    EXPECT_FALSE(fromBase64(text)) << text;
  }
}

}  // namespace hasher_test
}  // namespace study::storage
