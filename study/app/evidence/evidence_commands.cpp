// Commands that prove that a study's data are the recorded ones.
#include <cstdio>
#include <string>
#include <variant>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/evidence/time_stamps.h"
#include "study/app/json_file.h"
#include "study/session/backup.h"
#include "study/session/unblinding.h"
#include "study/session/verification.h"
#include "study/storage/evidence/witness_file.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

using Access = storage::Database::Access;

struct EvidenceArguments {
  std::string folder;
  std::string out;
  std::string reason;
  std::string expectedHead;
  std::string witness;
  std::string newWitness;
  std::string certificate;
  bool isOlderCopy = false;
  bool json = false;
};

void printChecks(const Verification& verification) {
  for (const auto& check : verification.checks) {
    fmt::print("{}  {}\n", check.problems.empty() ? "ok  " : "FAIL", check.what);
    for (const auto& problem : check.problems) fmt::print("      {}\n", problem);
    for (const auto& remark : check.remarks) fmt::print("      ({})\n", remark);
  }
}

void printHead(const Verification& verification) {
  fmt::print("Head of the audit trail: {}\n", verification.head);
}

/// Writes a witness file if one was requested.
void writeWitness(Study& study, const EvidenceArguments& options) {
  if (options.newWitness.empty()) return;
  storage::writeWitness(study.database(), options.newWitness, asUtc(study.clock().now().wall));
  if (!options.json) fmt::print("{} has its signed heads.\n", options.newWitness);
}

int backup(const EvidenceArguments& options) {
  const auto copy = backUp(options.folder, options.out);
  fmt::print(
      "Copy saved: {} ({}, {:.1f} MB).\n",
      options.out,
      options.folder,
      1e-6 * static_cast<double>(copy.bytes));
  if (!copy.isNoted) fmt::print("{}\n", kCopyNotNoted);
  if (copy.verification.isSound()) {
    fmt::print("It was read again to the last byte: everything is what was written.\n");
    printHead(copy.verification);
    auto study = Study::open(options.folder, Access::ReadOnly);
    writeWitness(study, options);
    return 0;
  }
  fmt::print("It is NOT sound, and so is the study that it was made of:\n");
  printChecks(copy.verification);
  return 1;
}

int verify(const EvidenceArguments& options) {
  auto study = Study::open(options.folder, Access::ReadOnly);
  auto verification = study::verify(
      study,
      {},
      {.notedHead = options.expectedHead,
       .witness = options.witness,
       .isOlderCopy = options.isOlderCopy});
  checkTimeStamps(study, options.certificate, verification);
  if (options.json) {
    std::fputs(verificationAsJson(verification).c_str(), stdout);
  } else {
    printChecks(verification);
    if (verification.isSound()) printHead(verification);
  }
  if (verification.isSound()) writeWitness(study, options);
  return verification.isSound() ? 0 : 1;
}

int restored(const EvidenceArguments& options) {
  auto study = Study::open(options.folder);
  const auto givenUp = recordRestoredCopy(study, options.reason);
  if (givenUp == 0) {
    fmt::print("This study has all that this station signed: there is nothing to note.\n");
    return 0;
  }
  fmt::print(
      "Noted: {} is right, and {} that this station signed of another copy {} given up.\n",
      options.folder,
      words::counted(givenUp, "head", "heads"),
      givenUp == 1 ? "is" : "are");
  return 0;
}

std::string detailOf(const storage::Event& event) {
  static const std::string kCommitment = "commitment";
  std::string words = event.detail;
  for (const auto& [name, value] : event.values) {
    const auto text =
        std::visit([](const auto& stored) { return fmt::format("{}", stored); }, value);
    // The event that a study was made has the commitment under another name.
    const auto& label = name == "secret" ? kCommitment : name;
    if (!text.empty()) words += (words.empty() ? "" : ", ") + label + ": " + text;
  }
  return words;
}

