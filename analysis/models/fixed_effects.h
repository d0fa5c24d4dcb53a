#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"

namespace analysis {

/// The fixed effects of a model as the columns of a design matrix, with one row per answer. The
/// first column is the intercept; add() appends the columns of a factor.
///
/// Factors have treatment coding: the first level is the reference level, and each other level has
/// a column that is 1 for its answers and 0 for all others. The coefficient of this column is the
/// difference of the level from the reference level.
class FixedEffects {
 public:
  /// A design matrix with the intercept only.
  explicit FixedEffects(std::size_t answers);

  /// @throws std::invalid_argument  if the factor has another number of answers, or the name of one
  ///     already added.
  void add(const Factor& factor);

  std::size_t answers() const noexcept { return answers_; }
  std::size_t columns() const noexcept { return columns_.size(); }
  /// The name of a column: "(Intercept)", "method fem".
  const std::string& name(std::size_t column) const { return columns_.at(column).name; }
  std::span<const double> column(std::size_t column) const { return columns_.at(column).values; }
  const std::vector<Factor>& factors() const noexcept { return factors_; }
  /// @throws std::invalid_argument  for a factor that has not been added.
  const Factor& factor(std::string_view name) const;

  /// The weights of the contrast level 1 − level 2, one for each column: 1 and −1 in the columns of
  /// the two levels (the reference level has no column), otherwise 0.
  /// @throws std::invalid_argument  for a factor or level that is not there.
  std::vector<double> difference(
      std::string_view factor, std::string_view level1, std::string_view level2) const;

  /// The rows of the design matrix for an answer at one level of a factor: one row for each
  /// combination of the levels of the other factors, or one row if there are no others.
  /// @throws std::invalid_argument  for a factor or level that is not there.
  std::vector<std::vector<double>> combinations(
      std::string_view factor, std::string_view level) const;

 private:
  struct Column {
    std::string name;
    std::vector<double> values;
  };

  std::size_t answers_;
  std::vector<Column> columns_;
  std::vector<Factor> factors_;
};

/// Why a model with these fixed effects and random intercepts is not defined for these answers: too
/// few answers, a factor with one level, linearly dependent columns, or random intercepts that are
/// confounded with each other or with the residuals. Empty if the model is defined.
///
/// @throws std::invalid_argument  if a factor has another number of answers.
Reason whyNotDefined(const FixedEffects& fixed, std::span<const Factor> random);

}  // namespace analysis
