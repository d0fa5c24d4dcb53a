#include "analysis/numerics/determined_unknowns.h"

#include <Eigen/LU>

namespace analysis {

std::size_t determinedUnknowns(const std::vector<std::vector<double>>& coefficients) {
  if (coefficients.empty() || coefficients.front().empty()) return 0;
  const auto rows = static_cast<Eigen::Index>(coefficients.size());
  const auto unknowns = static_cast<Eigen::Index>(coefficients.front().size());
  Eigen::MatrixXd matrix(rows, unknowns);
  for (Eigen::Index row = 0; const auto& equation : coefficients) {
    matrix.row(row++) = Eigen::Map<const Eigen::RowVectorXd>(equation.data(), unknowns);
  }
  // Without a null space Eigen returns one column of zeros: every unknown is determined.
  const Eigen::MatrixXd nullSpace = matrix.fullPivLu().kernel();
  constexpr double kZero = 1e-9;  // entries of a basis that is not 0 there are of order 1
  return static_cast<std::size_t>(
      (nullSpace.rowwise().lpNorm<Eigen::Infinity>().array() < kZero).count());
}

}  // namespace analysis
