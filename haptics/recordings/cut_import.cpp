#include "haptics/recordings/cut_import.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "haptics/recordings/force_curve.h"
#include "haptics/recordings/import_messages.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {

namespace {

std::string describe(std::span<const RowRange> ranges) {
  std::string words;
  for (const RowRange& rows : ranges) {
    if (!words.empty()) words += ", ";
    words += std::to_string(rows.first) + "-" + std::to_string(rows.last);
  }
  return "rows " + words;
}

/// The chosen rows as one curve; adds the number of merged samples to the report.
ForceCurve recordedCurve(const Trace& trace, ImportReport& report) {
  std::vector<ForceCurve> curves;
  std::size_t samples = 0;
  for (const RowRange& rows : report.rows) {
    MonotoneCurve recordedCurve = curveOf(trace, rows);
    samples += recordedCurve.samples;
    report.mergedSamples += recordedCurve.merged;
    curves.push_back(std::move(recordedCurve.curve));
  }
  if (report.mergedSamples > 0) {
    report.changes.push_back(importMessage("samples_merged", report.mergedSamples, samples));
  }
  if (curves.size() == 1) return curves.front();

  std::optional<MeanCurve> mean = meanCurve(curves);
  if (!mean)
    throw base::UserError("The chosen closures share no travel: choose others, or only one.");
  report.deviation = std::move(mean->deviation);
  report.changes.push_back(importMessage(
      "closures_averaged",
      curves.size(),
      MeanCurve::kNodes,
      mean->curve.start(),
      mean->curve.end()));
  return mean->curve;
}

/// The opening branch recorded after the chosen closures; std::nullopt if rows were requested, the
/// hand did not open, or the openings have no common travel.
std::optional<ForceCurve> openingBranchOf(
    const Trace& trace, double maxSlope, ImportReport& report) {
  std::vector<ForceCurve> curves;
  for (const std::size_t number : report.closures) {
    auto branch = openingCurveOf(trace, report.survey.closures[number - 1].opening);
    if (!branch) return std::nullopt;
    curves.push_back(std::move(branch->curve));
  }
  const std::optional<MeanCurve> mean = meanCurve(curves);
  if (!mean) return std::nullopt;
  SlopeLimited gentle = limitSlope(curves.size() == 1 ? curves.front() : mean->curve, maxSlope);
  const double from = gentle.curve.end();
  const double to = gentle.curve.start();
  report.changes.push_back(
      gentle.largestChange > 0.0 ? importMessage("opening_limited", from, to, gentle.largestChange)
                                 : importMessage("opening_kept", from, to));
  return std::move(gentle.curve);
}

double largestForce(std::span<const double> forces) {
  return *std::ranges::max_element(forces);
}

/// The largest force of the rows; of several ranges, the mean of their largest forces [N].
double recordedPeak(const Trace& trace, std::span<const RowRange> ranges) {
  double sum = 0.0;
  for (const RowRange& rows : ranges) {
    sum += largestForce(std::span(trace.force).subspan(rows.first - 1, rows.last - rows.first + 1));
  }
  return sum / static_cast<double>(ranges.size());
}

/// The largest slope from a node to the first node that is kSlopeStep or more beyond it.
double steepnessOf(const ForceCurve& curve) {
  const auto& nodes = curve.nodes();
  double largest = 0.0;
  std::size_t far = 0;
  for (const CurvePoint& near : nodes) {
    while (far < nodes.size() && nodes[far].travel < near.travel + kSlopeStep) ++far;
    if (far == nodes.size()) break;
    const double slope = (nodes[far].force - near.force) / (nodes[far].travel - near.travel);
    largest = std::max(largest, std::abs(slope));
  }
  return largest;
}

ForceCurve withLimitedSlope(const ForceCurve& curve, double maxSlope, ImportReport& report) {
  report.slopeBefore = curve.largestSlope();
  report.steepness = steepnessOf(curve);
  SlopeLimited gentle = limitSlope(curve, maxSlope);
  report.points = curve.nodes().size();
  for (std::size_t i = 0; i < report.points; ++i) {
    const double force = gentle.curve.nodes()[i].force;
    const double moved = std::abs(force - curve.nodes()[i].force);
    report.movedPoints += moved > kVisibleShare * report.peakBefore ? 1 : 0;
    report.peakAfter = i == 0 ? force : std::max(report.peakAfter, force);
  }
  report.largestChange = gentle.largestChange;
  report.largestChangeAt = gentle.largestChangeAt;
  if (gentle.largestChange > 0.0) {
    report.changes.push_back(importMessage(
        "slope_limited",
        maxSlope,
        gentle.largestChange,
        gentle.largestChangeAt,
        report.steepness,
        kSlopeStep));
  }
  return std::move(gentle.curve);
}

/// Puts the change of the peak at the head of the reported changes. Reports nothing if the peak is
/// unchanged and no point was moved.
void reportPeak(ImportReport& report) {
  constexpr double kShown = 0.005;  // [N]: two decimals
  const double change = report.peakAfter - report.peakBefore;
  if (std::abs(change) < kShown && report.movedPoints == 0) return;
  constexpr double kPercent = 100.0;
  const double visible = kPercent * kVisibleShare;
  auto said = report.peakBefore > 0.0 ? importMessage(
                                            "peak_changed",
                                            report.peakBefore,
                                            report.peakAfter,
                                            kPercent * change / report.peakBefore,
                                            report.movedPoints,
                                            report.points,
                                            visible)
                                      : importMessage(
                                            "peak_from_nothing",
                                            report.peakBefore,
                                            report.peakAfter,
                                            report.movedPoints,
                                            report.points,
                                            visible);
  report.changes.insert(report.changes.begin(), std::move(said));
}

/// Adds warnings about saturated and uncalibrated readings in the chosen rows.
void addSensorWarnings(
    const Recording& recording, const ForceCalibration& calibration, ImportReport& report) {
  std::size_t saturated = 0;
  std::size_t uncalibrated = 0;
  for (const RowRange& rows : report.rows) {
    for (std::size_t i = rows.first - 1; i < rows.last; ++i) {
      const double reading = recording.rows[i].reading;
      saturated += reading >= recording.saturation ? 1 : 0;
      uncalibrated += isExtrapolated(reading, calibration) ? 1 : 0;
    }
  }
  if (uncalibrated > 0) {
    const bool hasLowest = std::isfinite(calibration.lowest);
    report.changes.push_back(
        hasLowest
            ? importMessage(
                  "rows_beyond_calibration",
                  uncalibrated,
                  calibration.lowest,
                  calibration.highest,
                  calibration.unit)
            : importMessage(
                  "rows_above_calibration", uncalibrated, calibration.highest, calibration.unit));
  }
  if (saturated > 0) report.changes.push_back(importMessage("rows_saturated", saturated));
}

/// Adds doubts about the unit and the sign of the force and about the ends of the travel.
void addDoubts(const Trace& trace, ImportReport& report) {
  constexpr double kLeastPeak = 0.1;    // [N]; a hand feels no less
  constexpr double kMostPeak = 200.0;   // [N]; a hand squeezes no harder
  constexpr double kMostTravel = 20.0;  // [travel units]; 10 is closed
  const auto negative =
      std::ranges::count_if(trace.force, [](double force) { return force < 0.0; });
  const auto [least, most] = std::ranges::minmax(trace.travel);
  const bool isTurned =
      10 * negative > 9 * std::ssize(trace.force) && std::ranges::min(trace.force) < -kLeastPeak;
  const bool isOfOtherUnit = report.peakBefore < kLeastPeak || report.peakBefore > kMostPeak;
  std::vector<base::Message> doubts;
  if (isTurned) {
    doubts.push_back(importMessage("forces_negative"));
  } else if (isOfOtherUnit) {
    doubts.push_back(importMessage("peak_unlikely", report.peakBefore));
  }
  if (most > kMostTravel || least < -kMostTravel) {
    doubts.push_back(importMessage("travel_unlikely", least, most));
  }
  report.changes.insert(report.changes.begin(), doubts.begin(), doubts.end());
}

/// @throws UserError  with the first line that could not be read, if there is no closure and there
///     are such lines.
void requireLinesOfClosures(const Recording& recording, const ImportReport& report) {
  if (!report.survey.closures.empty() || recording.refusedLines.empty()) return;
  const auto& first = recording.refusedLines.front();
  throw base::UserError(
      "There is no closure in '" + recording.source + "': its travel never rises above 7. " +
      std::to_string(recording.refusedCount) + " of its " + std::to_string(recording.lines) +
      " lines could not be read, the first in line " + std::to_string(first.number) + " (" +
      first.reason + "): correct them, or choose rows.");
}

CutLandmarks landmarksOf(
    const ImportReport& report, const Trace& trace, const ForceCurve& curve, double yieldLoad) {
  if (report.closures.size() == 1) {
    return report.survey.closures[report.closures.front() - 1].landmarks;
  }
  if (report.closures.empty()) {
    const RowRange& rows = report.rows.front();
    const std::size_t count = rows.last - rows.first + 1;
    return landmarksAlong(
        std::span(trace.travel).subspan(rows.first - 1, count),
        std::span(trace.force).subspan(rows.first - 1, count),
        yieldLoad);
  }
  std::vector<double> travel;
  std::vector<double> force;
  for (const CurvePoint& node : curve.nodes()) {
    travel.push_back(node.travel);
    force.push_back(node.force);
  }
  return landmarksAlong(travel, force, yieldLoad);
}

/// In English, as the file of a cut keeps them.
std::vector<std::string> sentencesOf(const std::vector<base::Message>& changes) {
  std::vector<std::string> sentences;
  for (const auto& change : changes) sentences.push_back(describe(change));
  return sentences;
}

Provenance provenanceOf(
    const Recording& recording,
    const ForceCalibration& calibration,
    const ImportOptions& options,
    const ImportReport& report) {
  return {
      .statement = describe(report.rows) + " of the recording '" + recording.source + "' (" +
                   describe(report.reason) + ")",
      .sourceFile = recording.source,
      .rows = report.rows,
      .closures = report.closures,
      .calibration = calibration.name,
      .filter = std::string(nameOf(options.filter.kind)),
      .filterParameters = parametersOf(options.filter, report.survey.sampling.rate),
      .slopeLimit = options.maxSlope,
      .changes = sentencesOf(report.changes)};
}

void requireValidSlopeLimit(double maxSlope) {
  if (std::isfinite(maxSlope) && maxSlope > 0.0) return;
  throw std::invalid_argument("a slope limit is positive and finite");
}

}  // namespace

