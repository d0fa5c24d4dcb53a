#pragma once

#include <array>
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

/// How many characters (code points) @p text has; std::nullopt if it is no valid UTF-8.
///
/// Valid as the Unicode standard defines it: no overlong forms, no surrogates, nothing beyond
/// U+10FFFF. An emoji with a skin tone counts as two, a letter with a combining accent as well.
std::optional<std::size_t> charactersIn(std::string_view text) noexcept;

/// What a JSON file says, as a tree of plain values. Keys keep the order of the file.
struct Value {
  struct Member;
  using Array = std::vector<Value>;
  using Object = std::vector<Member>;

  std::variant<std::nullptr_t, bool, std::int64_t, double, std::string, Array, Object> data;
  int line = 0;  ///< of the file, from 0: of its key, or of the value where it has no key
};

struct Value::Member {
  std::string key;
  Value value;
};

/// The largest file that is read; what researchers write is far smaller.
inline constexpr std::size_t kLargestFile = 5'000'000;  ///< [bytes]
inline constexpr std::size_t kDeepestNesting = 64;
inline constexpr std::size_t kLongestText = 100'000;  ///< [bytes]
inline constexpr std::size_t kMostElements = 100'000;

/// Reads JSON from @p text. What a lenient reader lets pass is a problem here: duplicate keys,
/// NUL characters in texts, nesting deeper than kDeepestNesting, files larger than kLargestFile.
/// Nothing is returned where the text is no JSON at all.
std::optional<Value> parseJson(std::string_view text, Problems& problems);

/// The line of @p json, from 0, of what a path means ("$.phases[3].order"); where that is not
/// there, the line of the nearest thing around it that is. JSON that breaks off is read as far as
/// it goes.
int lineOf(std::string_view json, std::string_view path);

/// The whole file as text.
/// @param most  bytes.
/// @throws UserError  if it is missing, unreadable, no regular file, or larger than that; in words.
std::string readTextFile(const std::string& path, std::size_t most = kLargestFile);

/// A name of a choice in a file and what it stands for: {"latinSquare", OrderType::LatinSquare}.
template <typename Enum>
struct Choice {
  std::string_view name;
  Enum value;
};

/// A place in a researcher's file, with its path and the list that problems are added to.
///
/// Every read answers with a value of the right type. Where the file has none, that is a problem in
/// the list, the fallback goes on, and everything else is read too: so all problems of a file come
/// out in one reading. nlohmann::json makes an int of 1.5, of true and of 2^32 + 1 without an
/// error; a Node does not.
///
/// Values, problems and names outlive their nodes.
class Node {
 public:
  Node(const Value& value, std::string path, Problems& problems)
      : value_(&value), path_(std::move(path)), problems_(&problems) {}

  const std::string& path() const noexcept { return path_; }
  std::string pathOf(std::string_view key) const;
  void problem(std::string_view key, std::string what, std::string fix = {}) const;

  /// Whether no problem has been found here or in anything below.
  bool isSound() const;

  /// Refuses every key that is not in @p known, and names the nearest known one. False, and a
  /// problem, where this is no object at all.
  bool isObjectWith(std::initializer_list<std::string_view> known) const {
    return isObjectWith(std::span(known.begin(), known.size()));
  }
  bool isObjectWith(std::span<const std::string_view> known) const;

  bool has(std::string_view key) const noexcept { return find(key) != nullptr; }
  const Value& value() const noexcept { return *value_; }
  bool isText() const noexcept { return std::holds_alternative<std::string>(value_->data); }
  bool isObject() const noexcept { return std::holds_alternative<Value::Object>(value_->data); }

  /// This value itself as a text; empty, and a problem, if it is none.
  std::string asText() const;

  /// Required values: missing or wrong is a problem.
  std::string text(std::string_view key) const;
  double number(std::string_view key, double least, double most) const;
  std::int64_t wholeNumber(std::string_view key, std::int64_t least, std::int64_t most) const;

  /// Refuses a file that does not say under @p key that it is written in @p format.
  /// @param fix  what to do with a file of another format; empty: only another release wrote it
  void requireFormat(std::string_view key, std::string_view format, std::string fix = {}) const;

  /// A name for people, files and columns: a letter or digit, then up to 63 of letters, digits,
  /// '.', '_' and '-'.
  std::string id(std::string_view key) const;

