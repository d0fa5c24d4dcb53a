#include "analysis/models/mixed_model_design.h"

#include <algorithm>
#include <stdexcept>

#include <Eigen/Core>

namespace analysis {
namespace {

std::string whyFixedAreNotDefined(const FixedEffects& fixed) {
  if (fixed.answers() <= fixed.columns()) {
    return "there are " + std::to_string(fixed.answers()) + " answers for " +
           std::to_string(fixed.columns()) + " fixed effects, and more answers are needed";
  }
  for (const auto& factor : fixed.factors()) {
    if (factor.levels.size() < 2) {
      return "'" + factor.name + "' has one level only: there is nothing to compare";
    }
  }
  return {};
}

/// The first column that the ones before it make up, as where a combination of levels has no
/// answers.
std::string whyColumnsDepend(const FixedEffects& fixed) {
  constexpr double kNothing = 1e-9;  // of a column's length
  const auto rows = static_cast<Eigen::Index>(fixed.answers());
  Eigen::MatrixXd basis(rows, 0);
  for (std::size_t j = 0; j < fixed.columns(); ++j) {
    Eigen::VectorXd column = Eigen::Map<const Eigen::VectorXd>(fixed.column(j).data(), rows);
    const double length = column.norm();
    for (int pass = 0; pass < 2; ++pass) column -= basis * (basis.transpose() * column);
    if (!(column.norm() > kNothing * length)) {
      return "the fixed effect '" + fixed.name(j) +
             "' cannot be told apart from the others: it is a combination of them";
    }
    basis.conservativeResize(Eigen::NoChange, basis.cols() + 1);
    basis.rightCols(1) = column.normalized();
  }
  return {};
}

std::string whyRandomIsNotDefined(const Factor& factor) {
  if (factor.levels.size() < 2) {
    return "'" + factor.name + "' has one level only: how its levels vary cannot be estimated";
  }
  if (factor.levels.size() >= factor.levelOfAnswer.size()) {
    return "'" + factor.name +
           "' has as many levels as there are answers: its intercepts cannot be told apart from "
           "the residuals";
  }
  return {};
}

}  // namespace

std::string whyNotDefined(const FixedEffects& fixed, std::span<const Factor> random) {
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
        return "'" + random[l].name + "' and '" + random[k].name +
               "' group the answers alike: their variances cannot be told apart";
      }
    }
  }
  return {};
}

}  // namespace analysis
