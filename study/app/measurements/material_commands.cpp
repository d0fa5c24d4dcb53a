#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/reaming/material/series_text.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "protocols/reading/material_file.h"
#include "questionnaires/json/document.h"
#include "study/app/commands.h"
#include "study/app/finite_range.h"
#include "study/app/measurements/material_report.h"
#include "study/app/write_document.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/protocol_repository.h"

namespace study::app {
namespace {

namespace reaming = haptics::reaming;
using reaming::TestSet;

struct FitCommand {
  std::vector<std::string> files[3];  ///< by test set
  std::vector<std::string> columns;
  std::vector<std::string> units;
  std::string out;
  std::string report;
  std::string name = "material";
  std::string title = "A reaming material";
  std::string cutoffRule = "detrended-hann";
  std::string envelope = "single-sample";
  std::string nodes = "greedy";
  std::string spline = "hermite-data-slope";
  reaming::FitOptions options;
  bool isSynthetic = false;
};

/// "force=Kraft" to a pair.
std::map<std::string, std::string> pairs(const std::vector<std::string>& words) {
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

/// The choice whose name is @p name; CLI11 has made sure that there is one.
template <typename Enum, std::size_t kCount>
Enum named(const std::string& name, const Enum (&choices)[kCount]) {
  for (const auto choice : choices) {
    if (protocols::nameOf(choice) == name) return choice;
  }
  return choices[0];
}

using reaming::CutoffRule;
using reaming::EnvelopeRule;
using reaming::NodeRule;
using reaming::SplineKind;
constexpr CutoffRule kCutoffRules[]{CutoffRule::Floor, CutoffRule::Plain};
constexpr EnvelopeRule kEnvelopes[]{EnvelopeRule::SingleSample, EnvelopeRule::Pointwise};
constexpr NodeRule kNodeRules[]{
    NodeRule::Greedy, NodeRule::PaperLiteral, NodeRule::Thinned, NodeRule::Optimal};
constexpr SplineKind kSplines[]{
    SplineKind::HermiteDataSlope,
    SplineKind::Pchip,
    SplineKind::Makima,
    SplineKind::NaturalCubic,
    SplineKind::Linear};

template <typename Enum, std::size_t kCount>
CLI::IsMember oneOf(const Enum (&choices)[kCount]) {
  std::vector<std::string> names;
  for (const auto choice : choices) names.emplace_back(protocols::nameOf(choice));
  return CLI::IsMember(names);
}

/// All files of all test sets, and where each comes from.
std::vector<reaming::Series> readAll(
    const FitCommand& command, std::vector<protocols::MaterialSource>& sources) {
  const reaming::SeriesMapping mapping{pairs(command.columns), pairs(command.units)};
  std::vector<reaming::Series> all;
  for (const TestSet set : {TestSet::Static, TestSet::Dynamic1, TestSet::Dynamic2}) {
    for (const auto& file : command.files[static_cast<std::size_t>(set)]) {
      all.push_back(reaming::readSeriesFile(file, set, mapping));
      all.back().isSynthetic |= command.isSynthetic;
      sources.push_back(
          {std::filesystem::path(file).filename().string(),
           storage::sha256(reaming::contentOfSeriesFile(file))});
    }
  }
  return all;
}

/// Says where a harder bone would feel softer.
void warnOfCrossings(const reaming::TestSetFit& set) {
  constexpr double kFelt = 1.0;  // [N]
  std::string where;
  for (const auto& crossing : reaming::crossingsOf(set.force, kFelt)) {
    where += fmt::format(
        "{}{:.1f} to {:.1f} mm", where.empty() ? "" : ", ", 1e3 * crossing.from, 1e3 * crossing.to);
  }
  if (where.empty()) return;
  fmt::print(
      "           its curves cross ({}): there a higher hardness feels softer. With --envelope "
      "pointwise they keep their order, and are no specimen's.\n",
      where);
}

void print(const reaming::MaterialFit& fit) {
  for (const auto& series : fit.series) {
    if (!series.exclusion.isExcluded()) continue;
    fmt::print("left out  {} ({}): {}\n", series.name, nameOf(series.set), series.exclusion.words);
  }
  for (const auto& set : fit.sets) {
    const auto& force = set.force;
    fmt::print(
        "{:<10} {:>2} series to {:.2f} mm; nodes {} / {} / {} (minimum, average, maximum); largest "
        "error {:.2g} / {:.2g} / {:.2g} N\n",
        nameOf(set.set),
        set.used,
        1000.0 * set.scale,
        force.minimum.spline.nodes.size(),
        force.average.spline.nodes.size(),
        force.maximum.spline.nodes.size(),
        force.minimum.error.largest,
        force.average.error.largest,
        force.maximum.error.largest);
    warnOfCrossings(set);
  }
}

int fit(FitCommand& command) {
  command.options.cutoffRule = named(command.cutoffRule, kCutoffRules);
  command.options.envelope = named(command.envelope, kEnvelopes);
  command.options.nodes = named(command.nodes, kNodeRules);
  command.options.spline = named(command.spline, kSplines);
  std::vector<protocols::MaterialSource> sources;
  const auto series = readAll(command, sources);
  if (series.empty()) {
    throw UserError("No series were named. Say which test each is of: --dynamic-1 FILE …");
  }
  const bool isSynthetic =
      std::any_of(series.begin(), series.end(), [](const auto& each) { return each.isSynthetic; });
  const auto result = reaming::fitMaterial(series, command.options);
  print(result);
  if (isSynthetic) {
    fmt::print("SYNTHETIC: nobody measured these series, and what comes of them says so.\n");
  }
  if (result.sets.empty()) throw UserError("Every series was left out; there is nothing to fit.");
  if (!command.out.empty()) {
    writeNewFile(
        command.out,
        protocols::materialAsJson(
            command.name, command.title, isSynthetic, result, command.options, sources));
    fmt::print(
        "\n{0} holds the material. Put it beside a protocol and name it there: \"material\": "
        "\"{0}\".\n",
        command.out);
  }
  if (!command.report.empty()) {
    writeDocument(command.report, "material", materialReport(series, result, command.options));
    fmt::print("{}/material.html holds tables and figures.\n", command.report);
  }
  if (command.out.empty() && command.report.empty()) {
    fmt::print("\nNothing was written. Add --out MATERIAL.json, or --report FOLDER.\n");
  }
  return 0;
}

void addFit(CLI::App& noun, Action& action) {
  auto command = std::make_shared<FitCommand>();
  auto* verb = noun.add_subcommand("fit", "Measured series of reaming to a material file");
  verb->add_option("--static", command->files[0], "Series of static tests (CSV or TSV)");
  verb->add_option("--dynamic-1", command->files[1], "Series of the first dynamic tests");
  verb->add_option("--dynamic-2", command->files[2], "Series of the second dynamic tests");
  verb->add_option(
      "--column", command->columns, "WHAT=HEAD where a head does not say it, e.g. force=Kanal2");
  verb->add_option("--unit", command->units, "WHAT=UNIT where a head has none, e.g. force=kN");
  verb->add_option("--out", command->out, "The material file to write; nothing is overwritten");
  verb->add_option("--report", command->report, "A folder for tables, figures and a page");
  verb->add_option("--name", command->name, "Of the material")->capture_default_str();
  verb->add_option("--title", command->title, "For people")->capture_default_str();
  verb->add_option("--cutoff-rule", command->cutoffRule, "How a low-pass finds its cut-off")
      ->check(oneOf(kCutoffRules))
      ->capture_default_str();
  verb->add_option("--cutoff", command->options.cutoff, "The same for all, instead [Hz]")
      ->check(finiteRange(1e-4, 1e4));
  verb->add_option("--envelope", command->envelope, "What minimum and maximum are made of")
      ->check(oneOf(kEnvelopes))
      ->capture_default_str();
  verb->add_option("--nodes", command->nodes, "How nodes are chosen")
      ->check(oneOf(kNodeRules))
      ->capture_default_str();
  verb->add_option("--spline", command->spline, "How slopes at the nodes are come by")
      ->check(oneOf(kSplines))
      ->capture_default_str();
  verb->add_option("--error", command->options.wantedError, "Largest error of the spline, a share")
      ->check(finiteRange(1e-4, 1.0))
      ->capture_default_str();
  verb->add_option(
          "--force-floor", command->options.forceFloor, "Below it errors count as if at it [N]")
      ->check(finiteRange(1e-6, 1e4))
      ->capture_default_str();
  verb->add_flag(
      "--synthetic",
      command->isSynthetic,
      "Nobody measured these series, even if their files do not say so");
  verb->callback([&action, command] { action = [command] { return app::fit(*command); }; });
}

struct SynthesiseCommand {
  std::string folder;
  std::uint64_t seed = 1;
};

int synthesise(const SynthesiseCommand& command) {
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
      "{0} holds 72 series of 24 specimens that nobody measured: synthetic. Fit them with\n"
      "  palpate material fit --static {0}/*static.csv --dynamic-1 {0}/*dynamic-1.csv "
      "--dynamic-2 {0}/*dynamic-2.csv --out MATERIAL.json\n",
      command.folder);
  return 0;
}

void addSynthesise(CLI::App& noun, Action& action) {
  auto command = std::make_shared<SynthesiseCommand>();
  auto* verb = noun.add_subcommand(
      "synthesise", "Series with the published properties, for trying things out: not measured");
  verb->add_option("FOLDER", command->folder, "New, or empty")->required();
  verb->add_option("--seed", command->seed, "The same seed, the same series")
      ->capture_default_str();
  verb->callback([&action, command] { action = [command] { return synthesise(*command); }; });
}

}  // namespace

void addMaterialCommands(CLI::App& program, Action& action) {
  auto* noun = program.add_subcommand("material", "Measured reaming to bone that can be felt");
  noun->require_subcommand(1);
  addFit(*noun, action);
  addSynthesise(*noun, action);
}

}  // namespace study::app
