#include "study/app/devices/qemu_punch.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <vector>

#include "study/model/user_error.h"

namespace study::app {
namespace {

constexpr const char* kEmulator = "qemu-system-arm";
constexpr int kLongestStart = 5000;  // [ms]

pid_t start(const std::string& firmware, int out) {
  std::vector<std::string> texts{
      kEmulator,
      "-M",
      "mps2-an385",
      "-display",
      "none",
      "-monitor",
      "none",
      "-serial",
      "pty",
      "-kernel",
      firmware};
  std::vector<char*> words;
  for (auto& text : texts) words.push_back(text.data());
  words.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t id = fork();
  if (id != 0) return id;
  // QEMU is killed when this program ends, even if this program is killed.
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) == 0 && getppid() == parent &&
      dup2(out, STDOUT_FILENO) >= 0 && dup2(out, STDERR_FILENO) >= 0) {
    execvp(kEmulator, words.data());
  }
  _exit(127);
}

/// The path of the pseudo-terminal in QEMU's output: "char device redirected to /dev/pts/0 (label
/// serial0)".
std::string portIn(int from) {
  std::string said;
  pollfd watched{.fd = from, .events = POLLIN, .revents = 0};
  while (poll(&watched, 1, kLongestStart) > 0) {
    std::array<char, 512> bytes{};
    const ssize_t count = read(from, bytes.data(), bytes.size());
    if (count <= 0) break;
    said.append(bytes.data(), static_cast<std::size_t>(count));
    const auto begin = said.find("/dev/pts/");
    const auto end = begin == std::string::npos ? begin : said.find(' ', begin);
    if (end != std::string::npos) return said.substr(begin, end - begin);
  }
  throw UserError(
      "QEMU (qemu-system-arm) did not offer a serial line" + (said.empty() ? "" : ": " + said) +
      ". Install it with ./setup --firmware, or leave --firmware out: then the same program runs "
      "natively.");
}

}  // namespace

QemuPunch::QemuPunch(const std::string& firmware, const std::string& link) : link_(link) {
  if (!std::filesystem::is_regular_file(firmware)) {
    throw UserError(
        firmware +
        " is no firmware. It is built where arm-none-eabi-g++ is installed (./setup "
        "--firmware), as haptics/firmware/punch.elf in the build folder.");
  }
  requireFreeLink();
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw UserError("No pipe can be had from the system.");
  try {
    id_ = start(firmware, ends[1]);
    ::close(ends[1]);
    port_ = portIn(ends[0]);
    ::close(ends[0]);
  } catch (...) {
    ::close(ends[0]);
    if (id_ > 0) {
      kill(id_, SIGKILL);
      waitpid(id_, nullptr, 0);
    }
    throw;
  }
  if (link_.empty()) return;
  std::error_code ignored;
  if (std::filesystem::is_symlink(link_)) std::filesystem::remove(link_, ignored);
  std::filesystem::create_symlink(port_, link_);
}

/// Throws if the link exists and points to an existing port, which another program then uses.
void QemuPunch::requireFreeLink() const {
  std::error_code ignored;
  if (!std::filesystem::is_symlink(link_, ignored)) return;
  if (!std::filesystem::exists(link_, ignored)) return;
  throw UserError(
      "The name " + link_ +
      " leads to a port that is there: another emulator has it. End that one, choose another name, "
      "or remove the link.");
}

QemuPunch::~QemuPunch() {
  if (id_ > 0) {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  std::error_code ignored;
  if (!link_.empty() && std::filesystem::is_symlink(link_)) {
    std::filesystem::remove(link_, ignored);
  }
}

std::string QemuPunch::command(const std::string& line) {
  const std::string pid = " qemu_pid=" + std::to_string(id_);
  if (line == "status") return "device=punch-qemu running=" + std::to_string(id_ > 0) + pid;
  if (id_ <= 0) return "error QEMU is not running any more";
  if (line == "kill") {
    kill(id_, SIGKILL);
    waitpid(id_, nullptr, 0);
    id_ = -1;
  } else if (line == "stop") {
    kill(id_, SIGSTOP);
  } else if (line == "continue") {
    kill(id_, SIGCONT);
  } else {
    return "error '" + line + "' is no command. There are: " + help();
  }
  return "ok " + line;
}

}  // namespace study::app
