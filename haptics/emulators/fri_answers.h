#pragma once

#include <array>
#include <cstdint>

#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// Limits of the magnitudes of commanded force and moment. They apply besides the limits of the
/// arm's data sheet. KUKA publishes no such limits.
struct FriLimits {
  double maxForce = 140.0;          ///< [N]
  double maxMoment = 40.0;          ///< [N·m]
  double mirrorTolerance = 0.0001;  ///< tolerance of a command that mirrors the joints [rad]
};

/// The reason to refuse a command, and the joint concerned.
struct FriVerdict {
  FriEndReason end = FriEndReason::None;
  int joint = 0;  ///< 1 to 7; 0: no particular joint
};

/// Checks whether a command may be executed: it has the fields that its mode needs, and they are
/// within the limits of position, velocity (from command to command), torque and wrench.
class FriCommandCheck {
 public:
  using Mode = wire::fri::ClientCommandMode;

  FriCommandCheck(devices::IiwaModel model, const FriLimits& limits, Mode mode) noexcept
      : arm_(devices::propertiesOf(model)), limits_(limits), mode_(mode) {}

  /// @param before   joint position of the last command [rad]
  /// @param seconds  time since the last command [s], > 0
  FriVerdict judge(
      const wire::fri::CommandData& command,
      const wire::fri::Joints& before,
      double seconds) const noexcept;

  /// For CommandingWait: whether the command mirrors @p joints [rad] and has the fields that its
  /// mode needs, with any value.
  bool isMirror(
      const wire::fri::CommandData& command, const wire::fri::Joints& joints) const noexcept;

 private:
  /// The reason to refuse a command that lacks a field which its mode needs; None if it has all.
  FriEndReason missing(const wire::fri::CommandData& command) const noexcept;
  FriVerdict judgePosition(
      const wire::fri::Joints& position,
      const wire::fri::Joints& before,
      double seconds) const noexcept;
  FriVerdict judgeTorque(const wire::fri::Joints& torque) const noexcept;
  FriVerdict judgeWrench(const wire::fri::Vector6& wrench) const noexcept;

  const devices::IiwaProperties& arm_;
  FriLimits limits_;
  Mode mode_;
};

/// Finds for each answer of a client the message that it answers, and counts anomalies.
///
/// The reflected counter of an answer identifies the message. The answer is accepted if it is the
/// first to that message, and if the message is not older than a receive period; other answers are
/// counted and ignored. The client's own counter serves to count lost answers and restarts of the
/// client, and is sent back to it (reflected()).
class FriAnswerMatcher {
 public:
  struct Counts {
    std::uint64_t taken = 0;      ///< accepted answers
    std::uint64_t missed = 0;     ///< answers that did not arrive before the next one was due
    std::uint64_t lost = 0;       ///< answers missing in the client's own counter
    std::uint64_t doubled = 0;    ///< answers to a message that was answered before
    std::uint64_t late = 0;       ///< answers to a message older than a receive period
    std::uint64_t whileIdle = 0;  ///< answers to a message sent in Idle
    /// Answers to a message that was never sent, or was sent before a restart.
    std::uint64_t toUnknownMessage = 0;
    std::uint64_t restarts = 0;  ///< the client's counter went back in an answer that was in time
    std::uint64_t undecodable = 0;
    std::uint64_t wrongIdentifier = 0;
    std::uint64_t wrongJointCount = 0;
    std::uint64_t unexpectedSender = 0;
  };

  /// @param receiveMultiplier  n: the client answers every n-th message, 1 to 100.
  explicit FriAnswerMatcher(int receiveMultiplier) noexcept
      : multiplier_(static_cast<std::uint32_t>(receiveMultiplier)) {}

  /// Notes that the message with nextSequence() was sent. @p now [ns].
  void noteSent(std::int64_t now, bool isAnswerable) noexcept;

  /// Processes an answer. Returns whether it is accepted; if so, latency() is the latency of this
  /// answer.
  bool take(const wire::fri::Header& header, std::int64_t now) noexcept;

  /// Counts a datagram that is no valid answer, by the reason of the decoder.
  void refuse(wire::fri::Refusal refusal) noexcept;
  /// Counts a datagram from another address than the client's.
  void countUnexpectedSender() noexcept { ++counts_.unexpectedSender; }
  /// Counts an answer that was due and did not arrive.
  void countMissing() noexcept { ++counts_.missed; }

  /// Returns to the initial state, but keeps the counts.
  void restart() noexcept;

  std::uint32_t nextSequence() const noexcept { return next_; }
  std::uint32_t reflected() const noexcept {
    return lastClientSequence_;
  }                                                           ///< the client's last counter
  std::int64_t latency() const noexcept { return latency_; }  ///< of the last accepted answer [ns]
  const Counts& counts() const noexcept { return counts_; }

 private:
  /// Number of sent messages that are remembered; more than in a receive period.
  static constexpr std::uint32_t kSentHistory = 128;

  struct SentMessage {
    std::int64_t at = 0;  ///< [ns]
    bool isAnswerable = false;
    bool isAnswered = false;
  };

  void noteReceived(std::uint32_t sequence) noexcept;

  std::uint32_t multiplier_;
  std::uint32_t next_ = 0;
  std::array<SentMessage, kSentHistory> sent_{};
  std::uint32_t lastClientSequence_ = 0;  ///< the client's last counter
  bool hasHeard_ = false;                 ///< false before the first answer
  std::int64_t latency_ = 0;
  Counts counts_;
};

}  // namespace haptics::emulators
