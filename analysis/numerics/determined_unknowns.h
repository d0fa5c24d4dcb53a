#pragma once

#include <cstddef>
#include <vector>

namespace analysis {

/// The number of unknowns that have one value in all solutions of a system of linear equations,
/// for any right-hand sides: those that are 0 in the whole null space of its coefficients.
///
/// @param coefficients  a row an equation, each as long as the first; empty rows and no rows are
///                      allowed, and determine nothing.
std::size_t determinedUnknowns(const std::vector<std::vector<double>>& coefficients);

}  // namespace analysis
