#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/devices/hand.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/emulators/impairment.h"
#include "haptics/emulators/pseudo_terminal.h"
#include "haptics/firmware/punch_program.h"

namespace haptics::emulators {

/// An emulated punch, or another device with the same protocol, on a pseudo-terminal: the
/// firmware's program, compiled for this computer, with a simulated handle, motor, encoder and
/// hand, and with faults that are injected on command.
///
/// The motor's force is newtonsPerVolt times its voltage, without delay. A loop that hangs for 40
/// ms is reset, as by the board's hardware watchdog.
class PunchEmulator {
 public:
  struct Options {
    const devices::DeviceKind* kind = &devices::punchKind();
    std::string link;  ///< path of a link to the port; empty: the system's name
    devices::SimulatedHand::Person person;
    firmware::PunchLimits limits;
    double newtonsPerVolt = 0.667;
    double travelPerCount = kind->serial.travelPerCount;  ///< [travel units]
    double clockDrift = 0.0;  ///< error of the device's clock [parts per million]
    std::uint64_t seed = 1;   ///< seed of random faults
  };

  explicit PunchEmulator(const Options& options);

  const std::string& port() const noexcept { return line_.port(); }

  /// Performs one iteration of the device's loop; to be called at limits.rate.
  void step() noexcept;

  /// Executes a command ("drop 3", "unplug"). Returns an empty text, or a message about what is
  /// wrong with the command.
  std::string command(std::string_view line);
  static std::string_view help() noexcept;

  /// The state as one line of key=value pairs.
  std::string status() const;

  /// The faults of frames injected so far.
  InjectedCounts injected() const noexcept { return impairment_.counts(); }
  /// Time from the last command that caused a fault until the motor had no voltage [ms].
  /// std::nullopt if there was no such command, if the motor had no voltage when it came, or if the
  /// motor still has a voltage.
  std::optional<double> motorOffAfter() const noexcept;
  double force() const noexcept { return 1e-3 * voltage_ * options_.newtonsPerVolt; }  ///< [N]
  double travel() const noexcept { return travel_; }  ///< [travel units]

  // The hardware interface of PunchProgram.
  std::uint32_t micros() const noexcept;
  std::int32_t counts() const noexcept;
  void drive(std::int16_t millivolts) noexcept;
  bool hasDriverFault() const noexcept { return hasDriverFault_; }
  int read() noexcept;
  void write(const std::uint8_t* bytes, std::size_t count) noexcept;

 private:
  void restart() noexcept;
  void noteFault() noexcept;

  Options options_;
  PseudoTerminal line_;
  Impairment impairment_;
  devices::SimulatedHand hand_;
  devices::SimulatedDevice handle_;
  std::int64_t start_;
  double travel_ = 0.0;
  int voltage_ = 0;                // [mV]
  std::int32_t encoderError_ = 0;  // error of the encoder [counts]
  bool hasDriverFault_ = false;
  // Times on CLOCK_MONOTONIC [ns]; 0: none.
  std::int64_t stalledUntil_ = 0;
  std::int64_t stalledSince_ = 0;
  std::int64_t mutedUntil_ = 0;
  std::int64_t faultAt_ = 0;
  std::int64_t forceOffAt_ = 0;     // after the fault
  std::int64_t voltageZeroAt_ = 0;  // when the motor's voltage became 0 last
  bool hadForce_ = false;           // when the fault began, the motor had a voltage
  std::uint64_t steps_ = 0;
  std::array<std::uint8_t, 1024> input_{};
  std::size_t inputSize_ = 0;
  std::size_t inputPosition_ = 0;
  std::optional<firmware::PunchProgram<PunchEmulator>> program_;
};

}  // namespace haptics::emulators