bool ImportReport::isAltered() const noexcept {
  return std::max(largestChange, std::abs(peakAfter - peakBefore)) > kVisibleShare * peakBefore;
}

ImportedCut importCut(const Recording& recording, const ImportOptions& options) {
  requireValidSlopeLimit(options.maxSlope);
  const ForceCalibration calibration =
      options.calibration ? *options.calibration : calibrationFor(recording);
  const Trace trace = traceOf(recording, calibration, options.filter);
  ImportReport report{.survey = summariseCuts(recording, trace, options.yieldLoad)};
  if (!options.rows) requireLinesOfClosures(recording, report);
  CutChoice choice = chooseCut(trace, report.survey.closures, options, recording.source);
  report.closures = std::move(choice.closures);
  report.rows = std::move(choice.rows);
  report.reason = std::move(choice.reason);

  report.peakBefore = recordedPeak(trace, report.rows);
  const ForceCurve recorded = recordedCurve(trace, report);
  ForceCurve curve = withLimitedSlope(recorded, options.maxSlope, report);
  reportPeak(report);
  auto opening = openingBranchOf(trace, options.maxSlope, report);
  addSensorWarnings(recording, calibration, report);
  addDoubts(trace, report);
  Cut cut{
      .name = options.name,
      .title = options.title,
      .curve = std::move(curve),
      .opening = std::move(opening),
      .landmarks = landmarksOf(report, trace, recorded, options.yieldLoad),
      .provenance = provenanceOf(recording, calibration, options, report)};
  if (cut.name.empty()) cut.name = recording.source.substr(0, recording.source.rfind('.'));
  if (cut.title.empty()) cut.title = recording.source + ", " + describe(report.rows);
  return {std::move(cut), std::move(report)};
}

}  // namespace haptics::recordings
