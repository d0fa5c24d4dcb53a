#include "haptics/recordings/cut.h"

#include <algorithm>
#include <cstddef>

#include "haptics/models/cut_detector.h"

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

CutLandmarks landmarksAlong(std::span<const double> travel, std::span<const double> force) {
  Detector detector;
  const std::size_t count = std::min(travel.size(), force.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto event = detector.feed(travel[i], force[i]);
    if (event == Detector::Event::CutCompleted) return landmarksOf(detector.lastCut());
  }
  return landmarksOf(detector.cut());
}

}  // namespace haptics::recordings
