#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "questionnaires/json/problem.h"

namespace questionnaires {

/// The number of characters (code points) of @p text; std::nullopt if it is not valid UTF-8.
///
/// Valid as defined by the Unicode standard: no overlong forms, no surrogates, nothing above
/// U+10FFFF. An emoji with a skin tone, and a letter with a combining accent, count as two
/// characters.
std::optional<std::size_t> utf8CharacterCount(std::string_view text) noexcept;

/// A JSON value and its children. Members are in the order of the file.
struct Value {
  struct Member;
  using Array = std::vector<Value>;
  using Object = std::vector<Member>;

  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> data;
  int line = 0;  ///< line of the key, from 0; without a key, the line of the value
};

struct Value::Member {
  std::string key;
  Value value;
};

/// The largest file that is read; files written by researchers are far smaller.
inline constexpr std::size_t kLargestFile = 5'000'000;  ///< [bytes]
inline constexpr std::size_t kDeepestNesting = 64;
inline constexpr std::size_t kLongestText = 100'000;   ///< [bytes]
inline constexpr std::size_t kMostElements = 100'000;  ///< elements of one list or object

/// Parses JSON from @p text. Stricter than most parsers: duplicate keys, NUL characters in texts,
/// nesting deeper than kDeepestNesting, and a @p text longer than kLargestFile are problems.
/// Returns std::nullopt if @p text is not JSON.
std::optional<Value> parseJson(std::string_view text, Problems& problems);

/// The line in @p json, from 0, of the value at @p path ("$.phases[3].order"); of its nearest
/// existing ancestor if there is no such value. Incomplete JSON is parsed up to its end.
int lineOf(std::string_view json, std::string_view path);

/// Reads a whole file as text.
/// @param most  largest size [bytes].
/// @throws UserError  if the file is missing, unreadable, no regular file, or larger than @p most.
std::string readTextFile(const std::string& path, std::size_t most = kLargestFile);

/// A word in a file and its enumerator: {"latinSquare", OrderType::LatinSquare}.
template <typename Enum>
struct Choice {
  std::string_view name;
  Enum value;
};

/// A JSON value in a researcher's file, with its path and the list to which its problems are added.
///
/// Every function that reads returns a value of the right type. If the file has no such value, it
/// adds a problem and returns a fallback, so that reading continues and all problems of a file are
/// reported at once. nlohmann::json would convert 1.5, true and 2^32 + 1 to int without an error.
///
/// The Value and the Problems must outlive the Node.
class Node {
 public:
  Node(const Value& value, std::string path, Problems& problems)
      : value_(&value), path_(std::move(path)), problems_(&problems) {}

  const std::string& path() const noexcept { return path_; }
  /// The JSON path of the member @p key: "$.phases[3].order".
  std::string pathOf(std::string_view key) const;
  /// Adds an error at the member @p key, or at this value itself if @p key is empty.
  void problem(std::string_view key, std::string what, std::string fix = {}) const;

  /// Adds a warning at the member @p key.
  void warn(std::string_view key, base::Message what, base::Message fix) const;

  /// Whether this value and all values inside it have no error so far.
  bool isSound() const;

  /// Reports every key that is not in @p known as a problem, with the most similar known key.
  /// Returns false and adds a problem if this value is not an object.
  bool isObjectWithOnlyKeys(std::initializer_list<std::string_view> known) const {
    return isObjectWithOnlyKeys(std::span(known.begin(), known.size()));
  }
  bool isObjectWithOnlyKeys(std::span<const std::string_view> known) const;

  bool has(std::string_view key) const noexcept { return find(key) != nullptr; }
  /// As has(), but a missing key is a problem.
  bool require(std::string_view key) const { return required(key) != nullptr; }
  const Value& value() const noexcept { return *value_; }
  bool isText() const noexcept { return std::holds_alternative<std::string>(value_->data); }
  bool isObject() const noexcept { return std::holds_alternative<Value::Object>(value_->data); }

  /// This value as a text; empty, with a problem, if it is not a text.
  std::string asText() const;

  /// Required members: a missing value, or one of another type or outside of the range, is a
  /// problem. The range includes `least` and `most`.
  std::string text(std::string_view key) const;
  double number(std::string_view key, double least, double most) const;
  std::int64_t wholeNumber(std::string_view key, std::int64_t least, std::int64_t most) const;

  /// Adds a problem unless the value at @p key equals @p format.
  /// @param fix  advice for a file of another format; empty if only another release of Palpate can
  ///     have written it
  void requireFormat(std::string_view key, std::string_view format, std::string fix = {}) const;

  /// A required id, which is also usable in file names and column names: a letter or digit, then up
  /// to 63 letters, digits, '.', '_' or '-'.
  std::string id(std::string_view key) const;

