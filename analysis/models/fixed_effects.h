#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/factor.h"

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

  /// Products of the columns of two factors that have been added.
  /// @throws std::invalid_argument  if one of them has not.
  void addInteraction(std::string_view factor1, std::string_view factor2);

  /// A number per answer, for instance years of experience.
  /// @throws std::invalid_argument  for another number of answers, or a value that is not finite.
  void addCovariate(const std::string& name, std::vector<double> values);

  std::size_t answers() const noexcept { return answers_; }
  std::size_t columns() const noexcept { return columns_.size(); }
  /// "(Intercept)", "method fem", "method fem:round 2", "experience".
  const std::string& name(std::size_t column) const { return columns_.at(column).name; }
  std::span<const double> column(std::size_t column) const { return columns_.at(column).values; }
  const std::vector<Factor>& factors() const noexcept { return factors_; }
  /// @throws std::invalid_argument  for a factor that has not been added.
  const Factor& factor(std::string_view name) const;

  /// The weights of the coefficients in the estimated marginal mean of a level: the other factors
  /// count with each of their levels alike, covariates with their mean (Searle, Speed & Milliken
  /// 1980).
  /// @throws std::invalid_argument  for a factor or level that is not there.
  std::vector<double> marginalMean(std::string_view factor, std::string_view level) const;

  /// The weights of marginal mean of level 1 − marginal mean of level 2.
  std::vector<double> difference(
      std::string_view factor, std::string_view level1, std::string_view level2) const;

 private:
  struct Part {
    std::size_t factor = 0;
    std::size_t level = 0;
  };
  struct Column {
    std::string name;
    std::vector<Part> parts;  ///< the levels whose indicators are multiplied
    std::vector<double> values;
    double covariateMean = 1.0;
  };

  Column columnOf(const std::vector<Part>& parts) const;
  std::size_t factorIndex(std::string_view name) const;

  std::size_t answers_;
  std::vector<Column> columns_;
  std::vector<Factor> factors_;
};

}  // namespace analysis
