#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace haptics::bench::peers {

/// A curve through given nodes, by somebody.
class SplinePeer {
 public:
  virtual ~SplinePeer() = default;
  virtual std::string name() const = 0;
  virtual double at(double x) const = 0;

  /// Evaluates at all of @p xs, each only after the one before: the sum of a latency.
  virtual double sweep(std::span<const double> xs) const = 0;
};

/// Evaluates one after the other; a value that is multiplied with 0 makes the next one wait.
template <typename Evaluate>
double oneAfterTheOther(std::span<const double> xs, Evaluate evaluate) {
  double last = 0.0;
  for (const double x : xs) last = evaluate(x + last * 0.0);
  return last;
}

/// Boost's PCHIP and makima, GSL's cubic, Akima's and Steffen's spline (where GSL is there), and
/// for up to 100 nodes Eigen's cubic spline, whose fit takes O(n³).
std::vector<std::unique_ptr<SplinePeer>> splinePeers(
    const std::vector<double>& xs, const std::vector<double>& ys);

}  // namespace haptics::bench::peers
