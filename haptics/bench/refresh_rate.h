#pragma once

#include <array>
#include <string_view>

namespace haptics::bench {

/// A rendering of the punch with its mesh, as compared in Fig. 12 of the punch paper.
struct RefreshRate {
  std::string_view method;  ///< as measureRefresh() names it
  int elements = 0;         ///< N of the mesh
  double published = 0.0;   ///< update rate of the paper's Arduino Due, section III-D [Hz]
  /// Largest number of instructions of an update of Palpate on a Cortex-M3 in three cuts, in single
  /// precision, counted by QEMU (checked by tests/haptics/firmware/firmware_test.cpp).
  int instructions = 0;
};

inline constexpr std::array kRefreshRates{
    RefreshRate{"interpolation, with mesh", 5, 433.0, 1173},
    RefreshRate{"interpolation, with mesh", 10, 294.0, 1351},
    RefreshRate{"interpolation, with mesh", 15, 160.0, 1563},
    RefreshRate{"finite elements, with mesh", 5, 496.0, 493},
    RefreshRate{"finite elements, with mesh", 10, 326.0, 673},
    RefreshRate{"finite elements, with mesh", 15, 167.0, 883},
    RefreshRate{"Kalman filter, with mesh", 5, 375.0, 5408},
    RefreshRate{"Kalman filter, with mesh", 10, 276.0, 5555},
    RefreshRate{"Kalman filter, with mesh", 15, 147.0, 5785},
};

/// Clock rate of the paper's Arduino Due [Hz].
inline constexpr double kArduinoDueClock = 84e6;

}  // namespace haptics::bench
