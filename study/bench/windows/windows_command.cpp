// palpate-bench windows: the speed of scenes, plots and pages on this computer.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <QApplication>
#include <QStorageInfo>

#include "questionnaires/json/document.h"
#include "study/app/command_options.h"
#include "study/bench/bench_program.h"
#include "study/bench/print_result.h"
#include "study/bench/windows/window_speed.h"
#include "study/model/user_error.h"

namespace study::bench {
namespace {

using gui::scene::RendererChoice;
using gui::scene::SphereColours;

constexpr int kStudies = 200;
constexpr const char* kSimulations = "simulations";
constexpr const char* kDesk = "desk";

struct WindowsOptions {
  std::string part;  ///< empty: all
  std::string anatomy;
  std::string colours = "neutral";
  std::string renderer = "best";
  SimulationOptions simulation;
};

/// @throws UserError  with all problems of the file.
protocols::Anatomy anatomyIn(const std::string& file) {
  questionnaires::Problems problems;
  std::optional<protocols::Anatomy> anatomy;
  try {
    const auto text = questionnaires::readTextFile(file, protocols::kMaxAnatomyBytes);
    anatomy = protocols::readAnatomy(text, problems);
  } catch (const UserError& error) {
    problems.add("", error.what());
  }
  if (!anatomy) throw UserError(questionnaires::describe(problems.all()));
  return *anatomy;
}

std::string inPixels(std::pair<int, int> size) {
  return fmt::format("{} × {}", size.first, size.second);
}

DataTable simulationTable(
    const std::vector<SimulationSpeed>& simulations, std::pair<int, int> window) {
  DataTable table{
      .name = "simulations",
      .description = "Simulations, a window of " + inPixels(window),
      .columns = {
          {"simulation", "Simulation"},
          {"drawn_by", "Drawn by"},
          {"drawn_size", "Drawn size"},
          {"pictures_per_s", "Pictures a second"},
          {"mean_pictures_per_s", "… mean"},
          {"frame_p50_ms", "Picture to picture, p50 [ms]"},
          {"frame_p99_ms", "… p99"},
          {"frame_longest_ms", "… longest"},
          {"latency_p50_ms", "Latency, p50 [ms]"},
          {"latency_p99_ms", "… p99"},
          {"pictures", "Pictures"},
          {"making_ms", "Made ready in [ms]"},
          {"ticks", "Ticks of the hand"},
          {"late_ticks", "… late by a period"},
          {"bytes_per_picture", "Bytes about spheres a picture"},
          {"bytes", "… of all"},
          {"changes_lost", "Changes not shown"}}};
  for (const auto& measured : simulations) {
    const auto& view = measured.view;
    table.rows.push_back(
        {measured.name,
         view.renderer,
         inPixels(measured.size),
         view.frameMedian > 0.0 ? 1000.0 / view.frameMedian : 0.0,
         view.rate,
         view.frameMedian,
         view.frameP99,
         measured.longest,
         view.latencyMedian,
         view.latencyP99,
         static_cast<std::int64_t>(view.frames),
         measured.buildTime,
         static_cast<std::int64_t>(measured.trialRecord.ticks),
         static_cast<std::int64_t>(measured.trialRecord.lateTicks.value_or(0)),
         measured.bytesPerFrame,
         measured.allBytes,
         static_cast<std::int64_t>(view.lostChanges)});
  }
  return table;
}

DataTable plotTable(const PlotSpeed& plots) {
  return {
      .name = "plots",
      .description = "Live plots of the operator: three channels at 1 kHz",
      .columns =
          {{"pictures_per_s", "Pictures a second"}, {"processor", "Processor [share of one]"}},
      .rows = {{plots.picturesPerSecond, plots.processor}}};
}

DataTable pageTable(std::vector<double> waits, const std::string& folder) {
  std::ranges::sort(waits);
  const auto at = [&](double q) {
    return waits[static_cast<std::size_t>(q * static_cast<double>(waits.size() - 1))];
  };
  const auto disk = QStorageInfo(QString::fromStdString(folder)).fileSystemType().toStdString();
  return {
      .name = "pages",
      .description = "Page changes of a participant, answers on the disk first",
      .columns =
          {{"pages", "Page changes"},
           {"p50_ms", "p50 [ms]"},
           {"p99_ms", "p99 [ms]"},
           {"file_system", "File system"}},
      .rows = {{static_cast<std::int64_t>(waits.size()), at(0.5), at(0.99), disk}}};
}

DataTable homeTable(double drawn) {
  return {
      .name = "home",
      .description = "The home page",
      .columns = {{"studies", "Studies in its list"}, {"drawn_ms", "Made and drawn in [ms]"}},
      .rows = {{static_cast<std::int64_t>(kStudies), drawn}}};
}

int windows(const WindowsOptions& options) {
  auto simulation = options.simulation;
  simulation.colours = options.colours == "density"   ? SphereColours::Density
                       : options.colours == "removal" ? SphereColours::Removal
                                                      : SphereColours::Neutral;
  simulation.renderer = options.renderer == "finest"     ? RendererChoice::FullDetail
                        : options.renderer == "software" ? RendererChoice::Software
                                                         : RendererChoice::Best;
  if (!options.anatomy.empty()) simulation.knee = anatomyIn(options.anatomy);
  if (!simulation.folder.empty()) std::filesystem::create_directories(simulation.folder);
  const bool hasDisplay =
      !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
  if (!hasDisplay && qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM")) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
  }
  static int argc = 1;
  static char name[] = "palpate-bench";
  static char* argv[] = {name, nullptr};
  const QApplication application(argc, argv);

  report::Document document{
      .title = "Windows: simulations, plots, pages",
      .lead = {
          "How fast they are drawn on this computer. docs/benchmarks.md explains the columns."}};
  bool isSparing = true;
  std::string remark;
  if (options.part != kDesk) {
    const std::vector<SimulationSpeed> simulations{measureKnee(simulation), measureCup(simulation)};
    document.parts.push_back(
        {.heading = "Simulations", .tables = {simulationTable(simulations, simulation.size)}});
    isSparing = simulations.back().sendsChangesOnly();
    remark = simulations.front().remark;
    document.lead.push_back(remark);
  }
  if (options.part != kSimulations) {
    std::fprintf(stderr, "live plots, pages\n");
    const auto plots = measurePlots(simulation.seconds);
    const auto folder = simulation.folder.empty() ? std::filesystem::temp_directory_path().string()
                                                  : simulation.folder;
    const auto waits = measurePageChanges(folder);
    const auto home = measureHome(folder, kStudies);
    document.parts.push_back(
        {.heading = "Desk",
         .tables = {plotTable(plots), pageTable(waits, folder), homeTable(home)}});
  }
  printAndWrite(simulation.folder, "windows", document);
  if (!remark.empty()) fmt::print("{}\n", remark);
  if (!isSparing)
    fmt::print("FAIL  a picture hands on more than 5 % of the bytes of all spheres.\n");
  return isSparing ? 0 : 1;
}

}  // namespace

void addWindowsCommand(CLI::App& program, Action& action) {
  auto [command, options] = app::addCommand(
      program,
      action,
      "windows",
      "Measure how fast simulations, live plots and a participant's pages are drawn",
      windows);
  auto& simulation = options.simulation;
  command
      ->add_option(
          "--part",
          options.part,
          "Part to measure: simulations, or desk (plots, pages, list of studies) (default: both)")
      ->check(CLI::IsMember({kSimulations, kDesk}));
  addOutFolder(*command, simulation.folder, "pictures, tables (CSV)");
  command
      ->add_option(
          "--seconds", simulation.seconds, "Duration of each simulation, and of the live plots [s]")
      ->check(app::finiteRange(0.5, 600.0))
      ->capture_default_str();
  command
      ->add_option(
          "--size", simulation.size, "Size of a simulation's window [pixels] (default: 1280x800)")
      ->delimiter('x')
      ->type_name("WIDTHxHEIGHT")
      ->check(CLI::Range(320, 7680));
  command->add_option("--spheres", simulation.spheres, "Number of spheres in the acetabulum")
      ->check(CLI::Range(std::size_t{1000}, std::size_t{10'000'000}))
      ->capture_default_str();
  command->add_option("--colours", options.colours, "Colours of the spheres")
      ->check(CLI::IsMember({"neutral", "density", "removal"}))
      ->capture_default_str();
  command
      ->add_option(
          "--renderer",
          options.renderer,
          "Renderer: best that this computer has, finest (as on a graphics card), or software")
      ->check(CLI::IsMember({"best", "finest", "software"}))
      ->capture_default_str();
  command
      ->add_option(
          "--anatomy", options.anatomy, "OBJ file of a knee to draw instead of the built-in one")
      ->check(CLI::ExistingFile);
}

}  // namespace study::bench
