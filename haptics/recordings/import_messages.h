#pragma once

#include <array>
#include <utility>

#include "base/message.h"

namespace haptics::recordings {

/// Why rows were chosen for a cut, and what an import changed.
inline constexpr auto kImportMessages = std::to_array<base::MessageKind>({
    {"cut_rows_asked_for", "rows {} to {} were asked for"},
    {"cut_asked_for", "asked for by number"},
    {"cut_only_candidate", "the only complete closure without a saturated row"},
    {"cut_most_typical", "nearest to the mean of the {} complete closures without a saturated row"},
    {"samples_merged",
     "{} of {} samples merged into their neighbours' mean, so that the travel rises strictly"},
    {"closures_averaged",
     "mean of {} closures at {} travels that all of them share, from {:.3f} to {:.3f}"},
    {"opening_kept", "the opening branch is kept as well, from {:.3f} down to {:.3f}"},
    {"opening_limited",
     "the opening branch is kept as well, from {:.3f} down to {:.3f}, slope limited, which moves "
     "it by up to {:.3f} N"},
    {"slope_limited",
     "slope limited to {:.2f} N per travel unit, which moves the force by up to {:.3f} N, most at "
     "travel {:.3f}; the recording rises by up to {:.2f} N per travel unit (over steps of {:.1f} "
     "travel units)"},
    {"peak_changed",
     "peak {:.2f} → {:.2f} N ({:+.1f} %); {} of {} points moved by more than {:.0f} % of the "
     "recorded "
     "peak"},
    {"peak_from_nothing",
     "peak {:.2f} → {:.2f} N; {} of {} points moved by more than {:.0f} % of the recorded peak"},
    {"rows_above_calibration", "{} rows read more than {:g} {}, beyond the sensor's calibration"},
    {"rows_beyond_calibration",
     "{} rows read less than {:g} or more than {:g} {}, beyond the sensor's calibration"},
    {"forces_negative",
     "the force is negative almost everywhere: if pressing gives negative values, write the "
     "'factor' -1 into the columns file"},
    {"peak_unlikely", "the peak is {:.4g} N: is the unit of the force right?"},
    {"travel_unlikely",
     "the travel goes from {:.1f} to {:.1f}, and 0 is open, 10 closed: are 'open' and 'closed' "
     "right?"},
    {"rows_saturated", "{} rows were saturated: their force is a lower bound"},
});

/// A message of kImportMessages with its arguments.
template <typename... Arguments>
base::Message importMessage(
    base::CheckedKey<kImportMessages, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kImportMessages>(key, std::forward<Arguments>(arguments)...);
}

}  // namespace haptics::recordings
