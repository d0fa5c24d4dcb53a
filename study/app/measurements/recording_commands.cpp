#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/recordings/cut_import.h"
#include "haptics/recordings/recording.h"
#include "haptics/recordings/trace.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/app/measurements/recording_inputs.h"
#include "study/app/measurements/recording_report.h"
#include "study/app/write_report.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/session/import_recording.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

namespace recordings = haptics::recordings;

struct NoiseArguments {
  RecordingInputs inputs;
  std::vector<std::string> rows;
  double leastStep = recordings::kLeastStep;
  bool json = false;
};

struct ImportArguments {
  RecordingInputs inputs;
  std::string out;
  std::string rows;
  std::string report;
  recordings::ImportOptions options;
  bool json = false;
};

/// Reads a range of rows: "5900:5975", numbered from 1, including the last one.
recordings::RowRange rowRange(const std::string& text) {
  recordings::RowRange range;
  char colon = '\0';
  char more = '\0';
  const int read =
      std::sscanf(text.c_str(), "%zu%c%zu%c", &range.first, &colon, &range.last, &more);
  if (read != 3 || colon != ':' || range.first == 0 || range.last < range.first) {
    throw UserError(
        "'" + text + "' is no range of rows. Write FIRST:LAST, numbered from 1, e.g. 5900:5975.");
  }
  return range;
}

std::string describeLandmark(const char* name, const std::optional<recordings::CurvePoint>& point) {
  return point ? fmt::format("{} {:.2f} → {:.2f} N", name, point->travel, point->force)
               : fmt::format("{} –", name);
}

void printSurvey(
    const recordings::Recording& recording,
    const recordings::RecordingSurvey& survey,
    const std::string& calibration,
    const std::string& filter) {
  fmt::print(
      "{}\n  {} rows at {:.1f} Hz (steps of {:.3g} to {:.3g} ms), {} could not be read\n",
      recording.source,
      survey.rows,
      survey.sampling.rate,
      1000.0 * survey.sampling.stepMin,
      1000.0 * survey.sampling.stepMax,
      words::counted(static_cast<std::uint64_t>(survey.refusedLines), "line"));
  for (const auto& line : recording.refusedLines) {
    fmt::print("  line {}: {}\n", line.number, line.reason);
  }
  fmt::print(
      "  force {:.2f} to {:.2f} N by {}; {} rows saturated, {} beyond the calibration; {} "
      "distinct travels\n  filter of the travel: {}\n\n",
      survey.minForce,
      survey.maxForce,
      calibration,
      survey.saturatedRows,
      survey.uncalibratedRows,
      survey.distinctTravels,
      filter);
  // a cut file contains the closing rows
  fmt::print("  cut    closing rows      whole cut      seconds  peak [N]\n");
  for (std::size_t i = 0; i < survey.closures.size(); ++i) {
    const auto& c = survey.closures[i];
    fmt::print(
        "  {:>3} {:>7}–{:<7} {:>7}–{:<7} {:>9.2f} {:>9.2f}  {}, {}, {}, {}{}\n",
        i + 1,
        c.closing.first,
        c.closing.last,
        c.rows.first,
        c.rows.last,
        c.duration,
        c.peakForce,
        describeLandmark("interception", c.landmarks.interception),
        describeLandmark("yield", c.landmarks.yield),
        describeLandmark("bottom-out", c.landmarks.bottomOut),
        describeLandmark("opening", c.landmarks.opening),
        c.isComplete ? "" : "  (incomplete)");
  }
}

/// The requested cut. If none was requested and none can be chosen automatically, std::nullopt, and
/// @p whyNot receives the reason; the recording can still be shown.
std::optional<recordings::ImportedCut> requestedCut(
    const recordings::Recording& recording, const ImportArguments& command, std::string& whyNot) {
  const bool isLookingOnly =
      command.out.empty() && command.rows.empty() && command.options.closures.empty();
  try {
    return importRecording(recording, command.options);
  } catch (const UserError& error) {
    if (!isLookingOnly) throw;
    whyNot = error.what();
    return std::nullopt;
  }
}

void printChosenCut(const ImportArguments& command, const recordings::ImportReport& report) {
  fmt::print("\n  {}\n", describe(report.reason));
  for (const auto& change : report.changes) fmt::print("  {}\n", describe(change));
  if (report.isAltered()) {
    fmt::print(
        "\nWARNING: the cut is not what was recorded: its peak is {:.2f} N in place of {:.2f} N, "
        "and its force differs by up to {:.2f} N. Slopes above {:g} N per travel unit are limited "
        "(--max-slope; by default 4.39, the largest stiffness in the cuts of the punch paper), and "
        "the recording rises by up to {:.2f}. A larger --max-slope keeps its shape; check the "
        "result with 'palpate scene explain'.\n",
        report.peakAfter,
        report.peakBefore,
        report.largestChange,
        command.options.maxSlope,
        report.steepness);
  }
  if (command.out.empty()) {
    fmt::print("\nNothing was written. Add --out CUT.json to keep this cut.\n");
  } else {
    fmt::print(
        "\nCut saved: {0}. Put it beside a protocol and name it there: \"cut\": \"{0}\".\n",
        command.out);
  }
}

