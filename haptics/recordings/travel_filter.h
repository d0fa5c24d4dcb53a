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
/// One count of the published potentiometer is 0.256 travel units, so that the raw travel is a
/// staircase. Every filter delays nothing and is designed for the rate of the recording, so that a
/// frequency in hertz is one; `authors-fir-333` alone counts rows.
///
/// - `authors-fir` has the response, in hertz, of the authors' call `lowpass(x, 5, Fs)` in MATLAB:
///   a filters::KaiserLowPass with β = 5.653 and −6 dB at 17.69 Hz whose window lasts 0.144 s.
///   (5 Hz, which the paper calls the cut-off, is only the edge of the pass-band.) At 1000/3 Hz
///   these are the authors' 49 taps, at 1 kHz 145.
/// - `authors-fir-333` is what the authors did: the 49 taps for a nominal 1000/3 Hz, at any
///   rate. In a recording taken at 373 Hz the −6 dB point is really at 19.8 Hz. It reproduces all
///   the angles of the authors' table to the three decimals printed. The table fixes the −6 dB
///   point to 17.68…17.70 Hz; of these 17.69075 Hz also yields both numbers of eq. (22) of the
///   punch paper that depend on it, 7.0275 and 0.2772. How MATLAB treats the ends of a recording
///   no published number shows, since no published cut lies within 24 rows of one; here the end
///   values are held.
/// - `butterworth-zero-phase` is filters::zeroPhaseLowPass() at a cut-off of one's own. With 5 Hz
///   it does what the paper's text says.
/// - `none` leaves the travel as it is.
struct TravelFilter {
  enum class Kind : std::uint8_t { AuthorsFir, AuthorsFir333, ButterworthZeroPhase, None };

  Kind kind = Kind::AuthorsFir;
  double cutoff = 5.0;  ///< of `butterworth-zero-phase`: where the amplitude is halved [Hz]
};

/// The travel as the filter leaves it, row for row.
///
/// @param rate  of the recording [Hz]; not used by `authors-fir-333` and `none`.
/// @throws UserError  if the filter cannot be designed for that rate: it is not positive, not above
///     twice the cut-off, or (`authors-fir`) above 69 kHz.
std::vector<double> filtered(
    std::span<const double> travel, double rate, const TravelFilter& filter);

/// The variant as researchers write it, e.g. `authors-fir`.
std::string_view nameOf(TravelFilter::Kind kind) noexcept;

/// The variant of that name, if there is one.
std::optional<TravelFilter::Kind> travelFilterNamed(std::string_view name) noexcept;

/// The names of all variants.
std::vector<std::string> travelFilterNames();

/// Every parameter of it at that rate [Hz], in words, for those who want to filter alike.
std::string parametersOf(const TravelFilter& filter, double rate);

}  // namespace haptics::recordings
