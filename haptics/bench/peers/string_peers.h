#pragma once

#include <functional>
#include <string>
#include <vector>

namespace haptics::bench::peers {

/// The paper's string of finite elements, solved in one way.
struct StringSolver {
  std::string name;
  /// The force at the tool [N] where it has moved by y [travel units]; works out the displacements
  /// of all midpoints as well, except where its name says otherwise.
  std::function<double(double y)> solve;
};

/// Solvers that form the matrix, for elements of length 1 and boundary A as in StringReference:
/// dense LU at each step (as the paper's program) and once, both up to 1000 unknowns; sparse LDLᵀ
/// once; Thomas' algorithm at each step.
std::vector<StringSolver> stringPeers(
    const std::vector<double>& elementStiffnesses, double toolPosition);

}  // namespace haptics::bench::peers
