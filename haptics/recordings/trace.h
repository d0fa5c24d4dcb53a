#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

/// A low-pass that delays nothing: a symmetric finite filter, applied about the middle.
///
/// The n = 2m + 1 taps are an ideal low-pass under a Kaiser window, scaled to a gain of one at
/// rest:
///
///     h(j) ∝ sin(2π f j / Fs) / (π j) · I₀(β √(1 − (j/m)²)) / I₀(β),   j = −m … m,   Σ h = 1
///
///     y(i) = Σ h(j) x(i + j)
///
/// At the cut-off f the gain is one half (−6 dB). Before the first sample and after the last one
/// the signal is taken to go on as it began or ended; so a signal that rests at its ends is not
/// pulled to zero there, and any constant stays what it is.
class KaiserLowPass {
 public:
  struct Design {
    int taps = 49;                     ///< odd
    double beta = 5.653;               ///< shape of the window; 5.653 is a stop-band of 60 dB
    double cutoff = 17.69075;          ///< f, where the gain is −6 dB [Hz]
    double sampleRate = 1000.0 / 3.0;  ///< Fs [Hz]
  };

  /// @throws std::invalid_argument  if taps is even, less than 3 or more than 9,999, beta negative
  ///     or more than 100, or the cut-off not between 0 and half the sample rate.
  explicit KaiserLowPass(const Design& design);

  std::span<const double> taps() const noexcept { return taps_; }

  /// As many samples as went in.
  std::vector<double> filtered(std::span<const double> signal) const;

 private:
  std::vector<double> taps_;
};

/// From the reading of the force sensor to newtons.
///
/// With r the reading in counts (10 bits, 0…1023):
///
///     paper-eq1       f = (3·10⁻⁷ r³ − 2·10⁻⁴ r² + 0.7815 r) · 9.81·10⁻³
///     recorder-2021   f = (3·10⁻⁷ r³ − 3·10⁻⁴ r² + 0.7261 r) · 9.81·10⁻³
///
/// The first is eq. (1) of the punch paper. The second is the force column of the published
/// recordings (there in grams, although their heading says otherwise) and is kept to compare with;
/// it reads a sixth less at full scale.
enum class ForceCalibration : std::uint8_t { PaperEq1, Recorder2021 };

/// From here on the sensor says no more: a force is a lower bound [counts].
inline constexpr double kSaturatedReading = 1023.0;

/// Up to here (900 g) readings and loads kept together in the authors' calibration; readings from
/// here on stood for 700 to 1,300 g [counts].
inline constexpr double kUncalibratedReading = 870.0;

/// The force [N] at a reading [counts].
double forceOf(double reading, ForceCalibration calibration) noexcept;

/// The variant as researchers write it, e.g. `paper-eq1`.
std::string_view nameOf(ForceCalibration calibration) noexcept;

/// The variant of that name, if there is one.
std::optional<ForceCalibration> forceCalibrationNamed(std::string_view name) noexcept;

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

/// Every parameter of it, in words, for those who want to filter alike.
std::string parametersOf(TravelFilter filter);

/// The variant of that name, if there is one.
std::optional<TravelFilter> travelFilterNamed(std::string_view name) noexcept;

/// A recording as force over travel: calibrated and filtered, row for row.
struct Trace {
  std::vector<double> travel;  ///< filtered [travel units]
  std::vector<double> force;   ///< from the reading [N]
};

/// The filter runs over the whole recording, as the authors' did, and not over one cut.
Trace traceOf(const Recording& recording, ForceCalibration calibration, TravelFilter filter);

/// Some rows of a trace as a curve; see monotoneCurve().
///
/// @param rows  within the trace.
/// @throws Error  if they give fewer than two different travels.
MonotoneCurve curveOf(const Trace& trace, const RowRange& rows);

/// The same of an opening hand, whose travel falls: read backwards. Nothing where it does not fall.
std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows);

/// How force and stiffness vary over recorded cuts: Q of eq. (22) of the punch paper, for cuts of
/// one's own. Variances with n − 1.
struct ProcessNoise {
  double force = 0.0;       ///< σ²_f [N²]
  double covariance = 0.0;  ///< of force and stiffness [N²/travel unit]
  double stiffness = 0.0;   ///< σ²_ζ [N²/travel unit²]
  std::size_t samples = 0;  ///< that went in
  std::size_t resting = 0;  ///< left out: the travel hardly changed, and there is no quotient
};

/// A tenth of a count of the potentiometer [travel units]: with smaller steps a difference quotient
/// is only noise. The published numbers include all rows: with this step the ten cuts give 5.94,
/// 0.002 and 2.62.
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
