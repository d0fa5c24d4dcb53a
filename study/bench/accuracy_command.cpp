// palpate-bench accuracy: errors and run times of the models and of other libraries.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/bench/measurement.h"
#include "haptics/bench/refresh_rate.h"
#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/print_result.h"
#include "study/model/user_error.h"

namespace study::bench {
namespace {

using haptics::bench::AccuracyRun;
using haptics::bench::Measurement;
using haptics::bench::RepeatedMeasurement;
using report::Chart;
using report::ChartSeries;

/// A figure for one setting of a family, with a line for each method.
struct Figure {
  enum class Shows { ErrorOverTime, ErrorOverParameter, TimeOverParameter };

  const char* name;
  const char* setting;
  const char* unit;  ///< of the error
  Shows shows = Shows::ErrorOverParameter;
  bool isLogarithmic = false;  ///< of the axis of errors
};

using RepeatedMeasurements = std::vector<RepeatedMeasurement>;

struct Family {
  const char* option;  ///< name on the command line and of its files
  const char* name;    ///< name in measurements
  const char* heading;
  const char* parameter;  ///< name of the parameter that varies
  void (*measure)(const AccuracyRun&);
  bool isMeasuredOnce;  ///< whether it is measured in one process only, because it is slow
  std::vector<Figure> figures;
  DataTable (*summary)(const RepeatedMeasurements&) =
      nullptr;  ///< table that is shown before the measurements
};

DataTable refreshTable(const RepeatedMeasurements& all);

const std::vector<Family>& families() {
  using enum Figure::Shows;
  static const std::vector<Family> kFamilies{
      {"splines",
       "splines",
       "Splines: force over displacement",
       "Nodes",
       haptics::bench::measureSplines,
       false,
       {{"splines", "random", "largest error [N]", ErrorOverTime, true}}},
      {"finite-elements",
       "finite elements",
       "Finite elements: force and mesh",
       "N or d",
       haptics::bench::measureFiniteElements,
       false,
       {{"finite-elements", "elements alike", "relative error of the force", ErrorOverTime, true},
        {"contrast",
         "elements that differ, N = 15",
         "relative error of the force",
         ErrorOverParameter,
         true}}},
      {"kalman",
       "Kalman filter",
       "Kalman filter",
       "d",
       haptics::bench::measureKalmanFilter,
       false,
       {{"kalman-error",
         "Q = 0, relative error",
         "relative error of the force, p99",
         ErrorOverParameter,
         true},
        {"kalman-negative", "Q = 0, negative variances of 100 steps", "steps of 100"}}},
      {"encoders",
       "encoder",
       "Encoders",
       "Resolution [travel units]",
       haptics::bench::measureEncoders,
       false,
       {{"encoder-difference",
         "RMS difference from an ideal encoder [N], 10 travel units/s",
         "RMS difference [N]"},
        {"encoder-chatter", "RMS chatter [N], 10 travel units/s", "RMS chatter [N]"}}},
      {"refresh",
       "refresh",
       "Three renderings of the punch with their mesh (Fig. 12 of the punch paper)",
       "N",
       haptics::bench::measureRefresh,
       false,
       {{"refresh", "a step", "", TimeOverParameter}},
       refreshTable},
      {"filter",
       "filter",
       "From a measured series to nodes",
       "Samples or error",
       haptics::bench::measureFilter,
       true,
       {{"nodes", "nodes for an error", "nodes"}}},
      {"packing",
       "packing",
       "Bone of spheres",
       "Spheres",
       haptics::bench::measurePacking,
       true,
       {{"packing", "contact", "area ripple [%]", ErrorOverTime, true}}},
      {"density",
       "density",
       "Densities of the spheres",
       "λ, iterations or layers",
       haptics::bench::measureDensity,
       true,
       {{"density", "all spheres", "|Aρ − F| / |F|", ErrorOverTime, true}}}};
  return kFamilies;
}

struct AccuracyOptions {
  std::string out;
  int processes = 5;
  std::vector<std::string> families;
  bool isShortRun = false;
  bool isWorker = false;