  /// Optional members: if the key is missing, returns the fallback; a wrong value is a problem.
  std::string text(std::string_view key, std::string fallback) const;
  double number(std::string_view key, double least, double most, double fallback) const;
  std::int64_t wholeNumber(
      std::string_view key, std::int64_t least, std::int64_t most, std::int64_t fallback) const;
  bool flag(std::string_view key, bool fallback) const;

  /// The object or list at @p key; std::nullopt or an empty list if the key is missing. A value of
  /// another type is a problem. More than @p most entries are a problem, too, and the rest is
  /// ignored.
  std::optional<Node> object(std::string_view key) const;
  std::vector<Node> list(std::string_view key, std::size_t most = kMostElements) const;

  /// Like object() and list(), but a missing key or an empty list is a problem.
  std::optional<Node> requiredObject(std::string_view key) const;
  std::vector<Node> requiredList(std::string_view key) const;

  /// The value at @p key, of any type; std::nullopt if the key is missing.
  std::optional<Node> member(std::string_view key) const;

  /// The keys of this object with their nodes, in the order of the file.
  std::vector<std::pair<std::string, Node>> members() const;

  /// A list of texts: ["a", "b"].
  std::vector<std::string> texts(std::string_view key) const;
  /// A list of numbers: [1.5, 2].
  std::vector<double> numbers(std::string_view key, double least, double most) const;
  /// A list of ids; a duplicate is a problem.
  std::vector<std::string> ids(std::string_view key) const;

  /// The enumerator of a required word, which must be one of @p choices; the first one, with a
  /// problem, if it is none of them.
  template <typename Choices>
  auto choice(std::string_view key, const Choices& choices) const {
    return chosen(key, choices).value_or(choices[0]).value;
  }

  /// The one of @p choices that a required word names; std::nullopt, with a problem, if it names
  /// none.
  template <typename Choices>
  std::optional<typename Choices::value_type> chosen(
      std::string_view key, const Choices& choices) const {
    const Value* value = required(key);
    return value == nullptr ? std::nullopt : at(key, *value).chosen(choices);
  }

  /// Like chosen(), for this value itself.
  template <typename Choices>
  std::optional<typename Choices::value_type> chosen(const Choices& choices) const {
    std::vector<std::string_view> names;
    names.reserve(choices.size());
    for (const auto& choice : choices) names.push_back(choice.name);
    const auto index = indexIn(names);
    return index ? std::optional(choices[*index]) : std::nullopt;
  }

  /// Like choice(), or @p fallback if the key is missing.
  template <typename Choices, typename Value>
  Value choice(std::string_view key, const Choices& choices, Value fallback) const {
    return has(key) ? choice(key, choices) : fallback;
  }

 private:
  /// The value at @p key; nullptr if the key is missing or this is no object.
  const Value* find(std::string_view key) const noexcept;
  /// As find(), but a missing key is a problem.
  const Value* required(std::string_view key) const;
  /// The Node of the value at @p key.
  Node at(std::string_view key, const Value& value) const;
  /// @p value as a number; std::nullopt, with a problem, if it is none or outside of the range.
  std::optional<double> numberIn(
      std::string_view key, const Value& value, double least, double most) const;
  std::optional<std::int64_t> wholeNumberIn(
      std::string_view key, const Value& value, std::int64_t least, std::int64_t most) const;
  /// The index of this value in @p names; std::nullopt, with a problem, if it is not in @p names.
  std::optional<std::size_t> indexIn(const std::vector<std::string_view>& names) const;

  const Value* value_;
  std::string path_;
  Problems* problems_;
};

/// Parses JSON and returns the result of @p read for the root Node; std::nullopt if there are
/// errors. All problems are added to @p problems.
template <typename T, typename Read>
std::optional<T> readJson(std::string_view text, Problems& problems, Read read) {
  Problems found;
  std::optional<T> result;
  if (const auto value = parseJson(text, found)) result = read(Node(*value, "$", found));
  problems.append(found);
  return found.hasErrors() ? std::nullopt : std::move(result);
}

/// Whether @p id has the form of an id (see Node::id()).
bool isValidId(std::string_view id) noexcept;

/// The rule for ids, reported as the fix of a problem.
inline constexpr std::string_view kIdRule =
    "use a letter or digit, then letters, digits, '.', '_' or '-', at most 64 in all";

/// The type of a value for messages: "a number", "a list".
std::string typeName(const Value& value);

/// @p number for a message, without superfluous digits: 0.5, 1000000000.
std::string shown(double number);

/// @p text for a message: in one line, without control characters, and truncated if it is long.
std::string shown(std::string_view text);

/// The word in @p known of which @p word is probably a misspelling; std::nullopt if none is
/// similar.
std::optional<std::string_view> nearest(
    std::string_view word, std::span<const std::string_view> known);

}  // namespace questionnaires
