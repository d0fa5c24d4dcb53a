#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace haptics::recordings {

/// The filter that is applied to a recording's travel before the force is expressed over travel.
///
/// One count of the published potentiometer is 0.256 travel units, so the raw travel is a
/// staircase. Every filter is without delay (zero-phase) and designed for the sampling rate of the
/// recording, except `authors-fir-333`, which is designed per row.
///
/// - `authors-fir` has the frequency response of the authors' call `lowpass(x, 5, Fs)` in MATLAB: a
///   filters::KaiserLowPass with β = 5.653, −6 dB at 17.69 Hz and a window of 0.144 s. (5 Hz, which
///   the paper calls the cut-off, is only the edge of the pass-band.) At 1000/3 Hz this gives the
///   authors' 49 taps, at 1 kHz 145.
/// - `authors-fir-333` is what the authors did: the 49 taps for a nominal 1000/3 Hz, at any rate.
///   In a recording at 373 Hz the −6 dB point is really at 19.8 Hz. It reproduces all angles of the
///   authors' table to the three decimals printed. The table determines the −6 dB point as
///   17.68…17.70 Hz; 17.69075 Hz also gives both numbers of eq. (22) of the punch paper that depend
///   on it, 7.0275 and 0.2772. No published number shows how MATLAB treats the ends of a recording,
///   since no published cut is within 24 rows of one; these filters continue the end values.
/// - `butterworth-zero-phase` is filters::zeroPhaseLowPass() with a chosen cut-off. With 5 Hz it is
///   what the paper's text describes.
/// - `none` does not filter.
struct TravelFilter {
  enum class Kind : std::uint8_t { AuthorsFir, AuthorsFir333, ButterworthZeroPhase, None };

  Kind kind = Kind::AuthorsFir;
  /// Of `butterworth-zero-phase`: frequency at which the amplitude is halved [Hz].
  double cutoff = 5.0;
};

/// Returns the filtered travel, one value per row.
///
/// @param rate  sampling rate of the recording [Hz]; not used by `authors-fir-333` and `none`.
/// @throws UserError  if the filter cannot be designed for that rate: it is not positive, not above
///     twice the cut-off, or (`authors-fir`) above 69 kHz.
std::vector<double> filtered(
    std::span<const double> travel, double rate, const TravelFilter& filter);

/// The name of a filter in options and files, e.g. `authors-fir`.
std::string_view nameOf(TravelFilter::Kind kind) noexcept;

/// The filter of that name; std::nullopt if there is none.
std::optional<TravelFilter::Kind> travelFilterNamed(std::string_view name) noexcept;

/// The names of all filters.
std::vector<std::string> travelFilterNames();

/// Describes all parameters of the filter at @p rate [Hz], so that others can reproduce it.
std::string parametersOf(const TravelFilter& filter, double rate);

}  // namespace haptics::recordings
