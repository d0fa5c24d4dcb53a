// JSON text to plain values, through the library's event interface: what its convenient one would
// let pass (duplicate keys, any depth) is seen here.
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_set>

#include <nlohmann/json.hpp>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace {

class TreeBuilder final : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(std::string_view text, Problems& problems) : text_(text), problems_(problems) {}

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
    std::get<Value::Object>(open_.back().value->data).push_back({value, {}});
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
      problems_.add(
          path(),
          where + ": the number " + shown(lastToken) + " is too large",
          "write a finite number");
      return false;
    }
    const std::string near = lastToken.empty() ? "" : ", near '" + ending(lastToken) + "'";
    problems_.add(
        path(),
        where + ": this is not JSON" + near,
        "look for a missing comma, quote or bracket just before it; JSON has no comments, no NaN "
        "and no text after its last bracket");
    return false;
  }

 private:
  struct Level {
    Value* value;
    std::size_t elements = 0;
    std::unordered_set<std::string> keys{};
  };

  static std::string lineAndColumn(std::string_view before) {
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const auto lineStart = before.rfind('\n');
    const auto column = before.size() - (lineStart == std::string_view::npos ? 0 : lineStart + 1);
    return "line " + std::to_string(line) + ", column " + std::to_string(column);
  }

  /// The token may hold anything, so only what is plainly printable is repeated.
  static std::string ending(const std::string& token) {
    constexpr std::size_t kShown = 40;
    std::string end = token.substr(token.size() > kShown ? token.size() - kShown : 0);
    std::replace_if(
        end.begin(), end.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
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
  Value root_;
  std::vector<Level> open_;
};

}  // namespace

std::optional<Value> parseJson(std::string_view text, Problems& problems) {
  if (text.size() > kLargestFile) {
    problems.add(
        "$",
        "the file is larger than " + std::to_string(kLargestFile / 1'000'000) + " MB",
        "no researcher's file needs that; is it the right file?");
    return std::nullopt;
  }
  TreeBuilder builder(text, problems);
  if (!nlohmann::json::sax_parse(text.begin(), text.end(), &builder)) return std::nullopt;
  return builder.takeRoot();
}

}  // namespace questionnaires
