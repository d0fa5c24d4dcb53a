#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/factor.h"
#include "analysis/data/reason.h"

namespace analysis {

/// The fixed effects of a model as the columns of a design matrix, one row per answer: an
/// intercept, then what is added.
///
/// A factor is coded by treatment: its first level is the base, and each other level has a column
/// that is one for its answers and zero for all others. The coefficient of that column is the
/// difference of the level from the base.
class FixedEffects {
 public:
  /// The intercept alone.
  explicit FixedEffects(std::size_t answers);

  /// @throws std::invalid_argument  for another number of answers, or a name that is there.
  void add(const Factor& factor);

  std::size_t answers() const noexcept { return answers_; }
  std::size_t columns() const noexcept { return columns_.size(); }
  /// "(Intercept)", "method fem".
  const std::string& name(std::size_t column) const { return columns_.at(column).name; }
  std::span<const double> column(std::size_t column) const { return columns_.at(column).values; }
  const std::vector<Factor>& factors() const noexcept { return factors_; }
  /// @throws std::invalid_argument  for a factor that has not been added.
  const Factor& factor(std::string_view name) const;

  /// The weights of the coefficients in level 1 − level 2, one for each column: 1 and −1 in the
  /// columns of the two levels, of which the base has none.
  /// @throws std::invalid_argument  for a factor or level that is not there.
  std::vector<double> difference(
      std::string_view factor, std::string_view level1, std::string_view level2) const;

  /// The design of an answer at one level of a factor: a row of columns for each combination of the
  /// levels of all other factors; one row where there are none.
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

/// Why a model with these fixed effects and random intercepts is not defined for these answers:
/// too few of them, a factor of one level, linearly dependent columns, random intercepts that
/// cannot be told apart from each other or from the single answers. Empty where it is defined.
///
/// @throws std::invalid_argument  if a factor has another number of answers.
Reason whyNotDefined(const FixedEffects& fixed, std::span<const Factor> random);

}  // namespace analysis
