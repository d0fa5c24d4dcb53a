#include "base/message.h"

#include <gtest/gtest.h>

namespace base {
namespace message_test {

inline constexpr auto kKinds = std::to_array<MessageKind>({
    {"empty_group", "group {} has no values"},
    {"late", "{} of {:.2f} ticks of '{}' were late"},
});

template <typename... Arguments>
Message message(CheckedKey<kKinds, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return messageOf<kKinds>(key, std::forward<Arguments>(arguments)...);
}

TEST(Message, IsDescribedInEnglishWithItsArguments) {
  EXPECT_EQ(describe(message("empty_group", 2)), "group 2 has no values");
  EXPECT_EQ(describe(message("late", 30U, 2.0, "a")), "30 of 2.00 ticks of 'a' were late");
  EXPECT_EQ(
      describe({message("empty_group", 1), message("empty_group", 2)}),
      "group 1 has no values; group 2 has no values");
}

TEST(Message, IsEqualIfKindAndArgumentsAreEqual) {
  EXPECT_EQ(message("empty_group", 2), message("empty_group", 2));
  EXPECT_NE(message("empty_group", 2), message("empty_group", 1));
  EXPECT_NE(message("empty_group", 2), Message::verbatim("group 2 has no values"));
  EXPECT_EQ(message("empty_group", 2).key(), "empty_group");
}

TEST(Message, MayBeEmptyOrVerbatim) {
  EXPECT_TRUE(Message().empty());
  EXPECT_EQ(describe(Message()), "");
  EXPECT_TRUE(Message::verbatim("").empty());
  const auto words = Message::verbatim("no {} such file");
  EXPECT_EQ(words.key(), "");
  EXPECT_EQ(describe(words), "no {} such file");
}

TEST(Message, FillsArgumentsByName) {
  EXPECT_EQ(
      filled("{item} = {value:.1f}", NamedArguments{{"value", 4.0}, {"item", std::string("a")}}),
      "a = 4.0");
}

}  // namespace message_test
}  // namespace base
