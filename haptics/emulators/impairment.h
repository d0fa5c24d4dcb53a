#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/random.h"

namespace haptics::emulators {

/// Faults in the transmission of a frame (a datagram, or a frame on a serial line).
enum class Fault : std::uint8_t {
  Drop,     ///< the frame never arrives
  Double,   ///< the frame arrives twice in succession
  Reorder,  ///< the frame arrives after its successor
  Delay,    ///< the frame arrives some frames later
  Garbage,  ///< random bytes are sent before the frame
  Damage    ///< one byte of the frame is changed
};

inline constexpr std::array<std::string_view, 6> kFaultNames{
    "drop", "double", "reorder", "delay", "garbage", "damage"};

/// Numbers of frames and of injected faults.
struct InjectedCounts {
  std::uint64_t passed = 0;  ///< frames that were given to pass()
  /// Number of frames with each fault, in the order of Fault.
  std::array<std::uint64_t, kFaultNames.size()> of{};

  std::uint64_t operator[](Fault fault) const noexcept {
    return of[static_cast<std::size_t>(fault)];
  }
};

/// Passes frames on, and injects faults into some of them, as scheduled or at random (seeded), so
/// that a test knows exactly how many anomalies the receiver must have counted.
///
/// - A frame gets at most one fault. Scheduled faults come first, in the order of Fault; random
///   faults only if none is scheduled.
/// - The frame after a reordered one gets no fault, so that exactly two frames change places.
/// - A frame that is held back (Reorder, Delay) is sent only after a later frame has passed
///   undamaged, so that the receiver always sees it out of order. It is counted when it is sent.
/// - If there is no space to hold a frame, the fault stays scheduled.
/// - A frame that is empty or longer than kLongestFrame passes without a fault.
///
/// One thread calls pass(); any thread may schedule faults and read counts. No function allocates
/// after construction.
class Impairment {
 public:
  static constexpr std::size_t kLongestFrame = 1500;  ///< [bytes]
  static constexpr std::size_t kMostHeld = 64;        ///< most frames held at a time

  struct Options {
    /// Probability of each random fault, in the order of Fault; their sum is at most 1.
    std::array<double, kFaultNames.size()> shares{};
    std::uint64_t seed = 1;
    int delay = 5;             ///< number of frames by which Delay holds a frame back, >= 1
    std::size_t garbage = 24;  ///< size of a block of garbage [bytes], 1 to kLongestFrame
    /// The byte that ends a frame; std::nullopt: none. With a delimiter, garbage and damage affect
    /// one frame only: garbage ends with the delimiter and does not contain it elsewhere, and
    /// damage neither changes nor creates a delimiter.
    std::optional<std::uint8_t> delimiter;
  };

  Impairment() : Impairment(Options{}) {}
  /// @throws std::invalid_argument  if the options are not valid.
  explicit Impairment(const Options& options);

  /// Schedules @p fault for the next @p howMany frames that can have it, after those already
  /// scheduled. Any thread.
  void schedule(Fault fault, int howMany) noexcept;
  /// Sets the number of frames by which Delay holds a frame back, >= 1. Any thread.
  void setDelay(int frames) noexcept;

  /// Passes on @p frame, intact or with a fault, and the held frames that are due.
  /// @param send  called with a std::span<const std::uint8_t> for each frame to send; the bytes are
  ///              valid only during the call.
  template <typename Send>
  void pass(std::span<const std::uint8_t> frame, Send&& send) {
    const Delivery delivery = decide(frame);
    if (!delivery.garbage.empty()) send(delivery.garbage);
    for (int i = 0; i < delivery.copies; ++i) send(delivery.frame);
    sendDue(send);
  }

  /// Passes on @p frame, which the caller has made invalid already, without a further fault. It
  /// does not count as overtaking held frames.
  template <typename Send>
  void passWithoutFault(std::span<const std::uint8_t> frame, Send&& send) {
    countIntact();
    send(frame);
    sendDue(send);
  }

  /// Passes on all held frames, for the end of a connection. Frames that no later one has overtaken
  /// are not counted as faults.
  template <typename Send>
  void flush(Send&& send) {
    releaseAll();
    sendDue(send);
  }

  /// The exact numbers of injected faults. Any thread.
  InjectedCounts counts() const noexcept;
  /// The number of scheduled faults of this kind that are still pending. Any thread.
  int pendingCount(Fault fault) const noexcept;
  /// Number of frames held back at present. Only for the thread that calls pass().
  std::size_t held() const noexcept { return held_; }

 private:
  using Bytes = std::array<std::uint8_t, kLongestFrame>;

  struct Delivery {
    std::span<const std::uint8_t> garbage;
    std::span<const std::uint8_t> frame;
    int copies = 1;
  };
  struct HeldFrame {
    Bytes bytes{};
    std::size_t size = 0;
    int left = 0;  ///< number of frames that pass before this one is due
    bool isOvertaken = false;
    Fault fault = Fault::Reorder;
  };

  Delivery decide(std::span<const std::uint8_t> frame) noexcept;
  Delivery impair(std::span<const std::uint8_t> frame, Fault fault) noexcept;
  /// Counts a frame that gets no fault; held frames come closer to being due.
  void countIntact() noexcept;
  std::optional<Fault> nextFault() noexcept;
  std::optional<Fault> scheduledFault() noexcept;
  std::optional<Fault> randomFault() noexcept;
  bool hasRoomFor(Fault fault) const noexcept;
  void hold(std::span<const std::uint8_t> frame, Fault fault, int frames) noexcept;
  void countDownHeld(bool overtakes) noexcept;
  void releaseAll() noexcept;
  /// The next held frame that is due; empty if there is none. Valid until the next frame is passed.
  std::span<const std::uint8_t> nextDue() noexcept;
  std::span<const std::uint8_t> makeGarbage() noexcept;
  std::span<const std::uint8_t> damage(std::span<const std::uint8_t> frame) noexcept;
  std::uint8_t randomByte() noexcept;
  void countFault(Fault fault) noexcept;

  template <typename Send>
  void sendDue(Send& send) {
    for (auto due = nextDue(); !due.empty(); due = nextDue()) send(due);
  }

  Options options_;
  base::SplitMix64 random_;
  std::vector<HeldFrame> heldFrames_;  ///< the held frames come first, by age
  std::size_t held_ = 0;
  bool isReordering_ = false;  ///< a reordered frame waits for its successor
  bool isFlushing_ = false;    ///< all held frames are due
  Bytes scratch_{};
  std::atomic<int> delay_;
  std::array<std::atomic<std::int64_t>, kFaultNames.size()> scheduled_{};
  std::atomic<std::uint64_t> passed_{0};
  std::array<std::atomic<std::uint64_t>, kFaultNames.size()> counts_{};
};

}  // namespace haptics::emulators
