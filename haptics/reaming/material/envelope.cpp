#include "haptics/reaming/material/envelope.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace haptics::reaming {
namespace {

/// Value and weight of a specimen at a depth.
struct Member {
  double value = 0.0;
  double share = 1.0;  ///< weight, 0 to 1
};

Member memberAt(const SpecimenCurve& specimen, std::size_t place, double depth) {
  if (place < specimen.curve.size()) return {specimen.curve.y[place], 1.0};
  if (specimen.isCensored) return {specimen.last, 1.0};
  return {specimen.last, std::clamp(1.0 - (depth - specimen.end) / kFadeOutDepth, 0.0, 1.0)};
}

double meanOf(std::span<const Member> members) {
  double sum = 0.0;
  double shares = 0.0;
  for (const auto& member : members) {
    sum += member.share * member.value;
    shares += member.share;
  }
  return sum / shares;
}

/// The expected extreme (largest or smallest value) of a random sample, in which each member is
/// included with a probability equal to its share; at least one share must be 1.
template <typename Before>
double expectedExtreme(std::span<const Member> members, Before before) {
  std::vector<Member> sorted(members.begin(), members.end());
  std::ranges::sort(
      sorted, [&](const Member& a, const Member& b) { return before(a.value, b.value); });
  double expected = 0.0;
  double left = 1.0;  // probability that the sample has none of the members so far
  for (const auto& member : sorted) {
    expected += left * member.share * member.value;
    left *= 1.0 - member.share;
    if (left <= 0.0) break;
  }
  return expected;
}

double expectedMinimum(std::span<const Member> members) {
  return expectedExtreme(members, [](double a, double b) { return a < b; });
}
double expectedMaximum(std::span<const Member> members) {
  return expectedExtreme(members, [](double a, double b) { return a > b; });
}

/// A statistic of the specimens as a function of depth. An offset compensates the fall that a
/// leaving specimen would cause; see depthEnvelopeOf().
class StatisticAlongDepth {
 public:
  using Statistic = double (*)(std::span<const Member>);

  explicit StatisticAlongDepth(Statistic statistic) : statistic_(statistic) {}

  double next(const std::vector<Member>& now) {
    const double value = statistic_(now);
    if (!previousMembers_.empty()) {
      auto moved = now;  // the present values with the previous shares
      for (std::size_t i = 0; i < moved.size(); ++i) moved[i].share = previousMembers_[i].share;
      const double values = statistic_(moved);
      addChange(values - value_, value - values);
    }
    previousMembers_ = now;
    value_ = value;
    return value + offset_;
  }

 private:
  /// @param rise    change of the statistic that the changed values caused.
  /// @param change  change of the statistic that the changed weights caused.
  void addChange(double rise, double change) {
    totalRise_ += rise;
    if (offset_ == 0.0) highestRise_ = totalRise_;
    if (totalRise_ > highestRise_) {
      offset_ = std::max(0.0, offset_ - (totalRise_ - highestRise_));
      highestRise_ = totalRise_;
    }
    if (change != 0.0) offset_ = std::max(0.0, offset_ - change);
  }

