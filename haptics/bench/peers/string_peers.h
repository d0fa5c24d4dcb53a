#pragma once

#include <memory>
#include <string>
#include <vector>

namespace haptics::bench::peers {

/// The paper's string, solved by somebody who forms the matrix.
class StringPeer {
 public:
  virtual ~StringPeer() = default;
  virtual std::string name() const = 0;

  /// The force at the tool [N] where it has moved by @p y [travel units], and the displacements of
  /// all midpoints into mesh().
  virtual double solve(double y) = 0;
  virtual const double* mesh() const = 0;
};

/// Elements of length 1, boundary A, as StringReference. Dense LU at each step (as the paper's
/// program; up to 1000 unknowns), dense LU once, sparse LDLᵀ once, Thomas at each step.
std::vector<std::unique_ptr<StringPeer>> stringPeers(
    const std::vector<double>& elementStiffnesses, double toolPosition);

}  // namespace haptics::bench::peers
