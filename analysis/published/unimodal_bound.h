#pragma once

#include <optional>

#include "analysis/data/likert_counts.h"

namespace analysis {

/// The largest variance that answers on the scale @p lowest … @p highest with the mean @p mean can
/// have while their distribution has one peak: rises up to some point, and falls from there on.
///
/// Every such distribution is a mixture of uniform ones over runs of points that all hold the peak
/// (Khintchine's theorem for whole numbers; Dharmadhikari & Joag-Dev 1988, ch. 4). The second
/// moment is linear in the mixture, so that two of them reach the largest variance for a given
/// mean. Population variance, without n − 1.
///
/// @throws std::invalid_argument  for a scale of fewer than two points or a mean outside it.
double largestUnimodalVariance(int lowest, int highest, double mean);

/// Whether answers scatter more than any distribution with one peak and their mean could: then they
/// have two camps, and their mean says what nobody thinks. Sample variance (n − 1) against the
/// bound times n / (n − 1). Nothing for fewer than two answers.
std::optional<bool> isBeyondUnimodal(const LikertCounts& counts);

}  // namespace analysis
