// Commands on the key with which conditions are sealed.
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/command_options.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/session/study_key.h"

namespace study::app {
namespace {

struct KeyArguments {
  std::string folder;
  std::string file;
  std::string reason;
};

int exportTo(const KeyArguments& options) {
  auto study = Study::open(options.folder);
  askForKeyIfLocked(study);
  exportKey(study, options.file, options.reason);
  fmt::print(
      "{} has the key of {}. Who has this file and the study can say which condition each "
      "alternative was: hand it over in person, and keep a copy apart from the study.\n",
      options.file,
      options.folder);
  return 0;
}

int import(const KeyArguments& options) {
  auto study = Study::open(options.folder);
  if (!options.file.empty()) {
    importKey(study, options.file);
  } else {
    askForKeyIfLocked(study);
    storeOpenedKey(study);
  }
  fmt::print("This account has the key of {} now.\n", options.folder);
  return 0;
}

int passphrase(const KeyArguments& options) {
  auto study = Study::open(options.folder);
  askForKeyIfLocked(study);
  setPassphrase(study, askNewPassphrase("New passphrase of the study"), options.reason);
  fmt::print(
      "The passphrase opens the key of {}, and of copies that are made from now on. Write it down "
      "at a safe place: it cannot be recovered.\n",
      options.folder);
  return 0;
}

int removeKey(const KeyArguments& options) {
  auto study = Study::open(options.folder);
  dropKey(study, options.reason);
  fmt::print("This account no longer has the key of {}.\n", options.folder);
  return 0;
}

}  // namespace

void addKeyCommands(CLI::App& study, Action& action) {
  auto& parentCommand = addCommandGroup(
      study,
      "key",
      "Manage the study's key (blinding key), which encrypts what each alternative is");
  const auto add = [&](const char* name, const char* help, int (*perform)(const KeyArguments&)) {
    auto added = addCommand(parentCommand, action, name, help, perform);
    addStudyFolder(*added.command, added.options.folder);
    return added;
  };
  auto [out, exporting] = add("export", "Write the key to a file, to hand it over", exportTo);
  out->add_option("--out", exporting.file, "New file for the key")->type_name("FILE")->required();
  addAuditedReason(*out, exporting.reason)->required();
  auto [in, importing] =
      add("import",
          "Store, in your account on this computer, a key that another person handed over",
          import);
  in->add_option(
      "FILE",
      importing.file,
      "File from 'key export' (default: asks for the passphrase that opens the key)");
  auto [words, setting] = add("passphrase", "Set a passphrase that opens the key", passphrase);
  addAuditedReason(*words, setting.reason)->required();
  auto [gone, dropping] =
      add("drop",
          "Remove the key from your account on this computer, once it has been exported or has a "
          "passphrase",
          removeKey);
  addAuditedReason(*gone, dropping.reason)->required();
}

}  // namespace study::app