  Statistic statistic_;
  std::vector<Member> previousMembers_;
  double value_ = 0.0;
  double offset_ = 0.0;       // offset that compensates leaving specimens
  double totalRise_ = 0.0;    // total change of the statistic caused by the values
  double highestRise_ = 0.0;  // maximum of totalRise_ while offset_ is not 0
};

const SampledCurve& longestOf(std::span<const SpecimenCurve> specimens) {
  return std::ranges::max_element(
             specimens,
             [](const auto& a, const auto& b) { return a.curve.size() < b.curve.size(); })
      ->curve;
}

/// The curve of one specimen at all depths, constant beyond its end.
SampledCurve extended(const SpecimenCurve& specimen, const std::vector<double>& places) {
  SampledCurve curve{places, specimen.curve.y};
  curve.y.resize(places.size(), specimen.last);
  return curve;
}

Envelope singleSampleEnvelope(
    std::span<const SpecimenCurve> specimens, const std::vector<double>& places) {
  std::size_t common = places.size();
  for (const auto& specimen : specimens) common = std::min(common, specimen.curve.size());
  std::vector<std::size_t> order(specimens.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto total = [&](std::size_t i) {
    const auto& y = specimens[i].curve.y;
    return std::accumulate(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(common), 0.0);
  };
  std::ranges::stable_sort(
      order, [&](std::size_t a, std::size_t b) { return total(a) < total(b); });
  return {
      extended(specimens[order.front()], places),
      extended(specimens[order[order.size() / 2]], places),
      extended(specimens[order.back()], places)};
}

Envelope pointwiseEnvelope(
    std::span<const SpecimenCurve> specimens, const std::vector<double>& places) {
  Envelope envelope;
  for (auto* curve : {&envelope.minimum, &envelope.average, &envelope.maximum}) curve->x = places;
  StatisticAlongDepth smallest(expectedMinimum);
  StatisticAlongDepth mean(meanOf);
  StatisticAlongDepth largest(expectedMaximum);
  std::vector<Member> members(specimens.size());
  for (std::size_t place = 0; place < places.size(); ++place) {
    for (std::size_t i = 0; i < members.size(); ++i) {
      members[i] = memberAt(specimens[i], place, places[place]);
    }
    const double low = smallest.next(members);
    const double high = std::max(low, largest.next(members));
    envelope.minimum.y.push_back(low);
    envelope.average.y.push_back(std::clamp(mean.next(members), low, high));
    envelope.maximum.y.push_back(high);
  }
  return envelope;
}

Envelope statisticsOfPresent(
    std::span<const SpecimenCurve> specimens, const std::vector<double>& places) {
  Envelope envelope;
  for (auto* curve : {&envelope.minimum, &envelope.average, &envelope.maximum}) curve->x = places;
  for (std::size_t place = 0; place < places.size(); ++place) {
    std::vector<Member> members;
    for (const auto& specimen : specimens) {
      if (place < specimen.curve.size()) members.push_back({specimen.curve.y[place], 1.0});
    }
    envelope.minimum.y.push_back(expectedMinimum(members));
    envelope.average.y.push_back(meanOf(members));
    envelope.maximum.y.push_back(expectedMaximum(members));
  }
  return envelope;
}

/// Counts the specimens at each depth.
DepthEnvelope withSpecimenCounts(std::span<const SpecimenCurve> specimens, bool canBeHeld) {
  DepthEnvelope result;
  for (std::size_t place = 0; place < longestOf(specimens).size(); ++place) {
    int measured = 0;
    int held = 0;
    for (const auto& specimen : specimens) {
      const bool isMeasured = place < specimen.curve.size();
      measured += isMeasured ? 1 : 0;
      held += !isMeasured && canBeHeld && specimen.isCensored ? 1 : 0;
    }
    result.measured.push_back(measured);
    result.held.push_back(held);
  }
  return result;
}

}  // namespace

DepthEnvelope depthEnvelopeOf(std::span<const SpecimenCurve> specimens, EnvelopeRule rule) {
  const auto& places = longestOf(specimens).x;
  DepthEnvelope result = withSpecimenCounts(specimens, true);
  result.curves = rule == EnvelopeRule::Pointwise ? pointwiseEnvelope(specimens, places)
                                                  : singleSampleEnvelope(specimens, places);
  return result;
}

DepthEnvelope envelopeOfRunningTests(std::span<const SpecimenCurve> specimens, EnvelopeRule rule) {
  const auto& places = longestOf(specimens).x;
  DepthEnvelope result = withSpecimenCounts(specimens, false);
  result.curves = rule == EnvelopeRule::Pointwise ? statisticsOfPresent(specimens, places)
                                                  : singleSampleEnvelope(specimens, places);
  return result;
}

namespace {

using HermiteNodes = std::vector<models::HermiteNode<double>>;

/// The difference of the slopes of @p upper and @p lower at node @p i, limited so that the curves
/// do not cross.
double boundedDifference(const HermiteNodes& lower, const HermiteNodes& upper, std::size_t i) {
  const double gap = std::max(0.0, upper[i].force - lower[i].force);
  double difference = upper[i].slope - lower[i].slope;
  if (i > 0) {
    difference = std::min(difference, 3.0 * gap / (upper[i].position - upper[i - 1].position));
  }
  if (i + 1 < upper.size()) {
    difference = std::max(difference, -3.0 * gap / (upper[i + 1].position - upper[i].position));
  }
  return difference;
}

/// Adjusts the slopes of the outer curves so that they do not cross the middle one.
void boundOuterSlopes(EnvelopeSplines& splines) {
  auto& [low, middle, high] = splines;
  for (std::size_t i = 0; i < middle.nodes.size(); ++i) {
    const double below = boundedDifference(low.nodes, middle.nodes, i);
    const double above = boundedDifference(middle.nodes, high.nodes, i);
    low.nodes[i].slope = middle.nodes[i].slope - below;
    high.nodes[i].slope = middle.nodes[i].slope + above;
  }
  low = splineOf(low.nodes);
  high = splineOf(high.nodes);
}

struct Worst {
  double error = 0.0;
  std::size_t at = 0;
};

Worst worstOf(const SampledCurve& curve, const Spline& spline, double floor) {
  Worst worst;
  std::size_t piece = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    while (piece + 1 < spline.segments.size() && spline.segments[piece].end < curve.x[i]) ++piece;
    const double off = std::abs(spline.segments[piece].at(curve.x[i]).force - curve.y[i]);
    const double error = off / std::max(std::abs(curve.y[i]), floor);
    if (error > worst.error) worst = {error, i};
  }
  return worst;
}

/// Adds the node @p at; returns false if it was one already.
bool addNode(std::vector<std::size_t>& nodes, std::size_t at) {
  const auto place = std::lower_bound(nodes.begin(), nodes.end(), at);
  if (place != nodes.end() && *place == at) return false;
  nodes.insert(place, at);
  return true;
}

}  // namespace

EnvelopeSplines orderedSplines(const Envelope& envelope, const NodeCriterion& nodeCriterion) {
  const std::array<const SampledCurve*, 3> curves{
      &envelope.minimum, &envelope.average, &envelope.maximum};
  std::vector<std::size_t> nodes;
  std::array<std::vector<double>, 3> slopes;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    const auto own = chooseNodes(*curves[c], nodeCriterion).nodes;
    nodes.insert(nodes.end(), own.begin(), own.end());
    slopes[c] = dataSlopes(*curves[c]);
  }
  std::ranges::sort(nodes);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  while (true) {
    EnvelopeSplines splines;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      splines[c] = splineThrough(*curves[c], slopes[c], nodes, nodeCriterion.kind);
    }
    // Linear pieces between ordered nodes cannot cross.
    if (nodeCriterion.kind != SplineKind::Linear) boundOuterSlopes(splines);
    bool hasAdded = false;
    for (std::size_t c = 0; c < curves.size(); ++c) {
      const auto worst = worstOf(*curves[c], splines[c], nodeCriterion.floor);
      if (worst.error > nodeCriterion.error) hasAdded |= addNode(nodes, worst.at);
    }
    if (!hasAdded) return splines;
  }
}

}  // namespace haptics::reaming
