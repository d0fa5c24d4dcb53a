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

/// What can go wrong with a frame on its way, be it a datagram or a frame on a serial line.
enum class Fault : std::uint8_t {
  Drop,     ///< it never arrives
  Double,   ///< it arrives twice, one right after the other
  Reorder,  ///< it arrives after its successor
  Delay,    ///< it arrives some frames later
  Garbage,  ///< garbage is sent before it
  Damage    ///< one of its bytes is another
};

inline constexpr std::array<std::string_view, 6> kFaultNames{
    "drop", "double", "reorder", "delay", "garbage", "damage"};

/// What has happened to frames.
struct Injected {
  std::uint64_t passed = 0;                            ///< frames that were given to pass()
  std::array<std::uint64_t, kFaultNames.size()> of{};  ///< frames that met each fault

  std::uint64_t operator[](Fault fault) const noexcept {
    return of[static_cast<std::size_t>(fault)];
  }
};

/// Lets frames pass and does to some of them what an order or a seeded chance says, so that a test
/// knows exactly how many anomalies the other side must have seen.
///
/// - A frame meets one fault at most. Of several orders the first in the list of faults is served
///   first; chance is asked only where no order waits.
/// - The frame after one that is to be reordered meets none, so that two change places.
/// - A frame that is held back (Reorder, Delay) is sent only after a later frame has passed
///   undamaged: it is always seen to be out of order. It counts when it is sent.
/// - Without room to hold a frame the order waits; so it does for a frame that is empty or longer
///   than kLongestFrame, which passes as it is.
///
/// One thread passes; any thread orders and asks for counts. Nothing allocates after construction.
class Impairment {
 public:
  static constexpr std::size_t kLongestFrame = 1500;  ///< [bytes]
  static constexpr std::size_t kMostHeld = 64;        ///< frames at a time

  struct Options {
    /// Of all frames that meet each fault by chance, in the order of Fault; together at most 1.
    std::array<double, kFaultNames.size()> shares{};
    std::uint64_t seed = 1;
    int delay = 5;             ///< by how many frames Delay holds back, >= 1
    std::size_t garbage = 24;  ///< how much of it comes at once [bytes], 1 to kLongestFrame
    /// The byte that ends a frame, if there is one. Garbage then ends with it and contains no
    /// other, and damage neither hits nor makes one: either spoils one frame, not its neighbours.
    std::optional<std::uint8_t> delimiter;
  };

  Impairment() : Impairment(Options{}) {}
  /// @throws std::invalid_argument  if the options are not valid.
  explicit Impairment(const Options& options);

  /// Any thread: the next @p howMany frames that can meet @p fault do, after those of earlier
  /// orders.
  void order(Fault fault, int howMany) noexcept;
  /// Any thread: how far Delay holds back from now on [frames], at least 1.
  void setDelay(int frames) noexcept;

  /// Passes on @p frame, as it is or impaired, and the frames that have been delayed long enough.
  /// @param send  is called with a std::span<const std::uint8_t> for each frame that goes out; the
  ///              bytes are gone when it returns.
  template <typename Send>
  void pass(std::span<const std::uint8_t> frame, Send&& send) {
    const Delivery delivery = decide(frame);
    if (!delivery.garbage.empty()) send(delivery.garbage);
    for (int i = 0; i < delivery.copies; ++i) send(delivery.frame);
    sendDue(send);
  }

  /// Hands on @p frame as it is: something else is wrong with it already, so it meets no fault, and
  /// overtaking it would not be seen.
  template <typename Send>
  void passUnimpaired(std::span<const std::uint8_t> frame, Send&& send) {
    spare();
    send(frame);
    sendDue(send);
  }

  /// Passes on the frames that are held back, at the end of a line. Frames that no later one has
  /// overtaken do not count.
  template <typename Send>
  void flush(Send&& send) {
    releaseAll();
    sendDue(send);
  }

  /// Any thread: exactly how many frames met each fault.
  Injected counts() const noexcept;
  /// Any thread: how many orders of @p fault are not yet taken up.
  int waiting(Fault fault) const noexcept;
  /// Frames that are held back at present; the passing thread's.
  std::size_t held() const noexcept { return held_; }

 private:
  using Bytes = std::array<std::uint8_t, kLongestFrame>;

  struct Delivery {
    std::span<const std::uint8_t> garbage;
    std::span<const std::uint8_t> frame;
    int copies = 1;
  };
  struct Held {
    Bytes bytes{};
    std::size_t size = 0;
    int left = 0;  ///< frames still to pass
    bool isOvertaken = false;
    Fault fault = Fault::Reorder;
  };

  Delivery decide(std::span<const std::uint8_t> frame) noexcept;
  Delivery impair(std::span<const std::uint8_t> frame, Fault fault) noexcept;
  void spare() noexcept;
  std::optional<Fault> nextFault() noexcept;
  std::optional<Fault> orderedFault() noexcept;
  std::optional<Fault> randomFault() noexcept;
  bool hasRoomFor(Fault fault) const noexcept;
  void hold(std::span<const std::uint8_t> frame, Fault fault, int frames) noexcept;
  void age(bool overtakes) noexcept;
  void releaseAll() noexcept;
  std::span<const std::uint8_t> nextDue() noexcept;  ///< The next frame that is due; empty if there
                                                     ///< is none. Valid until the next frame is
                                                     ///< passed.
  std::span<const std::uint8_t> makeGarbage() noexcept;
  std::span<const std::uint8_t> damage(std::span<const std::uint8_t> frame) noexcept;
  std::uint8_t anyByte() noexcept;
  void note(Fault fault) noexcept;

  template <typename Send>
  void sendDue(Send& send) {
    for (auto due = nextDue(); !due.empty(); due = nextDue()) send(due);
  }

  Options options_;
  base::SplitMix64 random_;
  std::vector<Held> places_;  ///< those held come first, the oldest before the others
  std::size_t held_ = 0;
  bool isSwapping_ = false;  ///< a frame waits to change places with its successor
  bool isHurrying_ = false;  ///< all that is held is due
  Bytes scratch_{};
  std::atomic<int> delay_;
  std::array<std::atomic<std::int64_t>, kFaultNames.size()> orders_{};
  std::atomic<std::uint64_t> passed_{0};
  std::array<std::atomic<std::uint64_t>, kFaultNames.size()> counts_{};
};

}  // namespace haptics::emulators
