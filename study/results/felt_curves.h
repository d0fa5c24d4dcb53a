#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The force that a condition really had: the commanded force while the tool closed or advanced,
/// over travel, in all finished trials of completed sessions. This is a manipulation check: if the
/// alternatives did not differ at the handle, no questionnaire could tell them apart.
struct FeltCurve {
  struct Point {
    double travel = 0.0;  ///< middle of a bin [device's travel unit]
    double low = 0.0;     ///< 10th percentile over strokes [N]
    double median = 0.0;  ///< [N]
    double high = 0.0;    ///< 90th percentile [N]
    int bin = 0;          ///< its number, as in medians
  };

  std::string condition;
  std::string device;
  int trials = 0;
  std::vector<Point> points;
  /// For bone: the force of its material at the travel of each point, moved slowly [N]; otherwise
  /// empty.
  std::vector<double> intended = {};
  /// The median force in every bin that a participant reached, by participant [N].
  std::map<std::string, std::map<int, double>> medians = {};
};

/// How much the force of two alternatives differed at the handle: the root mean square difference
/// of median forces [N]. Both values are over the same travel: what everyone who felt both passed
/// with both.
struct FeltDifference {
  std::string condition1;
  std::string condition2;
  double pooled = 0.0;                         ///< of the medians over all participants' strokes
  std::size_t participants = 0;                ///< who had both
  std::optional<double> mean;                  ///< of the participants' own differences
  std::optional<analysis::Interval> interval;  ///< of that mean, Student's, at 95 %
};

/// One curve for every condition that was rendered, in the protocol's order.
std::vector<FeltCurve> feltCurves(Study& study, RunMode mode);

/// The root mean square difference of the median from the material's force [N]; std::nullopt if
/// that is not known.
std::optional<double> rmsFromIntended(const FeltCurve& curve);

/// Every pair of curves of the same device over the same travel.
std::vector<FeltDifference> feltDifferences(const std::vector<FeltCurve>& curves);

}  // namespace study
