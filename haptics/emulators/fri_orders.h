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

/// A fault of the controller that a test, or the user at the keyboard, requests.
///
/// Any thread gives orders; the one that steps the controller takes them, once each.
class FriOrders {
 public:
  enum class OneTime : std::uint8_t {
    SixJoints,   ///< messages with six joints
    NotANumber,  ///< messages in which a joint is NaN
    Impostor,    ///< messages from another sender
    Stall        ///< periods in which nothing is sent
  };
  static constexpr std::size_t kOneTimeCount = 4;

  enum class Event : std::uint8_t { Restart, Idle, Motion, SafetyStop, SafetyReset, WrongVersion };

  /// @param impairment  must outlive it; gets the orders of its own faults.
  /// @param period      of sending [ms]; times are rounded up to it.
  FriOrders(Impairment& impairment, int period) noexcept
      : impairment_(impairment), period_(period) {}

  /// Takes a line such as "drop 3"; see docs of FriController::command().
  /// @return std::nullopt, or what is wrong with the line, in a sentence.
  std::optional<std::string> give(std::string_view line);

  /// All commands of the arm's stand-in, with their arguments, in one line.
  static std::string help();

  /// One fewer; false if none was ordered.
  bool take(OneTime order) noexcept;
  bool take(Event event) noexcept;
  bool isQualityPoor() const noexcept { return isQualityPoor_.load(std::memory_order_relaxed); }

 private:
  struct Word;
  static const Word kWords[];
  std::optional<std::string> execute(
      const Word& word, std::string_view line, std::span<const std::string_view> texts);
  void add(OneTime order, int howMany) noexcept;
  void raise(Event event) noexcept;
  int periodsOf(int milliseconds) const noexcept;

  Impairment& impairment_;
  int period_;  ///< [ms]
  std::array<std::atomic<int>, kOneTimeCount> once_{};
  std::atomic<std::uint32_t> events_{0};  ///< one bit each
  std::atomic<bool> isQualityPoor_{false};
};

}  // namespace haptics::emulators