int import(ImportArguments& command) {
  const auto [recording, calibration] = readFrom(command.inputs);
  command.options.calibration = calibration;
  command.options.filter = command.inputs.travelFilter();
  if (!command.rows.empty()) command.options.rows = rowRange(command.rows);
  const auto trace = recordings::traceOf(recording, calibration, command.options.filter);
  const auto survey = recordings::summariseCuts(recording, trace, command.options.yieldLoad);
  const auto filter = recordings::parametersOf(command.options.filter, survey.sampling.rate);
  std::string whyNot;
  const auto imported = requestedCut(recording, command, whyNot);
  if (imported && !command.out.empty()) {
    writeNewFile(command.out, cutAsJsonWithSource(command.inputs.file, imported->cut));
  }
  if (!command.report.empty()) {
    writeDocument(
        command.report, "recording", recordingReport(recording, trace, survey, filter, imported));
  }
  if (command.json) {
    std::fputs(importAsJson(recording, survey, trace, imported, whyNot).c_str(), stdout);
    return 0;
  }
  printSurvey(recording, survey, calibration.name, filter);
  if (imported) {
    printChosenCut(command, imported->report);
  } else {
    fmt::print("\n  {}\n", whyNot);
  }
  return 0;
}

int noise(const NoiseArguments& command) {
  const auto [recording, calibration] = readFrom(command.inputs);
  const auto trace = recordings::traceOf(recording, calibration, command.inputs.travelFilter());
  std::vector<recordings::RowRange> rows;
  for (const auto& text : command.rows) rows.push_back(rowRange(text));
  if (rows.empty()) {
    for (const auto& closure : recordings::closuresOf(recording, trace)) {
      if (closure.isComplete) rows.push_back(closure.closing);
    }
  }
  for (const auto& range : rows) {
    if (range.last <= recording.rows.size()) continue;
    throw UserError(fmt::format(
        "Rows {} to {} do not lie in '{}', which has {} rows.",
        range.first,
        range.last,
        recording.source,
        recording.rows.size()));
  }
  const auto found = recordings::processNoiseOf(trace, rows, command.leastStep);
  if (command.json) {
    std::fputs(processNoiseAsJson(found).c_str(), stdout);
    return 0;
  }
  fmt::print(
      "{}\n  {} rows of {}", recording.source, found.samples, words::counted(rows.size(), "cut"));
  if (found.resting > 0)
    fmt::print("; {} left out, where the travel hardly changes", found.resting);
  fmt::print(
      "\n\n  variance of the force       {:.5g} N²\n  covariance                  {:.5g} "
      "N²/travel unit\n  variance of the stiffness   {:.5g} N²/travel unit²\n\n"
      "As \"process_force\", \"process_covariance\" and \"process_stiffness\" they go into the "
      "\"noise\" of a Kalman condition (--json writes them so).\n",
      found.force,
      found.covariance,
      found.stiffness);
  return 0;
}

void addImport(CLI::App& parentCommand, Action& action) {
  auto [import, command] = addCommand(
      parentCommand,
      action,
      "import",
      "Read a recording of a real punch, find its cuts, write one as a cut file",
      app::import);
  command.inputs.addTo(*import);
  import
      ->add_option(
          "--out", command.out, "New file for the cut (default: only print what was found)")
      ->type_name("FILE");
  auto* cuts = import->add_option(
      "--cut",
      command.options.closures,
      "Cut to import, numbered from 1; several are averaged (default: the most typical one)");
  import
      ->add_option(
          "--rows", command.rows, "Rows to import instead of a cut: FIRST:LAST, numbered from 1")
      ->excludes(cuts);
  import
      ->add_option(
          "--max-slope",
          command.options.maxSlope,
          "Largest slope of the curve; steeper parts are made gentler [N per unit of the "
          "recording's travel]")
      ->check(finiteRange(0.01, 1e6))
      ->capture_default_str();
  import
      ->add_option(
          "--yield-load",
          command.options.yieldLoad,
          "A cut counts if the force rises by at least this until the tissue yields [N]; 0: any")
      ->check(finiteRange(0.0, 1e6))
      ->capture_default_str();
  addReportFolder(*import, command.report, "figures (spectrum, closures, the cut)");
  import->add_option("--name", command.options.name, "Name of the cut (default: the file's name)");
  import->add_flag("--json", command.json, "Print JSON with full precision");
}

void addNoise(CLI::App& parentCommand, Action& action) {
  auto [noise, command] = addCommand(
      parentCommand,
      action,
      "noise",
      "Estimate the process noise of a Kalman filter from the variation of recorded cuts",
      app::noise);
  command.inputs.addTo(*noise);
  noise
      ->add_option(
          "--rows",
          command.rows,
          "Ranges of rows FIRST:LAST, numbered from 1 (default: the closing part of every complete "
          "cut)")
      ->delimiter(',');
  noise
      ->add_option(
          "--least-step",
          command.leastStep,
          "Leave out rows whose travel changes by less than this [unit of the recording's travel]; "
          "0: only unchanged rows")
      ->check(finiteRange(0.0, 1.0))
      ->capture_default_str();
  noise->add_flag(
      "--json", command.json, "Print JSON for the 'noise' of a protocol, with full precision");
}

}  // namespace

void addRecordingCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program,
      "recording",
      "Import measured cuts for rendering; calibrate the force sensor that measured them");
  addImport(parentCommand, action);
  addNoise(parentCommand, action);
  addCalibrateCommand(parentCommand, action);
}

}  // namespace study::app
