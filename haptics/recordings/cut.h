#pragma once

#include <optional>
#include <string>

#include "haptics/recordings/cut_landmarks.h"
#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/provenance.h"

namespace haptics::recordings {

/// One cut, ready to be felt: the content of a cut file.
struct Cut {
  std::string name{};   ///< for files and protocols
  std::string title{};  ///< for people
  std::string unit =
      "travel_unit";  ///< of every travel in it, until a laboratory supplies a factor
  ForceCurve curve;
  std::optional<ForceCurve> opening{};  ///< what was recorded while the tool opened again
  CutLandmarks landmarks{};             ///< as measured, before the slope was limited
  Provenance provenance{};
  bool isSynthetic = false;  ///< nobody recorded it
};

}  // namespace haptics::recordings
