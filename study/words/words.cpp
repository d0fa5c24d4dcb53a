#include "study/words/words.h"

#include <cctype>

namespace study::words {
namespace {

bool isDigit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool isWordEnd(std::string_view text, std::size_t at) {
  return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

/// Where the number that begins at @p at ends: "3", "0.017", "5e-05".
std::size_t endOfNumber(std::string_view text, std::size_t at) {
  const auto digits = [&](std::size_t from) {
    while (from < text.size() && isDigit(text[from])) ++from;
    return from;
  };
  std::size_t end = digits(at);
  if (end + 1 < text.size() && text[end] == '.' && isDigit(text[end + 1])) end = digits(end + 1);
  if (end + 2 < text.size() && text[end] == 'e' && (text[end + 1] == '-' || text[end + 1] == '+')) {
    end = digits(end + 2);
  }
  return end;
}

/// A sentence with {} for its numbers and quoted names, and those.
struct Holes {
  std::string pattern;
  std::vector<std::string> fillings;
};

Holes holesIn(std::string_view text) {
  Holes holes;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    if (isDigit(text[at]) && isWordEnd(text, at)) end = endOfNumber(text, at);
    if (text[at] == '\'' && isWordEnd(text, at)) {
      const auto closing = text.find('\'', at + 1);
      if (closing != std::string_view::npos) end = closing + 1;
    }
    if (end == at) {
      holes.pattern += text[at++];
      continue;
    }
    holes.pattern += "{}";
    holes.fillings.emplace_back(text.substr(at, end - at));
    at = end;
  }
  return holes;
}

std::string filledIn(std::string_view pattern, const std::vector<std::string>& fillings) {
  std::string text;
  std::size_t next = 0;
  for (std::size_t at = 0; at < pattern.size(); ++at) {
    if (pattern.substr(at, 2) == "{}" && next < fillings.size()) {
      text += fillings[next++];
      ++at;
    } else {
      text += pattern[at];
    }
  }
  return text;
}

}  // namespace

const std::string& Words::operator()(std::string_view english) const {
  const auto found = catalogue_.find(english);
  if (found != catalogue_.end()) return found->second;
  return *missing_.emplace(english).first;
}

std::string Words::known(std::string_view words) const {
  if (const auto found = catalogue_.find(words); found != catalogue_.end()) return found->second;
  const auto holes = holesIn(words);
  const auto found = catalogue_.find(holes.pattern);
  if (found != catalogue_.end()) return filledIn(found->second, holes.fillings);
  const auto colon = words.find(": ");
  if (colon == std::string_view::npos) return std::string(words);
  return known(words.substr(0, colon)) + std::string(words.substr(colon));
}

std::string Words::knownList(std::string_view words) const {
  const auto end = words.find("; ");
  if (end == std::string_view::npos) return known(words);
  return known(words.substr(0, end)) + "; " + knownList(words.substr(end + 2));
}

}  // namespace study::words
