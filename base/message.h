#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace base {

/// One kind of message. Each room lists its kinds in one table; the key and the English text are
/// written nowhere else.
struct MessageKind {
  std::string_view key;      ///< stable: catalogues, tests and stored messages name it
  std::string_view english;  ///< with {} (or {:.2f}) for each argument, as fmt::format reads it
};

using Argument = std::variant<std::int64_t, double, std::string>;

template <typename T>
Argument asArgument(T&& value) {
  using Plain = std::remove_cvref_t<T>;
  static_assert(!std::same_as<Plain, bool>, "say it with two kinds of message");
  if constexpr (std::same_as<Plain, Argument>) {
    return std::forward<T>(value);
  } else if constexpr (std::integral<Plain>) {
    return static_cast<std::int64_t>(value);
  } else if constexpr (std::floating_point<Plain>) {
    return static_cast<double>(value);
  } else {
    return std::string(std::forward<T>(value));
  }
}

/// A message for a person, such as why a number is missing, a warning about a protocol file, or
/// what was wrong with a trial. Code compares and stores its kind and arguments; the sentence is
/// made only for display, in English by describe() and in other languages by study::words::Words.
class Message {
 public:
  /// No message.
  Message() = default;

  Message(const MessageKind& kind, std::vector<Argument> arguments)
      : kind_(&kind), arguments_(std::move(arguments)) {}

  /// A text that is never translated: an error of the operating system, a title in a researcher's
  /// file, or an error in such a file (English only).
  static Message verbatim(std::string words) {
    Message message;
    if (!words.empty()) message.arguments_.emplace_back(std::move(words));
    return message;
  }

  bool empty() const noexcept { return kind_ == nullptr && arguments_.empty(); }

  /// Empty if there is no message or the text is verbatim.
  std::string_view key() const noexcept { return kind_ == nullptr ? "" : kind_->key; }
  /// "{}" if the text is verbatim.
  std::string_view english() const noexcept { return kind_ != nullptr ? kind_->english : "{}"; }
  const std::vector<Argument>& arguments() const noexcept { return arguments_; }

  friend bool operator==(const Message& a, const Message& b) {
    return a.key() == b.key() && a.arguments_ == b.arguments_;
  }

 private:
  const MessageKind* kind_ = nullptr;
  std::vector<Argument> arguments_;
};

/// The message in English; empty for no message.
std::string describe(const Message& message);

/// Several messages in English, separated by semicolons.
std::string describe(const std::vector<Message>& messages);

/// A pattern, in any language, with its arguments filled in. In the pseudo-language its letters are
/// replaced (see asDisplayed()).
std::string filled(std::string_view pattern, const std::vector<Argument>& arguments);

/// A pattern with named arguments, such as "{item} = {value}", filled in.
using NamedArguments = std::vector<std::pair<std::string, Argument>>;
std::string filled(std::string_view pattern, const NamedArguments& arguments);

/// A pattern as it is shown to people: unchanged, unless the environment variable
/// PALPATE_PSEUDO_LANGUAGE is set. Then every letter outside {} is replaced by another one that is
/// computed from the pattern. Tests run programs in this way, so that code which reads a sentence
/// as data fails.
std::string asDisplayed(std::string_view pattern);

constexpr std::size_t placeholderCount(std::string_view pattern) {
  std::size_t places = 0;
  for (const char c : pattern) places += c == '{' ? 1 : 0;
  return places;
}

/// A key of the table @p kKinds, checked at compile time: the key must exist, and its pattern must
/// have @p kArguments arguments.
template <const auto& kKinds, std::size_t kArguments>
class CheckedKey {
 public:
  consteval CheckedKey(const char* key) {  // NOLINT(google-explicit-constructor)
    while (index_ < kKinds.size() && kKinds[index_].key != key) ++index_;
    if (index_ == kKinds.size()) throw "there is no message of this key";
    if (placeholderCount(kKinds[index_].english) != kArguments) throw "wrong number of arguments";
  }

  constexpr const MessageKind& kind() const noexcept { return kKinds[index_]; }

 private:
  std::size_t index_ = 0;
};

/// A message of the table @p kKinds.
template <const auto& kKinds, typename... Arguments>
Message messageOf(CheckedKey<kKinds, sizeof...(Arguments)> key, Arguments&&... arguments) {
  std::vector<Argument> values;
  values.reserve(sizeof...(Arguments));
  (values.push_back(asArgument(std::forward<Arguments>(arguments))), ...);
  return {key.kind(), std::move(values)};
}

}  // namespace base
