#include "base/message.h"

#include <cstdlib>

#include <fmt/args.h>
#include <fmt/format.h>

namespace base {
namespace {

bool isPseudoLanguage() {
  // Read once; the program never sets its environment.
  static const bool isOn =
      std::getenv("PALPATE_PSEUDO_LANGUAGE") != nullptr;  // NOLINT(concurrency-mt-unsafe)
  return isOn;
}

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string pseudoTranslated(std::string_view pattern) {
  std::string text(pattern);
  // Each new letter depends on all letters before it. A pattern always gives the same text.
  std::uint64_t state = 0x9e3779b97f4a7c15U * (pattern.size() + 1);
  int depth = 0;
  for (char& c : text) {
    if (c == '{') ++depth;
    if (c == '}') --depth;
    if (depth > 0 || !isLetter(c)) continue;
    state = (state ^ static_cast<unsigned char>(c)) * 0xbf58476d1ce4e5b9U;
    c = static_cast<char>((c >= 'a' ? 'a' : 'A') + static_cast<char>((state >> 32U) % 26));
  }
  return text;
}

}  // namespace

std::string asDisplayed(std::string_view pattern) {
  return isPseudoLanguage() ? pseudoTranslated(pattern) : std::string(pattern);
}

std::string filled(std::string_view pattern, const std::vector<Argument>& arguments) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const auto& argument : arguments) {
    std::visit([&](const auto& value) { store.push_back(value); }, argument);
  }
  return fmt::vformat(asDisplayed(pattern), store);
}

std::string filled(std::string_view pattern, const NamedArguments& arguments) {
  fmt::dynamic_format_arg_store<fmt::format_context> store;
  for (const auto& named : arguments) {
    const auto add = [&](const auto& value) {
      store.push_back(fmt::arg(named.first.c_str(), value));
    };
    std::visit(add, named.second);
  }
  return fmt::vformat(asDisplayed(pattern), store);
}

std::string describe(const Message& message) {
  return message.empty() ? std::string() : filled(message.english(), message.arguments());
}

std::string describe(const std::vector<Message>& messages) {
  std::string text;
  for (const auto& message : messages) text += (text.empty() ? "" : "; ") + describe(message);
  return text;
}

}  // namespace base
