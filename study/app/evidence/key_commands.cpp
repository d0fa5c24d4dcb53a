// Commands about the key with which conditions are sealed.
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "study/app/commands.h"
#include "study/app/keys/ask_passphrase.h"
#include "study/model/user_error.h"
#include "study/session/study_key.h"

namespace study::app {
namespace {

struct KeyArguments {
  std::string folder;
  std::string file;
  std::string reason;
};

int exportTo(const KeyArguments& options) {
  SystemClock clock;
  auto study = Study::open(options.folder, clock);
  unlockIfAsked(study);
  exportKey(study, options.file, options.reason);
  fmt::print(
      "{} has the key of {}. Who has this file and the study can say which condition each "
      "alternative was: hand it over in person, and keep a copy apart from the study.\n",
      options.file,
      options.folder);
  return 0;
}

int import(const KeyArguments& options) {
  SystemClock clock;
  auto study = Study::open(options.folder, clock);
  if (!options.file.empty()) {
    importKey(study, options.file);
  } else {
    unlockIfAsked(study);
    keepOpenedKey(study);
  }
  fmt::print("This account has the key of {} now.\n", options.folder);
  return 0;
}

int passphrase(const KeyArguments& options) {
  SystemClock clock;
  auto study = Study::open(options.folder, clock);
  unlockIfAsked(study);
  setPassphrase(study, askNewPassphrase("New passphrase of the study"), options.reason);
  fmt::print(
      "The passphrase opens the key of {}, and of copies that are made from now on. Write it down "
      "at a safe place: nobody can find it out.\n",
      options.folder);
  return 0;
}

int drop(const KeyArguments& options) {
  SystemClock clock;
  auto study = Study::open(options.folder, clock);
  dropKey(study, options.reason);
  fmt::print("This account has the key of {} no more.\n", options.folder);
  return 0;
}

CLI::App* addVerb(
    CLI::App& noun,
    const char* name,
    const char* help,
    const std::shared_ptr<KeyArguments>& options,
    Action& action,
    int (*perform)(const KeyArguments&)) {
  auto* verb = noun.add_subcommand(name, help);
  verb->add_option("DIR", options->folder, "The study's folder")->required();
  verb->callback(
      [&action, options, perform] { action = [options, perform] { return perform(*options); }; });
  return verb;
}

void addReason(CLI::App& verb, const std::shared_ptr<KeyArguments>& options) {
  verb.add_option("--reason", options->reason, "Why; goes into the audit trail")->required();
}

}  // namespace

void addKeyCommands(CLI::App& study, Action& action) {
  auto* noun = study.add_subcommand("key", "The key with which conditions are sealed");
  noun->require_subcommand(1);
  auto options = std::make_shared<KeyArguments>();
  auto* out = addVerb(
      *noun, "export", "Write the key to a file, to hand it over", options, action, exportTo);
  out->add_option("--out", options->file, "New file; nothing is overwritten")->required();
  addReason(*out, options);
  auto* in = addVerb(
      *noun, "import", "Let this account keep a key that was handed over", options, action, import);
  in->add_option("FILE", options->file, "The key's file (default: asks for the passphrase)");
  auto* words = addVerb(
      *noun, "passphrase", "Set a passphrase that opens the key", options, action, passphrase);
  addReason(*words, options);
  auto* gone = addVerb(
      *noun,
      "drop",
      "Take the key from this account, once it was exported or has a passphrase",
      options,
      action,
      drop);
  addReason(*gone, options);
}

}  // namespace study::app
