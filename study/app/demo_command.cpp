#include <filesystem>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "haptics/recordings/recording.h"
#include "protocols/load_protocol.h"
#include "study/app/command_options.h"
#include "study/app/write_report.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/export.h"
#include "study/model/new_file.h"
#include "study/session/import_recording.h"
#include "study/session/verification.h"

namespace study::app {
namespace {

namespace fs = std::filesystem;

struct DemoArguments {
  std::string out = "palpate-demo";
  std::uint64_t seed = 20221212;
  std::string recording;
};

/// The protocol of the punch paper's study, with the cut of a real recording if one is given.
std::string punchProtocol(const DemoArguments& options, const fs::path& folder) {
  const std::string path = (folder / "punch-face-validity.json").string();
  std::string text(protocols::libraryProtocol("punch-face-validity").value());
  if (!options.recording.empty()) {
    const auto recording = haptics::recordings::readRecordingFile(options.recording);
    const auto imported = importPublishedCut(recording);
    writeNewFile(
        (folder / "recorded-cut.json").string(),
        cutAsJsonWithSource(options.recording, imported.cut));
    fmt::print("Cut from {}: {}\n", recording.source, describe(imported.report.reason));
    for (const auto& change : imported.report.changes) fmt::print("  {}\n", describe(change));
    text = withRecordedCut(std::move(text), "recorded-cut.json");
  }
  writeNewFile(path, text);
  return path;
}

report::ReportSection runStudy(
    const std::string& protocolFile,
    const fs::path& folder,
    const std::string& name,
    std::uint64_t seed) {
  questionnaires::Problems problems;
  const auto protocol = protocols::loadProtocolFile(protocolFile, problems);
  if (!protocol) throw base::UserError(questionnaires::describe(problems.all()));
  SimulatedClock clock;
  auto study = Study::create(folder / name, *protocol, clock, seed);
  const int participants = plannedParticipants(protocol->protocol);
  fmt::print("{}: {} simulated participants …\n", protocol->protocol.study.title, participants);
  simulateCohorts(study, clock, participants, seed, [](const auto&) {});
  if (!verify(study).isSound()) throw std::logic_error("the demo's own study does not verify");
  exportStudy(
      study,
      (folder / ("export-" + name)).string(),
      {.format = ExportFormat::Csv, .runMode = RunMode::Simulated});
  return report::gather(study, RunMode::Simulated);
}

int demo(const DemoArguments& options) {
  const fs::path folder(options.out);
  std::error_code error;
  if (fs::exists(folder, error) || !fs::create_directories(folder, error)) {
    throw storage::StorageError(
        options.out + (fs::exists(folder) ? " is there already. Choose another folder with --out."
                                          : " cannot be made. Choose another folder with --out."));
  }
  std::vector<report::ReportSection> sections;
  sections.push_back(runStudy(punchProtocol(options, folder), folder, "punch-study", options.seed));
  const std::string reaming = (folder / "reaming-hardness.json").string();
  writeNewFile(reaming, std::string(protocols::libraryProtocol("reaming-hardness").value()));
  sections.push_back(runStudy(reaming, folder, "reaming-study", options.seed));
  const auto page = (folder / "report.html").string();
  writeNewFile(page, reportFileContent(page, sections));
  const std::string place = fs::absolute(folder).lexically_normal().string();
  fmt::print(
      "\nReport:   {0}/report.html\nExports:  {0}/export-punch-study, {0}/export-reaming-study\n"
      "Studies:  {0}/punch-study, {0}/reaming-study\n",
      place);
  return 0;
}

}  // namespace

void addDemoCommand(CLI::App& program, Action& action) {
  auto [command, options] = addCommand(
      program,
      action,
      "demo",
      "Run the two published studies with simulated participants; write a report and exports",
      app::demo);
  command
      ->add_option("--out", options.out, "New folder for the studies, the report and the exports")
      ->type_name("FOLDER")
      ->capture_default_str();
  command
      ->add_option(
          "--seed",
          options.seed,
          "Random seed; the same seed gives identical exports, but not databases")
      ->capture_default_str();
  command
      ->add_option(
          "--recording",
          options.recording,
          "Recording (text) of a real punch; its cut replaces the built-in synthetic one")
      ->type_name("FILE");
}

}  // namespace study::app
