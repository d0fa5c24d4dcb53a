#include "study/export/coarsening.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "study/storage/answer_repository.h"

namespace study {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;
using questionnaires::Option;

/// The smallest of 1, 2 and 5 times a power of ten that is at least @p least.
double roundWidth(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double times : {1.0, 2.0, 5.0}) {
    // the tolerance keeps a rounding error in `power` from giving the next wider band
    if (times * power >= least * (1.0 - 1e-12)) return times * power;
  }
  return 10.0 * power;
}

bool isBand(const Option& option) {
  return !option.id.empty() && std::isdigit(static_cast<unsigned char>(option.id.front())) != 0;
}

/// Groups of @p groupSize neighbouring options that are bands; every other option is a group of its
/// own.
std::vector<std::vector<Option>> groupsOfNeighbours(
    const std::vector<Option>& options, std::size_t groupSize) {
  std::vector<std::vector<Option>> groups;
  bool isOpen = false;
  for (const auto& option : options) {
    if (!isOpen || !isBand(option) || groups.back().size() == groupSize) groups.emplace_back();
    groups.back().push_back(option);
    isOpen = isBand(option);
  }
  return groups;
}

}  // namespace

PublicForm publicFormOf(const Item& item) noexcept {
  const bool isListed = item.optionSource == questionnaires::OptionSource::Listed;
  switch (item.type) {
    case ItemType::Number:
      return PublicForm::Bands;
    case ItemType::SingleChoice:
      return isListed ? PublicForm::Options : PublicForm::None;
    case ItemType::MultipleChoice:
      return isListed ? PublicForm::Sets : PublicForm::None;
    case ItemType::Likert:
    case ItemType::SemanticDifferential:
    case ItemType::Slider:
    case ItemType::PairwiseChoice:
    case ItemType::ShortText:
    case ItemType::LongText:
      break;
  }
  return PublicForm::None;
}

GeneralisationHierarchy::GeneralisationHierarchy(const Item& item, std::string_view language) {
  switch (publicFormOf(item)) {
    case PublicForm::Bands:
      addBands(item);
      break;
    case PublicForm::Options:
      addOptions(item, language);
      break;
    case PublicForm::Sets:
      levels_.emplace_back();
      break;
    case PublicForm::None:
      break;
  }
}

void GeneralisationHierarchy::addBands(const Item& item) {
  const double range = item.most - item.least;
  if (!(range > 0.0) || !std::isfinite(range)) return;
  const double first = roundWidth(std::max(range / 20.0, 5.0 * item.step));
  isWhole_ = item.step >= 1.0 && std::floor(item.step) == item.step;
  for (double width = first; width < range; width *= 2.0) {
    GeneralisationLevel level{.values = {}, .byOption = {}, .width = width};
    for (double from = std::floor(item.least / width) * width; from <= item.most; from += width) {
      const auto text = bandLabel(from, width);
      level.values.push_back({text, item.unit.empty() ? text : text + " " + item.unit});
    }
    levels_.push_back(std::move(level));
  }
}

void GeneralisationHierarchy::addOptions(const Item& item, std::string_view language) {
  std::size_t before = 0;
  for (std::size_t groupSize = 1;; groupSize *= 2) {
    const auto groups = groupsOfNeighbours(item.options, groupSize);
    if (groups.size() == before) return;
    before = groups.size();
    GeneralisationLevel level;
    for (const auto& group : groups) {
      Level joined{group.front().id, group.front().text.in(language)};
      if (group.size() > 1) {
        joined.value += " to " + group.back().id;
        joined.label += " to " + group.back().text.in(language);
      }
      for (const auto& option : group) level.byOption[option.id] = joined.value;
      level.values.push_back(std::move(joined));
    }
    levels_.push_back(std::move(level));
  }
}

std::optional<double> GeneralisationHierarchy::bandWidth() const {
  if (levels_.empty() || levels_.front().width <= 0.0) return std::nullopt;
  return levels_.front().width;
}

std::string GeneralisationHierarchy::bandLabel(double from, double width) const {
  // nine decimals remove the rounding errors of sums of widths; + 0.0 makes -0 a plain 0
  const auto rounded = [](double value) {
    return exactDecimal(std::round(value * 1e9) / 1e9 + 0.0);
  };
  return rounded(from) + " to " +
         (isWhole_ ? rounded(from + width - 1.0) : "<" + rounded(from + width));
}

std::string GeneralisationHierarchy::releasedValue(
    std::size_t level, const questionnaires::Response& response) const {
  const auto& chosen = levels_.at(level);
  const auto stored = storage::stored(response);
  if (chosen.width > 0.0) {
    const auto number = stored.point ? static_cast<double>(*stored.point) : stored.number;
    return number ? bandLabel(std::floor(*number / chosen.width) * chosen.width, chosen.width) : "";
  }
  const auto text = stored.text.value_or("");
  if (chosen.byOption.empty()) return text;
  const auto option = chosen.byOption.find(text);
  return option == chosen.byOption.end() ? std::string() : option->second;
}

}  // namespace study
