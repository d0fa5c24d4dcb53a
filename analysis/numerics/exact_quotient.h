#pragma once

#include "analysis/numerics/double_double.h"

namespace analysis {

/// A whole number of 128 bits: what sums of squares of very many answers need.
__extension__ using Wide = __int128;

/// The quotient of two whole numbers; its high part is the exactly rounded double,
/// and both together have all the digits of a DoubleDouble.
///
/// @param numerator    of less than 2^127
/// @param denominator  between 1 and 2^126
DoubleDouble exactQuotient(Wide numerator, Wide denominator);

}  // namespace analysis
