#include "haptics/recordings/trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "haptics/recordings/recording.h"

namespace haptics::recordings {
namespace {

void requireSound(const KaiserLowPass::Design& design) {
  if (design.taps % 2 == 0 || design.taps < 3 || design.taps > 9999) {
    throw std::invalid_argument("a zero-phase filter has an odd number of taps, 3 to 9999");
  }
  if (!(design.beta >= 0.0 && design.beta <= 100.0)) {
    throw std::invalid_argument("the beta of a Kaiser window is 0 to 100");
  }
  const double nyquist = design.sampleRate / 2.0;
  if (!std::isfinite(nyquist) || !(design.cutoff > 0.0 && design.cutoff < nyquist)) {
    throw std::invalid_argument("a cut-off lies between 0 and half the sample rate");
  }
}

double tap(const KaiserLowPass::Design& design, int j) {
  const double cycles = 2.0 * design.cutoff / design.sampleRate;
  const double x = std::numbers::pi * j;
  const double ideal = j == 0 ? cycles : std::sin(cycles * x) / x;
  const double fraction = 2.0 * j / (design.taps - 1);
  const double inside = std::max(0.0, 1.0 - fraction * fraction);
  return ideal * std::cyl_bessel_i(0.0, design.beta * std::sqrt(inside));
}

}  // namespace

KaiserLowPass::KaiserLowPass(const Design& design) {
  requireSound(design);
  const int reach = design.taps / 2;
  for (int j = -reach; j <= reach; ++j) taps_.push_back(tap(design, j));
  const double gain = std::accumulate(taps_.begin(), taps_.end(), 0.0);
  for (double& value : taps_) value /= gain;
}

std::vector<double> KaiserLowPass::filtered(std::span<const double> signal) const {
  std::vector<double> result;
  if (signal.empty()) return result;
  const std::size_t reach = taps_.size() / 2;
  std::vector<double> held(reach, signal.front());
  held.insert(held.end(), signal.begin(), signal.end());
  held.insert(held.end(), reach, signal.back());
  result.reserve(signal.size());
  for (auto at = held.begin(); result.size() < signal.size(); ++at) {
    result.push_back(std::inner_product(taps_.begin(), taps_.end(), at, 0.0));
  }
  return result;
}

namespace {

constexpr double kNewtonsPerGram = 9.81e-3;
constexpr std::array kCalibrations{ForceCalibration::PaperEq1, ForceCalibration::Recorder2021};

}  // namespace

double forceOf(double r, ForceCalibration calibration) noexcept {
  const bool isPaper = calibration == ForceCalibration::PaperEq1;
  const double square = isPaper ? -2e-4 : -3e-4;
  const double linear = isPaper ? 0.7815 : 0.7261;
  return (3e-7 * r * r * r + square * r * r + linear * r) * kNewtonsPerGram;
}

std::string_view nameOf(ForceCalibration calibration) noexcept {
  return calibration == ForceCalibration::PaperEq1 ? "paper-eq1" : "recorder-2021";
}

std::optional<ForceCalibration> forceCalibrationNamed(std::string_view name) noexcept {
  for (const ForceCalibration calibration : kCalibrations) {
    if (nameOf(calibration) == name) return calibration;
  }
  return std::nullopt;
}

namespace {

constexpr std::array kTravelFilters{TravelFilter::AuthorsFir, TravelFilter::None};

}  // namespace

std::vector<double> filtered(std::span<const double> travel, TravelFilter filter) {
  if (filter == TravelFilter::None) return {travel.begin(), travel.end()};
  return KaiserLowPass(KaiserLowPass::Design{}).filtered(travel);
}

std::string_view nameOf(TravelFilter filter) noexcept {
  return filter == TravelFilter::AuthorsFir ? "authors-fir" : "none";
}

std::string parametersOf(TravelFilter filter) {
  if (filter == TravelFilter::None) return "travel as recorded";
  return "49-tap linear-phase Kaiser FIR, beta 5.653, -6 dB at 17.69075 Hz, Fs 1000/3 Hz nominal, "
         "unit gain at rest, delay of 24 rows taken out, end values held";
}

std::optional<TravelFilter> travelFilterNamed(std::string_view name) noexcept {
  for (const TravelFilter filter : kTravelFilters) {
    if (nameOf(filter) == name) return filter;
  }
  return std::nullopt;
}

namespace {

std::vector<CurvePoint> samplesOf(const Trace& trace, const RowRange& rows) {
  std::vector<CurvePoint> samples;
  for (std::size_t i = rows.first - 1; i < rows.last; ++i) {
    samples.push_back({trace.travel[i], trace.force[i]});
  }
  return samples;
}

}  // namespace

Trace traceOf(const Recording& recording, ForceCalibration calibration, TravelFilter filter) {
  Trace trace;
  trace.force.reserve(recording.rows.size());
  std::vector<double> travel;
  travel.reserve(recording.rows.size());
  for (const Recording::Row& row : recording.rows) {
    travel.push_back(row.travel);
    trace.force.push_back(forceOf(row.reading, calibration));
  }
  trace.travel = filtered(travel, filter);
  return trace;
}

MonotoneCurve curveOf(const Trace& trace, const RowRange& rows) {
  try {
    return monotoneCurve(samplesOf(trace, rows));
  } catch (const std::invalid_argument&) {
    throw Error(
        "Rows " + std::to_string(rows.first) + " to " + std::to_string(rows.last) +
        " are no closing hand (their travel does not rise): choose other rows.");
  }
}

std::optional<MonotoneCurve> openingCurveOf(const Trace& trace, const RowRange& rows) {
  auto samples = samplesOf(trace, rows);
  std::reverse(samples.begin(), samples.end());
  try {
    return monotoneCurve(samples);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

namespace {

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double covarianceOf(const std::vector<double>& a, const std::vector<double>& b) {
  const double meanA = meanOf(a);
  const double meanB = meanOf(b);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - meanA) * (b[i] - meanB);
  return sum / static_cast<double>(a.size() - 1);
}

}  // namespace

ProcessNoise processNoiseOf(const Trace& trace, std::span<const RowRange> rows, double leastStep) {
  constexpr std::size_t kFewest = 3;
  std::vector<double> force;
  std::vector<double> stiffness;
  ProcessNoise noise;
  double lastTravel = 0.0;
  for (const RowRange& range : rows) {
    for (std::size_t row = range.first - 1; row < range.last; ++row) {
      const double travelled = trace.travel[row] - lastTravel;
      const bool isFirst = force.empty();
      if (!isFirst && (travelled == 0.0 || std::abs(travelled) < leastStep)) {
        ++noise.resting;
        continue;
      }
      stiffness.push_back(isFirst ? 0.0 : (trace.force[row] - force.back()) / travelled);
      force.push_back(trace.force[row]);
      lastTravel = trace.travel[row];
    }
  }
  if (force.size() < kFewest) {
    throw Error("Two rows and fewer say nothing about a variance. Name longer ranges of rows.");
  }
  noise.samples = force.size();
  noise.force = covarianceOf(force, force);
  noise.covariance = covarianceOf(force, stiffness);
  noise.stiffness = covarianceOf(stiffness, stiffness);
  return noise;
}

}  // namespace haptics::recordings
