#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace haptics::recordings {

/// From the reading of the force sensor to newtons.
///
/// With r the reading in counts (10 bits, 0…1023):
///
///     paper-eq1       f = (3·10⁻⁷ r³ − 2·10⁻⁴ r² + 0.7815 r) · 9.81·10⁻³
///     recorder-2021   f = (3·10⁻⁷ r³ − 3·10⁻⁴ r² + 0.7261 r) · 9.81·10⁻³
///
/// The first is eq. (1) of the punch paper. The second is the force column of the published
/// recordings (there in grams, whatever their heading says) and is kept to compare with; it reads
/// a sixth less at full scale.
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

}  // namespace haptics::recordings
