#pragma once

#include <sys/types.h>

#include <string>

namespace study::app {

/// The punch's firmware as it is compiled for a Cortex-M3, run by QEMU (mps2-an385) behind a
/// pseudo-terminal, with a handle that is simulated on the board. QEMU keeps neither the
/// processor's speed nor its timing.
class QemuPunch {
 public:
  /// @param link  a name for its port that stays; empty: the one that QEMU gets.
  /// @throws UserError  if QEMU or the firmware is missing, in words.
  QemuPunch(const std::string& firmware, const std::string& link);
  ~QemuPunch();
  QemuPunch(const QemuPunch&) = delete;
  QemuPunch& operator=(const QemuPunch&) = delete;

  const std::string& port() const noexcept { return link_.empty() ? port_ : link_; }
  pid_t id() const noexcept { return id_; }

  /// "kill", "stop", "continue" or "status"; the answer.
  std::string command(const std::string& line);
  static std::string help() { return "kill, stop, continue, status, help, quit"; }

 private:
  void refuseNameOfAnother() const;

  std::string firmware_;
  std::string link_;
  std::string port_;
  pid_t id_ = -1;
};

}  // namespace study::app
