#include "haptics/emulators/pseudo_terminal.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace haptics::emulators {
namespace {

[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error(what + ": " + std::strerror(errno));
}

}  // namespace

PseudoTerminal::PseudoTerminal(std::string link) : link_(std::move(link)) {
  plugIn();
}

PseudoTerminal::~PseudoTerminal() {
  unplug();
}

void PseudoTerminal::plugIn() {
  if (isPlugged()) return;
  const int master = posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  std::array<char, 128> name{};
  if (master < 0 || grantpt(master) != 0 || unlockpt(master) != 0 ||
      ptsname_r(master, name.data(), name.size()) != 0) {
    if (master >= 0) close(master);
    fail("no pseudo-terminal can be had from the system");
  }
  master_ = master;
  systemName_ = name.data();
  termios settings{};
  if (tcgetattr(master_, &settings) == 0) {
    cfmakeraw(&settings);
    tcsetattr(master_, TCSANOW, &settings);
  }
  if (link_.empty()) return;
  requireUnusedLink();
  removeLink();
  if (symlink(systemName_.c_str(), link_.c_str()) != 0) {
    unplug();
    fail("the name " + link_ + " cannot be given to the port");
  }
}

void PseudoTerminal::unplug() noexcept {
  if (!isPlugged()) return;
  close(master_);
  master_ = -1;
  removeLink();
}

/// Refuses a link to a port that exists, because another program uses it. A link to a missing port,
/// or to this one, is left over and may be replaced.
void PseudoTerminal::requireUnusedLink() {
  std::array<char, 256> target{};
  const ssize_t size = readlink(link_.c_str(), target.data(), target.size() - 1);
  if (size <= 0 || systemName_ == target.data() || access(link_.c_str(), F_OK) != 0) return;
  close(master_);
  master_ = -1;
  throw std::runtime_error(
      "The name " + link_ + " leads to a port that is there (" + target.data() +
      "): another emulator has it. End that one, choose another name, or remove the link.");
}

/// Removes link_ only if it is a symbolic link, never a file.
void PseudoTerminal::removeLink() noexcept {
  std::array<char, 256> target{};
  if (!link_.empty() && readlink(link_.c_str(), target.data(), target.size()) > 0) {
    ::unlink(link_.c_str());
  }
}

std::size_t PseudoTerminal::read(std::span<std::uint8_t> into) noexcept {
  if (!isPlugged()) return 0;
  const ssize_t count = ::read(master_, into.data(), into.size());
  return count > 0 ? static_cast<std::size_t>(count) : 0;
}

void PseudoTerminal::write(std::span<const std::uint8_t> bytes) noexcept {
  if (!isPlugged()) return;
  // All or nothing: a partial frame would count as damage that was not ordered.
  int waiting = 0;
  constexpr int kMostWaitingBytes = 3000;  // of the terminal's buffer of 4096
  if (ioctl(master_, TIOCOUTQ, &waiting) == 0 && waiting > kMostWaitingBytes) return;
  [[maybe_unused]] const ssize_t written = ::write(master_, bytes.data(), bytes.size());
}

}  // namespace haptics::emulators
