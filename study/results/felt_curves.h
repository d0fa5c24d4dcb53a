#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

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
  int trials = 0;
  std::vector<Point> points;
  /// Of bone: what its material gives at the travel of each point, slowly [N]; else empty.
  std::vector<double> meant = {};
  /// Participant by participant, the median force in every bin that they felt [N].
  std::map<std::string, std::map<int, double>> medians = {};
};

/// How much two alternatives differed at the handle: the root of the mean squared difference of
/// median forces [N].
struct FeltDifference {
  std::string condition1;
  std::string condition2;
  double pooled = 0.0;                         ///< of the medians of everybody's samples
  std::size_t participants = 0;                ///< who felt both
  std::optional<double> mean;                  ///< of what it was for each of them
  std::optional<analysis::Interval> interval;  ///< of that mean, Student's, at 95 %
};

/// One curve for every condition that was felt, in the protocol's order.
std::vector<FeltCurve> feltCurves(Study& study, RunMode mode);

/// How far the median is from what the material gives: the root of the mean squared difference [N];
/// nothing where that is not known.
std::optional<double> rmsFromMeant(const FeltCurve& curve);

/// Every pair of curves that were felt on one device over the same travel.
std::vector<FeltDifference> feltDifferences(const std::vector<FeltCurve>& curves);

}  // namespace study
