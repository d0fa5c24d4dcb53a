#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tests/support/child_process.h"
#include "tests/support/scratch_folder.h"

namespace tests {

/// An emulator in its own process, with its control line.
class Emulator {
 public:
  explicit Emulator(std::vector<std::string> arguments);

  /// The line that it prints when it is ready.
  const std::string& ready() const noexcept { return ready_; }
  /// Sends a command ("drop 3") and returns the answer.
  std::string ask(const std::string& line);
  /// Its status, by key.
  std::map<std::string, std::string> status();
  double number(const std::string& key) { return std::stod(status().at(key)); }

 private:
  ChildProcess process_;
  std::string ready_;
};

/// Both emulators, a device file for them, and a study that uses both devices in as few trials as
/// possible.
class EmulatedLaboratory {
 public:
  /// Cuts and strokes in every trial.
  explicit EmulatedLaboratory(int cuts = 1, int strokes = 1);

  Emulator& punch() noexcept { return *punch_; }
  Emulator& iiwa() noexcept { return *iiwa_; }
  const std::string& deviceFile() const noexcept { return deviceFile_; }
  const std::string& study() const noexcept { return study_; }
  const std::string& protocol() const noexcept { return protocol_; }
  const std::string& port() const noexcept { return port_; }
  std::string operator/(std::string_view name) const { return folder_ / name; }

  /// Runs the program.
  Finished palpate(std::vector<std::string> call) const;
  /// Starts one simulated participant on the devices.
  std::unique_ptr<ChildProcess> participant() const;
  /// Waits until @p emulator gets a force of more than @p newtons; false if that takes longer than
  /// a minute, or when @p isWorthWaiting no longer holds.
  static bool waitForForce(
      Emulator& emulator, double newtons, const std::function<bool()>& isWorthWaiting);
  /// The details of all events of this kind, in order.
  std::vector<std::string> events(const std::string& kind) const;
  /// The endings of all trials, in order.
  std::vector<std::string> endings() const;

 private:
  std::vector<std::string> column(const std::string& of, const std::string& from) const;

  ScratchFolder folder_;
  std::string port_;
  std::string deviceFile_;
  std::string protocol_;
  std::string study_;
  std::unique_ptr<Emulator> punch_;
  std::unique_ptr<Emulator> iiwa_;
};

/// CLOCK_MONOTONIC [ns], which the emulators use, too.
std::int64_t monotonic();

}  // namespace tests
