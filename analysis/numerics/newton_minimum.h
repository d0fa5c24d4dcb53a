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

/// A function to be minimised. value and derivatives return std::nullopt where it is not defined.
struct Objective {
  std::function<std::optional<double>(const Eigen::VectorXd&)> value;
  std::function<std::optional<Derivatives>(const Eigen::VectorXd&)> derivatives;
  double lowerBound;  ///< of every parameter; −infinity for none
};

/// The minimum of a function.
struct Minimum {
  Eigen::VectorXd at;
  double value = 0.0;
  Derivatives derivatives;  ///< at the minimum
  int iterations = 0;
  /// Whether the gradient vanishes (or points into the bound) and the curvature is positive.
  bool isFound = false;
};

/// Minimises by Newton's method. The step uses the Hessian with its eigenvalues replaced by their
/// absolute values, is projected on the bound, halved until the function decreases enough (Armijo),
/// and changes no parameter by more than 2. Stops after 200 iterations at the latest.
///
/// (Nocedal & Wright 2006, Numerical Optimization, algorithm 3.2 and section 16.7.)
Minimum minimise(const Objective& objective, Eigen::VectorXd start);

}  // namespace analysis
