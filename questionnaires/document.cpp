#include "questionnaires/document.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace questionnaires {
namespace {

std::string inWords(double value) {
  std::string text = std::to_string(value);
  if (std::abs(value) >= 1e15) return std::abs(value) > 1e300 ? "any size" : text;
  while (text.find('.') != std::string::npos && (text.back() == '0' || text.back() == '.')) {
    const bool point = text.back() == '.';
    text.pop_back();
    if (point) break;
  }
  return text;
}

/// Edits (insert, delete, replace, swap of neighbours) that lead from one word to the other.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replace});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

std::string listed(std::span<const std::string_view> names) {
  std::string result;
  for (const auto name : names) result += (result.empty() ? "" : ", ") + std::string(name);
  return result;
}

const char* kindOf(const Value& value) {
  switch (value.data.index()) {
    case 0: return "null";
    case 1: return "true or false";
    case 2:
    case 3: return "a number";
    case 4: return "a text";
    case 5: return "a list";
    default: return "an object";
  }
}

}  // namespace

std::string inWords(const std::vector<Problem>& problems) {
  std::string text;
  for (const auto& problem : problems) {
    text += problem.severity == Severity::Error ? "error   " : "warning ";
    text += problem.path + ": " + problem.what;
    if (!problem.fix.empty()) text += "; " + problem.fix;
    text += '\n';
  }
  return text;
}

std::string readTextFile(const std::string& path) {
  namespace fs = std::filesystem;
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) {
    throw Error("There is no file " + path + ". Check the spelling and the folder.");
  }
  if (status.type() != fs::file_type::regular) {
    throw Error(path + " is not a file that can be read. Give the name of a text file.");
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw Error(
        path + " cannot be opened (" + std::generic_category().message(errno) +
        "). Check who may read it.");
  }
  if (fs::file_size(path, error) > kLargestFile) {
    throw Error(
        path + " is larger than " + std::to_string(kLargestFile / 1'000'000) +
        " MB. No researcher's file needs that; is it the right file?");
  }
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (file.bad()) throw Error(path + " could not be read to its end. Is the disk healthy?");
  return text;
}

bool isSoundId(std::string_view id) noexcept {
  const auto letterOrDigit = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  };
  constexpr std::size_t kLongest = 64;
  return !id.empty() && id.size() <= kLongest && letterOrDigit(id.front()) &&
         std::all_of(id.begin(), id.end(), [&](char c) {
           return letterOrDigit(c) || c == '.' || c == '_' || c == '-';
         });
}

std::optional<std::string_view> nearest(
    std::string_view word, std::span<const std::string_view> known) {
  constexpr std::size_t kLongestWord = 64;
  if (word.size() > kLongestWord) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t fewest = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (const auto name : known) {
    const std::size_t edits = editDistance(word, name);
    if (edits < fewest && edits < std::max(word.size(), name.size())) {
      fewest = edits;
      best = name;
    }
  }
  return best;
}

std::string Node::pathOf(std::string_view key) const {
  return key.empty() ? path_ : path_ + "." + std::string(key);
}

void Node::problem(std::string_view key, std::string what, std::string fix) const {
  problems_->add(pathOf(key), std::move(what), std::move(fix));
}

void Node::warning(std::string_view key, std::string what, std::string fix) const {
  problems_->warn(pathOf(key), std::move(what), std::move(fix));
}

bool Node::isObjectWith(std::initializer_list<std::string_view> known) const {
  const auto* object = std::get_if<Value::Object>(&value_->data);
  if (object == nullptr) {
    problem("", std::string("an object is expected here, not ") + kindOf(*value_), "write { … }");
    return false;
  }
  const std::span<const std::string_view> names(known.begin(), known.size());
  for (const auto& member : *object) {
    if (std::find(names.begin(), names.end(), member.key) != names.end()) continue;
    const auto meant = nearest(member.key, names);
    problem(
        member.key,
        "unknown key '" + member.key + "'",
        meant ? "did you mean '" + std::string(*meant) + "'?"
              : "known here: " + listed(names));
  }
  return true;
}

