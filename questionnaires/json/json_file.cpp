// Parses JSON with the event (SAX) interface of nlohmann::json, because its tree interface accepts
// duplicate keys and any nesting depth.
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <string>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace {

/// An iterator over characters that stores its position in a variable of its creator.
class PositionTrackingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  PositionTrackingIterator(const char* at, const char*& reached) : at_(at), reached_(&reached) {}

  reference operator*() const { return *at_; }
  PositionTrackingIterator& operator++() {
    *reached_ = ++at_;
    return *this;
  }
  bool operator==(const PositionTrackingIterator& other) const { return at_ == other.at_; }

 private:
  const char* at_;
  const char** reached_;
};

class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, Problems& problems)
      : text_(text), problems_(problems), reached_(text.data()), counted_(text.data()) {}

  /// Parses the text; false if it is not JSON. The tree then contains the part before the error.
  bool read() {
    const char* begin = text_.data();
    return nlohmann::json::sax_parse(
        PositionTrackingIterator(begin, reached_),
        PositionTrackingIterator(begin + text_.size(), reached_),
        this);
  }

  Value takeRoot() { return std::move(root_); }

  bool null() override { return put({nullptr}); }
  bool boolean(bool value) override { return put({value}); }
  bool number_integer(number_integer_t value) override {
    return put({static_cast<std::int64_t>(value)});
  }
  bool number_unsigned(number_unsigned_t value) override {
    if (value <= static_cast<number_unsigned_t>(std::numeric_limits<std::int64_t>::max())) {
      return put({static_cast<std::int64_t>(value)});
    }
    return put({static_cast<double>(value)});
  }
  bool number_float(number_float_t value, const string_t& /*source*/) override {
    return put({value});
  }
  bool string(string_t& value) override {
    const Value* text = put({std::move(value)});
    if (text != nullptr) checkText(std::get<std::string>(text->data));
    return text != nullptr;
  }
  bool binary(binary_t& /*value*/) override { return false; }

  bool start_object(std::size_t /*size*/) override { return open(Value{Value::Object{}}); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*size*/) override { return open(Value{Value::Array{}}); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override {
    std::get<Value::Object>(open_.back().value->data).push_back({value, {.line = line()}});
    checkText(value);
    if (!open_.back().keys.insert(value).second) {
      problems_.add(
          path(), "the key '" + shown(value) + "' stands here twice", "keep one of the two");
    }
    return true;
  }

  bool parse_error(
      std::size_t position,
      const std::string& lastToken,
      const nlohmann::detail::exception& error) override {
    const std::string where = lineAndColumn(text_.substr(0, position));
    if (dynamic_cast<const nlohmann::detail::out_of_range*>(&error) != nullptr) {
      addProblem(
          position,
          where + ": the number " + shown(lastToken) + " is too large",
          "write a finite number");
      return false;
    }
    const std::string near = lastToken.empty() ? "" : ", near '" + tokenEnd(lastToken) + "'";
    if (!utf8CharacterCount(text_)) {
      addProblem(position, where + ": this is not JSON in UTF-8", "save the file as UTF-8");
      return false;
    }
    addProblem(position, where + ": this is not JSON" + near, adviceOn(position, lastToken));
    return false;
  }

 private:
  struct OpenContainer {
    Value* value;
    std::size_t elements = 0;
    std::unordered_set<std::string> keys{};
  };

  /// Advice on a token that JSON does not allow where it ends at @p position.
  std::string adviceOn(std::size_t position, const std::string& token) const {
    const auto upTo = text_.substr(0, std::min(position, text_.size()));
    const auto before = upTo.substr(0, upTo.size() - std::min(token.size(), upTo.size()));
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const bool isDecimalComma = before.size() > 1 && before.back() == ',' &&
                                isDigit(before[before.size() - 2]) && !token.empty() &&
                                isDigit(token.front());
    if (isDecimalComma) return "write numbers with a decimal point: 0.05";
    // the text, since the parser's token of a bracket or comma has what stands before it as well
    const char end = upTo.empty() ? '\0' : upTo.back();
    const auto rest = upTo.substr(0, upTo.empty() ? 0 : upTo.size() - 1);
    const auto last = rest.find_last_not_of(" \t\r\n");
    const char previous = last == std::string_view::npos ? '\0' : rest[last];
    const bool isAtEnd = (end == ']' || end == '}') && previous == ',';
    const bool isAtComma = end == ',' && (previous == ',' || previous == '[' || previous == '{');
    if (isAtEnd || isAtComma) return "remove the comma that is too many";
    constexpr std::string_view kCurlyQuotes = "\xE2\x80";  // the first two bytes of each
    const auto start = upTo.empty() ? 0 : upTo.size() - 1;
    const bool isCurly = text_.substr(start).starts_with(kCurlyQuotes) ||
                         token.find(kCurlyQuotes) != std::string::npos;
    if (isCurly) return "write straight quotation marks: \"…\"";
    return "look for a missing comma, quote or bracket just before it; JSON has no comments, no "
           "NaN "
           "and no text after its last bracket";
  }

  /// Adds a problem about the JSON syntax.
  void addProblem(std::size_t position, std::string what, std::string fix) {
    const auto before = text_.substr(0, position);
    problems_.add(
        {.path = path(),
         .what = base::Message::verbatim(std::move(what)),
         .fix = base::Message::verbatim(std::move(fix)),
         .line = static_cast<int>(std::ranges::count(before, '\n'))});
  }

  /// The line of the token that was read last. The last character read is ignored: after a number
  /// it is the next character, which may be a line end.
  int line() {
    const char* const end = reached_ > counted_ ? reached_ - 1 : counted_;
    line_ += static_cast<int>(std::count(counted_, end, '\n'));
    counted_ = end;
    return line_;
  }

  static std::string lineAndColumn(std::string_view before) {
    const auto line = 1 + std::ranges::count(before, '\n');
    const auto lineStart = before.rfind('\n');
    const auto column = before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
  }

  /// The end of a token for a message. Characters that are not printable ASCII are replaced,
  /// because a token may contain any bytes.
  static std::string tokenEnd(const std::string& token) {
    constexpr std::size_t kShown = 40;
    std::string end = token.substr(token.size() > kShown ? token.size() - kShown : 0);
    std::ranges::replace_if(
        end, [](char c) { return c < 0x20 || c > 0x7e; }, '?');
    return end;
  }

  std::string path() const {
    std::string result = "$";
    for (const auto& level : open_) {
      if (const auto* object = std::get_if<Value::Object>(&level.value->data)) {
        if (!object->empty()) result += "." + shown(object->back().key);
      } else {
        result += "[" + std::to_string(level.elements == 0 ? 0 : level.elements - 1) + "]";
      }
    }
    return result;
  }

  void checkText(const std::string& value) {
    if (value.find('\0') != std::string::npos) {
      problems_.add(path(), "a text holds the character NUL", "remove \\u0000");
    }
    if (value.size() > kLongestText) {
      problems_.add(
          path(),
          "a text is longer than " + std::to_string(kLongestText) + " bytes",
          "shorten it; long material belongs in a document of its own");
    }
  }

  Value* put(Value value) {
    value.line = line();
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    if (++open_.back().elements > kMostElements) {
      problems_.add(
          path(),
          "more than " + std::to_string(kMostElements) + " elements",
          "no researcher's file needs that; is it the right file?");
      return nullptr;
    }
    if (auto* object = std::get_if<Value::Object>(&open_.back().value->data)) {
      value.line = object->back().value.line;
      object->back().value = std::move(value);
      return &object->back().value;
    }
    auto& array = std::get<Value::Array>(open_.back().value->data);
    array.push_back(std::move(value));
    return &array.back();
  }

  bool open(Value value) {
    if (open_.size() == kDeepestNesting) {
      problems_.add(
          path(),
          "nested deeper than " + std::to_string(kDeepestNesting) + " levels",
          "no researcher's file needs that; is it the right file?");
      return false;
    }
    Value* place = put(std::move(value));
    if (place == nullptr) return false;
    open_.push_back({place});
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  std::string_view text_;
  Problems& problems_;
  const char* reached_;  ///< position up to which the parser has read
  const char* counted_;  ///< position up to which line ends have been counted
  int line_ = 0;
  Value root_;
  std::vector<OpenContainer> open_;
};

/// The value at @p path, or its nearest existing ancestor. Keys may contain dots.
const Value& nearestValue(const Value& value, std::string_view path) {
  const auto next = [&](const Value& part, const std::string& step) -> const Value* {
    if (!path.starts_with(step)) return nullptr;
    const auto rest = path.substr(step.size());
    const bool isWhole = rest.empty() || rest.front() == '.' || rest.front() == '[';
    return isWhole ? &nearestValue(part, rest) : nullptr;
  };
  if (const auto* object = std::get_if<Value::Object>(&value.data)) {
    for (const auto& [key, part] : *object) {
      if (const auto* found = next(part, "." + shown(key))) return *found;
    }
  }
  if (const auto* array = std::get_if<Value::Array>(&value.data)) {
    for (std::size_t i = 0; i < array->size(); ++i) {
      if (const auto* found = next((*array)[i], "[" + std::to_string(i) + "]")) return *found;
    }
  }
  return value;
}

}  // namespace

int lineOf(std::string_view json, std::string_view path) {
  Problems ignored;
  TreeBuilder builder(json, ignored);
  builder.read();
  return nearestValue(builder.takeRoot(), path.substr(path.starts_with('$') ? 1 : 0)).line;
}

std::optional<Value> parseJson(std::string_view text, Problems& problems) {
  if (text.size() > kLargestFile) {
    problems.add(
        "$",
        "the file is larger than " + std::to_string(kLargestFile / 1'000'000) + " MB",
        "no researcher's file needs that; is it the right file?");
    return std::nullopt;
  }
  TreeBuilder builder(text, problems);
  if (!builder.read()) return std::nullopt;
  return builder.takeRoot();
}

}  // namespace questionnaires
