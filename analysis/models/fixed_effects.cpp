#include "analysis/models/fixed_effects.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <Eigen/Core>

namespace analysis {
namespace {

Reason whyFixedAreNotDefined(const FixedEffects& fixed) {
  if (fixed.answers() <= fixed.columns()) {
    return reason("too_few_answers", fixed.answers(), fixed.columns());
  }
  for (const auto& factor : fixed.factors()) {
    if (factor.levels.size() < 2) return reason("one_level", factor.name);
  }
  return {};
}

/// Finds the first column that is a linear combination of those before it, for instance because two
/// methods were each used in one round only. Uses Gram–Schmidt orthogonalisation with every
/// projection done twice, because the first one leaves rounding errors of the size of the column.
Reason whyColumnsDepend(const FixedEffects& fixed) {
  constexpr double kDependentLength = 1e-9;  // of a column's length
  const auto rows = static_cast<Eigen::Index>(fixed.answers());
  Eigen::MatrixXd basis(rows, 0);
  for (std::size_t j = 0; j < fixed.columns(); ++j) {
    Eigen::VectorXd column = Eigen::VectorXd::Map(fixed.column(j).data(), rows);
    const double length = column.norm();
    for (int pass = 0; pass < 2; ++pass) column -= basis * (basis.transpose() * column);
    if (!(column.norm() > kDependentLength * length))
      return reason("dependent_effect", fixed.name(j));
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = column.normalized();
  }
  return {};
}

Reason whyRandomIsNotDefined(const Factor& factor) {
  if (factor.levels.size() < 2) return reason("one_random_level", factor.name);
  if (factor.levels.size() >= factor.levelOfAnswer.size()) {
    return reason("as_many_levels", factor.name);
  }
  return {};
}

}  // namespace

FixedEffects::FixedEffects(std::size_t answers) : answers_(answers) {
  columns_.push_back({.name = "(Intercept)", .values = std::vector<double>(answers, 1.0)});
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
    Column column{.name = factor.name + " " + factor.levels[level], .values = {}};
    for (const std::size_t answerLevel : factor.levelOfAnswer) {
      column.values.push_back(answerLevel == level ? 1.0 : 0.0);
    }
    columns_.push_back(std::move(column));
  }
}

const Factor& FixedEffects::factor(std::string_view name) const {
  const auto place = std::ranges::find(factors_, name, &Factor::name);
  if (place == factors_.end()) {
    throw std::invalid_argument("'" + std::string(name) + "' is no factor of the fixed effects");
  }
  return *place;
}

std::vector<double> FixedEffects::difference(
    std::string_view name, std::string_view level1, std::string_view level2) const {
  const Factor& factor = this->factor(name);
  std::size_t base = 0;  // index of the column before those of the factor
  for (const Factor* before = factors_.data(); before != &factor; ++before) {
    base += before->levels.size() - 1;
  }
  std::vector<double> weights(columns_.size(), 0.0);
  const auto add = [&](std::string_view level, double weight) {
    const auto place = std::ranges::find(factor.levels, level);
    if (place == factor.levels.end()) {
      throw std::invalid_argument(
          "'" + std::string(level) + "' is no level of '" + factor.name + "'");
    }
    if (place != factor.levels.begin()) {
      weights[base + static_cast<std::size_t>(place - factor.levels.begin())] += weight;
    }
  };
  add(level1, 1.0);
  add(level2, -1.0);
  return weights;
}

std::vector<std::vector<double>> FixedEffects::combinations(
    std::string_view name, std::string_view level) const {
  const Factor& held = factor(name);
  if (std::ranges::find(held.levels, level) == held.levels.end()) {
    throw std::invalid_argument("'" + std::string(level) + "' is no level of '" + held.name + "'");
  }
  std::vector<std::vector<double>> rows{{1.0}};
  for (const auto& factor : factors_) {
    std::vector<std::vector<double>> longer;
    for (const auto& row : rows) {
      for (std::size_t at = 0; at < factor.levels.size(); ++at) {
        if (&factor == &held && factor.levels[at] != level) continue;
        auto& next = longer.emplace_back(row);
        for (std::size_t l = 1; l < factor.levels.size(); ++l) next.push_back(l == at ? 1.0 : 0.0);
      }
    }
    rows = std::move(longer);
  }
  return rows;
}

Reason whyNotDefined(const FixedEffects& fixed, std::span<const Factor> random) {
  for (const auto& factor : random) {
    if (factor.levelOfAnswer.size() != fixed.answers()) {
      throw std::invalid_argument("'" + factor.name + "' has another number of answers");
    }
  }
  if (auto why = whyFixedAreNotDefined(fixed); !why.empty()) return why;
  if (auto why = whyColumnsDepend(fixed); !why.empty()) return why;
  for (std::size_t k = 0; k < random.size(); ++k) {
    if (auto why = whyRandomIsNotDefined(random[k]); !why.empty()) return why;
    // Two random factors are confounded if no level of either occurs with two levels of the other.
    for (std::size_t l = 0; l < k; ++l) {
      const std::size_t pairs = interactionOf(random[k], random[l]).levels.size();
      if (pairs == random[k].levels.size() && pairs == random[l].levels.size()) {
        return reason("same_grouping", random[l].name, random[k].name);
      }
    }
  }
  return {};
}

}  // namespace analysis