  /// Values that may be left out: wrong is a problem, missing is the fallback.
  std::string text(std::string_view key, std::string fallback) const;
  double number(std::string_view key, double least, double most, double fallback) const;
  std::int64_t wholeNumber(
      std::string_view key, std::int64_t least, std::int64_t most, std::int64_t fallback) const;
  bool flag(std::string_view key, bool fallback) const;

  /// The object or list behind a key. std::nullopt if the key is missing; a problem where it is
  /// something else, or where the list has more than @p most entries (and these are left out).
  std::optional<Node> object(std::string_view key) const;
  std::vector<Node> list(std::string_view key, std::size_t most = kMostElements) const;

  /// The same, and a problem where the key is missing (or the list is empty).
  std::optional<Node> requiredObject(std::string_view key) const;
  std::vector<Node> requiredList(std::string_view key) const;

  /// The value behind a key; std::nullopt if the key is missing.
  std::optional<Node> member(std::string_view key) const;

  /// The keys of this object with their nodes, in the order of the file.
  std::vector<std::pair<std::string, Node>> members() const;

  /// Texts in a list: ["a", "b"].
  std::vector<std::string> texts(std::string_view key) const;
  /// Numbers in a list: [1.5, 2].
  std::vector<double> numbers(std::string_view key, double least, double most) const;
  /// Ids in a list, each once.
  std::vector<std::string> ids(std::string_view key) const;

  /// One of several names; required.
  template <typename Choices>
  auto choice(std::string_view key, const Choices& choices) const {
    std::vector<std::string_view> names;
    names.reserve(choices.size());
    for (const auto& choice : choices) names.push_back(choice.name);
    return choices[chosenAt(key, names)].value;
  }

  /// The same, where this value itself is the name; std::nullopt if it is none of them.
  template <typename Enum, std::size_t kCount>
  std::optional<Enum> chosen(const std::array<Choice<Enum>, kCount>& choices) const {
    std::vector<std::string_view> names;
    names.reserve(choices.size());
    for (const auto& choice : choices) names.push_back(choice.name);
    const auto index = indexIn(names);
    return index ? std::optional(choices[*index].value) : std::nullopt;
  }

  /// One of several names, or @p fallback where the key is missing.
  template <typename Choices, typename Value>
  Value choice(std::string_view key, const Choices& choices, Value fallback) const {
    return has(key) ? choice(key, choices) : fallback;
  }

 private:
  const Value* find(std::string_view key) const noexcept;
  const Value* required(std::string_view key) const;
  Node at(std::string_view key, const Value& value) const;
  std::optional<double> numberIn(
      std::string_view key, const Value& value, double least, double most) const;
  std::optional<std::int64_t> wholeNumberIn(
      std::string_view key, const Value& value, std::int64_t least, std::int64_t most) const;
  std::size_t chosenAt(std::string_view key, const std::vector<std::string_view>& names) const;
  std::optional<std::size_t> indexIn(const std::vector<std::string_view>& names) const;

  const Value* value_;
  std::string path_;
  Problems* problems_;
};

/// Reads JSON whose root @p read takes as a Node: what it returns; std::nullopt if there are
/// errors. All problems are added to @p problems.
template <typename T, typename Read>
std::optional<T> readJson(std::string_view text, Problems& problems, Read read) {
  Problems found;
  std::optional<T> result;
  if (const auto value = parseJson(text, found)) result = read(Node(*value, "$", found));
  problems.append(found);
  return found.hasErrors() ? std::nullopt : std::move(result);
}

/// Whether @p id is a name for people, files and columns (see Node::id()).
bool isSoundId(std::string_view id) noexcept;

/// What an id has to look like, as the fix of a problem with one that does not.
inline constexpr std::string_view kIdRule =
    "use a letter or digit, then letters, digits, '.', '_' or '-', at most 64 in all";

/// What kind of value this is: "a number", "a list".
std::string typeName(const Value& value);

/// @p number as a message may show it, without needless digits: 0.5, 1000000000.
std::string shown(double number);

/// @p text as a message may show it: a line without control characters, cut where it is long.
std::string shown(std::string_view text);

/// The one of @p known that @p word is probably a misspelling of.
std::optional<std::string_view> nearest(
    std::string_view word, std::span<const std::string_view> known);

}  // namespace questionnaires
