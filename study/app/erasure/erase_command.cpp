// Commands on names of participants and on erasures.
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/file.h"
#include "study/app/command_options.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/app/paint_figures.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/report/erasure_certificate.h"
#include "study/session/study_key.h"
#include "study/session/unblinding.h"
#include "study/storage/erasure/erasure_list.h"
#include "study/words/words.h"

namespace study::app {
namespace {

struct ErasureArguments {
  std::string folder;
  std::string level = "all";
  ErasureRequest request;
  std::vector<std::string> otherCopies;
  std::vector<std::string> certificates;
  std::string certificateToRepeat;
  bool setsPassphrase = false;
  std::string language = "en";  ///< language of certificates
};

void write(
    const report::ErasureCertificate& certificate,
    const words::Words& words,
    const std::string& path) {
  const auto extension = std::filesystem::path(path).extension();
  if (extension == ".pdf") {
    writeNewFile(path, pdfOf(asHtml(certificate, words), certificate.title));
  } else {
    writeNewFile(
        path, extension == ".html" ? asHtml(certificate, words) : asText(certificate, words));
  }
}

/// Repeats the erasures that a certificate lists in another copy of the study.
int repeatErasures(const ErasureArguments& options) {
  const auto erasures =
      report::erasuresIn(base::readFile(options.certificateToRepeat).value_or(""));
  if (erasures.empty()) {
    throw UserError(
        options.certificateToRepeat +
        " is not the text of a certificate of erasure. 'palpate study erase "
        "--certificate FILE.txt' writes it.");
  }
  // opening a copy of the study repeats the erasures of this station's list
  for (const auto& erasure : erasures) storage::addListedErasure(erasure);
  auto study = Study::open(options.folder);
  bool isOfThisStudy = false;
  for (const auto& erasure : erasures) {
    if (erasure.study != study.uuid()) continue;
    isOfThisStudy = true;
    const bool isThere = study.sessions().enrolledUtc(erasure.participant) == erasure.enrolledUtc;
    if (isThere) {
      fmt::print("{} is erased from {}.\n", erasure.participant, options.folder);
      for (const auto& copy : copiesNotErased(study, {}, erasure.participant)) {
        if (!copy.isPresent || copy.folder.empty()) continue;
        fmt::print("Copy that is left, and may have the participant: {}\n", copy.folder);
      }
    } else {
      fmt::print(
          "{} does not have the participant {} of the certificate. Nothing was changed.\n",
          options.folder,
          erasure.participant);
    }
  }
  if (!isOfThisStudy)
    throw UserError(options.certificateToRepeat + " is of another study. Nothing was changed.");
  return 0;
}

int erase(ErasureArguments options) {
  if (!options.certificateToRepeat.empty()) return repeatErasures(options);
  if (options.request.participant.empty()) {
    throw UserError("Say who: --participant P001. 'palpate study names' finds the code.");
  }
  options.request.level = storage::erasureLevelNamed(options.level).value();
  SystemClock clock;
  auto study = Study::open(options.folder, clock);
  askForNamesIfLocked(study, true);
  report::ErasureCertificate certificate{.title = study.protocol().protocol.study.title};
  certificate.report = study::erase(study, options.request);
  const auto known = knownCopies(study);
  for (const auto& folder : options.otherCopies) {
    certificate.copies.push_back(
        eraseFromCopy(folder, certificate.report.listed, certificate.report.texts, clock, known));
  }
  certificate.notErasedFrom =
      copiesNotErased(study, certificate.copies, certificate.report.erasure.participant);
  if (certificate.report.wasTrailResealed) {
    fmt::print("The audit trail was sealed again; 'palpate study verify' says so from now on.\n");
  }
  fmt::print("{}", asText(certificate));
  if (!certificate.isClean()) {
    fmt::print(
        "\nSomething is left. Delete the files in which a text was found, or export them again (in "
        "a "
        "database, another participant wrote the same), and try again what was not erased.\n");
  }
  const auto words = words::wordsIn(options.language);
  for (const auto& path : options.certificates) write(certificate, words, path);
  return certificate.isClean() ? 0 : 1;
}

int setPassphrase(const ErasureArguments& options) {
  auto study = Study::open(options.folder);
  askForNamesIfLocked(study);
  setPassphraseOfNames(study, askNewPassphrase(kAskNewNamesPassphrase), options.request.reason);
  fmt::print(
      "Names in {} are behind the passphrase, and in copies that are made from now on. Sessions "
      "ask "
      "for it. It cannot be recovered.\n",
      options.folder);
  return 0;
}

int names(const ErasureArguments& options) {
  if (options.setsPassphrase) return setPassphrase(options);
  auto study = Study::open(options.folder, storage::Database::Access::ReadOnly);
  askForNamesIfLocked(study);
  const auto names = study.identities().names();
  const bool isNoted = recordNamesShown(study, names.size());
  for (const auto& name : names) {
    fmt::print("{:<12} {:<20} {}\n", name.participant, name.item, name.text);
  }
  if (names.empty()) fmt::print("This study keeps no names.\n");
  if (!isNoted) fmt::print("{}\n", kNamesNotNoted);
  return 0;
}

}  // namespace

void addErasureCommands(CLI::App& parentCommand, Action& action) {
  auto [erase, erasure] = addCommand(
      parentCommand,
      action,
      "erase",
      "Erase a participant: names, answers and traces; the audit trail stays valid",
      app::erase);
  addStudyFolder(*erase, erasure.folder);
  auto* participant =
      erase->add_option("--participant", erasure.request.participant, "Participant code")
          ->type_name("CODE");
  auto* level = erase
                    ->add_option(
                        "--level",
                        erasure.level,
                        "Data to erase: identity (names, signatures), answers (with votes, texts "
                        "and traces), or "
                        "all")
                    ->check(CLI::IsMember({"identity", "answers", "all"}))
                    ->capture_default_str();
  auto* reason = erase->add_option(
      "--reason", erasure.request.reason, "Reason, without a name: it stays in the audit trail");
  auto* reseal = erase->add_flag(
      "--reseal",
      erasure.request.resealsTrail,
      "Before erasing, encrypt an audit trail that an older release wrote (once per study)");
  auto* also =
      erase
          ->add_option(
              "--also",
              erasure.otherCopies,
              "Other copy of the data: a backup to erase from, or an export or a report to delete; "
              "repeatable")
          ->type_name("PATH");
  auto* certificate = erase
                          ->add_option(
                              "--certificate",
                              erasure.certificates,
                              "New file for a certificate: .txt, .html or .pdf; repeatable")
                          ->check(fileEndingIn({".txt", ".html", ".pdf"}));
  erase->add_option("--language", erasure.language, "Language of certificates")
      ->check(CLI::IsMember(words::languages()))
      ->capture_default_str();
  auto* certificateToRepeat =
      erase
          ->add_option(
              "--by",
              erasure.certificateToRepeat,
              "Repeat an erasure that was done in another copy; FILE is its certificate (.txt)")
          ->type_name("FILE");
  // A certificate says what is erased, from whom and why.
  for (auto* option : {participant, level, reason, reseal, also, certificate})
    certificateToRepeat->excludes(option);

  auto [names, naming] = addCommand(
      parentCommand,
      action,
      "names",
      "List names by participant code (recorded in the audit trail)",
      app::names);
  addStudyFolder(*names, naming.folder);
  auto* sets = names->add_flag(
      "--set-passphrase",
      naming.setsPassphrase,
      "Protect names with a passphrase, or change it; names cannot be read without it");
  addAuditedReason(*names, naming.request.reason)->needs(sets);
}

}  // namespace study::app
