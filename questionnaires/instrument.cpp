#include "questionnaires/instrument.h"

#include <algorithm>
#include <iterator>

namespace questionnaires {

const Item* Instrument::item(std::string_view itemId) const noexcept {
  const auto found = std::find_if(
      items.begin(), items.end(), [&](const Item& candidate) { return candidate.id == itemId; });
  return found == items.end() ? nullptr : &*found;
}

std::vector<Item> Instrument::itemsOf(std::string_view set) const {
  std::vector<Item> result;
  std::copy_if(items.begin(), items.end(), std::back_inserter(result), [&](const Item& candidate) {
    return set.empty() || candidate.set == set;
  });
  return result;
}

}  // namespace questionnaires
