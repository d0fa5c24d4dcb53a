#pragma once

#include <optional>

#include "analysis/data/vote_counts.h"

namespace analysis {

/// The exact multinomial test of equal shares: the probability, if all options were equally likely,
/// of an outcome that is not more probable than the observed one.
///
///     p = Σ n! / (v₁! … v_k!) / kⁿ   over all outcomes v whose term is not larger
///
/// Counted in whole numbers, so that ties are ties and p is exactly rounded. Nothing is returned
/// without votes, nor where the outcomes are too many to count: kⁿ > 2¹²⁶, that is from 127 votes
/// on two options, 80 on three, 64 on four.
std::optional<double> equalSharesP(const VoteCounts& votes);

}  // namespace analysis
