#pragma once

#include <array>
#include <string_view>

namespace haptics::bench {

/// A rendering of the punch with its mesh, as Fig. 12 of the punch paper compares three.
struct RefreshRate {
  std::string_view method;  ///< as measureRefresh() names it
  int elements = 0;         ///< N of the mesh
  double published = 0.0;   ///< updates a second of the paper's Arduino Due, III-D [Hz]
  /// Of an update of ours on a Cortex-M3, the most in three cuts, counted by QEMU in single
  /// precision (tests/haptics/firmware/firmware_test.cpp holds them).
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

/// Of the Arduino Due that the paper used [Hz].
inline constexpr double kDueClock = 84e6;

}  // namespace haptics::bench