  bool wants(const Family& family) const {
    return families.empty() || std::ranges::find(families, family.option) != families.end();
  }
};

/// The point of a measurement in a figure; std::nullopt if it cannot be shown.
std::optional<report::ChartPoint> pointOf(const Measurement& m, const Figure& figure) {
  using enum Figure::Shows;
  const auto parameter = m.parameter >= 1000 ? fmt::format("{:g}k", m.parameter / 1000)
                                             : fmt::format("{:g}", m.parameter);
  if (figure.shows == TimeOverParameter) {
    if (!m.time) return std::nullopt;
    return report::ChartPoint{m.parameter, m.time->median};
  }
  if (!m.error) return std::nullopt;
  // Zero and undefined errors are drawn at the ends of the logarithmic axis.
  const double error = figure.isLogarithmic ? std::clamp(*m.error, 1e-18, 1e6) : *m.error;
  if (figure.shows == ErrorOverParameter) return report::ChartPoint{m.parameter, error};
  if (!m.time) return std::nullopt;
  return report::ChartPoint{m.time->median, error, m.time->p99, parameter};
}

Chart chartOf(const RepeatedMeasurements& all, const Family& family, const Figure& figure) {
  const bool isOverTime = figure.shows == Figure::Shows::ErrorOverTime;
  const bool isTime = figure.shows == Figure::Shows::TimeOverParameter;
  constexpr const char* kTime = "time of a step [ns], median; bars to p99";
  Chart chart{
      .x = {.title = isOverTime ? kTime : family.parameter, .isLogarithmic = isOverTime || isTime},
      .y = {
          .title = isTime ? "time of a step [ns], median" : figure.unit,
          .isLogarithmic = isTime || figure.isLogarithmic}};
  for (const auto& r : all) {
    const auto& m = r.measurement;
    if (m.family != family.name || m.setting != figure.setting) continue;
    const auto point = pointOf(m, figure);
    if (!point) continue;
    auto series =
        std::ranges::find_if(chart.series, [&](const auto& s) { return s.title == m.method; });
    if (series == chart.series.end()) {
      chart.series.push_back({.title = m.method, .style = ChartSeries::Style::LineAndMarkers});
      series = chart.series.end() - 1;
    }
    series->points.push_back(*point);
  }
  return chart;
}

DataTable tableOf(const RepeatedMeasurements& all, const Family& family) {
  DataTable table{
      .name = family.option,
      .description = family.heading,
      .columns = {
          {"setting", "Setting"},
          {"method", "Method"},
          {"parameter", family.parameter},
          {"error", "Error"},
          {"bound", "At most"},
          {"median_ns", "Median [ns]"},
          {"p99_ns", "p99 [ns]"},
          {"fastest_process_ns", "Fastest process [ns]"},
          {"slowest_process_ns", "Slowest process [ns]"}}};
  for (const auto& r : all) {
    const auto& m = r.measurement;
    if (m.family != family.name) continue;
    std::vector<Cell> row{
        m.setting, m.method, m.parameter, numberCell(m.error), numberCell(m.bound)};
    if (m.time) row.insert(row.end(), {m.time->median, m.time->p99, r.fastest, r.slowest});
    row.resize(table.columns.size());
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Updates per second of the three renderings: on the punch paper's Arduino Due, on this computer,
/// and the limit that the number of instructions sets on a Cortex-M3 at the Due's clock rate.
DataTable refreshTable(const RepeatedMeasurements& all) {
  DataTable table{
      .name = "fig-12",
      .description = "Updates a second, force and mesh (Fig. 12 of the punch paper)",
      .columns = {
          {"method", "Method"},
          {"elements", "N"},
          {"published_hz", "Published, Arduino Due [Hz]"},
          {"this_computer_hz", "Here, on this computer [Hz]"},
          {"cortex_m3_instructions", "Ours on a Cortex-M3 (QEMU) [instructions]"},
          {"due_hz_at_most", "… at 84 MHz, one a cycle: at most [Hz]"}}};
  for (const auto& rate : haptics::bench::kRefreshRates) {
    std::optional<double> here;
    for (const auto& r : all) {
      const auto& m = r.measurement;
      const bool isIt = m.family == "refresh" && m.method == rate.method && m.time &&
                        m.parameter == static_cast<double>(rate.elements);
      if (isIt) here = 1e9 / m.time->median;
    }
    table.rows.push_back(
        {std::string(rate.method),
         std::int64_t{rate.elements},
         rate.published,
         cellOf(here),
         std::int64_t{rate.instructions},
         haptics::bench::kArduinoDueClock / rate.instructions});
  }
  return table;
}

report::Document reportOf(const RepeatedMeasurements& all, const AccuracyOptions& options) {
  report::Document document{
      .title = "Error against run time",
      .lead = {fmt::format(
          "Errors are deterministic. Times are medians of {} processes' medians; all methods of a "
          "family are timed in turn, in the same process. docs/benchmarks.md explains the "
          "settings.",
          options.processes)}};
  for (const auto& family : families()) {
    report::DocumentPart part{.heading = family.heading};
    if (family.summary != nullptr && options.wants(family)) {
      part.tables.push_back(family.summary(all));
    }
    auto table = tableOf(all, family);
    if (table.rows.empty() && part.tables.empty()) continue;
    for (const auto& figure : family.figures) {
      auto chart = chartOf(all, family, figure);
      if (chart.series.empty()) continue;
      part.figures.push_back(
          {.name = figure.name, .caption = figure.setting, .chart = std::move(chart)});
    }
    if (!table.rows.empty()) part.tables.push_back(std::move(table));
    document.parts.push_back(std::move(part));
  }
  return document;
}

/// Measures the families that @p options name in this process.
void measureInThisProcess(const AccuracyOptions& options, const AccuracyRun& run) {
  for (const auto& family : families()) {
    if (options.wants(family)) family.measure(run);
  }
}

/// Runs this program in a new process and adds its measurements to @p run.
/// @throws UserError  if the process cannot be started or fails.
void measureInProcess(
    const AccuracyOptions& options,
    const std::vector<const Family*>& wanted,
    const AccuracyRun& run) {
  // The path is passed in an environment variable, so that the shell needs no quoting.
  setenv("PALPATE_BENCH", std::filesystem::read_symlink("/proc/self/exe").c_str(), 1);
  std::string call = "exec \"$PALPATE_BENCH\" accuracy --worker";
  if (options.isShortRun) call += " --short";
  for (const auto* family : wanted) call += std::string(" --family ") + family->option;
  FILE* output = popen(call.c_str(), "r");
  if (output == nullptr) throw UserError("A second process cannot be started.");
  char* text = nullptr;
  std::size_t size = 0;
  for (ssize_t length = 0; (length = getline(&text, &size, output)) > 0;) {
    const std::string line(text, static_cast<std::size_t>(length - 1));
    if (const auto measurement = haptics::bench::fromLine(line)) run.report(*measurement);
  }
  free(text);
  if (pclose(output) != 0) {
    throw UserError("A process that measured ended before its time: its results are incomplete.");
  }
}

RepeatedMeasurements measure(const AccuracyOptions& options) {
  std::vector<Measurement> all;
  for (int process = 1; process <= options.processes; ++process) {
    std::vector<const Family*> wanted;
    for (const auto& family : families()) {
      if (options.wants(family) && (!family.isMeasuredOnce || process == 1))
        wanted.push_back(&family);
    }
    if (wanted.empty()) break;
    std::string family;
    const auto keep = [&](const Measurement& m) {
      if (m.family != family) {
        family = m.family;
        std::fprintf(stderr, "process %d of %d: %s\n", process, options.processes, family.c_str());
      }
      all.push_back(m);
      if (options.isShortRun) all.back().time.reset();
    };
    const AccuracyRun run{.report = keep, .isShortRun = options.isShortRun};
    options.processes == 1 ? measureInThisProcess(options, run)
                           : measureInProcess(options, wanted, run);
  }
  return haptics::bench::mergedOverProcesses(all);
}

/// Prints the errors that exceed their bounds. Returns whether no error does.
bool areWithinBounds(const RepeatedMeasurements& all) {
  int bounded = 0;
  int failed = 0;
  for (const auto& r : all) {
    const auto& m = r.measurement;
    if (!m.bound) continue;
    ++bounded;
    if (m.isWithinBound()) continue;
    ++failed;
    fmt::print(
        "FAIL  {}, {}, {} at {:g}: error {:g}, at most {:g}\n",
        m.family,
        m.setting,
        m.method,
        m.parameter,
        m.error.value_or(NAN),
        *m.bound);
  }
  fmt::print("\n{} errors have a bound, {} exceed it.\n", bounded, failed);
  return failed == 0;
}

int accuracy(AccuracyOptions options) {
  if (options.isWorker) {
    const auto print = [](const Measurement& m) {
      std::fputs((haptics::bench::asLine(m) + "\n").c_str(), stdout);
      std::fflush(stdout);
    };
    measureInThisProcess(options, {.report = print, .isShortRun = options.isShortRun});
    return 0;
  }
  if (options.isShortRun) options.processes = 1;  // errors are the same in all processes
  const auto measured = measure(options);
  printAndWrite(options.out, "accuracy", reportOf(measured, options));
  return areWithinBounds(measured) ? 0 : 1;
}

}  // namespace

void addAccuracyCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "accuracy",
      "Measure errors and run times of Palpate's models, and of the same methods in other software",
      accuracy);
  addOutFolder(*command, options.out);
  command
      ->add_option(
          "--processes",
          options.processes,
          "How often everything is measured, each time in a new process")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const auto& family : families()) names.emplace_back(family.option);
  command
      ->add_option(
          "--family", options.families, "Methods to measure (docs/benchmarks.md; default: all)")
      ->check(CLI::IsMember(names));
  command->add_flag("--short", options.isShortRun, "Measure errors of small models only, no times");
  command->add_flag("--worker", options.isWorker)->group("");  // measureInProcess() sets it
}

}  // namespace study::bench
