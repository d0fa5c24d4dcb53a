#include "study/words/words.h"

#include "base/joined.h"

namespace study::words {

std::string_view Words::patternOf(
    const Catalogue::Entries& entries, std::string_view key, std::string_view english) const {
  const auto found = entries.find(key);
  if (found != entries.end()) return found->second;
  missing_.emplace(key);
  return english;
}

std::string Words::operator()(std::string_view english) const {
  return base::asDisplayed(patternOf(catalogue_.texts, english, english));
}

std::string Words::operator()(const base::Message& message) const {
  if (message.empty() || message.key().empty()) return base::describe(message);
  return base::filled(
      patternOf(catalogue_.messages, message.key(), message.english()), message.arguments());
}

std::string Words::operator()(const std::vector<base::Message>& messages) const {
  return base::joined(messages, "; ", *this);
}

}  // namespace study::words
