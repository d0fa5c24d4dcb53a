#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "haptics/emulators/impairment.h"

namespace haptics::emulators {

/// Faults that the emulated controller is to have, from a test or from the keyboard.
///
/// Any thread may add faults; the thread that steps the controller takes each once.
class FriFaultQueue {
 public:
  enum class OneTimeFault : std::uint8_t {
    SixJoints,   ///< messages with six joints
    NotANumber,  ///< messages in which a joint is NaN
    Impostor,    ///< messages from another sender
    Stall        ///< periods in which nothing is sent
  };
  static constexpr std::size_t kOneTimeFaultCount = 4;

  enum class Event : std::uint8_t { Restart, Idle, Motion, SafetyStop, SafetyReset, WrongVersion };

  /// @param impairment  receives the faults of messages; must outlive this object.
  /// @param period      send period [ms]; times are rounded up to it.
  FriFaultQueue(Impairment& impairment, int period) noexcept
      : impairment_(impairment), period_(period) {}

  /// Executes a line such as "drop 3"; see FriController::command().
  /// @return std::nullopt, or a message about what is wrong with the line.
  std::optional<std::string> executeLine(std::string_view line);

  /// All commands of the emulated arm with their arguments, in one line.
  static std::string help();

  /// Removes one pending fault from the queue; returns false if there is none.
  bool take(OneTimeFault fault) noexcept;
  bool take(Event event) noexcept;
  bool isQualityPoor() const noexcept { return isQualityPoor_.load(std::memory_order_relaxed); }

 private:
  struct Command;
  static const Command kCommands[];
  std::optional<std::string> execute(
      const Command& command, std::string_view line, std::span<const std::string_view> texts);
  void add(OneTimeFault fault, int howMany) noexcept;
  void raise(Event event) noexcept;
  /// The number of send periods in a time, rounded up.
  int periodsOf(int milliseconds) const noexcept;

  Impairment& impairment_;
  int period_;  ///< [ms]
  /// How many of each OneTimeFault are still pending.
  std::array<std::atomic<int>, kOneTimeFaultCount> pendingOneTime_{};
  std::atomic<std::uint32_t> events_{0};  ///< pending events, one bit each
  std::atomic<bool> isQualityPoor_{false};
};

}  // namespace haptics::emulators