const Value* Node::find(std::string_view key) const noexcept {
  const auto* object = std::get_if<Value::Object>(&value_->data);
  if (object == nullptr) return nullptr;
  const auto member = std::find_if(
      object->begin(), object->end(), [&](const auto& m) { return m.key == key; });
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
  problem("", std::string("a text is expected here, not ") + kindOf(*value_), "write \"…\"");
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
  return has(key) ? at(key, *find(key)).asText() : fallback;
}

std::string Node::id(std::string_view key) const {
  const Value* value = required(key);
  if (value == nullptr) return {};
  std::string result = at(key, *value).asText();
  if (std::holds_alternative<std::string>(value->data) && !isSoundId(result)) {
    problem(
        key,
        "'" + result.substr(0, 80) + "' cannot be an id",
        "use a letter or digit, then letters, digits, '.', '_' or '-', at most 64 in all");
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
    problem(key, std::string("a number is expected here, not ") + kindOf(value));
    return std::nullopt;
  }
  if (!(number >= least && number <= most)) {
    problem(
        key,
        "this number is out of range",
        "write a number from " + inWords(least) + " to " + inWords(most));
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
    problem(key, std::string("a whole number is expected here, not ") + kindOf(value),
            "write it without a decimal point");
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

std::int64_t Node::wholeNumber(
    std::string_view key, std::int64_t least, std::int64_t most) const {
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
  problem(key, std::string("true or false is expected here, not ") + kindOf(*value));
  return fallback;
}

std::optional<Node> Node::object(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  if (!std::holds_alternative<Value::Object>(value->data)) {
    problem(key, std::string("an object is expected here, not ") + kindOf(*value), "write { … }");
    return std::nullopt;
  }
  return at(key, *value);
}

std::optional<Node> Node::requiredObject(std::string_view key) const {
  return required(key) == nullptr ? std::nullopt : object(key);
}

std::vector<Node> Node::list(std::string_view key) const {
  const Value* value = find(key);
  if (value == nullptr) return {};
  const auto* array = std::get_if<Value::Array>(&value->data);
  if (array == nullptr) {
    problem(key, std::string("a list is expected here, not ") + kindOf(*value), "write [ … ]");
    return {};
  }
  std::vector<Node> nodes;
  for (std::size_t i = 0; i < array->size(); ++i) {
    nodes.emplace_back((*array)[i], pathOf(key) + "[" + std::to_string(i) + "]", *problems_);
  }
  return nodes;
}

std::vector<Node> Node::requiredList(std::string_view key) const {
  const Value* value = required(key);
  if (value == nullptr) return {};
  auto nodes = list(key);
  if (nodes.empty() && std::holds_alternative<Value::Array>(value->data)) {
    problem(key, "this list is empty", "it needs at least one entry");
  }
  return nodes;
}

std::vector<std::pair<std::string, Node>> Node::members() const {
  std::vector<std::pair<std::string, Node>> result;
  if (const auto* object = std::get_if<Value::Object>(&value_->data)) {
    for (const auto& member : *object) {
      result.emplace_back(member.key, at(member.key, member.value));
    }
  }
  return result;
}

std::vector<std::string> Node::texts(std::string_view key) const {
  std::vector<std::string> result;
  for (const auto& node : list(key)) result.push_back(node.asText());
  return result;
}

std::vector<std::string> Node::ids(std::string_view key) const {
  std::vector<std::string> result;
  std::set<std::string> seen;
  for (const auto& node : list(key)) {
    std::string id = node.asText();
    if (node.isText() && !isSoundId(id)) {
      node.problem("", "'" + id.substr(0, 80) + "' cannot be an id", "");
    }
    if (node.isText() && !seen.insert(id).second) {
      node.problem("", "'" + id + "' stands in this list twice", "keep one");
    }
    result.push_back(std::move(id));
  }
  return result;
}

std::size_t Node::chosen(
    std::string_view key, const std::vector<std::string_view>& names) const {
  const Value* value = required(key);
  if (value == nullptr) return 0;
  const auto* text = std::get_if<std::string>(&value->data);
  if (text == nullptr) {
    problem(
        key, std::string("a text is expected here, not ") + kindOf(*value),
        "one of: " + listed(names));
    return 0;
  }
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  const auto meant = nearest(*text, names);
  problem(
      key,
      "unknown word '" + text->substr(0, 80) + "'",
      (meant ? "did you mean '" + std::string(*meant) + "'? " : "") + "one of: " + listed(names));
  return 0;
}

}  // namespace questionnaires
