#pragma once

#include <sys/types.h>

#include <string>

namespace study::app {

/// The punch's firmware, compiled for a Cortex-M3 and run by QEMU (mps2-an385) on a
/// pseudo-terminal. The firmware itself simulates the handle. QEMU reproduces neither the speed nor
/// the timing of the processor.
class QemuPunch {
 public:
  /// @param link  a symbolic link to its port; empty: only the port that QEMU chooses.
  /// @throws UserError  if QEMU or the firmware is missing, QEMU does not start, or the link is in
  ///     use.
  QemuPunch(const std::string& firmware, const std::string& link);
  ~QemuPunch();
  QemuPunch(const QemuPunch&) = delete;
  QemuPunch& operator=(const QemuPunch&) = delete;

  const std::string& port() const noexcept { return link_.empty() ? port_ : link_; }
  pid_t id() const noexcept { return id_; }

  /// Executes "kill", "stop", "continue" or "status"; returns the answer.
  std::string command(const std::string& line);
  static std::string help() { return "kill, stop, continue, status, help, quit"; }

 private:
  void requireFreeLink() const;

  std::string link_;
  std::string port_;
  pid_t id_ = -1;
};

}  // namespace study::app
