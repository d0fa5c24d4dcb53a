#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

namespace analysis {

/// First and second derivatives of a function of k parameters.
struct Derivatives {
  Eigen::VectorXd gradient;  ///< k numbers
  Eigen::MatrixXd hessian;   ///< k × k, symmetric
};

/// A function to be minimised: std::nullopt if it is not defined.
struct Objective {
  std::function<std::optional<double>(const Eigen::VectorXd&)> value;
  std::function<std::optional<Derivatives>(const Eigen::VectorXd&)> derivatives;
  double lowerBound;  ///< of every parameter; −infinity for none
};

/// Where a function is smallest.
struct Minimum {
  Eigen::VectorXd at;
  double value = 0.0;
  Derivatives derivatives;  ///< there
  int iterations = 0;
  /// Whether the gradient vanishes (or pushes against the bound) and the curvature is positive.
  bool isFound = false;
};

/// Minimises by Newton's method: the step is that of the Hessian with the absolute values of its
/// eigenvalues, projected on the bound, halved until the function falls enough (Armijo), and
/// never longer than two in any parameter. Ends after 200 iterations in any case.
///
/// (Nocedal & Wright 2006, Numerical Optimization, algorithm 3.2 and section 16.7.)
Minimum minimise(const Objective& objective, Eigen::VectorXd start);

}  // namespace analysis
