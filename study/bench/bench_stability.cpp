// What `palpate bench stability` makes of its sweeps.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "haptics/bench/stability.h"
#include "haptics/engine/passivity.h"
#include "study/bench/bench_report.h"

namespace study::app {
namespace {

using haptics::bench::StabilityCheck;
using haptics::bench::StabilityResult;
using haptics::bench::WallPoint;
using report::Chart;
using report::ChartSeries;

DataTable tableOf(
    const StabilityResult& result,
    const std::string& sweep,
    const std::string& name,
    const std::string& parameter) {
  DataTable table{
      .name = name,
      .description = "Every case of this sweep",
      .columns = {
          {"what", "What"},
          {"arithmetic", "Arithmetic"},
          {"parameter", parameter},
          {"measured", "Measured"},
          {"bound", "At most"},
          {"passed", "Passed"}}};
  for (const auto& check : result.checks) {
    if (check.sweep != sweep) continue;
    table.rows.push_back(
        {check.what,
         check.build,
         check.parameter,
         std::isfinite(check.measured) ? Cell(check.measured) : Cell(std::string("no number")),
         check.bound,
         check.isPassed()});
  }
  return table;
}

/// A line for each thing of a sweep whose words hold @p part, over what is swept.
Chart chartOf(
    const StabilityResult& result,
    const std::string& sweep,
    const std::vector<std::string>& parts,
    const report::ChartAxis& x,
    const report::ChartAxis& y,
    double floor) {
  Chart chart{.x = x, .y = y};
  for (const auto& part : parts) {
    for (const auto& check : result.checks) {
      if (check.sweep != sweep || check.what.find(part) == std::string::npos) continue;
      std::string title = check.what;
      const auto detail = title.find(": relative error,");
      if (detail != std::string::npos) title.erase(detail, std::string(": relative error").size());
      if (!check.build.empty()) {
        title += check.build == "fused multiply-add" ? "; fused" : "; rounded";
      }
      auto series = std::find_if(chart.series.begin(), chart.series.end(), [&](const auto& s) {
        return s.title == title;
      });
      if (series == chart.series.end()) {
        chart.series.push_back({.title = title, .style = ChartSeries::Style::LineAndMarkers});
        series = chart.series.end() - 1;
      }
      series->points.push_back({check.parameter, std::max(check.measured, floor)});
    }
  }
  return chart;
}

report::DocumentPart elementPart(const StabilityResult& result) {
  auto chart = chartOf(
      result,
      "finite elements",
      {"N = 5:", "N = 1000:"},
      {.title = "d: stiffnesses log-uniform over 10^±d"},
      {.title = "largest relative error of the stiffness", .isLogarithmic = true, .most = 1e-5},
      1e-17);
  return {
      .heading = "Finite elements of very different stiffness",
      .paragraphs =
          {"Random chains of 1 to 12,445 elements whose stiffnesses span up to 24 decades, against "
           "the assembled matrix eliminated in 100 decimal digits. Elements of no stiffness and of "
           "a stiffness without end are tried at every place of a chain."},
      .figures =
          {{.name = "contrast",
            .caption = "Largest relative error over the contrast; the bounds are 4·10⁻¹⁵ in "
                       "double and 10⁻⁶ in single precision.",
            .chart = std::move(chart)}},
      .tables = {tableOf(result, "finite elements", "finite-elements", "d")}};
}

report::DocumentPart filterPart(const StabilityResult& result) {
  return {
      .heading = "Kalman filter",
      .paragraphs =
          {"600 filters of 200 steps for each row, in all four variants: Q, both R and every Δθ "
           "log-uniform over 10^±d, correlations up to 0.999, and without process noise. A rest of "
           "an hour at 1 kHz (Δθ = 0): paper-text goes on alternating between its two forces, the "
           "others stay where they are. Noise that is none must be refused before anything is "
           "felt; "
           "steps of 10¹⁵⁵ may fail, but not with a sane face."},
      .figures =
          {{.name = "filter",
            .caption = "Steps with a negative variance: none, at any scale.",
            .chart = chartOf(
                result,
                "Kalman filter",
                {"negative variances"},
                {.title = "d: numbers log-uniform over 10^±d"},
                {.title = "steps with a negative variance", .least = 0.0, .most = 10.0},
                0.0)}},
      .tables = {tableOf(result, "Kalman filter", "filter", "d")}};
}

report::DocumentPart splinePart(const StabilityResult& result) {
  return {
      .heading = "Splines",
      .paragraphs =
          {"Two nodes at distances and with forces over up to 600 decades: either the pair is "
           "refused when the scene is loaded, or every force between them lies between theirs. "
           "Coincident nodes are refused. Two to twelve nodes that crowd over ten decades do not "
           "overshoot."},
      .figures =
          {{.name = "splines",
            .caption = "Forces outside of their two nodes, of 20,000.",
            .chart = chartOf(
                result,
                "splines",
                {"outside"},
                {.title = "d: distances and forces over 10^±d"},
                {.title = "forces outside", .least = 0.0, .most = 10.0},
                0.0)}},
      .tables = {tableOf(result, "splines", "splines", "d")}};
}

bool isShown(const WallPoint& wall, double rate, bool isControlled) {
  return wall.rate == rate && wall.quantum == 0.0 && wall.delay == 0 &&
         wall.isControlled == isControlled;
}

Chart wallChart(const StabilityResult& result, double rate, bool isControlled) {
  Chart chart{
      .x = {.title = "K, stiffness of the wall [N/travel unit]", .isLogarithmic = true},
      .y = {.title = "b, damping of mechanism and hand [N·s/travel unit]", .isLogarithmic = true}};
  ChartSeries quiet{.title = "quiet", .style = ChartSeries::Style::Markers, .colour = 2};
  ChartSeries loud{.title = "vibrates", .style = ChartSeries::Style::Markers, .colour = 1};
  ChartSeries limit{
      .title = "b = K T / 2 (eq. 25)", .style = ChartSeries::Style::Dashed, .colour = 6};
  for (const auto& wall : result.walls) {
    if (!isShown(wall, rate, isControlled)) continue;
    (wall.isStable ? quiet : loud).points.push_back({wall.stiffness, wall.damping});
  }
  for (const double damping : {0.01, 0.02, 0.05, 0.1, 0.2}) {
    const haptics::engine::Passivity passivity{.period = 1.0 / rate};
    limit.points.push_back({passivity.allowedStiffness(damping), damping});
  }
  chart.series = {std::move(quiet), std::move(loud), std::move(limit)};
  return chart;
}

DataTable wallTable(const StabilityResult& result) {
  DataTable table{
      .name = "walls",
      .columns = {
          {"rate_hz"},
          {"stiffness"},
          {"damping"},
          {"encoder_quantum"},
          {"delay_ticks"},
          {"controlled"},
          {"stable"},
          {"foreseen_by_eq_25"},
          {"noticed_by_observer"},
          {"amplitude"}}};
  for (const auto& wall : result.walls) {
    table.rows.push_back(
        {wall.rate,
         wall.stiffness,
         wall.damping,
         wall.quantum,
         std::int64_t{wall.delay},
         wall.isControlled,
         wall.isStable,
         wall.isForeseen,
         wall.isNoticed,
         std::isfinite(wall.amplitude) ? Cell(wall.amplitude) : Cell(std::monostate())});
  }
  return table;
}

/// How many walls vibrate, by how they are rendered.
DataTable wallSummary(const StabilityResult& result) {
  struct Kind {
    std::string name;
    double rate;
    double quantum;
    int delay;
    bool isControlled;
  };
  const Kind kinds[]{
      {"375 Hz", 375, 0, 0, false},
      {"375 Hz, controlled", 375, 0, 0, true},
      {"1 kHz", 1000, 0, 0, false},
      {"1 kHz, controlled", 1000, 0, 0, true},
      {"1 kHz, force one tick old", 1000, 0, 1, false},
      {"1 kHz, encoder 0.0439", 1000, 0.0439, 0, false},
      {"1 kHz, encoder 0.176", 1000, 0.176, 0, false},
      {"4 kHz", 4000, 0, 0, false},
      {"4 kHz, controlled", 4000, 0, 0, true}};
  DataTable table{
      .name = "walls-summary",
      .description =
          "Walls from a tenth to a hundred times the passive stiffness, b from 0.01 to "
          "0.2 N·s/travel unit",
      .columns = {
          {"rendering", "Rendering"},
          {"walls", "Walls"},
          {"vibrate", "Vibrate"},
          {"foreseen", "… and eq. (25) says so"},
          {"noticed", "… and the observer notices"}}};
  for (const auto& kind : kinds) {
    std::int64_t walls = 0, loud = 0, foreseen = 0, noticed = 0;
    for (const auto& wall : result.walls) {
      const bool isOfKind = wall.rate == kind.rate && wall.quantum == kind.quantum &&
                            wall.delay == kind.delay && wall.isControlled == kind.isControlled;
      if (!isOfKind) continue;
      ++walls;
      if (wall.isStable) continue;
      ++loud;
      foreseen += wall.isForeseen ? 1 : 0;
      noticed += wall.isNoticed ? 1 : 0;
    }
    table.rows.push_back({kind.name, walls, loud, foreseen, noticed});
  }
  return table;
}

report::DocumentPart wallPart(const StabilityResult& result) {
  return {
      .heading = "A hand on a virtual wall (Z-width)",
      .paragraphs =
          {"A hand of 3 N/travel unit leans on a wall at 5 units through the punch's mechanism "
           "(0.004 N·s²/travel unit), which moves on in steps of 10 µs while the force is held for "
           "a "
           "tick. A wall vibrates if its amplitude over 0.4 s has not shrunk by a third within a "
           "second, and exceeds a thousandth of a unit, or four grains of the encoder.",
           "Nothing may diverge unnoticed: every wall that vibrates is one that eq. (25) does not "
           "call passive, and one whose energy the observer sees getting out. A force that is one "
           "tick old needs b > K (T/2 + τ); counting the delay once only, as T_eff does, leaves "
           "walls that vibrate unforeseen. Controlled means that the observer damps by up to m/T."},
      .figures =
          {{.name = "walls-1000",
            .caption =
                "1 kHz, as it is. Left of the dashed line every wall is quiet, whoever leans "
                "on it.",
            .chart = wallChart(result, 1000.0, false)},
           {.name = "walls-1000-controlled",
            .caption = "1 kHz, with damping where the energy says so.",
            .chart = wallChart(result, 1000.0, true)}},
      .tables = {
          wallSummary(result), tableOf(result, "wall", "wall-checks", "–"), wallTable(result)}};
}

report::DocumentPart ratePart(const StabilityResult& result) {
  return {
      .heading = "Rates, and a clock that trembles",
      .paragraphs =
          {"A force that is held over a tick is off by K v T / 2 on average; measured through the "
           "finite elements at 57 units/s. The space-domain filter feels alike at every rate. With "
           "periods drawn between a fifth and five times the nominal one, a simulated hand cuts on "
           "while forces keep their limits."},
      .figures =
          {{.name = "rates",
            .caption = "Difference from what a rate without end would give.",
            .chart = chartOf(
                result,
                "rate",
                {"held force", "space-domain: force"},
                {.title = "rate [Hz]", .isLogarithmic = true},
                {.title = "relative, or [N]", .isLogarithmic = true},
                1e-17)}},
      .tables = {tableOf(result, "rate", "rates", "Rate [Hz]")}};
}

report::DocumentPart encoderPart(const StabilityResult& result) {
  return {
      .heading = "Encoders in slow motion",
      .paragraphs =
          {"A tool that creeps through the cut at 0.5 and 2 units/s rests for many ticks and then "
           "jumps by a grain of its encoder: 0.176 units (2048 increments) or 0.0439 (quadrature). "
           "The force then steps by at most K times the grain. paper-text takes its two forces in "
           "turn; it steps by up to their difference whatever the encoder, as published."},
      .figures =
          {{.name = "encoders",
            .caption = "Largest step of the force from tick to tick at 0.5 units/s.",
            .chart = chartOf(
                result,
                "encoder",
                {"at 0.5"},
                {.title = "grain of the encoder [travel units]", .least = 0.0},
                {.title = "largest step [N]", .least = 0.0},
                0.0)}},
      .tables = {tableOf(result, "encoder", "encoders", "Grain")}};
}

report::DocumentPart inputPart(const StabilityResult& result) {
  Chart chart{
      .x = {.title = "scene, in the order of the table"},
      .y = {.title = "difference of the force afterwards [N]", .isLogarithmic = true}};
  ChartSeries series{.title = "afterwards", .style = ChartSeries::Style::Markers};
  double place = 1.0;
  for (const auto& check : result.checks) {
    if (check.sweep != "bad input" || check.what.find("afterwards") == std::string::npos) continue;
    series.points.push_back({place++, std::max(check.measured, 1e-17)});
  }
  chart.series.push_back(std::move(series));
  return {
      .heading = "What is no number",
      .paragraphs =
          {"200,000 ticks of each scene in which a third of all travels, velocities and periods is "
           "NaN, an infinity, a denormal, 1e±308 or the like, and the device fails, falls silent "
           "and "
           "is armed again: no force that is no number or beyond the limit is ever commanded, and "
           "afterwards the scene feels as an engine does that has seen none of it."},
      .figures =
          {{.name = "input",
            .caption = "How far the force at 5 units is off afterwards, against an engine "
                       "that was spared; the bound is 0.02 N.",
            .chart = std::move(chart)}},
      .tables = {tableOf(result, "bad input", "input", "–")}};
}

report::DocumentPart reamingPart(const StabilityResult& result) {
  Chart chart{
      .x = {.title = "case, in the order of the table"},
      .y = {.title = "mass unaccounted for, relative", .isLogarithmic = true}};
  ChartSeries series{.title = "unaccounted for", .style = ChartSeries::Style::Markers};
  double place = 1.0;
  for (const auto& check : result.checks) {
    const bool isMass = check.what.find("mass unaccounted") != std::string::npos;
    if (check.sweep != "reaming" || !isMass) continue;
    series.points.push_back({place++, std::max(check.measured, 1e-17)});
  }
  chart.series.push_back(std::move(series));
  return {
      .heading = "Bone that is reamed",
      .paragraphs =
          {"A cup of 4000 spheres: couplings up to 10⁵ N/mm, densities from nothing to 10¹² N/m², "
           "tiny spheres between large ones, a reamer that is teleported into the bone and through "
           "it, that has no number for a pose, that turns backwards, that goes on where nothing is "
           "left, and ten minutes of reaming. Whatever happens, forces are numbers, no larger than "
           "the coupling gives, and what has left and what is there make up the whole; a step "
           "looks "
           "at no more groups of spheres than before, and nothing is allocated."},
      .figures =
          {{.name = "reaming",
            .caption = "Mass that neither left nor is there; the bound is 10⁻⁶.",
            .chart = std::move(chart)}},
      .tables = {tableOf(result, "reaming", "reaming", "Swept")}};
}

}  // namespace

report::Document stabilityReport(const StabilityResult& result) {
  const auto failed = std::count_if(
      result.checks.begin(), result.checks.end(), [](const auto& c) { return !c.isPassed(); });
  DataTable summary{
      .name = "summary",
      .description = "Sweeps",
      .columns = {{"sweep", "Sweep"}, {"cases", "Cases"}, {"failed", "Failed"}}};
  for (const char* sweep :
       {"finite elements",
        "Kalman filter",
        "splines",
        "wall",
        "encoder",
        "rate",
        "bad input",
        "reaming"}) {
    std::int64_t cases = 0, wrong = 0;
    for (const auto& check : result.checks) {
      if (check.sweep != sweep) continue;
      ++cases;
      wrong += check.isPassed() ? 0 : 1;
    }
    summary.rows.push_back({std::string(sweep), cases, wrong});
  }
  return {
      .title = "Stability in extreme cases",
      .lead =
          {fmt::format(
               "{} cases, each against a bound that was stated before; {} failed. All sweeps are "
               "seeded: the same program gives the same table.",
               result.checks.size(),
               failed),
           "The models are compiled twice, with each operation rounded by itself and with "
           "products and sums fused, because rounding once instead of twice makes textbook "
           "forms of the filter worse."},
      .parts = {
          {.heading = "Machine and summary", .tables = {machineTable(), std::move(summary)}},
          elementPart(result),
          filterPart(result),
          splinePart(result),
          wallPart(result),
          encoderPart(result),
          ratePart(result),
          inputPart(result),
          reamingPart(result)}};
}

}  // namespace study::app
