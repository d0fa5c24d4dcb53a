#pragma once

#include <optional>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// The 76 rows of a published recording that the authors' program renders as its table, known by
/// the recorder's clock: 1,820.425 s to 1,820.659 s. They are rows 5900 to 5975 of the file in its
/// folder HAPTIC_RENDERING/MATLAB, and rows 13,486 to 13,561 of the whole recording.
///
/// @return nothing where @p recording is another one.
std::optional<RowRange> publishedCutIn(const Recording& recording);

}  // namespace haptics::recordings
