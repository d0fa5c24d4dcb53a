#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace study::app {

/// An emulator as a process of its own: `palpate device emulate …`, of the palpate beside this
/// program. It ends with this object, and with this process, however that ends.
class EmulatorProcess {
 public:
  /// @param arguments  after "device emulate". Waits until it says that it is ready.
  /// @throws UserError  if it does not, with what it said instead.
  explicit EmulatorProcess(const std::vector<std::string>& arguments);
  ~EmulatorProcess();
  EmulatorProcess(const EmulatorProcess&) = delete;
  EmulatorProcess& operator=(const EmulatorProcess&) = delete;

  pid_t id() const noexcept { return id_; }
  /// What it said of itself: "port=/dev/pts/3".
  const std::string& ready() const noexcept { return ready_; }

  /// A line for it ("drop 3"), and its answer.
  std::string ask(const std::string& line);

 private:
  void start(const std::vector<std::string>& arguments);
  void end() noexcept;
  bool readLine(int from, std::string& line);

  pid_t id_ = -1;
  int to_ = -1;
  int from_ = -1;
  int errors_ = -1;
  std::string buffer_;
  std::string ready_;
};

}  // namespace study::app
