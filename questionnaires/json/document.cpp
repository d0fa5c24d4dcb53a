#include "questionnaires/json/document.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "base/joined.h"
#include "base/search.h"

namespace questionnaires {
namespace {

/// Advice where a number is expected and @p value may be a number in quotation marks: "8", "60 s",
/// "0,5". Otherwise @p usual.
std::string adviceOnNumber(const Value& value, const std::string& usual) {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) return usual;
  const auto end = text->find_first_not_of("0123456789.,-+");
  auto number = text->substr(0, end);
  std::ranges::replace(number, ',', '.');
  const bool isNumber = number.find_first_of("0123456789") != std::string::npos &&
                        std::ranges::count(number, '.') <= 1;
  if (!isNumber) return usual;
  return (end == std::string::npos ? "write it without quotation marks: "
                                   : "write the number alone, without quotation marks: ") +
         shown(number);
}

/// Advice where true or false is expected.
std::string adviceOnFlag(const Value& value) {
  const auto* text = std::get_if<std::string>(&value.data);
  return text == nullptr ? "" : "write true or false, without quotation marks";
}

/// The longest of @p names with which @p word begins: "holm" of "holm-bonferroni".
std::optional<std::string_view> beginningOf(
    std::string_view word, std::span<const std::string_view> names) {
  constexpr std::size_t kShortest = 3;
  std::optional<std::string_view> longest;
  for (const auto name : names) {
    if (name.size() < kShortest || !word.starts_with(name)) continue;
    if (!longest || name.size() > longest->size()) longest = name;
  }
  return longest;
}

}  // namespace

std::string Node::pathOf(std::string_view key) const {
  return key.empty() ? path_ : path_ + "." + shown(key);
}

void Node::problem(std::string_view key, std::string what, std::string fix) const {
  problems_->add(pathOf(key), std::move(what), std::move(fix));
}

void Node::warn(std::string_view key, base::Message what, base::Message fix) const {
  problems_->warn(pathOf(key), std::move(what), std::move(fix));
}

bool Node::isSound() const {
  const auto& all = problems_->all();
  return std::ranges::none_of(all, [&](const auto& p) {
    return p.severity == Severity::Error && p.path.starts_with(path_);
  });
}

bool Node::isObjectWithOnlyKeys(std::span<const std::string_view> names) const {
  const auto* object = std::get_if<Value::Object>(&value_->data);
  if (object == nullptr) {
    problem("", "an object is expected here, not " + typeName(*value_), "write { … }");
    return false;
  }
  for (const auto& member : *object) {
    if (base::contains(names, member.key)) continue;
    const auto meant = nearest(member.key, names);
    problem(
        member.key,
        "unknown key '" + shown(member.key) + "'",
        meant ? "did you mean '" + std::string(*meant) + "'?"
              : "known here: " + base::joined(names, ", "));
  }
  return true;
}

const Value* Node::find(std::string_view key) const noexcept {
  const auto* object = std::get_if<Value::Object>(&value_->data);
  if (object == nullptr) return nullptr;
  const auto member = std::ranges::find_if(*object, [&](const auto& m) { return m.key == key; });
  return member == object->end() ? nullptr : &member->value;
}

const Value* Node::required(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) {
    problem("", "'" + std::string(key) + "' is missing", "add it");
  }
  return value;
}

Node Node::at(std::string_view key, const Value& value) const {
  return {value, pathOf(key), *problems_};
}

std::string Node::asText() const {
  if (const auto* text = std::get_if<std::string>(&value_->data)) return *text;
  problem("", "a text is expected here, not " + typeName(*value_), "write \"…\"");
  return {};
}

std::string Node::text(std::string_view key) const {
  const Value* value = required(key);
  if (value == nullptr) return {};
  std::string result = at(key, *value).asText();
  if (result.empty() && std::holds_alternative<std::string>(value->data)) {
    problem(key, "this text is empty", "write something");
  }
  return result;
}

std::string Node::text(std::string_view key, std::string fallback) const {
  return has(key) ? at(key, *find(key)).asText() : std::move(fallback);
}

