#pragma once

#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/answer_lattice.h"
#include "analysis/published/published_convention.h"

namespace analysis {

/// Whether two groups have a p between two limits, for very many pairs of groups.
///
/// Most pairs are decided by their t alone, from the quantiles at the whole degrees of freedom
/// below and above; a p is computed only for a t between these.
class TWindow {
 public:
  TWindow(const Interval& p, const PublishedConvention& convention);

  /// @param group1  and group2: of two answers at least.
  bool holds(const LatticePoint& group1, const LatticePoint& group2) const;

 private:
  struct Limits {
    double nearest = 0.0;  ///< t at the larger p
    double furthest = 0.0;
  };

  const Limits& limitsAt(std::size_t degreesOfFreedom) const;

  Interval p_;
  PublishedConvention convention_;
  mutable std::vector<Limits> limits_;  ///< [degrees of freedom], as far as they were asked for
};

}  // namespace analysis
