#include "study/app/keys/ask_passphrase.h"

#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <functional>
#include <iostream>

#include <fmt/format.h>

#include "study/model/user_error.h"
#include "study/session/study_key.h"

namespace study::app {
namespace {

/// Switches the terminal's echo off while the object exists.
class WithoutEcho {
 public:
  WithoutEcho() : isTerminal_(tcgetattr(STDIN_FILENO, &settingsBefore_) == 0) {
    if (!isTerminal_) return;
    termios silent = settingsBefore_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    silent.c_lflag |= ECHONL;
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  ~WithoutEcho() {
    if (isTerminal_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &settingsBefore_);
  }
  WithoutEcho(const WithoutEcho&) = delete;
  WithoutEcho& operator=(const WithoutEcho&) = delete;

 private:
  termios settingsBefore_{};
  bool isTerminal_;
};

/// Prints @p question and reads a line without echo; empty if nothing was typed.
std::string typedAnswer(const std::string& question) {
  fmt::print(stderr, "{}: ", question);
  std::fflush(stderr);
  const WithoutEcho quiet;
  std::string typed;
  std::getline(std::cin, typed);
  return typed;
}

/// Asks up to three times for a passphrase, until @p opens returns true. @return  false if nothing
/// was typed
bool unlock(const std::string& question, const std::function<bool(const std::string&)>& opens) {
  constexpr int kTries = 3;
  for (int i = 0; i < kTries; ++i) {
    const auto typed = typedAnswer(question);
    if (typed.empty()) return false;
    if (opens(typed)) return true;
    fmt::print(stderr, "This is not the passphrase.\n");
  }
  throw UserError("The passphrase was wrong three times. Nothing was changed.");
}

void requireTyped(bool isTyped) {
  if (!isTyped) throw UserError("No passphrase was typed. Nothing was changed.");
}

}  // namespace

std::string askPassphrase(const std::string& question) {
  auto typed = typedAnswer(question);
  requireTyped(!typed.empty());
  return typed;
}

std::string askNewPassphrase(const std::string& question) {
  auto typed = askPassphrase(question);
  requireLongPassphrase(typed);
  if (askPassphrase("The same again") != typed) {
    throw UserError("The second was another one. Nothing was changed.");
  }
  return typed;
}

void askForKeyIfLocked(Study& study) {
  if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
  requireTyped(
      unlock("Passphrase of the study", [&](const auto& typed) { return study.unlock(typed); }));
}

void askForNamesIfLocked(Study& study, bool isOptional) {
  if (!study.identities().isLocked()) return;
  const std::string without = isOptional ? " (empty line: without names)" : "";
  const bool isUnlocked = unlock(
      "Passphrase of names" + without, [&](const auto& typed) { return study.unlockNames(typed); });
  requireTyped(isUnlocked || isOptional);
}

}  // namespace study::app