void Node::requireFormat(std::string_view key, std::string_view format, std::string fix) const {
  const std::string name(key);
  const std::string wanted(format);
  if (!has(key)) {
    problem("", "'" + name + "' is missing", "write \"" + name + "\": \"" + wanted + "\"");
    return;
  }
  const auto written = text(key);
  if (written.empty() || written == format) return;
  if (fix.empty()) fix = "this program reads " + wanted;
  problem(key, "this is written for '" + shown(written) + "'", std::move(fix));
}

std::string Node::id(std::string_view key) const {
  const Value* value = required(key);
  if (value == nullptr) return {};
  std::string result = at(key, *value).asText();
  if (std::holds_alternative<std::string>(value->data) && !isValidId(result)) {
    problem(key, "'" + shown(result) + "' cannot be an id", std::string(kIdRule));
  }
  return result;
}

std::optional<double> Node::numberIn(
    std::string_view key, const Value& value, double least, double most) const {
  double number = 0.0;
  if (const auto* whole = std::get_if<std::int64_t>(&value.data)) {
    number = static_cast<double>(*whole);
  } else if (const auto* real = std::get_if<double>(&value.data)) {
    number = *real;
  } else {
    problem(key, "a number is expected here, not " + typeName(value), adviceOnNumber(value, ""));
    return std::nullopt;
  }
  if (!(number >= least && number <= most)) {
    problem(
        key,
        "this number is out of range",
        "write a number from " + shown(least) + " to " + shown(most));
    return std::nullopt;
  }
  return number;
}

double Node::number(std::string_view key, double least, double most) const {
  const Value* value = required(key);
  return value == nullptr ? least : numberIn(key, *value, least, most).value_or(least);
}

double Node::number(std::string_view key, double least, double most, double fallback) const {
  const Value* value = find(key);
  return value == nullptr ? fallback : numberIn(key, *value, least, most).value_or(fallback);
}

std::optional<std::int64_t> Node::wholeNumberIn(
    std::string_view key, const Value& value, std::int64_t least, std::int64_t most) const {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  if (whole == nullptr) {
    const bool isFraction = std::holds_alternative<double>(value.data);
    problem(
        key,
        std::string("a whole number is expected here, not ") +
            (isFraction ? "one with a decimal point" : typeName(value)),
        adviceOnNumber(value, "write it with digits only, without a decimal point"));
    return std::nullopt;
  }
  if (*whole < least || *whole > most) {
    problem(
        key,
        "this number is out of range",
        "write a whole number from " + std::to_string(least) + " to " + std::to_string(most));
    return std::nullopt;
  }
  return *whole;
}

std::int64_t Node::wholeNumber(std::string_view key, std::int64_t least, std::int64_t most) const {
  const Value* value = required(key);
  return value == nullptr ? least : wholeNumberIn(key, *value, least, most).value_or(least);
}

std::int64_t Node::wholeNumber(
    std::string_view key, std::int64_t least, std::int64_t most, std::int64_t fallback) const {
  const Value* value = find(key);
  return value == nullptr ? fallback : wholeNumberIn(key, *value, least, most).value_or(fallback);
}

bool Node::flag(std::string_view key, bool fallback) const {
  const Value* value = find(key);
  if (value == nullptr) return fallback;
  if (const auto* flag = std::get_if<bool>(&value->data)) return *flag;
  problem(key, "true or false is expected here, not " + typeName(*value), adviceOnFlag(*value));
  return fallback;
}

std::optional<std::size_t> Node::indexIn(const std::vector<std::string_view>& names) const {
  const auto* text = std::get_if<std::string>(&value_->data);
  if (text == nullptr) {
    problem(
        "",
        "a text is expected here, not " + typeName(*value_),
        "one of: " + base::joined(names, ", "));
    return std::nullopt;
  }
  const auto found = std::ranges::find(names, *text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const auto begun = beginningOf(*text, names);
  const auto meant = begun ? begun : nearest(*text, names);
  problem(
      "",
      "unknown word '" + shown(*text) + "'",
      (meant ? "did you mean '" + std::string(*meant) + "'? " : "") +
          "one of: " + base::joined(names, ", "));
  return std::nullopt;
}

}  // namespace questionnaires
