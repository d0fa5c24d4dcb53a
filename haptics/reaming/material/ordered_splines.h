#pragma once

#include <array>

#include "haptics/reaming/material/envelope.h"
#include "haptics/reaming/material/node_choice.h"

namespace haptics::reaming {

/// The splines of an envelope from soft to hard.
using EnvelopeSplines = std::array<Spline, 3>;

/// Whether orderedSplines() does this: kinds with a slope of its own at each node, and nodes that
/// may be added.
constexpr bool canBeOrdered(const NodeWish& wish) noexcept {
  return (wish.rule == NodeRule::Greedy || wish.rule == NodeRule::Optimal) &&
         wish.kind != SplineKind::NaturalCubic;
}

/// Splines of curves that are in order everywhere, which are in order everywhere too, so that a
/// higher hardness is never softer.
///
/// All three have the same nodes, those that each needs. Where the slopes of two neighbours differ
/// so much that they could meet in between, they are brought together: with a gap g at a node and
/// pieces of h before and after it, the upper slope lies above the lower one by −3g/h (after) to
/// 3g/h (before). Then the Bernstein coefficients of their difference are not negative on any piece
/// (Schmidt & Hess 1988, "Positivity of cubic polynomials on intervals"). Nodes are added until
/// each spline has the error that was wanted.
///
/// @param envelope  in order at each place. @param wish  canBeOrdered().
EnvelopeSplines orderedSplines(const Envelope& envelope, const NodeWish& wish);

}  // namespace haptics::reaming
