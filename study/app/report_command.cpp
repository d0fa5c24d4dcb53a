#include <filesystem>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/app/paint_figures.h"
#include "study/app/write_report.h"
#include "study/model/new_file.h"
#include "study/session/unblinding.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

struct ReportArguments {
  std::vector<std::string> folders;
  std::string out;
  std::string figures;
  double figureWidth = 0.0;  ///< [mm]; 0: the width in the report
  double figureFont = report::FigureFormat::kUsualFont;
  std::string language = "en";
  std::string paper = "a4";
  std::string wording = "apa";
  bool hasQuotes = true;
  std::string runMode;
  std::string reason;
};

/// Writes each figure as a file to a new folder. Those of another study of the same protocol are in
/// a folder "study-2" in it, or of another number.
void writeFigureFolder(
    std::vector<report::ReportSection>& sections,
    const std::string& folder,
    const report::FigureFormat& format) {
  std::set<std::string> protocols;  // whose figures are named by them
  int count = 0;
  for (std::size_t i = 0; i < sections.size(); ++i) {
    const bool isFirst = protocols.insert(sections[i].protocol.study.id).second;
    const auto place = isFirst ? folder : fmt::format("{}/study-{}", folder, i + 1);
    std::filesystem::create_directories(place);
    count += writeFigures(sections[i], place, format);
  }
  if (count == 0) {
    throw std::runtime_error("There are no figures: this palpate was built without Qt.");
  }
  fmt::print(
      "Figures saved: {} ({}, each as SVG, PDF and PNG at 300 dpi).\n",
      folder,
      words::counted(static_cast<std::uint64_t>(count), "figure"));
}

report::FigureFormat formatOf(const ReportArguments& options) {
  report::FigureFormat format{.width = {}, .font = options.figureFont};
  if (options.figureWidth > 0.0) format.width = options.figureWidth;
  return format;
}

int report(const ReportArguments& options) {
  if (!options.figures.empty() && std::filesystem::exists(options.figures)) {
    throw std::runtime_error(
        options.figures + " is there already. Nothing is overwritten: choose another folder.");
  }
  std::vector<std::pair<Study, RunMode>> studies;
  std::vector<report::ReportSection> sections;
  bool isNoted = true;
  for (const auto& folder : options.folders) {
    auto study = Study::open(folder, accessForUnblinding(options.reason));
    askForKeyIfLocked(study);
    const auto mode = chosenRunMode(study, options.runMode);
    recordUnblinding(study, mode, EventKind::UnblindedReport, options.reason);
    if (!options.figures.empty()) {
      isNoted = recordReportPath(study, mode, "figures", options.figures) && isNoted;
    }
    sections.push_back(report::gather(study, mode, words::wordsIn(options.language)));
    sections.back().hasQuotes = options.hasQuotes;
    sections.back().wording = wordingNamed(options.wording);
    studies.emplace_back(std::move(study), mode);
  }
  const auto paper = options.paper == "letter" ? report::Paper::Letter : report::Paper::A4;
  const auto page = reportFileContent(options.out, sections, paper);
  for (auto& [study, mode] : studies) {
    isNoted = recordReportPath(study, mode, "report", options.out, page) && isNoted;
  }
  writeNewFile(options.out, page);
  fmt::print("Report saved: {}\n", options.out);
  if (!isNoted) fmt::print("{}\n", kCopyNotNoted);
  if (!options.figures.empty()) writeFigureFolder(sections, options.figures, formatOf(options));
  return 0;
}

}  // namespace

void addReportCommand(CLI::App& program, Action& action) {
  auto [command, options] = addCommand(
      program,
      action,
      "report",
      "Write a results section as one HTML page or PDF: tables, figures, rendered forces",
      app::report);
  command->add_option("FOLDER", options.folders, "Folders of one or more studies")->required();
  command->add_option("--out", options.out, "New file, .html or .pdf")
      ->required()
      ->check(fileEndingIn({".html", ".pdf"}));
  auto* figures = command
                      ->add_option(
                          "--figures",
                          options.figures,
                          "New folder in which every figure is saved as SVG, PDF and PNG")
                      ->type_name("FOLDER");
  command
      ->add_option(
          "--figure-width",
          options.figureWidth,
          "Width of the figures [mm], as the journal asks: 85 for one column, 180 for two")
      ->check(finiteRange(60.0, 400.0))
      ->needs(figures);
  command->add_option("--figure-font", options.figureFont, "Font size in the figures [pt]")
      ->check(finiteRange(5.0, 14.0))
      ->needs(figures)
      ->capture_default_str();
  command->add_option("--language", options.language, "Language of the report")
      ->capture_default_str()
      ->check(CLI::IsMember(words::languages()));
  command->add_option("--paper", options.paper, "Size of the pages of a PDF")
      ->capture_default_str()
      ->check(CLI::IsMember({"a4", "letter"}));
  addWordingOption(*command, options.wording);
  command->add_flag_callback(
      "--no-quotes",
      [&hasQuotes = options.hasQuotes] { hasQuotes = false; },
      "Leave out what participants wrote, to publish the report");
  addRunModeOption(*command, options.runMode);
  addReasonOption(*command, options.reason);
}

}  // namespace study::app
