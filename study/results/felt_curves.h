#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The rendered force of a condition: the commanded force while the tool closed or advanced, over
/// travel, in all finished trials of completed sessions. This is a manipulation check: if the
/// forces of alternatives do not differ at the handle, questionnaires cannot differ because of
/// them.
struct FeltCurve {
  struct Point {
    double travel = 0.0;  ///< middle of a bin [device's travel unit]
    double low = 0.0;     ///< 10th percentile over strokes [N]
    double median = 0.0;  ///< [N]
    double high = 0.0;    ///< 90th percentile [N]
    int bin = 0;          ///< number of the bin, the key in FeltCurve::medians
  };

  std::string condition;
  std::string device;
  int trials = 0;
  std::vector<Point> points;
  /// For bone: the quasi-static force of its material at the travel of each point [N]; otherwise
  /// empty.
  std::vector<double> intended = {};
  /// The median force in every bin that a participant reached, by participant [N].
  std::map<std::string, std::map<int, double>> medians = {};
};

/// How much the force of two alternatives differed at the handle: the root mean square difference
/// of median forces [N]. Both values are over the same travel: the bins that every participant with
/// both alternatives passed with both.
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

/// The root mean square difference of the medians from FeltCurve::intended [N]; std::nullopt if
/// that is empty.
std::optional<double> rmsFromIntended(const FeltCurve& curve);

/// The differences between all pairs of curves of the same device. Pairs without a common
/// bin are left out.
std::vector<FeltDifference> feltDifferences(const std::vector<FeltCurve>& curves);

}  // namespace study
