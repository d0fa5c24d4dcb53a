#include "analysis/data/factor.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <utility>

namespace analysis {

Factor factorOf(std::string name, std::span<const std::string> labels) {
  Factor factor{.name = std::move(name), .levels = {}, .levelOfAnswer = {}};
  std::map<std::string, std::size_t> indices;
  for (const auto& label : labels) {
    const auto [entry, isNew] = indices.try_emplace(label, factor.levels.size());
    if (isNew) factor.levels.push_back(label);
    factor.levelOfAnswer.push_back(entry->second);
  }
  return factor;
}

Factor factorOf(
    std::string name, std::span<const std::string> labels, std::span<const std::string> order) {
  const Factor found = factorOf(name, labels);
  Factor factor{.name = std::move(name), .levels = {}, .levelOfAnswer = {}};
  for (const auto& level : order) {
    if (std::ranges::count(found.levels, level) > 0) factor.levels.push_back(level);
  }

  std::vector<std::size_t> places;
  for (const auto& level : found.levels) {
    const auto place = std::ranges::find(factor.levels, level);
    if (place == factor.levels.end()) {
      throw std::invalid_argument("'" + level + "' is no level of '" + factor.name + "'");
    }
    places.push_back(static_cast<std::size_t>(place - factor.levels.begin()));
  }
  for (const std::size_t level : found.levelOfAnswer) factor.levelOfAnswer.push_back(places[level]);
  return factor;
}

Factor interactionOf(const Factor& a, const Factor& b) {
  if (a.levelOfAnswer.size() != b.levelOfAnswer.size()) {
    throw std::invalid_argument("factors to be crossed need the same answers");
  }
  Factor crossed{.name = a.name + ":" + b.name, .levels = {}, .levelOfAnswer = {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> indices;
  for (std::size_t i = 0; i < a.levelOfAnswer.size(); ++i) {
    const std::pair pair{a.levelOfAnswer[i], b.levelOfAnswer[i]};
    const auto [entry, isNew] = indices.try_emplace(pair, crossed.levels.size());
    if (isNew) crossed.levels.push_back(a.levels[pair.first] + ":" + b.levels[pair.second]);
    crossed.levelOfAnswer.push_back(entry->second);
  }
  return crossed;
}

}  // namespace analysis
