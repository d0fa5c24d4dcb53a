#include "analysis/models/mixed_model_design.h"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Core>

namespace analysis {
namespace {

Reason whyFixedAreNotDefined(const FixedEffects& fixed) {
  if (fixed.answers() <= fixed.columns()) {
    return reason("too_few_answers", fixed.answers(), fixed.columns());
  }
  for (const auto& factor : fixed.factors()) {
    if (factor.levels.size() < 2) {
      return reason("one_level", factor.name);
    }
  }
  return {};
}

/// The first column that the ones before it make up, as where a combination of levels has no
/// answers.
Reason whyColumnsDepend(const FixedEffects& fixed) {
  constexpr double kNothing = 1e-9;  // of a column's length
  const auto rows = static_cast<Eigen::Index>(fixed.answers());
  Eigen::MatrixXd basis(rows, 0);
  for (std::size_t j = 0; j < fixed.columns(); ++j) {
    Eigen::VectorXd column = Eigen::Map<const Eigen::VectorXd>(fixed.column(j).data(), rows);
    const double length = column.norm();
    for (int pass = 0; pass < 2; ++pass) column -= basis * (basis.transpose() * column);
    if (!(column.norm() > kNothing * length)) {
      return reason("dependent_effect", fixed.name(j));
    }
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = column.normalized();
  }
  return {};
}

Reason whyRandomIsNotDefined(const Factor& factor) {
  if (factor.levels.size() < 2) {
    return reason("one_random_level", factor.name);
  }
  if (factor.levels.size() >= factor.levelOfAnswer.size()) {
    return reason("as_many_levels", factor.name);
  }
  return {};
}

}  // namespace

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
    for (std::size_t l = 0; l < k; ++l) {
      const std::size_t pairs = crossing(random[k], random[l]).levels.size();
      if (pairs == random[k].levels.size() && pairs == random[l].levels.size()) {
        return reason("same_grouping", random[l].name, random[k].name);
      }
    }
  }
  return {};
}

}  // namespace analysis
