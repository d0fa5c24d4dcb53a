#include "study/export/column.h"

#include <array>

namespace study {

std::string_view nameOf(ColumnType type) noexcept {
  constexpr std::array<std::string_view, 5> kNames{
      "text", "integer", "number", "boolean", "date_time"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string Readers::inDeviceWords(const std::string& description) const {
  if (device == nullptr) return description;
  for (const auto& sentence : device->sentences) {
    if (sentence.language == "en" && sentence.english == description)
      return std::string(sentence.text);
  }
  return description;
}

}  // namespace study
