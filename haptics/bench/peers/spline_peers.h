#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

namespace haptics::bench::peers {

/// A curve through given nodes, by one library.
struct Spline {
  std::string name;
  std::function<double(double x)> at;
  /// Evaluates at all of xs, each only after the one before: the sum is a latency.
  std::function<double(std::span<const double> xs)> sweep;
};

/// @param evaluate  the value at x. It is called directly, so that it is part of the loop.
template <typename Evaluate>
Spline splineOf(std::string name, Evaluate evaluate) {
  const auto sweep = [evaluate](std::span<const double> xs) mutable {
    double last = 0.0;
    for (const double x : xs) last = evaluate(x + last * 0.0);  // waits for the one before
    return last;
  };
  return {std::move(name), evaluate, sweep};
}

/// Boost's PCHIP and makima, GSL's natural cubic and Steffen's spline (where GSL is installed), and
/// for up to 100 nodes Eigen's cubic spline, whose fit takes O(n³).
std::vector<Spline> splinePeers(const std::vector<double>& xs, const std::vector<double>& ys);

}  // namespace haptics::bench::peers
