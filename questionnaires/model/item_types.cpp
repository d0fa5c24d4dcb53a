#include "questionnaires/model/item_types.h"

namespace questionnaires {

std::string_view nameOf(ItemType type) noexcept {
  for (const auto& known : kItemTypes) {
    if (known.value == type) return known.name;
  }
  return {};
}

}  // namespace questionnaires
