#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// How good the connection to a client is, as a controller tells it.
///
/// KUKA does not publish what its levels mean. **These thresholds are our own.** Of the last 100
/// answers that were due we look at
///
/// - the share that came in time: before the next was due;
/// - the latency, the mean time from a message to its answer;
/// - the jitter, the mean difference between the latencies of two answers that follow each other;
///
/// the latter two as parts of the receive period. All three must be good enough:
///
/// | level     | share  | latency | jitter |
/// |-----------|--------|---------|--------|
/// | Excellent | ≥ 0.98 | ≤ 0.50  | ≤ 0.10 |
/// | Good      | ≥ 0.90 | ≤ 0.80  | ≤ 0.30 |
/// | Fair      | ≥ 0.70 | ≤ 1.00  | ≤ 0.60 |
/// | Poor      | less   | more    | more   |
///
/// What has not yet been is as if unanswered. So every connection starts Poor, and one where
/// everything comes in time is Fair with the 70th answer, Good with the 90th and Excellent with the
/// 98th.
class ConnectionQuality {
 public:
  using Level = wire::fri::ConnectionQuality;

  static constexpr std::size_t kWindow = 100;  ///< answers due

  struct Measures {
    double share = 0.0;    ///< [0, 1]
    double latency = 0.0;  ///< [receive periods]
    double jitter = 0.0;   ///< [receive periods]
  };

  struct Threshold {
    Level level = Level::Poor;
    Measures worst;
  };
  static constexpr std::array kThresholds{
      Threshold{Level::Excellent, {.share = 0.98, .latency = 0.5, .jitter = 0.1}},
      Threshold{Level::Good, {.share = 0.90, .latency = 0.8, .jitter = 0.3}},
      Threshold{Level::Fair, {.share = 0.70, .latency = 1.0, .jitter = 0.6}}};

  /// The level of @p measures; NaN counts as Poor.
  static Level levelOf(const Measures& measures) noexcept;

  /// An answer came in time, @p latency [receive periods] after its message.
  void answered(double latency) noexcept;
  /// An answer that was due did not come in time.
  void missed() noexcept;
  /// As new.
  void forget() noexcept { *this = ConnectionQuality(); }

  Measures measures() const noexcept;
  Level level() const noexcept { return levelOf(measures()); }

 private:
  static constexpr double kUnanswered = -1.0;
  static constexpr std::array<double, kWindow> unanswered() noexcept {
    std::array<double, kWindow> latencies{};
    latencies.fill(kUnanswered);
    return latencies;
  }

  void add(double latency) noexcept;

  std::array<double, kWindow> latencies_ = unanswered();
  std::size_t next_ = 0;  ///< the oldest, which is replaced next
};

/// Why a motion with overlay ended: what KUKA's controller would put into CK_COMPOUND_RETURN_ERROR,
/// in our own words. Numbers on the limits are with FriLimits.
enum class FriEndReason : std::uint8_t {
  None,
  Completed,  ///< the motion's time was over
  AnswersMissing,
  CommandsTooRare,  ///< torque: none for 5 ms
  QualityLost,
  NotMirrored,
  PositionMissing,
  WrenchMissing,
  TorqueMissing,
  PositionLimit,
  PositionLeap,
  WrenchLimit,
  TorqueLimit,
  SafetyStop,
  Idle,
  Restart
};

/// A sentence for the person at the desk.
std::string_view nameOf(FriEndReason end) noexcept;

/// The states of a session as the controller goes through them, one period at a time.
///
///     Idle → MonitoringWait → MonitoringReady → CommandingWait → CommandingActive
///
/// Idle ends with the time to stay; MonitoringWait when the quality is Good; MonitoringReady when
/// the program queues its motion; CommandingWait when the client mirrors the joints and has sent
/// what its command mode needs, kMirrored answers in a row. The commanding states end, with a
/// reason, in MonitoringWait and with a connection that counts as Poor until it has shown itself
/// good again; a motion whose time is over ends in Idle.
class FriSession {
 public:
  using State = wire::fri::SessionState;

  static constexpr int kMostMissed = 8;           ///< answers in a row; one more is too many
  static constexpr double kCommandTimeout = 5.0;  ///< [ms], in torque mode
  static constexpr int kMirrored = 10;            ///< answers in a row
  static constexpr double kMirrorTime = 10'000;   ///< the program's patience [ms]

  /// The least time in each state [periods of sending].
  struct Stay {
    int idle = 10;
    int monitoringWait = 0;
    int monitoringReady = 100;
    int commandingWait = 20;
    int commandingActive = 0;  ///< all of it, not the least; 0: until something ends it
  };

  struct Options {
    Stay stay;
    int period = 1;            ///< of sending [ms], 1 to 100
    bool isTorque = false;     ///< answers must come every 5 ms
    bool queuesAgain = false;  ///< the program tries again after a motion that failed
  };

  /// What has been since the last period.
  struct Input {
    wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
    int missed = 0;         ///< due answers in a row that did not come
    int sinceAnswered = 0;  ///< periods since the message that was last answered
  };

  explicit FriSession(const Options& options) noexcept : options_(options) {}

  /// One period goes by. True if this ended a motion.
  bool advance(const Input& input) noexcept;

  /// Records whether an answer in CommandingWait mirrored the joints.
  void mirror(bool isMirrored) noexcept { mirrored_ = isMirrored ? mirrored_ + 1 : 0; }

  /// Ends a motion, if there is one, for @p end; not in any state but the commanding ones. True if
  /// there was one.
  bool end(FriEndReason end) noexcept;
  void toIdle() noexcept;   ///< and stays there
  void restart() noexcept;  ///< from Idle, and on
  /// The program queues its motion (again), also after Idle.
  void queue() noexcept {
    isQueued_ = true;
    isClosed_ = false;
  }
  void stopSafely(bool isStopped) noexcept { isStopped_ = isStopped; }

  State state() const noexcept { return state_; }
  bool isCommanding() const noexcept { return state_ >= State::CommandingWait; }
  bool isActive() const noexcept { return state_ == State::CommandingActive; }
  bool isStopped() const noexcept { return isStopped_; }
  FriEndReason lastEnd() const noexcept { return lastEnd_; }

 private:
  void enter(State state) noexcept;
  FriEndReason reasonToEnd(const Input& input) const noexcept;
  void goOn(const Input& input) noexcept;

  Options options_;
  State state_ = State::Idle;
  int periods_ = 0;  ///< in this state
  int mirrored_ = 0;
  bool isQueued_ = true;
  bool isClosed_ = false;  ///< no session begins any more
  bool isStopped_ = false;
  FriEndReason lastEnd_ = FriEndReason::None;
};

}  // namespace haptics::emulators
