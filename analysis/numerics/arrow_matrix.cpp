#include "analysis/numerics/arrow_matrix.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace analysis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

Eigen::Map<const MatrixXd> matrixOf(
    const std::vector<double>& numbers, std::size_t rows, std::size_t columns) {
  return {numbers.data(), static_cast<Index>(rows), static_cast<Index>(columns)};
}

Eigen::Map<const VectorXd> vectorOf(std::span<const double> numbers) {
  return {numbers.data(), static_cast<Index>(numbers.size())};
}

}  // namespace

ArrowMatrix::ArrowMatrix(std::size_t diagonal, std::size_t corner)
    : diagonal_(diagonal),
      corner_(corner),
      delta_(diagonal, 0.0),
      edge_(diagonal * corner, 0.0),
      block_(corner * corner, 0.0) {}

void ArrowMatrix::add(std::size_t row, std::size_t column, double value) {
  if (row < column) return;  // the same by symmetry
  if (row < diagonal_) {
    delta_[row] += value;
  } else if (column < diagonal_) {
    edge_[column * corner_ + row - diagonal_] += value;
  } else {
    block_[(column - diagonal_) * corner_ + row - diagonal_] += value;
  }
}

bool ArrowMatrix::factorise() {
  const auto isPositive = [](double value) { return value > 0.0; };
  if (!std::ranges::all_of(delta_, isPositive)) return false;
  if (corner_ == 0) {
    invertDiagonal();
    return true;
  }
  const auto delta = vectorOf(delta_);
  const auto edge = matrixOf(edge_, corner_, diagonal_);
  const MatrixXd scaled = edge * delta.cwiseInverse().asDiagonal();
  MatrixXd schur = matrixOf(block_, corner_, corner_);
  schur.triangularView<Eigen::Lower>() -= scaled * edge.transpose();
  const Eigen::LLT<MatrixXd> cholesky(schur);  // of its lower half
  if (cholesky.info() != Eigen::Success) return false;

  const auto side = static_cast<Index>(corner_);
  const MatrixXd corner = cholesky.solve(MatrixXd::Identity(side, side));
  const MatrixXd inverseEdge = -(corner * scaled);
  const VectorXd diagonal =
      delta.cwiseInverse() - scaled.cwiseProduct(inverseEdge).colwise().sum().transpose();
  inverseCorner_.assign(corner.data(), corner.data() + corner.size());
  inverseEdge_.assign(inverseEdge.data(), inverseEdge.data() + inverseEdge.size());
  inverseDiagonal_.assign(diagonal.data(), diagonal.data() + diagonal.size());
  logDeterminant_ =
      delta.array().log().sum() + 2.0 * cholesky.matrixLLT().diagonal().array().log().sum();
  return true;
}

/// Without a corner there are no matrices.
void ArrowMatrix::invertDiagonal() {
  inverseDiagonal_.clear();
  logDeterminant_ = 0.0;
  for (const double delta : delta_) {
    inverseDiagonal_.push_back(1.0 / delta);
    logDeterminant_ += std::log(delta);
  }
}

std::vector<double> ArrowMatrix::solve(std::span<const double> right) const {
  if (corner_ == 0) {
    std::vector<double> solution(right.begin(), right.end());
    for (std::size_t i = 0; i < diagonal_; ++i) solution[i] /= delta_[i];
    return solution;
  }
  const auto first = vectorOf(right.first(diagonal_));
  const auto second = vectorOf(right.last(corner_));
  const auto edge = matrixOf(inverseEdge_, corner_, diagonal_);
  const VectorXd lower = edge * first + matrixOf(inverseCorner_, corner_, corner_) * second;
  const auto b = matrixOf(edge_, corner_, diagonal_);
  const VectorXd upper = (first - b.transpose() * lower).cwiseQuotient(vectorOf(delta_));
  std::vector<double> solution(upper.begin(), upper.end());
  solution.insert(solution.end(), lower.begin(), lower.end());
  return solution;
}

double ArrowMatrix::inverse(std::size_t row, std::size_t column) const {
  if (row < column) std::swap(row, column);
  if (row < diagonal_) return inverseDiagonal_[row];
  if (column < diagonal_) return inverseEdge_[column * corner_ + row - diagonal_];
  return inverseCorner_[(column - diagonal_) * corner_ + row - diagonal_];
}

}  // namespace analysis
