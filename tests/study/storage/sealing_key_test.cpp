#include "study/storage/keys/sealing_key.h"

#include <gtest/gtest.h>

#include "study/storage/hasher.h"

namespace study::storage {
namespace sealing_key_test {

SealingKey keyOf(unsigned char byte) {
  SealingKey::Bytes bytes{};
  bytes.fill(byte);
  return SealingKey(bytes);
}

TEST(SealingKey, OpensWhatItSealedForTheSamePlace) {
  const auto key = SealingKey::drawn();
  for (const std::string text : {"", "a", "an answer of many words"}) {
    const auto sealed = key.seal(text, "17/answered");
    EXPECT_EQ(sealed.size(), text.size() + 40);
    EXPECT_EQ(key.open(sealed, "17/answered"), text);
    EXPECT_EQ(key.open(sealed, "18/answered"), std::nullopt);
    EXPECT_EQ(SealingKey::drawn().open(sealed, "17/answered"), std::nullopt);
  }
}

TEST(SealingKey, NoticesEveryChangedByte) {
  const auto key = keyOf(1);
  const auto sealed = key.seal("words", "here");
  for (std::size_t i = 0; i < sealed.size(); ++i) {
    auto changed = sealed;
    changed[i] ^= std::byte{1};
    EXPECT_EQ(key.open(changed, "here"), std::nullopt) << i;
  }
  for (std::size_t size = 0; size < sealed.size(); ++size) {
    EXPECT_EQ(key.open(std::span(sealed).first(size), "here"), std::nullopt) << size;
  }
}

TEST(SealingKey, SealsTheSameWordsDifferentlyEachTime) {
  const auto key = keyOf(1);
  EXPECT_NE(key.seal("words", "here"), key.seal("words", "here"));
}

TEST(SealingKey, HashesWithAnotherKeyThanItSealsWith) {
  EXPECT_EQ(keyOf(1).hashingKey(), keyOf(1).hashingKey());
  EXPECT_NE(keyOf(1).hashingKey(), keyOf(2).hashingKey());
  EXPECT_NE(keyOf(1).hashingKey(), keyOf(1).bytes());
  Hasher hasher;
  hasher.add("an answer that can be guessed");
  EXPECT_EQ(hasher.finish(keyOf(1).hashingKey()), hasher.finish(keyOf(1).hashingKey()));
  EXPECT_NE(hasher.finish(keyOf(1).hashingKey()), hasher.finish(keyOf(2).hashingKey()));
  EXPECT_NE(hasher.finish(keyOf(1).hashingKey()), hasher.finish());
}

}  // namespace sealing_key_test
}  // namespace study::storage
