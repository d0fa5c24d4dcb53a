#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// Rates the quality of the connection to a client, which the controller sends in every message.
///
/// KUKA does not publish how its levels are defined. **These thresholds are Palpate's own.** They
/// use three measures of the last 100 answers that were due:
///
/// - share: the fraction that arrived in time, before the next was due;
/// - latency: the mean time from a message to its answer;
/// - jitter: the mean difference between the latencies of two successive answers;
///
/// the latter two in receive periods. A level requires all three:
///
/// | level     | share  | latency | jitter |
/// |-----------|--------|---------|--------|
/// | Excellent | ≥ 0.98 | ≤ 0.50  | ≤ 0.10 |
/// | Good      | ≥ 0.90 | ≤ 0.80  | ≤ 0.30 |
/// | Fair      | ≥ 0.70 | ≤ 1.00  | ≤ 0.60 |
/// | Poor      | less   | more    | more   |
///
/// Before 100 answers were due, those not yet due count as missing. So every connection starts as
/// Poor. If all answers arrive in time, it is Fair from the 70th answer, Good from the 90th and
/// Excellent from the 98th.
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

  /// Adds an answer that arrived in time, @p latency [receive periods] after its message.
  void noteAnswered(double latency) noexcept;
  /// Adds an answer that was due, but did not arrive in time.
  void noteMissed() noexcept;
  /// Returns to the initial state.
  void reset() noexcept { *this = ConnectionQuality(); }

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
  std::size_t next_ = 0;  ///< index of the oldest, which is replaced next
};

/// Why a motion with overlay ended. The limits are in FriLimits.
enum class FriEndReason : std::uint8_t {
  None,
  Completed,  ///< the motion reached its end
  AnswersMissing,
  CommandsTooRare,  ///< torque mode: no command for 5 ms
  QualityLost,
  NotMirrored,
  PositionMissing,
  WrenchMissing,
  TorqueMissing,
  PositionLimit,
  PositionJump,
  WrenchLimit,
  TorqueLimit,
  SafetyStop,
  Idle,
  Restart
};

/// A sentence for the operator.
std::string_view nameOf(FriEndReason end) noexcept;

/// The state machine of a controller's session; advances once per period.
///
///     Idle → MonitoringWait → MonitoringReady → CommandingWait → CommandingActive
///
/// Idle ends after its time in DwellTimes; MonitoringWait when the quality is Good; MonitoringReady
/// when the program queues its motion; CommandingWait when kMirroredAnswers consecutive answers
/// mirror the joints and have the fields of the command mode. A motion that ends with a reason
/// leads to MonitoringWait, and the connection counts as Poor until it is Good again; a completed
/// motion leads to Idle.
class FriSession {
 public:
  using State = wire::fri::SessionState;

  static constexpr int kMostMissed = 8;  ///< consecutive missing answers; one more ends the motion
  /// Longest time without a command in torque mode [ms].
  static constexpr double kCommandTimeout = 5.0;
  static constexpr int kMirroredAnswers = 10;  ///< consecutive answers that must mirror the joints
  static constexpr double kMirrorTime = 10'000;  ///< longest time in CommandingWait [ms]

  /// The least time in each state [periods of sending].
  struct DwellTimes {
    int idle = 10;
    int monitoringWait = 0;
    int monitoringReady = 100;
    int commandingWait = 20;
    int commandingActive = 0;  ///< duration of the motion, not the least time; 0: unlimited
  };

  struct Options {
    DwellTimes dwellTimes;
    int period = 1;               ///< send period [ms], 1 to 100
    bool isTorqueMode = false;    ///< torque mode: a command must arrive every kCommandTimeout
    bool restartsMotion = false;  ///< the robot's program restarts a motion that failed
  };

  /// What happened since the last period.
  struct Input {
    wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
    int missed = 0;                ///< consecutive answers that were due and did not arrive
    int periodsSinceAnswered = 0;  ///< periods since the last message that was answered
  };

  explicit FriSession(const Options& options) noexcept : options_(options) {}

  /// Advances by one period. Returns whether this ended a motion.
  bool advance(const Input& input) noexcept;

  /// Counts consecutive answers in CommandingWait that command the measured joint positions; any
  /// other answer resets the count.
  void noteAnswer(bool isMirrored) noexcept {
    mirroredAnswers_ = isMirrored ? mirroredAnswers_ + 1 : 0;
  }

  /// Ends the motion with reason @p end if the state is a commanding one; otherwise returns false.
  bool end(FriEndReason end) noexcept;
  void endSession() noexcept;  ///< ends the session; the state stays Idle
  void restart() noexcept;     ///< begins a new session from Idle
  /// The robot's program queues its motion (again), also after endSession().
  void queueMotion() noexcept {
    isQueued_ = true;
    isClosed_ = false;
  }
  void setSafetyStop(bool isStopped) noexcept { isStopped_ = isStopped; }

  State state() const noexcept { return state_; }
  bool isCommanding() const noexcept { return state_ >= State::CommandingWait; }
  bool isActive() const noexcept { return state_ == State::CommandingActive; }
  bool isStopped() const noexcept { return isStopped_; }
  FriEndReason lastEnd() const noexcept { return lastEnd_; }

 private:
  void enter(State state) noexcept;
  FriEndReason reasonToEnd(const Input& input) const noexcept;
  void advanceState(const Input& input) noexcept;

  Options options_;
  State state_ = State::Idle;
  int periods_ = 0;  ///< number of periods in this state
  int mirroredAnswers_ = 0;
  bool isQueued_ = true;
  bool isClosed_ = false;  ///< after endSession(): no new session begins
  bool isStopped_ = false;
  FriEndReason lastEnd_ = FriEndReason::None;
};

}  // namespace haptics::emulators
