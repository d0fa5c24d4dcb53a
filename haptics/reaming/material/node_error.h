#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "haptics/reaming/material/node_choice.h"

namespace haptics::reaming {

/// How far splines through some samples of a curve are off.
class NodeError {
 public:
  struct Worst {
    double error = 0.0;  ///< by the measure of the wish
    std::size_t at = 0;  ///< the sample
  };

  /// @param curve  must outlive this object.
  NodeError(const SampledCurve& curve, const NodeWish& wish);

  std::size_t size() const noexcept { return curve_.size(); }
  const SampledCurve& curve() const noexcept { return curve_; }
  const std::vector<double>& slopes() const noexcept { return slopes_; }

  /// Of the piece between two samples of a local kind; stops as soon as it exceeds @p enough.
  Worst between(
      std::size_t from,
      std::size_t to,
      double enough = std::numeric_limits<double>::infinity()) const;

  /// Of the whole spline through @p nodes; stops as soon as it exceeds @p enough.
  Worst through(
      std::span<const std::size_t> nodes,
      double enough = std::numeric_limits<double>::infinity()) const;

 private:
  Worst of(
      const models::CubicSegment<double>& piece,
      std::size_t from,
      std::size_t to,
      double enough) const;

  const SampledCurve& curve_;
  NodeWish wish_;
  std::vector<double> slopes_;
};

/// Nodes of the least largest error, as many as asked for: chooseNodes().
std::vector<std::size_t> nodesOfLeastError(
    const NodeError& error, std::size_t count, const NodeWish& wish);

}  // namespace haptics::reaming
