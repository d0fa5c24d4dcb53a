#pragma once

#include <cstddef>
#include <span>

#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"

namespace haptics::recordings {

/// How force and stiffness vary over recorded cuts: Q of eq. (22) of the punch paper, for cuts of
/// one's own. Variances with n − 1.
struct ProcessNoise {
  double force = 0.0;       ///< σ²_f [N²]
  double covariance = 0.0;  ///< of force and stiffness [N²/travel unit]
  double stiffness = 0.0;   ///< σ²_ζ [N²/travel unit²]
  std::size_t samples = 0;  ///< that went in
  std::size_t resting = 0;  ///< left out: the travel hardly changed, and there is no quotient
};

/// A tenth of a count of the potentiometer [travel units]: over less, a difference quotient says
/// nothing about the tissue. The published numbers leave nothing out: with this step the ten cuts
/// give 5.94, 0.002 and 2.62.
inline constexpr double kLeastStep = 0.0256;

/// Puts the rows of all ranges one after another; the stiffness of a row is the difference quotient
/// from the row before it in that list, and 0 for the first. With a least step of 0 that reproduces
/// the published numbers (6.1024, 0.2772 and 7.0275 from ten ranges of one recording).
///
/// @param rows       within the trace, one range or more.
/// @param leastStep  a row that has moved on by less than this, or not at all, is left out [travel
///                   units].
/// @throws Error  if fewer than three rows remain.
ProcessNoise processNoiseOf(
    const Trace& trace, std::span<const RowRange> rows, double leastStep = kLeastStep);

}  // namespace haptics::recordings
