#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace analysis {

/// A symmetric positive definite matrix whose first part is diagonal,
///
///     D = ( Δ  Bᵀ )
///         ( B  C  ),
///
/// as the random intercepts of a mixed model have it when the one with most levels comes first.
/// Solved through the Schur complement S = C − B Δ⁻¹ Bᵀ, so that the large part costs little.
class ArrowMatrix {
 public:
  /// All zero.
  ArrowMatrix(std::size_t diagonal, std::size_t corner);

  std::size_t size() const noexcept { return diagonal_ + corner_; }
  void add(std::size_t row, std::size_t column, double value);

  /// False if the matrix is not positive definite. After this nothing may be added.
  bool factorise();
  double logDeterminant() const noexcept { return logDeterminant_; }
  std::vector<double> solve(std::span<const double> right) const;
  /// An element of D⁻¹; within the diagonal part only those of the diagonal.
  double inverse(std::size_t row, std::size_t column) const;

 private:
  void invertDiagonal();

  std::size_t diagonal_;
  std::size_t corner_;
  std::vector<double> delta_;
  std::vector<double> edge_;           ///< B, column by column
  std::vector<double> block_;          ///< C
  std::vector<double> inverseCorner_;  ///< S⁻¹
  std::vector<double> inverseEdge_;    ///< −S⁻¹ B Δ⁻¹, column by column
  std::vector<double> inverseDiagonal_;
  double logDeterminant_ = 0.0;
};

}  // namespace analysis
