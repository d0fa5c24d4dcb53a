#include <filesystem>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/joined.h"
#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "protocols/reading/material_file.h"
#include "study/app/command_options.h"
#include "study/app/measurements/material_inputs.h"
#include "study/app/measurements/material_report.h"
#include "study/app/write_report.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;

struct FitArguments {
  MaterialInputs inputs;
  std::string out;
  std::string report;
  std::string name = "material";
  std::string title = "A reaming material";
};

/// Warns if the curve of a harder bone is below that of a softer one by more than @p
/// perceptibleDifference [N, N·m] at some depth, and names the option that prevents this.
void warnOfCrossings(
    const reaming::FittedEnvelope& envelope,
    const char* quantity,
    double perceptibleDifference,
    const reaming::FitOptions& options) {
  if (envelope.isOrdered) return;
  std::string where;
  for (const auto& crossing : reaming::crossingsOf(envelope, perceptibleDifference)) {
    where += fmt::format(
        "{}{:.1f} to {:.1f} mm", where.empty() ? "" : ", ", 1e3 * crossing.from, 1e3 * crossing.to);
  }
  if (where.empty()) return;
  fmt::print(
      "           curves of {} cross ({}): there a higher hardness feels softer. They keep their "
      "order with {}.\n",
      quantity,
      where,
      fmt::join(reaming::optionsAgainstCrossing(options), " and "));
}

/// The depth that all specimens reach, and the number of specimens at the end.
std::string specimensLeft(const reaming::TestSetFit& set) {
  const auto stretches = reaming::specimenCountsOf(set.force);
  const auto& last = stretches.back();
  const auto common = stretches.size() > 1 ? stretches[1].from : set.scale;
  return fmt::format(
      "all of them to {:.2f} mm; at the end {} measured, {} held at the force limit",
      1e3 * common,
      last.measured,
      last.held);
}

void print(const reaming::MaterialFit& fit, const reaming::FitOptions& options) {
  for (const auto& series : fit.series) {
    if (!series.exclusion.isExcluded()) continue;
    fmt::print("left out  {} ({}): {}\n", series.name, nameOf(series.set), series.exclusion.words);
  }
  for (const auto& set : fit.sets) {
    const auto& force = set.force;
    fmt::print(
        "{:<10} {:>2} series to {:.2f} mm; nodes {} / {} / {} (minimum, {}, maximum); largest "
        "error {:.2g} / {:.2g} / {:.2g} N\n           {}\n",
        nameOf(set.set),
        set.used,
        1000.0 * set.scale,
        force.minimum.spline.nodes.size(),
        force.average.spline.nodes.size(),
        force.maximum.spline.nodes.size(),
        middleCurveNameOf(options.envelope),
        force.minimum.error.largest,
        force.average.error.largest,
        force.maximum.error.largest,
        specimensLeft(set));
    warnOfCrossings(force, "force", 1.0, options);
    if (set.torque) warnOfCrossings(*set.torque, "torque", 0.03, options);
  }
}

/// @throws UserError  if a spline's error exceeds the requested one.
void requireSmallErrors(const reaming::MaterialFit& fit, const reaming::FitOptions& options) {
  const bool isPublished = options.nodes == reaming::NodeRule::PaperLiteral;
  for (const auto& curve : curvesOf(fit, options)) {
    if (curve.curve->isMet) continue;
    const auto& error = curve.curve->error;
    throw UserError(fmt::format(
        "The {} of {} ({}) cannot be had with an error of {:g}: {} nodes of the kind '{}' leave "
        "{:.3g}. Choose --nodes greedy, or a larger --error.",
        curve.curveName,
        curve.setName,
        curve.quantity,
        options.wantedError,
        curve.curve->spline.nodes.size(),
        protocols::nameOf(options.nodes),
        isPublished ? error.published : error.floored));
  }
}

/// @throws UserError  if the engine cannot render the material that is to be written.
void requireRenderable(const FitArguments& command, const reaming::FitOptions& options) {
  if (command.out.empty()) return;
  if (options.axis != reaming::DepthAxis::Depth) {
    throw UserError(
        "--axis " + command.inputs.axis +
        " is for comparing figures: a material that is felt lies over depth. Leave --out away, or "
        "use --axis depth.");
  }
  if (options.spline == reaming::SplineKind::Linear) {
    throw UserError(
        "A material file holds cubics with one slope at each node, and straight lines have two. "
        "Leave --out away, or use another --spline, e.g. pchip.");
  }
}

int fit(FitArguments& command) {
  const auto options = command.inputs.fitOptions();
  requireRenderable(command, options);
  const auto read = readAll(command.inputs);
  const auto result = reaming::fitMaterial(read.series, options);
  print(result, options);
  if (read.isSynthetic) {
    fmt::print(
        "SYNTHETIC: these series were not measured, and all that is fitted to them says so.\n");
  }
  if (result.sets.empty()) throw UserError("Every series was left out; there is nothing to fit.");
  if (!options.nodesOf) requireSmallErrors(result, options);
  if (!command.out.empty()) {
    writeNewFile(
        command.out,
        protocols::materialAsJson(
            command.name, command.title, read.isSynthetic, result, options, read.sources));
    fmt::print(
        "\nMaterial saved: {0}. Put it beside a protocol and name it there: \"material\": "
        "\"{0}\".\n",
        command.out);
  }
  if (!command.report.empty()) {
    writeDocument(command.report, "material", materialReport(read.series, result, options));
    fmt::print("Report saved: {}/material.html\n", command.report);
  }
  if (command.out.empty() && command.report.empty()) {
    fmt::print("\nNothing was written. Add --out MATERIAL.json, or --report FOLDER.\n");
  }
  return 0;
}

