#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "study/trial/device_file.h"

namespace study::app {

/// An emulator in its own process: `palpate device emulate …` of the palpate in this program's
/// folder. The process ends when this object is destroyed or this program ends.
class EmulatorProcess {
 public:
  /// Starts the emulator and waits until it is ready.
  /// @param arguments  the command-line arguments that follow "device emulate".
  /// @throws UserError  if the emulator does not start; with its output.
  explicit EmulatorProcess(const std::vector<std::string>& arguments);
  ~EmulatorProcess();
  EmulatorProcess(const EmulatorProcess&) = delete;
  EmulatorProcess& operator=(const EmulatorProcess&) = delete;

  pid_t id() const noexcept { return id_; }
  /// The text after "ready" in the emulator's first line: "port=/dev/pts/3".
  const std::string& ready() const noexcept { return ready_; }

  /// Sends a line ("drop 3") and returns the answer; empty if no answer arrives.
  std::string ask(const std::string& line);

 private:
  void start(const std::vector<std::string>& arguments);
  void end() noexcept;
  /// Reads a line from the file descriptor @p from; false at its end.
  bool readLine(int from, std::string& line);

  pid_t id_ = -1;
  int inputPipe_ = -1;
  int outputPipe_ = -1;
  int errorPipe_ = -1;
  std::string buffer_;
  std::string ready_;
};

/// The value of "key=value" in a line of an emulator.
/// @throws UserError  if the line lacks the key.
std::string valueIn(std::string_view line, std::string_view key);

/// An emulator, and the device entry that connects to it.
struct EmulatedDevice {
  std::unique_ptr<EmulatorProcess> emulator;
  DeviceEntry entry;
};

/// Starts the emulator of a kind of device.
/// @param id  id of the device entry.
/// @param options  further options of `device emulate`, for instance {"--seed", "1"}.
EmulatedDevice emulatedDevice(
    const haptics::devices::DeviceKind& kind,
    const std::string& id,
    const std::vector<std::string>& options);

}  // namespace study::app
