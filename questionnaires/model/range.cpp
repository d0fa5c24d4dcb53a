#include "questionnaires/model/range.h"

namespace questionnaires {

std::optional<Range> rangeOf(const Item& item) noexcept {
  switch (item.type) {
    case ItemType::Likert:
    case ItemType::SemanticDifferential:
      return Range{
          static_cast<double>(item.scale.lowest), static_cast<double>(item.scale.highest())};
    case ItemType::Slider:
    case ItemType::Number:
      return Range{item.least, item.most};
    default:
      return std::nullopt;
  }
}

}  // namespace questionnaires