void addFit(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "fit",
      "Fit a material to measured series of force and torque, and write it as a file",
      app::fit);
  command.inputs.addTo(*verb);
  verb->add_option("--out", command.out, "New file for the material")->type_name("FILE");
  addReportFolder(*verb, command.report, "tables, figures");
  verb->add_option("--name", command.name, "Name of the material")->capture_default_str();
  verb->add_option("--title", command.title, "Title shown in reports")->capture_default_str();
}

struct CompareArguments {
  MaterialInputs inputs;
  std::string curve = "dynamic-1/force/maximum";
  std::string report;
};

int compare(CompareArguments& command) {
  const auto options = command.inputs.fitOptions();
  auto figure = optionsForFigure7(options);
  const auto& given = *command.inputs.command;
  if (given.count("--error") > 0 || given.count("--nodes") > 0)
    figure.nodeCount = options.nodeCount;
  if (const auto problem = problemOf(figure)) {
    throw UserError("Such nodes cannot be found: " + *problem + ". Choose another --nodes.");
  }
  const auto read = readAll(command.inputs);
  auto curvesAlone = options;
  curvesAlone.nodeCount.reset();
  curvesAlone.nodesOf.reset();
  const auto result = reaming::fitMaterial(read.series, curvesAlone);
  const auto curves = curvesOf(result, options);
  report::Document document{.title = "Two splines through the same nodes"};
  for (const auto& curve : curves) {
    if (command.curve != "all" && pathOf(curve) != command.curve) continue;
    auto part = splineComparisonPart(curve, figure);
    fmt::print("{}\n", part.heading);
    for (const auto& line : part.paragraphs) fmt::print("  {}\n", line);
    document.parts.push_back(std::move(part));
  }
  if (document.parts.empty()) {
    throw UserError(
        "There is no curve '" + command.curve + "'. There are " +
        base::joined(curves, ", ", pathOf) + ", and all.");
  }
  if (!command.report.empty()) {
    if (read.isSynthetic) document.lead.emplace_back("SYNTHETIC: these series were not measured.");
    writeDocument(command.report, "figure-7", std::move(document));
    fmt::print("Figure saved: {}/figure-7.html\n", command.report);
  }
  return 0;
}

void addCompare(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "compare",
      "Compare natural cubic and Hermite splines through the same nodes (reaming paper, Fig. 7)",
      app::compare);
  command.inputs.addTo(*verb);
  verb->get_option("--nodes")->default_str("12");
  verb->get_option("--nodes-of")
      ->description("Kind of spline for which nodes are chosen (default: cubic-natural)");
  verb->get_option("--axis")->description(
      "Horizontal axis: depth, or displacement as a share of the largest of the test set "
      "(normalised) or of each series (normalised-series)");
  verb->remove_option(verb->get_option("--spline"));  // two kinds are compared, both fixed
  verb->add_option("--curve", command.curve, "Curve to compare: TEST-SET/QUANTITY/CURVE, or all")
      ->capture_default_str();
  addReportFolder(*verb, command.report, "the figure");
}

struct SynthesiseArguments {
  std::string folder;
  std::uint64_t seed = 1;
};

int synthesise(const SynthesiseArguments& command) {
  const std::filesystem::path folder(command.folder);
  if (std::filesystem::exists(folder) && !std::filesystem::is_empty(folder)) {
    throw UserError("'" + command.folder + "' is not empty. Choose a folder that is new.");
  }
  std::filesystem::create_directories(folder);
  for (const auto& series : reaming::syntheticStudy(command.seed)) {
    std::string name = series.name;
    for (char& c : name) c = c == ' ' || c == ',' ? '-' : c;
    writeNewFile((folder / (name + ".csv")).string(), reaming::asText(series));
  }
  fmt::print(
      "72 series of 24 specimens saved: {0}. They are synthetic, not measured. Fit them with\n"
      "  palpate material fit --static {0}/*static.csv --dynamic-1 {0}/*dynamic-1.csv "
      "--dynamic-2 {0}/*dynamic-2.csv --out MATERIAL.json\n",
      command.folder);
  return 0;
}

void addSynthesise(CLI::App& parentCommand, Action& action) {
  auto [verb, command] = addCommand(
      parentCommand,
      action,
      "synthesise",
      "Write synthetic series with the published properties, for trying things out",
      synthesise);
  verb->add_option("FOLDER", command.folder, "New or empty folder")->required();
  verb->add_option("--seed", command.seed, "Random seed; the same seed gives the same series")
      ->capture_default_str();
}

}  // namespace

void addMaterialCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program,
      "material",
      "Fit reaming materials to measured series of force and torque (docs/reaming.md)");
  addFit(parentCommand, action);
  addCompare(parentCommand, action);
  addSynthesise(parentCommand, action);
}

}  // namespace study::app
