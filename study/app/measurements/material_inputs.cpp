#include "study/app/measurements/material_inputs.h"

#include <filesystem>
#include <map>

#include "base/text_table.h"
#include "haptics/reaming/material/series.h"
#include "study/app/command_options.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using haptics::filters::CutoffRule;
using reaming::DepthAxis;
using reaming::EnvelopeRule;
using reaming::NodeRule;
using reaming::SplineKind;
using reaming::TestSet;

constexpr DepthAxis kAxes[]{DepthAxis::Depth, DepthAxis::Normalised, DepthAxis::NormalisedSeries};
constexpr CutoffRule kCutoffRules[]{CutoffRule::Floor, CutoffRule::Plain};
constexpr EnvelopeRule kEnvelopes[]{EnvelopeRule::Pointwise, EnvelopeRule::SingleSample};
constexpr NodeRule kNodeRules[]{
    NodeRule::Greedy, NodeRule::PaperLiteral, NodeRule::Thinned, NodeRule::Optimal};
constexpr SplineKind kSplines[]{
    SplineKind::HermiteDataSlope,
    SplineKind::Pchip,
    SplineKind::Makima,
    SplineKind::NaturalCubic,
    SplineKind::Linear};
constexpr int kFewestNodes = 2;
constexpr int kMostNodes = 200;

/// Splits texts such as "force=Kraft" at the equals sign.
std::map<std::string, std::string> pairsIn(const std::vector<std::string>& words) {
  std::map<std::string, std::string> result;
  for (const auto& word : words) {
    const auto equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw UserError("'" + word + "' names nothing. Write WHAT=NAME, e.g. force=Kraft.");
    }
    result[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return result;
}

/// The enumerator named @p name; CLI11 has checked that it exists.
template <typename Enum, std::size_t kCount>
Enum named(const std::string& name, const Enum (&choices)[kCount]) {
  for (const auto choice : choices) {
    if (protocols::nameOf(choice) == name) return choice;
  }
  return choices[0];
}

template <typename Enum, std::size_t kCount>
CLI::IsMember oneOf(const Enum (&choices)[kCount]) {
  std::vector<std::string> names;
  for (const auto choice : choices) names.emplace_back(protocols::nameOf(choice));
  return CLI::IsMember(names);
}

}  // namespace

