#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace haptics::recordings {

/// What is done to the travel of a recording before a force is plotted over it.
///
/// One count of the potentiometer is 0.256 travel units, so that the raw travel is a staircase.
///
/// - `authors-fir` is what the authors' call `lowpass(x, 5, Fs)` in MATLAB does: a KaiserLowPass
///   of 49 taps, β = 5.653, −6 dB at 17.69 Hz, at a nominal Fs of 1000/3 Hz. (5 Hz, which the
///   paper calls the cut-off, is only the edge of the pass-band.) It reproduces all the angles of
///   the authors' table to the three decimals printed. The table fixes the −6 dB point to
///   17.68…17.70 Hz; of these 17.69075 Hz also yields both numbers of eq. (22) of the punch paper
///   that depend on it, 7.0275 and 0.2772.
///
///   It counts rows and not seconds, as theirs does: in a recording taken at 373 Hz the −6 dB
///   point is really at 19.8 Hz. How MATLAB treats the ends of a recording no published number
///   shows, since no published cut lies within 24 rows of one; here the end values are held.
/// - `none` leaves the travel as it is.
enum class TravelFilter : std::uint8_t { AuthorsFir, None };

/// The travel as the filter leaves it, row for row.
std::vector<double> filtered(std::span<const double> travel, TravelFilter filter);

/// The variant as researchers write it, e.g. `authors-fir`.
std::string_view nameOf(TravelFilter filter) noexcept;

/// Every parameter of it, in words, for whoever wants to filter alike.
std::string parametersOf(TravelFilter filter);

/// The variant of that name, if there is one.
std::optional<TravelFilter> travelFilterNamed(std::string_view name) noexcept;

}  // namespace haptics::recordings
