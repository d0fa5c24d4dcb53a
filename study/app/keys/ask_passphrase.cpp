#include "study/app/keys/ask_passphrase.h"

#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include <fmt/format.h>

#include "study/model/user_error.h"

namespace study::app {
namespace {

/// While it exists, the terminal does not show what is typed.
class WithoutEcho {
 public:
  WithoutEcho() : isTerminal_(tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!isTerminal_) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    silent.c_lflag |= ECHONL;
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  ~WithoutEcho() {
    if (isTerminal_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }
  WithoutEcho(const WithoutEcho&) = delete;
  WithoutEcho& operator=(const WithoutEcho&) = delete;

 private:
  termios before_{};
  bool isTerminal_;
};

}  // namespace

std::string askPassphrase(const std::string& question) {
  fmt::print(stderr, "{}: ", question);
  std::fflush(stderr);
  const WithoutEcho quiet;
  std::string typed;
  if (!std::getline(std::cin, typed) || typed.empty()) {
    throw UserError("No passphrase was typed. Nothing was changed.");
  }
  return typed;
}

void unlockIfAsked(Study& study) {
  constexpr int kTries = 3;
  if (!study.isSealed() || study.hasKey() || !study.hasPassphrase()) return;
  for (int i = 0; i < kTries; ++i) {
    if (study.unlock(askPassphrase("Passphrase of the study"))) return;
    fmt::print(stderr, "This is not the passphrase.\n");
  }
  throw UserError("The passphrase was wrong three times. Nothing was changed.");
}

}  // namespace study::app