void MaterialInputs::addTo(CLI::App& verb) {
  command = &verb;
  verb.add_option("--static", files[0], "Series of static tests, without reaming (CSV or TSV)")
      ->type_name("FILE");
  verb.add_option(
          "--dynamic-1",
          files[1],
          "Series of the first dynamic tests: reaming with the next larger reamer")
      ->type_name("FILE");
  verb.add_option(
          "--dynamic-2",
          files[2],
          "Series of the second dynamic tests: reaming again with a reamer that is 2 mm larger")
      ->type_name("FILE");
  verb.add_option(
      "--column",
      columns,
      "Heading of the column that holds a quantity (time, displacement, force, torque), if it does "
      "not name it: force=Channel2");
  verb.add_option(
      "--unit", units, "Unit of a quantity where the column's heading has none: force=kN");
  verb.add_option(
          "--axis",
          axis,
          "Horizontal axis: depth (needed for rendering), or displacement as a share of the "
          "largest of the test set (normalised) or of each series (normalised-series)")
      ->check(oneOf(kAxes))
      ->capture_default_str();
  verb.add_option(
          "--force-limit", options.forceLimit, "Force at which static tests were stopped [N]")
      ->check(finiteRange(1.0, 1e5))
      ->capture_default_str();
  verb.add_option(
          "--cutoff-rule",
          cutoffRule,
          "Spectrum in which the low-pass filter's cut-off is found, at twice the noise floor: "
          "detrended with a Hann window, or plain (as in the reaming paper; lets more noise "
          "through)")
      ->check(oneOf(kCutoffRules))
      ->capture_default_str();
  verb.add_option(
          "--cutoff", options.cutoff, "One cut-off for all forces [Hz] (default: by the rule)")
      ->check(finiteRange(1e-4, 1e4));
  verb.add_option(
          "--torque-cutoff",
          options.torqueCutoff,
          "One cut-off for all torques [Hz] (default: by the rule)")
      ->check(finiteRange(1e-4, 1e4));
  verb.add_option(
          "--envelope",
          envelope,
          "How minimum, average and maximum curves are formed: at each depth, or from whole "
          "specimens")
      ->check(oneOf(kEnvelopes))
      ->capture_default_str();
  verb.add_option(
          "--nodes",
          nodes,
          "Number of the spline's nodes, or the rule that places them (docs/reaming.md, \"nodes\")")
      ->check(oneOf(kNodeRules) | CLI::Range(kFewestNodes, kMostNodes))
      ->capture_default_str();
  verb.add_option(
          "--nodes-of",
          nodesOf,
          "Kind of spline whose error decides where nodes go (default: that of --spline)")
      ->check(oneOf(kSplines));
  verb.add_option(
          "--spline",
          spline,
          "Kind of spline: how its slopes at the nodes are found (docs/reaming.md, \"spline\")")
      ->check(oneOf(kSplines))
      ->capture_default_str();
  verb.add_option(
          "--error", options.wantedError, "Largest relative error of the spline (0.05: 5 %)")
      ->check(finiteRange(1e-4, 1.0))
      ->capture_default_str();
  verb.add_option(
          "--force-floor",
          options.forceFloor,
          "Floor of relative errors: where the force is smaller, its error is divided by this "
          "instead [N]")
      ->check(finiteRange(1e-6, 1e4))
      ->capture_default_str();
  verb.add_option(
          "--torque-floor",
          options.torqueFloor,
          "Floor of relative errors: where the torque is smaller, its error is divided by this "
          "instead [N·m]")
      ->check(finiteRange(1e-6, 1e4))
      ->capture_default_str();
  verb.add_flag(
      "--synthetic",
      isSynthetic,
      "Mark these series as synthetic (not measured), even if their files do not");
}

reaming::FitOptions MaterialInputs::fitOptions() const {
  auto result = options;
  result.axis = named(axis, kAxes);
  result.cutoffRule = named(cutoffRule, kCutoffRules);
  result.envelope = named(envelope, kEnvelopes);
  result.spline = named(spline, kSplines);
  if (!nodesOf.empty()) result.nodesOf = named(nodesOf, kSplines);
  result.nodeCount = base::numberFrom<std::size_t>(nodes);
  if (!result.nodeCount) result.nodes = named(nodes, kNodeRules);
  if (result.nodeCount && command->count("--error") > 0) {
    throw UserError(
        "--nodes " + nodes +
        " places so many nodes at the least error that they allow; --error says how many there "
        "have to be. Leave one of the two away.");
  }
  if (const auto problem = problemOf(result)) {
    throw UserError(
        "'" + nodes + "' nodes cannot be found for " +
        std::string(protocols::nameOf(result.nodesOf.value_or(result.spline))) + ": " + *problem +
        ". Choose --nodes greedy, or a number.");
  }
  return result;
}

SeriesWithSources readAll(const MaterialInputs& inputs) {
  const reaming::SeriesMapping mapping{pairsIn(inputs.columns), pairsIn(inputs.units)};
  SeriesWithSources all;
  for (const TestSet set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
    for (const auto& file : inputs.files[static_cast<std::size_t>(set)]) {
      all.series.push_back(reaming::readSeriesFile(file, set, mapping));
      all.series.back().isSynthetic |= inputs.isSynthetic;
      all.isSynthetic |= all.series.back().isSynthetic;
      all.sources.push_back(
          {std::filesystem::path(file).filename().string(),
           storage::sha256(reaming::contentOfSeriesFile(file))});
    }
  }
  if (all.series.empty()) {
    throw UserError("No series were named. Say which test each is of: --dynamic-1 FILE …");
  }
  return all;
}

}  // namespace study::app
