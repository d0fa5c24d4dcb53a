#include "study/gui/authoring/json_places.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace study::gui {
namespace {

/// Walks through JSON and remembers where the longest part of a path stands that it came by.
class PlaceFinder {
 public:
  PlaceFinder(std::string_view json, std::string_view wanted) : json_(json), wanted_(wanted) {}

  std::size_t find() {
    value("$", 0);
    return found_;
  }

 private:
  /// @param begin  where the key stands, or the value where it has none.
  bool value(const std::string& path, std::size_t begin) {
    if (!leadsToWanted(path)) return skip();
    if (path.size() > length_ || length_ == 0) {
      length_ = path.size();
      found_ = begin;
    }
    space();
    if (peek() == '{') return object(path);
    if (peek() == '[') return list(path);
    return skip();
  }

  bool object(const std::string& path) {
    ++at_;
    while (true) {
      space();
      if (peek() == ',') {
        ++at_;
        continue;
      }
      if (peek() != '"') return peek() == '}' && ++at_ > 0;
      const std::size_t begin = at_;
      if (!text()) return false;
      const std::string key(json_.substr(begin + 1, at_ - begin - 2));
      space();
      if (peek() != ':') return false;
      ++at_;
      space();
      if (!value(path + "." + key, begin)) return false;
    }
  }

  bool list(const std::string& path) {
    ++at_;
    for (int index = 0;; ++index) {
      space();
      if (peek() == ']') return ++at_ > 0;
      if (index > 0) {
        if (peek() != ',') return false;
        ++at_;
        space();
      }
      if (!value(path + "[" + std::to_string(index) + "]", at_)) return false;
    }
  }

  /// Past a value, whatever it is; false where the text ends in it.
  bool skip() {
    space();
    int depth = 0;
    while (at_ < json_.size()) {
      const char c = json_[at_];
      if (c == '"') {
        if (!text()) return false;
      } else if (c == '{' || c == '[') {
        ++depth;
        ++at_;
      } else if (c == '}' || c == ']') {
        if (depth == 0) return true;
        --depth;
        ++at_;
      } else if (c == ',' && depth == 0) {
        return true;
      } else {
        ++at_;
        continue;
      }
      if (depth == 0) return true;
    }
    return false;
  }

  bool text() {
    for (++at_; at_ < json_.size(); ++at_) {
      if (json_[at_] == '\\') {
        ++at_;
      } else if (json_[at_] == '"') {
        return ++at_ > 0;
      }
    }
    return false;
  }

  void space() {
    while (at_ < json_.size() &&
           std::string_view(" \t\r\n").find(json_[at_]) != std::string::npos) {
      ++at_;
    }
  }

  char peek() const { return at_ < json_.size() ? json_[at_] : '\0'; }

  bool leadsToWanted(const std::string& path) const {
    if (!wanted_.starts_with(path)) return false;
    const bool isWhole = wanted_.size() == path.size();
    return isWhole || wanted_[path.size()] == '.' || wanted_[path.size()] == '[';
  }

  std::string_view json_;
  std::string_view wanted_;
  std::size_t at_ = 0;
  std::size_t found_ = 0;
  std::size_t length_ = 0;  ///< of the part that was found
};

int lineAt(std::string_view text, std::size_t place) {
  return static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(place), '\n'));
}

}  // namespace

int lineOf(std::string_view json, std::string_view path) {
  return lineAt(json, PlaceFinder(json, path).find());
}

int lineOf(std::string_view json, const questionnaires::Problem& problem) {
  constexpr std::string_view kLine = "line ";
  if (problem.what.starts_with(kLine)) {
    int line = 0;
    const char* end = problem.what.data() + problem.what.size();
    const auto read = std::from_chars(problem.what.data() + kLine.size(), end, line);
    if (read.ec == std::errc() && line > 0) return line - 1;
  }
  // "information-punch $.introduction.en" is about another file: shown is where that is named.
  const auto name = std::string_view(problem.path).substr(0, problem.path.find(' '));
  if (!name.empty() && name.front() != '$') {
    const auto place = json.find("\"" + std::string(name) + "\"");
    return place == std::string_view::npos ? 0 : lineAt(json, place);
  }
  return lineOf(json, std::string_view(problem.path));
}

}  // namespace study::gui
