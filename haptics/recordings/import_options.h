#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "haptics/recordings/force_calibration.h"
#include "haptics/recordings/row_range.h"
#include "haptics/recordings/travel_filter.h"

namespace haptics::recordings {

/// Which cut to take from a recording, and how.
///
/// Closures or rows, not both. Neither takes the closure that is most typical: of the complete
/// closures without a saturated row that whose curve is least far from the mean of all of theirs.
struct ImportOptions {
  std::vector<std::size_t> closures{};  ///< from 1; several become their mean curve
  std::optional<RowRange> rows{};
  ForceCalibration calibration = ForceCalibration::PaperEq1;
  TravelFilter filter = TravelFilter::AuthorsFir;

  /// Where the curve is steeper than this, it is made gentler [N/travel unit]. 4.39 is the largest
  /// stiffness that the punch paper finds in its cuts (V, below eq. (25)) and for which it works
  /// out how much damping the device needs to stay passive. The table that it then renders is as
  /// steep as 18.9 in its noisy end, so that the margin printed was not the margin felt.
  double maxSlope = 4.39;

  std::string name{};   ///< empty: the file's name without its ending
  std::string title{};  ///< empty: says which rows of which file it is
};

}  // namespace haptics::recordings
