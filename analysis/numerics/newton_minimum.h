#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// First and second derivatives of a function of k parameters.
struct Derivatives {
  std::vector<double> gradient;  ///< k numbers
  std::vector<double> hessian;   ///< k × k numbers, row by row
};

/// A function to be minimised: nothing where it is not defined.
struct Objective {
  std::function<std::optional<double>(std::span<const double>)> value;
  std::function<std::optional<Derivatives>(std::span<const double>)> derivatives;
  double lowerBound;  ///< of every parameter; −infinity for none
};

/// Where a function is smallest.
struct Minimum {
  std::vector<double> at;
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
Minimum minimise(const Objective& objective, std::vector<double> start);

}  // namespace analysis
