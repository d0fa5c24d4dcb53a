// What `palpate bench accuracy` makes of its measurements.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "study/bench/bench_report.h"

namespace study::app {
namespace {

using haptics::bench::Repeated;
using report::Chart;
using report::ChartSeries;
using Measured = std::vector<Repeated>;

bool isOf(const Repeated& r, const std::string& family, const std::string& setting) {
  return r.measurement.family == family && r.measurement.setting == setting;
}

/// A method's measurements in a setting, by what is swept.
std::vector<const Repeated*> along(
    const Measured& all,
    const std::string& family,
    const std::string& setting,
    const std::string& method) {
  std::vector<const Repeated*> found;
  for (const auto& r : all) {
    if (isOf(r, family, setting) && r.measurement.method == method) found.push_back(&r);
  }
  return found;
}

std::vector<std::string> methodsOf(
    const Measured& all, const std::string& family, const std::string& setting) {
  std::vector<std::string> methods;
  for (const auto& r : all) {
    const auto& method = r.measurement.method;
    const bool isNew = std::find(methods.begin(), methods.end(), method) == methods.end();
    if (isOf(r, family, setting) && isNew) methods.push_back(method);
  }
  return methods;
}

std::string shortNumber(double value) {
  return value >= 1000 ? fmt::format("{:g}k", value / 1000) : fmt::format("{:g}", value);
}

/// Error over median time, a line a method, what is swept on the markers, p99 as a bar.
Chart errorOverTime(
    const Measured& all,
    const std::string& family,
    const std::string& setting,
    const std::string& unit) {
  Chart chart{
      .x = {.title = "time of a step [ns], median; bars to p99", .isLogarithmic = true},
      .y = {.title = unit, .isLogarithmic = true}};
  for (const auto& method : methodsOf(all, family, setting)) {
    if (method.ends_with("no hint")) continue;  // hides what it lies beside; it is in the table
    ChartSeries series{.title = method, .style = ChartSeries::Style::LineAndMarkers};
    for (const auto* r : along(all, family, setting, method)) {
      const auto& m = r->measurement;
      if (!m.error || !m.time) continue;
      // What is exact to the last bit has a place at the bottom.
      const double error = std::max(*m.error, 1e-18);
      series.points.push_back({m.time->median, error, m.time->p99, shortNumber(m.parameter)});
    }
    if (!series.points.empty()) chart.series.push_back(std::move(series));
  }
  return chart;
}

Chart errorOverParameter(
    const Measured& all,
    const std::string& family,
    const std::string& setting,
    const std::string& parameter,
    const std::string& unit,
    bool isLogarithmic) {
  Chart chart{.x = {.title = parameter}, .y = {.title = unit, .isLogarithmic = isLogarithmic}};
  if (isLogarithmic) chart.y.most = 10.0;
  for (const auto& method : methodsOf(all, family, setting)) {
    ChartSeries series{.title = method, .style = ChartSeries::Style::LineAndMarkers};
    for (const auto* r : along(all, family, setting, method)) {
      const auto& m = r->measurement;
      if (!m.error) continue;
      const double shown = isLogarithmic ? std::clamp(*m.error, 1e-17, 10.0) : *m.error;
      series.points.push_back({m.parameter, shown});
    }
    chart.series.push_back(std::move(series));
  }
  return chart;
}

/// All measurements of a family, as exact numbers.
DataTable tableOf(
    const Measured& all,
    const std::string& family,
    const std::string& name,
    const std::string& parameter) {
  DataTable table{
      .name = name,
      .description = "Every measurement: " + family,
      .columns = {
          {"setting", "Setting"},
          {"method", "Method"},
          {"parameter", parameter},
          {"error", "Error"},
          {"median_ns", "Median [ns]"},
          {"p99_ns", "p99 [ns]"},
          {"fastest_process_ns", "Fastest process [ns]"},
          {"slowest_process_ns", "Slowest process [ns]"}}};
  for (const auto& r : all) {
    const auto& m = r.measurement;
    if (m.family != family) continue;
    const bool isTimed = m.time.has_value();
    const auto orNothing = [](bool isThere, double value) {
      return isThere ? Cell(value) : Cell(std::monostate());
    };
    table.rows.push_back(
        {m.setting,
         m.method,
         m.parameter,
         m.error && std::isfinite(*m.error) ? Cell(*m.error)
         : m.error                          ? Cell(std::string("no number"))
                                            : Cell(std::monostate()),
         orNothing(isTimed, isTimed ? m.time->median : 0.0),
         orNothing(isTimed, isTimed ? m.time->p99 : 0.0),
         orNothing(isTimed, r.fastest),
         orNothing(isTimed, r.slowest)});
  }
  return table;
}

/// The median time of a method [ns]; not a number where it was not measured.
double timeOf(
    const Measured& all,
    const std::string& family,
    const std::string& setting,
    const std::string& method,
    double parameter) {
  for (const auto* r : along(all, family, setting, method)) {
    if (r->measurement.parameter == parameter && r->measurement.time) {
      return r->measurement.time->median;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

report::DocumentPart splinePart(const Measured& all) {
  return {
      .heading = "Splines: force over displacement",
      .paragraphs =
          {"An analytic curve of reaming's shape (a lamella at 5 mm, 740 N at 20 mm) is sampled at "
           "4 to 10,000 nodes that lie nearly evenly. The error is the largest difference from the "
           "curve over 20,000 places [N]. Each evaluation waits for the one before (latency); "
           "queries are random, or coherent as a hand's, or random with cold caches: 80 MB of "
           "other "
           "memory are read before each.",
           "palpate Hermite is given the curve's slopes, as the reaming paper gives its own; "
           "palpate PCHIP makes monotone ones and, but for rounding, is Boost's."},
      .figures =
          {{.name = "splines",
            .caption =
                "Largest error over the time of an evaluation at a random place; the number of "
                "nodes at the markers.",
            .chart = errorOverTime(all, "splines", "random", "largest error [N]")}},
      .tables = {tableOf(all, "splines", "splines", "Nodes")}};
}

report::DocumentPart elementPart(const Measured& all) {
  const std::string differ = "elements that differ, N = 15";
  return {
      .heading = "Finite elements: force and mesh",
      .paragraphs =
          {"The string of eq. (3) to (11) with N elements; the error is the force's, relative to "
           "the "
           "same string in 100 decimal digits. The paper's program assembles and factorises the "
           "matrix in each step. palpate never forms it: it sums flexibilities, once for the "
           "force, "
           "and multiplies one stored shape for the mesh, which is worked out only where somebody "
           "looks.",
           "Where elements differ, forming kᵢ + kᵢ₊₁ loses the softer one: 20 chains each, "
           "stiffnesses log-uniform over 10^±d. Errors above 10, and what is no number, are drawn "
           "at 10."},
      .figures =
          {{.name = "finite-elements",
            .caption = "Relative error of the force over the time of a step; N at the markers.",
            .chart = errorOverTime(
                all, "finite elements", "elements alike", "relative error of the force")},
           {.name = "contrast",
            .caption = "Relative error of the force over the contrast of 15 elements.",
            .chart = errorOverParameter(
                all,
                "finite elements",
                differ,
                "d: stiffnesses over 10^±d",
                "relative error of the force",
                true)}},
      .tables = {tableOf(all, "finite elements", "finite-elements", "N or d")}};
}

report::DocumentPart kalmanPart(const Measured& all) {
  return {
      .heading = "Kalman filter",
      .paragraphs =
          {"A step is a prediction and two corrections (eq. (14) to (21)). Eigen's peers follow "
           "the "
           "equations as matrices; the scalar ones are the same worked out by hand. The adversary "
           "draws the variances at the start, both R and every Δθ log-uniformly over 10^±d, with "
           "no "
           "process noise; 60 filters of 40 steps, against the same filter in 100 decimal digits."},
      .figures =
          {{.name = "kalman-error",
            .caption = "What 99 % of the relative errors of the force do not exceed.",
            .chart = errorOverParameter(
                all,
                "Kalman filter",
                "Q = 0, relative error",
                "d: numbers over 10^±d",
                "relative error of the force, p99",
                true)},
           {.name = "kalman-negative",
            .caption =
                "Steps of a hundred after which a variance is negative: the filter is sure of "
                "more than everything.",
            .chart = errorOverParameter(
                all,
                "Kalman filter",
                "Q = 0, negative variances of 100 steps",
                "d: numbers over 10^±d",
                "steps of 100",
                false)}},
      .tables = {tableOf(all, "Kalman filter", "kalman", "d")}};
}

report::DocumentPart encoderPart(const Measured& all) {
  const std::string difference = "RMS difference from an ideal encoder [N], 10 travel units/s";
  const std::string chatter = "RMS chatter [N], 10 travel units/s";
  return {
      .heading = "Encoders",
      .paragraphs =
          {"An even closing at 1, 10 and 57 travel units/s and 1 kHz, seen through an encoder of "
           "0.176 (2048 increments) and 0.0439 (with quadrature) units, and by an ideal one. "
           "Chatter is what changes from tick to tick, normed so that a square wave of 1 N at half "
           "the rate is 1 N."},
      .figures =
          {{.name = "encoder-difference",
            .caption = "RMS difference of the force from that of an ideal encoder.",
            .chart = errorOverParameter(
                all, "encoder", difference, "grain of the encoder [travel units]", "[N]", false)},
           {.name = "encoder-chatter",
            .caption = "RMS chatter: paper-text is a square wave by itself, whatever the encoder.",
            .chart = errorOverParameter(
                all, "encoder", chatter, "grain of the encoder [travel units]", "[N]", false)}},
      .tables = {tableOf(all, "encoder", "encoders", "Grain")}};
}

/// The paper's Fig. 12, [Hz], at N = 5, 10, 15: punch paper, III-D.
struct PublishedRates {
  const char* method;
  double rates[3];
};
constexpr PublishedRates kPublished[]{
    {"finite elements", {496.0, 326.0, 167.0}},
    {"interpolation", {433.0, 294.0, 160.0}},
    {"Kalman filter", {375.0, 276.0, 147.0}}};

report::DocumentPart refreshPart(const Measured& all) {
  Chart chart{
      .x = {.title = "N, elements of the mesh", .isLogarithmic = true},
      .y = {.title = "steps a second", .isLogarithmic = true}};
  DataTable table{
      .name = "refresh",
      .description =
          "Steps a second of the three renderings, mesh included, on this computer and "
          "as published for an Arduino Due",
      .columns = {
          {"rendering", "Rendering"},
          {"elements", "N"},
          {"rate_hz", "Here [Hz]"},
          {"rate_without_mesh_hz", "… without mesh [Hz]"},
          {"published_hz", "Published [Hz]"}}};
  int colour = 0;
  for (const auto& published : kPublished) {
    ChartSeries ours{
        .title = published.method, .style = ChartSeries::Style::LineAndMarkers, .colour = colour};
    ChartSeries theirs{
        .title = std::string(published.method) + ", paper",
        .style = ChartSeries::Style::Dashed,
        .colour = colour++};
    const std::string method = published.method;
    int place = 0;
    for (const auto* r : along(all, "refresh", "a step", method + ", with mesh")) {
      const double elements = r->measurement.parameter;
      const double rate = 1e9 / r->measurement.time->median;
      const double bare =
          1e9 / timeOf(all, "refresh", "a step", method + ", force alone", elements);
      ours.points.push_back({elements, rate});
      const bool isPublished = place < 3;
      if (isPublished) theirs.points.push_back({elements, published.rates[place]});
      table.rows.push_back(
          {method,
           elements,
           rate,
           bare,
           isPublished ? Cell(published.rates[place]) : Cell(std::monostate())});
      ++place;
    }
    chart.series.push_back(std::move(ours));
    chart.series.push_back(std::move(theirs));
  }
  return {
      .heading = "Refresh rate against the number of elements (Fig. 12 of the punch paper)",
      .paragraphs =
          {"The paper's numbers come from a microcontroller that assembles and solves in each "
           "step; "
           "ours from the models alone, on this computer. The force costs the same for any N; what "
           "grows is drawing the mesh, and that is done at a display's rate, not in the tick. On a "
           "Cortex-M3 the same models take 5,410 instructions a step at N = 5 and 5,786 at N = 15 "
           "(haptics/firmware; the published code 28,400 and 143,900)."},
      .figures =
          {{.name = "refresh",
            .caption = "Steps a second, mesh included.",
            .chart = std::move(chart)}},
      .tables = {std::move(table)}};
}

report::DocumentPart filterPart(const Measured& all) {
  return {
      .heading = "From a measured series to nodes",
      .paragraphs =
          {"A synthetic dynamic test of 2000 s at 100 Hz, with 1 N of noise and the line of the "
           "reamer's rotation, against the same test without either. \"The best of all cut-offs\" "
           "has seen the noiseless curve. Nodes are counted for a wanted error; the optimum comes "
           "from dynamic programming over 1000 samples."},
      .figures =
          {{.name = "nodes",
            .caption = "Nodes that are needed for an error.",
            .chart = errorOverParameter(
                all, "filter", "nodes for an error", "wanted error, a share", "nodes", false)}},
      .tables = {tableOf(all, "filter", "filter", "Samples or error")}};
}

report::DocumentPart packingPart(const Measured& all) {
  return {
      .heading = "Bone of spheres",
      .paragraphs =
          {"A hemispherical reamer of 26 mm radius in the parametric cup. The error is how much "
           "the "
           "area that is felt departs from its mean over 6 mm of depth. nanoflann finds all "
           "centres "
           "within reach, Embree all boxes within the reamer; both add the spheres up one by one. "
           "\"All of them\" is our inner loop over every sphere.",
           "With removal every step is timed for itself: contact, cutting, what is left behind. "
           "Bones above 250,000 spheres are copies of a small one."},
      .figures =
          {{.name = "packing",
            .caption = "Area ripple over the time of a contact; the number of spheres at the "
                       "markers.",
            .chart = errorOverTime(all, "packing", "contact", "area ripple [%]")}},
      .tables = {tableOf(all, "packing", "packing", "Spheres")}};
}

report::DocumentPart densityPart(const Measured& all) {
  auto chart = errorOverTime(all, "density", "all spheres", "|Aρ − F| / |F|");
  chart.x.title = "time of a fit [ns]; bars to the slowest seed";
  auto layers = errorOverTime(all, "density", "layers", "|Aρ − F| / |F|");
  layers.x.title = chart.x.title;
  return {
      .heading = "Densities of the spheres",
      .paragraphs =
          {"201,532 spheres, 400 depths of a synthetic dynamic test. Bounded least squares are "
           "solved on their dual, so that the gap proves how near the optimum they are. The swarm "
           "has 40 particles; the paper gives no settings of its own. In layers a sphere's density "
           "is that of the depth at which it is first touched."},
      .figures =
          {{.name = "density",
            .caption = "Error over the time of a fit, every sphere for itself; λ or iterations at "
                       "the markers.",
            .chart = std::move(chart)},
           {.name = "density-layers",
            .caption = "The same for layers; their number at the markers.",
            .chart = std::move(layers)}},
      .tables = {tableOf(all, "density", "density", "λ, iterations or layers")}};
}

}  // namespace

report::Document accuracyReport(const Measured& all) {
  int processes = 1;
  for (const auto& r : all) processes = std::max(processes, r.processes);
  std::vector<report::DocumentPart> parts{
      {.heading = "Machine and targets",
       .tables = {machineTable(), targetTable(accuracyTargets(all))}}};
  const std::pair<const char*, report::DocumentPart (*)(const Measured&)> families[]{
      {"splines", splinePart},
      {"finite elements", elementPart},
      {"Kalman filter", kalmanPart},
      {"encoder", encoderPart},
      {"refresh", refreshPart},
      {"filter", filterPart},
      {"packing", packingPart},
      {"density", densityPart}};
  for (const auto& [family, part] : families) {
    const bool isMeasured = std::any_of(all.begin(), all.end(), [&, name = family](const auto& r) {
      return r.measurement.family == name;
    });
    if (isMeasured) parts.push_back(part(all));
  }
  return {
      .title = "Error against run time",
      .lead =
          {fmt::format(
               "Every family of the force engine, with its peers in the same process and the same "
               "rounds (A, B, C, A, B, C …). Times are medians of {} processes' medians of up to "
               "101 "
               "batches of 300 µs; bars and columns give p99 and the spread between processes. "
               "Ratios are the result, absolute times are colour.",
               processes),
           "Errors are deterministic and the same in every process."},
      .parts = std::move(parts)};
}

}  // namespace study::app
