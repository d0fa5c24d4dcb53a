// Commands that say what is stored: of one person, and of a study whose data are to be deleted.
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/search.h"
#include "study/app/command_options.h"
#include "study/app/erasure/person_page.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/report/erasure_certificate.h"
#include "study/session/arrivals.h"
#include "study/session/unblinding.h"
#include "study/storage/station_store.h"

namespace study::app {
namespace {

using Access = storage::Database::Access;

struct PersonArguments {
  std::string folder;
  std::string participant;
  std::string out;
  std::string reason;
  bool unblind = false;
};

RunMode runModeOf(Study& study, const std::string& participant) {
  const auto sessions = study.sessions().all();
  const auto theirs = std::ranges::find(sessions, participant, &storage::SessionRow::participant);
  if (theirs == sessions.end()) {
    throw UserError(
        "There is no participant '" + participant +
        "' in this study. 'palpate study status' lists the codes.");
  }
  return theirs->runMode;
}

int writePerson(const PersonArguments& options) {
  ExportOptions exported{
      .isBlinded = !options.unblind,
      .hasTraces = options.unblind,
      .isExact = true,
      .hasTexts = true,
      .participant = options.participant};
  {
    auto study = Study::open(options.folder, Access::ReadOnly);
    exported.runMode = runModeOf(study, options.participant);
  }
  auto study = openForExport(options.folder, exported);
  askForKeyIfLocked(study);
  askForNamesIfLocked(study, true);
  const auto page = personPage(study, exported);
  const auto written = exportStudy(study, options.out, exported, options.reason);
  writeNewFile((std::filesystem::path(options.out) / "person.html").string(), page);
  fmt::print(
      "What is stored about {} is in {}: read person.html first. It may have the name.\n",
      options.participant,
      options.out);
  if (!options.unblind) {
    fmt::print(
        "What was felt and measured is left out, because it tells which condition was which: "
        "--unblind --reason \"…\" adds it.\n");
  }
  if (!written.isNoted) fmt::print("{}\n", kCopyNotNoted);
  return 0;
}

struct RetentionArguments {
  std::string folder;
};

void printTask(const std::string& what, const std::string& toDo) {
  fmt::print("\n{}\n  {}\n", what, toDo);
}

/// What participants were promised, in the words that the laboratory filled in.
void printPromises(Study& study) {
  constexpr std::array kPromises{"delete_until", "names_destroyed", "data_kept_years"};
  for (const auto& blank : protocols::blanksOf(study.protocol())) {
    if (std::ranges::find(kPromises, blank.key) == kPromises.end()) continue;
    const auto text = blank.text.in("en");
    fmt::print("{}: {}\n", base::describe(blank.title), text.empty() ? "not filled in" : text);
  }
}

void printKeys(Study& study) {
  if (study.isSealed()) {
    printTask(
        "The study's key, in " + storage::StationStore::defaultFolder().string(),
        study.hasKey() ? "once no copy of the study is needed, delete the line that ends with its "
                         "folder from the file study-keys"
                       : "this account does not have it");
  }
  for (const auto& event : study.events().read(EventKind::ExportedKey)) {
    printTask(
        "The study's key, in a file, of " + asUtc(event.when.wall) + ": " + event.detail,
        "delete the file, also where it was handed to; where it was saved is not noted");
  }
  if (study.hasPassphrase() || study.identities().hasPassphrase()) {
    printTask("Passphrases that were written down", "destroy them");
  }
}

void printCopies(Study& study) {
  for (const auto& copy : knownCopies(study)) {
    printTask(copy.what + ": " + report::inWords(copy), "delete it, and what was made of it");
  }
  for (const auto& event : study.events().read(EventKind::CopiedConsent)) {
    printTask(
        "copied_consent: " + storage::describe(event) + ", of " + asUtc(event.when.wall),
        "delete the file; where it was saved is not noted");
  }
  const auto& station = study.station();
  if (station.isNone() && !study.isCollected()) return;
  const auto pushed = lastPush(study.uuid(), station.uuid);
  printTask(
      "The study's server, and its backups" +
          (pushed.utc.empty() ? std::string() : ", last pushed to on " + pushed.utc),
      "its administrator drops the database; each other station deletes its folder and key");
}

int listRetention(const RetentionArguments& options) {
  auto study = Study::open(options.folder, Access::ReadOnly);
  fmt::print("{}, made {}\n", study.protocol().protocol.study.title, study.createdUtc());
  printPromises(study);
  const auto sessions = study.sessions().all();
  const auto last = std::ranges::max_element(sessions, {}, &storage::SessionRow::startedUtc);
  if (last != sessions.end()) fmt::print("last session began {}\n", last->startedUtc);
  printTask(
      "The study's folder, " + std::filesystem::absolute(study.folder()).string(),
      "names alone: palpate study erase --level identity, for each participant; all: delete the "
      "folder, last");
  printKeys(study);
  printCopies(study);
  printTask(
      "What this study did not note",
      "copies made by hand, moved files, mails, printed pages, signed forms on paper: look for "
      "them");
  fmt::print("\nNothing was deleted.\n");
  return 0;
}

}  // namespace

void addPersonCommands(CLI::App& parentCommand, Action& action) {
  auto [person, options] = addCommand(
      parentCommand,
      action,
      "person",
      "Write all that is stored about one participant, for them to keep (right of access)",
      writePerson);
  addStudyFolder(*person, options.folder);
  person->add_option("--participant", options.participant, "Participant code")
      ->type_name("CODE")
      ->required();
  person->add_option("--out", options.out, "New folder for a page and tables")
      ->type_name("FOLDER")
      ->required();
  auto* unblind = person->add_flag(
      "--unblind",
      options.unblind,
      "Also what was felt and measured, with the samples; names each alternative's condition");
  unblind->needs(person->add_option(
      "--reason", options.reason, "Reason for unblinding; recorded in the audit trail"));

  auto [retention, listing] = addCommand(
      parentCommand,
      action,
      "retention",
      "List what is to be deleted, and where, when the data are no longer kept; deletes nothing",
      listRetention);
  addStudyFolder(*retention, listing.folder);
}

}  // namespace study::app
