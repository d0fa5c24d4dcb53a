#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/paint_figures.h"
#include "study/model/new_file.h"
#include "study/report/consent_copy.h"
#include "study/session/unblinding.h"

namespace study::app {
namespace {

struct ConsentArguments {
  std::string folder;
  std::string participant;
  std::string out;
};

int copyConsent(const ConsentArguments& options) {
  auto study = Study::open(options.folder, storage::Database::Access::ReadOnly);
  const auto html = report::consentCopy(study, options.participant, htmlOf);
  const bool isPdf = std::filesystem::path(options.out).extension() == ".pdf";
  const auto page = isPdf ? pdfOf(html, study.protocol().protocol.study.title) : html;
  requireNewFile(options.out);  // the trail never loses a copy that is noted
  const bool isNoted = recordConsentCopy(study, options.participant);
  writeNewFile(options.out, page);
  fmt::print("{} is for {} to keep.\n", options.out, options.participant);
  if (!isNoted) fmt::print("{}\n", kCopyNotNoted);
  return 0;
}

}  // namespace

void addConsentCommand(CLI::App& parentCommand, Action& action) {
  auto [verb, options] = addCommand(
      parentCommand,
      action,
      "consent",
      "Write the participant's copy of the signed consent",
      copyConsent);
  addStudyFolder(*verb, options.folder);
  verb->add_option("--participant", options.participant, "Participant code")
      ->type_name("CODE")
      ->required();
  verb->add_option("--out", options.out, "New file, .html or .pdf")
      ->required()
      ->check(fileEndingIn({".html", ".pdf"}));
}

}  // namespace study::app