int listTrail(const EvidenceArguments& options) {
  auto study = Study::open(options.folder, Access::ReadOnly);
  for (const auto& event : study.events().read()) {
    if (event.visit) continue;  // what happened in a session is in an export's events.csv
    fmt::print(
        "{}  {}  {:<18} {}\n",
        asUtc(event.when.wall),
        nameOf(event.actor),
        event.name(),
        detailOf(event));
  }
  return 0;
}

void addNewWitness(CLI::App& verb, EvidenceArguments& options) {
  verb.add_option(
          "--write-witness",
          options.newWitness,
          "New file that later proves, with 'study verify --witness', that nothing was changed; "
          "keep it out of operators' reach")
      ->type_name("FILE");
}

void addTimeStampCommand(CLI::App& parentCommand, Action& action) {
  auto [verb, options] = addCommand(
      parentCommand,
      action,
      "timestamp",
      "Have an outside authority certify when the audit trail existed (RFC 3161), online or by "
      "files",
      requestTimeStamp);
  addStudyFolder(*verb, options.folder);
  verb->add_option(
          "--authority",
          options.authority,
          "Online: web address (URL) of the authority; it receives only a fingerprint (hash), no "
          "data")
      ->type_name("URL");
  verb->add_option(
          "--request",
          options.request,
          "By files: write the request to a new file, to be sent from another computer")
      ->type_name("FILE");
  verb->add_option(
          "--reply",
          options.reply,
          "By files: store the authority's reply to a request, from this file")
      ->check(CLI::ExistingFile);
  verb->add_option(
          "--authority-certificate",
          options.certificate,
          "Certificate file (.pem) that the authority publishes, to check its time stamps; not "
          "needed with --request")
      ->type_name("FILE");
}

}  // namespace

void addEvidenceCommands(CLI::App& parentCommand, Action& action) {
  auto [backup, copying] = addCommand(
      parentCommand,
      action,
      "backup",
      "Back up a study, also during sessions, and verify the copy",
      app::backup);
  addStudyFolder(*backup, copying.folder);
  backup->add_option("--out", copying.out, "New folder for the copy")
      ->type_name("FOLDER")
      ->required();
  addNewWitness(*backup, copying);

  auto [trail, listing] = addCommand(
      parentCommand,
      action,
      "trail",
      "List the audit trail of the study itself: exports, keys, erasures, … with who, when and why",
      listTrail);
  addStudyFolder(*trail, listing.folder);

  auto [verify, verifying] = addCommand(
      parentCommand,
      action,
      "verify",
      "Check that no stored data was changed, lost or damaged",
      app::verify);
  addStudyFolder(*verify, verifying.folder);
  verify->add_flag("--json", verifying.json, "Print JSON");
  verify->add_option(
      "--expect",
      verifying.expectedHead,
      "Code (head of the audit trail) that an earlier 'study verify' printed: fails if the trail "
      "no longer contains it");
  verify
      ->add_option(
          "--witness",
          verifying.witness,
          "Witness file from an earlier --write-witness: fails if the study does not match it")
      ->type_name("FILE");
  addNewWitness(*verify, verifying);
  verify
      ->add_option(
          "--authority-certificate",
          verifying.certificate,
          "Certificate file (.pem) that the time-stamping authority publishes, to check its time "
          "stamps")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  verify->add_flag(
      "--older-copy",
      verifying.isOlderCopy,
      "The folder is an older backup: events that this computer signed later may be missing");

  addTimeStampCommand(parentCommand, action);

  auto [restored, noting] = addCommand(
      parentCommand,
      action,
      "restored",
      "Record that this folder was replaced on purpose by another copy, so that 'verify' accepts "
      "it",
      app::restored);
  addStudyFolder(*restored, noting.folder);
  restored
      ->add_option(
          "--reason", noting.reason, "Reason for doing so; it is recorded in the audit trail")
      ->required();
}

}  // namespace study::app
