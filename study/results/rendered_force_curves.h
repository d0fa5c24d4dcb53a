#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "analysis/numerics/interval.h"
#include "study/model/run_mode.h"
#include "study/session/study.h"

namespace study {

/// The commanded force of a condition over travel, while the tool closed or advanced, in all
/// finished trials of completed sessions, except optional trials. It is a manipulation check: if
/// the forces of two alternatives do not differ at the handle, forces cannot be the cause of
/// differences in questionnaires.
struct RenderedForceCurve {
  /// The forces in one bin of travel.
  struct Point {
    double travel = 0.0;      ///< middle of a bin [device's travel unit]
    double low = 0.0;         ///< 10th percentile over strokes [N]
    double median = 0.0;      ///< [N]
    double high = 0.0;        ///< 90th percentile [N]
    int bin = 0;              ///< number of the bin, the key in RenderedForceCurve::medians
    double atMostFeed = 0.0;  ///< share of the strokes that went as fast as the reamer cuts
  };

  std::string condition;
  std::string device;
  int trials = 0;
  std::size_t strokes = 0;    ///< number of strokes in the bin that most strokes passed
  std::vector<Point> points;  ///< bins that at least half as many strokes passed
  /// For bone: the quasi-static force of the material at the travel of each point [N]; otherwise
  /// empty.
  std::vector<double> intended = {};
  /// The largest speed of a tool through bone [m/s]; infinite if there is no limit.
  double mostFeed = std::numeric_limits<double>::infinity();
  /// The median force in every bin that a participant reached, by participant [N].
  std::map<std::string, std::map<int, double>> medians = {};
};

/// How much the forces of two conditions differed at the handle: the root mean square difference of
/// median forces [N]. Both `pooled` and `mean` use only the bins that every participant with both
/// conditions passed in both.
struct RenderedForceDifference {
  std::string condition1;
  std::string condition2;
  double pooled = 0.0;                         ///< between the medians over everybody's strokes
  std::size_t participants = 0;                ///< number of participants with both conditions
  std::optional<double> mean;                  ///< mean of the differences within participants
  std::optional<analysis::Interval> interval;  ///< Student's 95 % interval of that mean
};

/// One curve for every condition that was rendered, in the protocol's order.
std::vector<RenderedForceCurve> renderedForceCurves(Study& study, RunMode mode);

/// The root mean square difference between the medians and RenderedForceCurve::intended [N];
/// std::nullopt if `intended` is empty.
std::optional<double> rmsFromIntended(const RenderedForceCurve& curve);

/// Where most strokes went as fast as the reamer cuts: hands then push against this limit, and more
/// is felt than the material gives.
struct FeedLimited {
  double from = 0.0;  ///< [device's travel unit]
  double to = 0.0;    ///< [device's travel unit]
  double most = 0.0;  ///< largest median force above RenderedForceCurve::intended [N]
};
/// std::nullopt if there is no such place.
std::optional<FeedLimited> feedLimitedIn(const RenderedForceCurve& curve);

/// The differences between all pairs of curves of the same device. Pairs without a common
/// bin are left out.
std::vector<RenderedForceDifference> renderedForceDifferences(
    const std::vector<RenderedForceCurve>& curves);

}  // namespace study
