#include "protocols/model/blanks.h"

#include <algorithm>
#include <array>
#include <utility>

#include "protocols/model/messages.h"

namespace protocols {
namespace {

/// The blanks of the shipped texts, in the order of a form.
std::vector<std::pair<std::string_view, base::Message>> knownBlanks() {
  return {
      {"institution", message("blank.institution")},
      {"contact", message("blank.contact")},
      {kDurationBlank, message("blank.duration")},
      {"ethics", message("blank.ethics")},
      {"delete_until", message("blank.delete_until")},
      {"names_seen_by", message("blank.names_seen_by")},
      {"names_destroyed", message("blank.names_destroyed")},
      {"data_kept_years", message("blank.data_kept_years")},
      {"data_protection_officer", message("blank.data_protection_officer")},
      {"data_protection_authority", message("blank.data_protection_authority")},
  };
}

}  // namespace

std::vector<Blank> blanksOf(const LoadedProtocol& loaded) {
  std::vector<Blank> blanks;
  const auto add = [&](const std::string& key, const base::Message& title) {
    const auto text = loaded.protocol.texts.find(key);
    const bool isFilled = text != loaded.protocol.texts.end();
    blanks.push_back({key, title, isFilled ? text->second : LocalizedText()});
  };
  const auto known = knownBlanks();
  for (const auto& [key, title] : known) {
    if (std::ranges::find(loaded.blanks, key) != loaded.blanks.end()) add(std::string(key), title);
  }
  for (const auto& key : loaded.blanks) {
    const bool isKnown =
        std::ranges::any_of(known, [&](const auto& one) { return one.first == key; });
    if (!isKnown) add(key, message("blank.own", key));
  }
  return blanks;
}

}  // namespace protocols
