#include "haptics/recordings/travel_filter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "haptics/filters/low_pass.h"
#include "haptics/recordings/recording.h"

namespace haptics::recordings {
namespace {

using Kind = TravelFilter::Kind;
using filters::KaiserLowPass;

constexpr std::array kKinds{
    Kind::AuthorsFir, Kind::AuthorsFir333, Kind::ButterworthZeroPhase, Kind::None};
constexpr int kMostTaps = 9999;

/// The number of taps that gives the window at @p rate [Hz] the same duration as the authors'
/// window has at their rate.
int tapsAt(double rate) {
  const KaiserLowPass::Design authors;
  const int half = (authors.taps - 1) / 2;  // taps is odd
  const double reach = half * rate / authors.sampleRate;
  return 2 * static_cast<int>(std::lround(std::clamp(reach, 1.0, 1.0 * kMostTaps))) + 1;
}

void requireRate(double rate, double cutoff) {
  if (!(rate > 0.0)) {
    throw base::UserError(
        "The times of the recording do not go on, so that it has no rate to filter for. Correct "
        "the times, or leave the travel as it is (filter 'none').");
  }
  if (rate <= 2.0 * cutoff) {
    throw base::UserError(
        "The recording has " + decimal(rate, 1) + " rows a second; a filter of " +
        decimal(cutoff, 2) + " Hz needs more than " + decimal(2.0 * cutoff, 2) +
        ". Choose a lower cut-off (filter 'butterworth-zero-phase'), or leave the travel as it is "
        "(filter 'none'). If these are too few rows, the unit of the time may be wrong.");
  }
}

KaiserLowPass::Design designAt(double rate) {
  KaiserLowPass::Design design;
  requireRate(rate, design.cutoff);
  design.taps = tapsAt(rate);
  if (design.taps > kMostTaps) {
    throw base::UserError(
        "The recording has " + decimal(rate, 0) +
        " rows a second, more than this filter is made for. The unit of the time may be wrong; "
        "otherwise keep every tenth row.");
  }
  design.sampleRate = rate;
  return design;
}

std::string describeFir(const KaiserLowPass::Design& design, const std::string& rate) {
  return std::to_string(design.taps) +
         "-tap linear-phase Kaiser FIR, beta 5.653, -6 dB at 17.69075 Hz, " + rate +
         ", unit gain at rest, delay of " + std::to_string(design.taps / 2) +
         " rows taken out, end values held";
}

/// Frequency at which the amplitude is 1/√2, with the frequency warping of the bilinear transform
/// [Hz].
double halfPowerOf(double cutoff, double rate) {
  const double bent = std::tan(std::numbers::pi * cutoff / rate);
  return rate / std::numbers::pi * std::atan(bent * std::pow(std::numbers::sqrt2 - 1.0, 1.0 / 8.0));
}

}  // namespace

std::vector<double> filtered(
    std::span<const double> travel, double rate, const TravelFilter& filter) {
  switch (filter.kind) {
    case Kind::AuthorsFir:
      return KaiserLowPass(designAt(rate)).filtered(travel);
    case Kind::AuthorsFir333:
      return KaiserLowPass(KaiserLowPass::Design{}).filtered(travel);
    case Kind::ButterworthZeroPhase:
      requireRate(rate, filter.cutoff);
      return filters::zeroPhaseLowPass(travel, rate, filter.cutoff);
    case Kind::None:
      break;
  }
  return {travel.begin(), travel.end()};
}

std::string_view nameOf(TravelFilter::Kind kind) noexcept {
  switch (kind) {
    case Kind::AuthorsFir:
      return "authors-fir";
    case Kind::AuthorsFir333:
      return "authors-fir-333";
    case Kind::ButterworthZeroPhase:
      return "butterworth-zero-phase";
    case Kind::None:
      break;
  }
  return "none";
}

std::optional<TravelFilter::Kind> travelFilterNamed(std::string_view name) noexcept {
  for (const Kind kind : kKinds) {
    if (nameOf(kind) == name) return kind;
  }
  return std::nullopt;
}

std::vector<std::string> travelFilterNames() {
  std::vector<std::string> names;
  for (const Kind kind : kKinds) names.emplace_back(nameOf(kind));
  return names;
}

std::string parametersOf(const TravelFilter& filter, double rate) {
  const std::string own = "designed for the recording's own " + decimal(rate, 1) + " Hz";
  switch (filter.kind) {
    case Kind::AuthorsFir:
      return describeFir(designAt(rate), own);
    case Kind::AuthorsFir333: {
      const KaiserLowPass::Design design;
      const double really = design.cutoff * rate / design.sampleRate;
      return describeFir(design, "Fs 1000/3 Hz nominal") + "; at the recording's own " +
             decimal(rate, 1) + " Hz really -6 dB at " + decimal(really, 2) + " Hz";
    }
    case Kind::ButterworthZeroPhase:
      return "Butterworth low-pass of order 4, forwards and backwards (no delay), -6 dB at " +
             decimal(filter.cutoff, 3) + " Hz, -3 dB at " +
             decimal(halfPowerOf(filter.cutoff, rate), 3) + " Hz, " + own + ", ends mirrored";
    case Kind::None:
      break;
  }
  return "travel as recorded";
}

}  // namespace haptics::recordings
