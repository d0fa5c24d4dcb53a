#include "haptics/reaming/material/exclusion.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace haptics::reaming {
namespace {

std::string shown(double value, int digits = 1) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

constexpr double kMillimetres = 1000.0;

std::optional<std::string> implausible(const Series& series) {
  constexpr std::size_t kFewest = 100;
  const auto& x = series.displacement;
  if (x.size() != series.force.size() ||
      (!series.torque.empty() && series.torque.size() != x.size())) {
    return "its columns differ in length";
  }
  if (x.size() < kFewest) {
    return "it has " + std::to_string(x.size()) + " samples; a test takes " +
           std::to_string(kFewest) + " and more";
  }
  for (const auto* column : {&series.displacement, &series.force, &series.torque}) {
    for (std::size_t i = 0; i < column->size(); ++i) {
      if (!std::isfinite((*column)[i])) {
        return "sample " + std::to_string(i + 1) + " is no number";
      }
    }
  }
  const double way = x.back() - x.front();
  if (!(way > 0.0)) {
    return "its displacement goes from " + shown(kMillimetres * x.front(), 2) + " to " +
           shown(kMillimetres * x.back(), 2) + " mm; the axis is reversed, or nothing moved";
  }
  const double least = *std::min_element(x.begin(), x.end());
  if (x.front() - least > 0.05 * way) return "the reamer goes back at its beginning";
  return std::nullopt;
}

double medianOf(std::vector<double> values) {
  std::nth_element(
      values.begin(),
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
      values.end());
  return values[values.size() / 2];
}

std::optional<std::string> feedChanged(const Series& series) {
  constexpr std::size_t kParts = 20;
  constexpr double kTolerated = 1.0 / 3.0;
  const auto& x = series.displacement;
  std::vector<double> feeds;
  for (std::size_t part = 0; part < kParts; ++part) {
    const std::size_t from = part * (x.size() - 1) / kParts;
    const std::size_t to = (part + 1) * (x.size() - 1) / kParts;
    feeds.push_back((x[to] - x[from]) * series.rate / static_cast<double>(to - from));
  }
  const double usual = medianOf(feeds);
  for (std::size_t part = 0; part < kParts; ++part) {
    if (std::abs(feeds[part] - usual) <= kTolerated * usual) continue;
    const auto second = [&](std::size_t of) {
      const std::size_t sample = of * (x.size() - 1) / kParts;
      return shown(static_cast<double>(sample) / series.rate);
    };
    return "the feed was changed: it is " + shown(kMillimetres * feeds[part], 3) +
           " mm/s between " + second(part) + " and " + second(part + 1) + " s, and mostly " +
           shown(kMillimetres * usual, 3) + " mm/s";
  }
  return std::nullopt;
}

/// The mean force of each half second.
std::vector<double> halfSeconds(const Series& series) {
  const auto length = std::max<std::size_t>(1, static_cast<std::size_t>(series.rate / 2.0));
  std::vector<double> means;
  for (std::size_t at = 0; at + length <= series.force.size(); at += length) {
    double sum = 0.0;
    for (std::size_t i = at; i < at + length; ++i) sum += series.force[i];
    means.push_back(sum / static_cast<double>(length));
  }
  return means;
}

std::optional<std::string> brokeOut(const Series& series) {
  constexpr double kWorthBreaking = 20.0;  // [N]
  const auto means = halfSeconds(series);
  for (std::size_t i = 2; i < means.size(); ++i) {
    // Over two halves: the break may lie within one.
    const double before = means[i - 2];
    if (before < kWorthBreaking || means[i] > 0.5 * before) continue;
    const double after =
        *std::max_element(means.begin() + static_cast<std::ptrdiff_t>(i), means.end());
    if (after > 0.75 * before) continue;
    return "the force falls from " + shown(before, 0) + " to " + shown(means[i], 0) +
           " N within a second, at " + shown(static_cast<double>(i) / 2.0) +
           " s, and does not come back";
  }
  return std::nullopt;
}

std::optional<std::string> reamedThrough(const Series& series) {
  constexpr double kEarliestDepth = 0.010;  // [m]
  constexpr double kAtLeast = 0.001;        // [m]
  const auto means = halfSeconds(series);
  if (means.empty()) return std::nullopt;
  const double most = *std::max_element(means.begin(), means.end());
  const double start = series.displacement.front();
  const std::size_t length = series.force.size() / means.size();
  std::size_t empty = means.size();
  while (empty > 0 && means[empty - 1] < 0.1 * most) --empty;
  if (empty == means.size()) return std::nullopt;
  const double from = series.displacement[empty * length] - start;
  const double to = series.displacement.back() - start;
  if (from < kEarliestDepth || to - from < kAtLeast) return std::nullopt;
  return "nothing is felt any more from " + shown(kMillimetres * from) + " mm on";
}

}  // namespace

Exclusion exclusionOf(const Series& series) {
  if (const auto why = implausible(series)) return {ExclusionReason::Implausible, *why};
  if (const auto why = feedChanged(series)) return {ExclusionReason::FeedChanged, *why};
  if (series.set == TestSet::Static) return {};
  // What is reamed through falls as well, and is the later of both.
  if (const auto why = reamedThrough(series)) return {ExclusionReason::ReamedThrough, *why};
  if (const auto why = brokeOut(series)) return {ExclusionReason::BrokeOut, *why};
  return {};
}

}  // namespace haptics::reaming
