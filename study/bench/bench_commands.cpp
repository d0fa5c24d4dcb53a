#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/bench/stability_kernels.h"
#include "study/app/commands.h"
#include "study/app/finite_range.h"
#include "study/app/write_document.h"
#include "study/bench/bench_devices.h"
#include "study/bench/bench_report.h"
#include "study/bench/bench_workers.h"

namespace study::app {
namespace {

namespace bench = haptics::bench;

struct AccuracyOptions {
  std::string out;
  int processes = 5;
  std::vector<std::string> families;
  bool isWorker = false;
};

struct Family {
  const char* name;
  void (*measure)(const bench::Report&);
  bool isOnce = false;  ///< takes long, and one process is enough
};
constexpr Family kFamilies[]{
    {"splines", bench::measureSplines},
    {"finite-elements", bench::measureFiniteElements},
    {"kalman", bench::measureKalmanFilter},
    {"encoders", bench::measureEncoders},
    {"refresh", bench::measureRefresh},
    {"filter", bench::measureFilter, true},
    {"packing", bench::measurePacking, true},
    {"density", bench::measureDensity, true}};

/// Measures once, and prints what comes out for whoever started this.
int measureOnce(const AccuracyOptions& options) {
  const auto print = [](const bench::Measurement& m) {
    std::fputs((bench::asLine(m) + "\n").c_str(), stdout);
    std::fflush(stdout);
  };
  for (const auto& family : kFamilies) {
    const auto& wanted = options.families;
    const bool isWanted =
        wanted.empty() || std::find(wanted.begin(), wanted.end(), family.name) != wanted.end();
    if (isWanted) family.measure(print);
  }
  return 0;
}

/// What the so-manieth process is to do; nothing where there is nothing left.
std::vector<std::string> callOfWorker(const AccuracyOptions& options, int process) {
  std::vector<std::string> call;
  for (const auto& family : kFamilies) {
    const auto& wanted = options.families;
    const bool isWanted =
        wanted.empty() || std::find(wanted.begin(), wanted.end(), family.name) != wanted.end();
    if (!isWanted || (family.isOnce && process > 1)) continue;
    if (call.empty()) call = {"bench", "accuracy", "--worker"};
    call.insert(call.end(), {"--family", family.name});
  }
  return call;
}

int accuracy(const AccuracyOptions& options) {
  if (options.isWorker) return measureOnce(options);
  std::vector<bench::Measurement> all;
  for (int process = 1; process <= options.processes; ++process) {
    std::string family;
    const auto call = callOfWorker(options, process);
    if (call.empty()) break;
    runAnotherOfUs(call, [&](const std::string& line) {
      const auto measurement = bench::fromLine(line);
      if (!measurement) return;
      if (measurement->family != family) {
        family = measurement->family;
        std::fprintf(stderr, "process %d of %d: %s\n", process, options.processes, family.c_str());
      }
      all.push_back(*measurement);
    });
  }
  const auto gathered = bench::gathered(all);
  printTargets(accuracyTargets(gathered));
  if (options.out.empty()) {
    fmt::print("\nNothing was written. Add --out FOLDER for tables, figures and a page.\n");
  } else {
    writeDocument(options.out, "accuracy", accuracyReport(gathered));
    fmt::print("\n{}/accuracy.html holds tables and figures.\n", options.out);
  }
  return 0;
}

void addAccuracy(CLI::App& noun, Action& action) {
  auto options = std::make_shared<AccuracyOptions>();
  auto* verb = noun.add_subcommand(
      "accuracy", "Error against run time: our models and their peers, on this computer");
  verb->add_option("--out", options->out, "A folder for tables (CSV), figures (SVG) and a page");
  verb->add_option("--processes", options->processes, "How many processes measure, one by one")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  std::vector<std::string> names;
  for (const auto& family : kFamilies) names.emplace_back(family.name);
  verb->add_option("--family", options->families, "Only these families (default: all)")
      ->check(CLI::IsMember(names));
  verb->add_flag("--worker", options->isWorker)->group("");  // not for people
  verb->callback([&action, options] { action = [options] { return accuracy(*options); }; });
}

struct StabilityOptions {
  std::string out;
  double effort = 1.0;
};

int stability(const StabilityOptions& options) {
  const auto result = bench::runStability(options.effort, [](const std::string& sweep) {
    std::fprintf(stderr, "%s\n", sweep.c_str());
  });
  int failed = 0;
  for (const auto& check : result.checks) {
    if (check.isPassed()) continue;
    ++failed;
    fmt::print(
        "FAIL  {}: {} ({}, at {:g}): {:g}, at most {:g}\n",
        check.sweep,
        check.what,
        check.build.empty() ? "engine" : check.build,
        check.parameter,
        check.measured,
        check.bound);
  }
  if (bench::fusedKernels() == nullptr) {
    fmt::print("This processor has no fused multiply-add; that half was left out.\n");
  }
  fmt::print("{} cases, {} failed.\n", result.checks.size(), failed);
  if (options.out.empty()) {
    fmt::print("Nothing was written. Add --out FOLDER for tables, figures and a page.\n");
  } else {
    writeDocument(options.out, "stability", stabilityReport(result));
    fmt::print("{}/stability.html holds tables and figures.\n", options.out);
  }
  return failed == 0 ? 0 : 1;
}

void addStability(CLI::App& noun, Action& action) {
  auto options = std::make_shared<StabilityOptions>();
  auto* verb =
      noun.add_subcommand("stability", "Stiff and extreme cases: what holds, within which bounds");
  verb->add_option("--out", options->out, "A folder for tables (CSV), figures (SVG) and a page");
  verb->add_option("--effort", options->effort, "Less than 1 tries fewer random cases")
      ->check(finiteRange(0.001, 100.0))
      ->capture_default_str();
  verb->callback([&action, options] { action = [options] { return stability(*options); }; });
}

struct ServoOptions {
  std::string out;
  std::string disk = ".";
  std::vector<double> rates{1000.0, 2000.0, 4000.0, 8000.0};
  double seconds = 4.0;
  double recording = 20.0;
};

int servo(const ServoOptions& options) {
  ServoMeasurement measured;
  for (const double rate : options.rates) {
    for (const auto& mode : bench::servoModes()) {
      std::fprintf(stderr, "%g Hz, %s\n", rate, mode.name.c_str());
      measured.runs.push_back(bench::runServo(mode, rate, options.seconds));
    }
  }
  std::fprintf(stderr, "recorder, %g s in all\n", options.recording + options.seconds);
  measured.recorders = raceRecorders(options.disk, options.seconds);
  measured.loop = recordInLoop(options.disk, 1000.0, options.recording);
  printTargets(servoTargets(measured));
  const bool isRealtime = measured.runs.back().isRealtime;
  if (!isRealtime) {
    fmt::print(
        "\nReal-time priority was not granted: the loop ran as any program. An administrator "
        "grants it in /etc/security/limits.conf (rtprio 80, memlock unlimited).\n");
  }
  if (options.out.empty()) {
    fmt::print("\nNothing was written. Add --out FOLDER for tables, figures and a page.\n");
  } else {
    writeDocument(options.out, "servo", servoReport(measured));
    fmt::print("\n{}/servo.html holds tables and figures.\n", options.out);
  }
  return 0;
}

void addServo(CLI::App& noun, Action& action) {
  auto options = std::make_shared<ServoOptions>();
  auto* verb = noun.add_subcommand(
      "servo", "How punctual the force loop is on this computer, and what recording costs");
  verb->add_option("--out", options->out, "A folder for tables (CSV), figures (SVG) and a page");
  verb->add_option("--disk", options->disk, "A folder on the disk that studies are kept on")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  verb->add_option("--rates", options->rates, "Of the loop [Hz]")
      ->check(finiteRange(1.0, 10'000.0))
      ->capture_default_str();
  verb->add_option("--seconds", options->seconds, "For each rate and mode")
      ->check(finiteRange(0.1, 3600.0))
      ->capture_default_str();
  verb->add_option("--recording", options->recording, "How long a loop is recorded [s]")
      ->check(finiteRange(0.1, 36'000.0))
      ->capture_default_str();
  verb->callback([&action, options] { action = [options] { return servo(*options); }; });
}

struct DevicesOptions {
  std::string out;
  DeviceBenchOptions bench;
};

int devices(const DevicesOptions& options) {
  const auto measured = measureDevices(options.bench);
  for (const auto& series : measured.together) {
    const auto& run = series.longest();
    fmt::print(
        "{} at {:g} Hz: round trip {:.0f} µs (median), {:.0f} (p99); tick {:.0f} µs, {:.0f}\n",
        series.device,
        series.rate,
        run.link.roundTrip.quantile(0.5),
        run.link.roundTrip.quantile(0.99),
        run.loop.compute.quantile(0.5),
        run.loop.compute.quantile(0.99));
  }
  printTargets(devicesTargets(measured));
  if (options.out.empty()) {
    fmt::print("\nNothing was written. Add --out FOLDER for tables, figures and a page.\n");
  } else {
    writeDocument(options.out, "devices", devicesReport(measured));
    fmt::print("\n{}/devices.html holds tables and figures.\n", options.out);
  }
  return measured.isExact() ? 0 : 1;
}

void addDevices(CLI::App& noun, Action& action) {
  auto options = std::make_shared<DevicesOptions>();
  auto* verb = noun.add_subcommand(
      "devices", "Both devices on their wires, by stand-ins: round trip, lost cycles, stalls");
  verb->add_option("--out", options->out, "A folder for tables (CSV), figures (SVG) and a page");
  verb->add_option("--seconds", options->bench.seconds, "Both at once; 600 for ten minutes")
      ->check(finiteRange(0.5, 36'000.0))
      ->capture_default_str();
  verb->add_option("--faults", options->bench.faults, "To be counted, of each kind")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  const std::vector<std::string> parts(kDeviceBenchParts.begin(), kDeviceBenchParts.end());
  verb->add_option("--part", options->bench.parts, "Only these parts (default: all)")
      ->check(CLI::IsMember(parts));
  verb->callback([&action, options] { action = [options] { return devices(*options); }; });
}

}  // namespace

void addBenchCommands(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand("bench", "How exact, how stable, how fast, how punctual");
  noun->require_subcommand(1);
  addAccuracy(*noun, action);
  addStability(*noun, action);
  addServo(*noun, action);
  addDevices(*noun, action);
  addStatsBench(*noun, action);
}

}  // namespace study::app
