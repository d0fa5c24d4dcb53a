#include "haptics/recordings/cut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>
#include <vector>

#include "haptics/models/cut_detector.h"
#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

namespace {

using Detector = models::CutDetector<double>;

std::optional<CurvePoint> point(const Detector::Landmark& landmark) {
  if (!landmark.found) return std::nullopt;
  return CurvePoint{landmark.travel, landmark.force};
}

CutLandmarks landmarksOf(const Detector::Cut& cut) {
  return {point(cut.interception), point(cut.yield), point(cut.bottomOut), point(cut.opening)};
}

}  // namespace

CutLandmarks landmarksAlong(
    std::span<const double> travel, std::span<const double> force, double yieldLoad) {
  constexpr double kLeftAfterAYield = 0.25;
  Detector detector({.yieldLoad = yieldLoad, .leastLoadAfterYield = kLeftAfterAYield});
  const std::size_t count = std::min(travel.size(), force.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto event = detector.feed(travel[i], force[i]);
    if (event == Detector::Event::CutCompleted) return landmarksOf(detector.lastCut());
  }
  return landmarksOf(detector.cut());
}

namespace {

/// A cubic between two points with given slopes.
struct Piece {
  CurvePoint from;
  CurvePoint to;
  double slopeFrom = 0.0;
  double slopeTo = 0.0;

  double length() const { return to.travel - from.travel; }
  double secant() const { return (to.force - from.force) / length(); }

  CurvePoint at(double s) const {
    const double bend = slopeFrom * s * (1.0 - s) * (1.0 - s) + secant() * s * s * (3.0 - 2.0 * s) -
                        slopeTo * s * s * (1.0 - s);
    return {from.travel + length() * s, from.force + length() * bend};
  }
};

std::array<CurvePoint, 6> landmarksOf(const CutShape& shape) {
  const CurvePoint start{shape.start, shape.interception.force};
  return {start, shape.interception, shape.yield, shape.through, shape.bottomOut, shape.end};
}

std::array<Piece, 5> piecesOf(const CutShape& shape) {
  const auto points = landmarksOf(shape);
  std::array<Piece, 5> pieces{};
  for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i] = {points[i], points[i + 1]};
  const double slowFall = pieces[3].secant();
  pieces[2].slopeTo = slowFall;
  pieces[3].slopeFrom = slowFall;
  pieces[4].slopeTo = 1.5 * pieces[4].secant();
  return pieces;
}

void requireValid(const CutShape& shape) {
  const auto points = landmarksOf(shape);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool isNumber = std::isfinite(points[i].travel) && std::isfinite(points[i].force);
    if (!isNumber || points[i].force < 0.0) {
      throw std::invalid_argument("a landmark of a cut has a finite travel and a force from 0 on");
    }
    if (i > 0 && !(points[i].travel > points[i - 1].travel)) {
      throw std::invalid_argument("the landmarks of a cut follow one another in travel");
    }
  }
  const auto pieces = piecesOf(shape);
  const bool fallsFastThenSlowly =
      pieces[3].secant() < 0.0 && pieces[2].secant() <= pieces[3].secant();
  if (!(pieces[1].secant() > 0.0) || !fallsFastThenSlowly || !(pieces[4].secant() > 0.0)) {
    throw std::invalid_argument("the force of a cut rises, falls, falls more slowly and rises");
  }
  if (!(shape.release >= 0.0) || !std::isfinite(shape.release)) {
    throw std::invalid_argument("the force of a cut falls to nothing over a length from 0 on");
  }
  const double whole = shape.end.travel - shape.start;
  if (!(shape.openingShare >= 0.0 && shape.openingShare <= 1.0)) {
    throw std::invalid_argument("opening gives back a share from 0 to 1 of the force of closing");
  }
  if (!(shape.spacing >= 1e-4 * whole && shape.spacing <= 0.1 * whole)) {
    throw std::invalid_argument("the nodes of a cut are 0.0001 to 0.1 of its length apart");
  }
}

ForceCurve curveOfShape(const CutShape& shape) {
  std::vector<CurvePoint> nodes{landmarksOf(shape).front()};
  for (const Piece& piece : piecesOf(shape)) {
    // The subtraction prevents an additional step by rounding.
    const int steps = static_cast<int>(std::ceil(piece.length() / shape.spacing - 1e-9));
    for (int i = 1; i < steps; ++i) nodes.push_back(piece.at(static_cast<double>(i) / steps));
    nodes.push_back(piece.to);
  }
  if (shape.release > 0.0) nodes.push_back({shape.end.travel + shape.release, 0.0});
  return ForceCurve(std::move(nodes));
}

}  // namespace

Cut parametricCut(const CutShape& shape) {
  requireValid(shape);
  SlopeLimited limitedCurve = limitSlope(curveOfShape(shape), shape.maxSlope);
  Provenance provenance{.statement = "parametric; not a recording", .slopeLimit = shape.maxSlope};
  if (limitedCurve.largestChange > 0.0) {
    provenance.changes.push_back(
        "slope limited to " + decimal(shape.maxSlope, 2) + " N per travel unit");
  }
  std::vector<CurvePoint> opening;
  for (const CurvePoint& node : limitedCurve.curve.nodes()) {
    opening.push_back({node.travel, shape.openingShare * node.force});
  }
  return {
      .name = "parametric-cut",
      .title = "A cut of our own making, built from landmarks",
      .curve = std::move(limitedCurve.curve),
      .opening = ForceCurve(std::move(opening)),
      .landmarks =
          {.interception = shape.interception,
           .yield = shape.yield,
           .bottomOut = shape.bottomOut,
           .opening = shape.end},
      .provenance = std::move(provenance),
      .isSynthetic = true};
}

std::optional<RowRange> publishedCutIn(const Recording& recording) {
  constexpr double kBegin = 1'820'425.0;  // [ms]
  constexpr double kEnd = 1'820'659.0;    // [ms]
  constexpr std::ptrdiff_t kRows = 76;
  const auto& rows = recording.rows;
  const auto first =
      std::ranges::find_if(rows, [](const Recording::Row& row) { return row.time == kBegin; });
  if (rows.end() - first < kRows || first[kRows - 1].time != kEnd) return std::nullopt;
  const auto before = static_cast<std::size_t>(first - rows.begin());
  return RowRange{before + 1, before + kRows};
}

}  // namespace haptics::recordings
