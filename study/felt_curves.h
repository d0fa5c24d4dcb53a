#pragma once

#include <string>
#include <vector>

#include "study/run_mode.h"
#include "study/study.h"

namespace study {

/// What a condition really felt like: the force that was commanded while the tool closed or
/// advanced, over travel, in all finished trials of completed sessions. A manipulation check: had
/// the alternatives not differed at the handle, no questionnaire could tell them apart.
struct FeltCurve {
  struct Point {
    double travel = 0.0;  ///< middle of a bin [device's travel unit]
    double low = 0.0;     ///< a tenth of all samples lie below [N]
    double median = 0.0;  ///< [N]
    double high = 0.0;    ///< a tenth lie above [N]
  };

  std::string condition;
  std::string device;
  std::string travelUnit;
  int trials = 0;
  std::vector<Point> points;
  /// Of bone: what its material gives at the travel of each point, slowly [N]; else empty.
  std::vector<double> meant = {};
};

/// One curve for every condition that was felt, in the protocol's order.
std::vector<FeltCurve> feltCurves(Study& study, RunMode mode);

/// How far the median is from what the material gives: the root of the mean squared difference [N];
/// nothing where that is not known.
std::optional<double> rmsFromMeant(const FeltCurve& curve);

/// How much two curves differ where both were felt: the root of the mean squared difference of
/// their medians [N]; nothing where they share no travel.
std::optional<double> rmsDifference(const FeltCurve& a, const FeltCurve& b);

}  // namespace study
