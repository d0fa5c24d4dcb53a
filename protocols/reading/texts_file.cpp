#include <stdexcept>

#include <nlohmann/json.hpp>

#include "protocols/reading/protocol_file.h"

namespace protocols {
namespace {

using questionnaires::LocalizedText;

constexpr std::string_view kTextsKey = "\"texts\"";
constexpr std::string_view kSpaces = " \t\r\n";

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump();
}

std::string asJson(const LocalizedText& text) {
  const auto& all = text.all();
  if (all.size() == 1 && text.has("en")) return quoted(text.in("en"));
  std::string json;
  for (const auto& [language, words] : all) {
    json += (json.empty() ? "{" : ", ") + quoted(language) + ": " + quoted(words);
  }
  return json + "}";
}

std::string asJson(const std::map<std::string, LocalizedText>& texts) {
  std::string json;
  for (const auto& [key, text] : texts) {
    json += (json.empty() ? "{\n    " : ",\n    ") + quoted(key) + ": " + asJson(text);
  }
  return json + "\n  }";
}

/// The index after the string that begins at @p start.
std::size_t endOfString(std::string_view json, std::size_t start) {
  std::size_t i = start + 1;
  while (i < json.size() && json[i] != '"') i += json[i] == '\\' ? 2 : 1;
  return i + 1;
}

/// The index after the value that begins at @p start, or after spaces that follow the value.
std::size_t endOfValue(std::string_view json, std::size_t start) {
  int depth = 0;
  std::size_t i = start;
  while (i < json.size()) {
    const char c = json[i];
    if (c == '"') {
      i = endOfString(json, i);
    } else if (depth == 0 && (c == ',' || c == '}' || c == ']')) {
      break;
    } else {
      depth += c == '{' || c == '[' ? 1 : c == '}' || c == ']' ? -1 : 0;
      ++i;
    }
    if (depth == 0 && i > start && (json[i - 1] == '}' || json[i - 1] == ']')) break;
  }
  return i;
}

struct Range {
  std::size_t begin = std::string_view::npos;
  std::size_t end = std::string_view::npos;
};

/// The positions of members in the outermost object: of all members together, and of the wanted one
/// with its key.
struct Members {
  Range all;
  Range wanted;
  std::size_t comma = std::string_view::npos;  ///< index of the comma before the wanted member;
                                               ///< npos if it is the first
};

/// @param key  key of the wanted member, in quotes.
Members membersOf(std::string_view json, std::string_view key) {
  Members members;
  std::size_t comma = std::string_view::npos;
  std::size_t i = json.find_first_not_of(kSpaces, json.find('{') + 1);
  members.all.begin = i;
  while (i < json.size() && json[i] == '"') {
    const auto nameEnd = endOfString(json, i);
    const auto value = json.find_first_not_of(kSpaces, json.find(':', nameEnd) + 1);
    const auto end = json.find_last_not_of(kSpaces, endOfValue(json, value) - 1) + 1;
    if (json.substr(i, nameEnd - i) == key) {
      members.wanted = {i, end};
      members.comma = comma;
    }
    members.all.end = end;
    i = json.find_first_not_of(kSpaces, end);
    if (i == std::string_view::npos || json[i] != ',') break;
    comma = i;
    i = json.find_first_not_of(kSpaces, i + 1);
  }
  if (members.all.end == std::string_view::npos) {
    throw std::invalid_argument("no JSON object with members");
  }
  return members;
}

/// @p json with @p value as the value of the member @p key (in quotes) of its outermost object.
std::string withValue(std::string_view json, std::string_view key, std::string_view value) {
  const auto member = membersOf(json, key).wanted;
  if (member.begin == std::string_view::npos) throw std::invalid_argument("no such member");
  const auto written = std::string(key) + ": " + std::string(value);
  return std::string(json).replace(member.begin, member.end - member.begin, written);
}

}  // namespace

std::string withName(std::string_view json, const std::string& id, const std::string& title) {
  constexpr std::string_view kStudy = "\"study\"";
  const auto member = membersOf(json, kStudy).wanted;
  if (member.begin == std::string_view::npos) throw std::invalid_argument("no study");
  const auto begin = json.find('{', member.begin);
  auto study = withValue(json.substr(begin, member.end - begin), "\"id\"", quoted(id));
  study = withValue(study, "\"title\"", quoted(title));
  return withValue(json, kStudy, study);
}

std::string withTexts(std::string_view json, const std::map<std::string, LocalizedText>& texts) {
  const auto members = membersOf(json, kTextsKey);
  const bool isThere = members.wanted.begin != std::string_view::npos;
  std::string result(json);
  if (texts.empty()) {
    if (!isThere) return result;
    const bool isFirst = members.comma == std::string_view::npos;
    const auto begin = isFirst ? members.wanted.begin : members.comma;
    auto end = members.wanted.end;
    if (isFirst) end = json.find_first_not_of(kSpaces, json.find(',', end) + 1);
    return result.erase(begin, end - begin);
  }
  const auto member = std::string(kTextsKey) + ": " + asJson(texts);
  if (isThere)
    return result.replace(members.wanted.begin, members.wanted.end - members.wanted.begin, member);
  return result.insert(members.all.end, ",\n  " + member);
}

}  // namespace protocols
