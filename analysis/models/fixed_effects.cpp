#include "analysis/models/fixed_effects.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace analysis {

FixedEffects::FixedEffects(std::size_t answers) : answers_(answers) {
  columns_.push_back(
      {.name = "(Intercept)", .parts = {}, .values = std::vector<double>(answers, 1.0)});
}

void FixedEffects::add(const Factor& factor) {
  if (factor.levelOfAnswer.size() != answers_) {
    throw std::invalid_argument("'" + factor.name + "' has another number of answers");
  }
  if (std::ranges::count(factors_, factor.name, &Factor::name) > 0) {
    throw std::invalid_argument("'" + factor.name + "' is among the fixed effects already");
  }
  factors_.push_back(factor);
  for (std::size_t level = 1; level < factor.levels.size(); ++level) {
    columns_.push_back(columnOf({{.factor = factors_.size() - 1, .level = level}}));
  }
}

void FixedEffects::addInteraction(std::string_view factor1, std::string_view factor2) {
  const std::size_t a = factorIndex(factor1);
  const std::size_t b = factorIndex(factor2);
  for (std::size_t j = 1; j < factors_[b].levels.size(); ++j) {
    for (std::size_t i = 1; i < factors_[a].levels.size(); ++i) {
      columns_.push_back(columnOf({{.factor = a, .level = i}, {.factor = b, .level = j}}));
    }
  }
}

void FixedEffects::addCovariate(const std::string& name, std::vector<double> values) {
  const auto isFinite = [](double value) { return std::isfinite(value); };
  if (values.size() != answers_ || !std::ranges::all_of(values, isFinite)) {
    throw std::invalid_argument("'" + name + "' needs a finite number for each answer");
  }
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) /
                      static_cast<double>(std::max<std::size_t>(answers_, 1));
  columns_.push_back(
      {.name = name, .parts = {}, .values = std::move(values), .covariateMean = mean});
}

const Factor& FixedEffects::factor(std::string_view name) const {
  return factors_[factorIndex(name)];
}

std::vector<double> FixedEffects::marginalMean(
    std::string_view factor, std::string_view level) const {
  const std::size_t wanted = factorIndex(factor);
  const auto place = std::ranges::find(factors_[wanted].levels, level);
  if (place == factors_[wanted].levels.end()) {
    throw std::invalid_argument(
        "'" + std::string(level) + "' is no level of '" + std::string(factor) + "'");
  }
  const auto at = static_cast<std::size_t>(place - factors_[wanted].levels.begin());

  std::vector<double> weights;
  for (const auto& column : columns_) {
    double weight = column.covariateMean;
    for (const auto& part : column.parts) {
      if (part.factor == wanted) weight *= part.level == at ? 1.0 : 0.0;
      if (part.factor != wanted) weight /= static_cast<double>(factors_[part.factor].levels.size());
    }
    weights.push_back(weight);
  }
  return weights;
}

std::vector<double> FixedEffects::difference(
    std::string_view factor, std::string_view level1, std::string_view level2) const {
  std::vector<double> weights = marginalMean(factor, level1);
  const std::vector<double> other = marginalMean(factor, level2);
  for (std::size_t i = 0; i < weights.size(); ++i) weights[i] -= other[i];
  return weights;
}

FixedEffects::Column FixedEffects::columnOf(const std::vector<Part>& parts) const {
  Column column{.name = {}, .parts = parts, .values = std::vector<double>(answers_, 1.0)};
  for (const auto& [factor, level] : parts) {
    const Factor& its = factors_[factor];
    column.name += (column.name.empty() ? "" : ":") + its.name + " " + its.levels[level];
    for (std::size_t i = 0; i < answers_; ++i) {
      if (its.levelOfAnswer[i] != level) column.values[i] = 0.0;
    }
  }
  return column;
}

std::size_t FixedEffects::factorIndex(std::string_view name) const {
  const auto place = std::ranges::find(factors_, name, &Factor::name);
  if (place == factors_.end()) {
    throw std::invalid_argument("'" + std::string(name) + "' is no factor of the fixed effects");
  }
  return static_cast<std::size_t>(place - factors_.begin());
}

}  // namespace analysis
