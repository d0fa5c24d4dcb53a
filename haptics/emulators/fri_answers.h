#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "haptics/devices/iiwa/iiwa_kinematics.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// Limits of commands in addition to the arm's data sheet. Force and moment as lengths of vectors;
/// the arm's are Cartesian, and KUKA publishes none.
struct FriLimits {
  double maxForce = 140.0;      ///< [N]
  double maxMoment = 40.0;      ///< [N·m]
  double mirrorReach = 0.0001;  ///< how far from the joints a mirror of them may be [rad]
};

/// What is wrong with a command, and with which joint of it.
struct FriVerdict {
  FriEndReason end = FriEndReason::None;
  int joint = 0;  ///< 1 to 7; 0: none in particular
};

/// Says whether a command may be followed: it has what its mode needs, and all of that within the
/// limits of position, velocity (from command to command), torque and wrench.
class FriCommandCheck {
 public:
  using Mode = wire::fri::ClientCommandMode;

  FriCommandCheck(devices::IiwaModel model, const FriLimits& limits, Mode mode) noexcept
      : arm_(devices::propertiesOf(model)), limits_(limits), mode_(mode) {}

  /// @param before   the joint position of the last command [rad]
  /// @param seconds  since then, > 0
  FriVerdict judge(
      const wire::fri::CommandData& command,
      const wire::fri::Joints& before,
      double seconds) const noexcept;

  /// In CommandingWait: it mirrors @p joints and has the fields that its mode needs, with any
  /// value.
  bool isMirror(
      const wire::fri::CommandData& command, const wire::fri::Joints& joints) const noexcept;

 private:
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

/// Who has answered which message, and what was wrong with answers.
///
/// An answer says by the reflected counter which message it belongs to. It is taken if it is the
/// first to that message, and if that message is not older than a receive period; everything else
/// is counted and not acted upon. The client's own counter only shows what was lost on the way.
class FriAnswers {
 public:
  struct Counts {
    std::uint64_t taken = 0;
    std::uint64_t missed = 0;  ///< due, and not there when the next was due
    std::uint64_t lost = 0;    ///< left out by the client's own counter
    std::uint64_t doubled = 0;
    std::uint64_t late = 0;       ///< to a message of more than a receive period ago
    std::uint64_t unasked = 0;    ///< to a message in Idle
    std::uint64_t neverSent = 0;  ///< to a message that never was, or from before a restart
    std::uint64_t restarts = 0;   ///< the client's counter went back, with an answer in time
    std::uint64_t undecodable = 0;
    std::uint64_t wrongIdentifier = 0;
    std::uint64_t wrongJointCount = 0;
    std::uint64_t unexpectedSender = 0;
  };

  /// @param receiveMultiplier  the client answers every so manieth message, 1 to 100.
  explicit FriAnswers(int receiveMultiplier) noexcept
      : multiplier_(static_cast<std::uint32_t>(receiveMultiplier)) {}

  /// A message went out, with the next counter. @p now [ns].
  void sent(std::int64_t now, bool isAnswerable) noexcept;

  /// Notes an answer. True if it is to be acted upon; latency() is then its own.
  bool take(const wire::fri::Header& header, std::int64_t now) noexcept;

  void refuse(wire::fri::Refusal refusal) noexcept;
  void refuseSender() noexcept { ++counts_.unexpectedSender; }
  void miss() noexcept { ++counts_.missed; }

  /// As if nothing had been sent or heard; what was counted stays.
  void restart() noexcept;

  std::uint32_t nextSequence() const noexcept { return next_; }
  std::uint32_t reflected() const noexcept { return heard_; }  ///< the client's last counter
  std::int64_t latency() const noexcept { return latency_; }   ///< of the last answer taken [ns]
  const Counts& counts() const noexcept { return counts_; }

 private:
  static constexpr std::uint32_t kRemembered = 128;  ///< messages; more than a receive period has

  struct Sent {
    std::int64_t at = 0;  ///< [ns]
    bool isAnswerable = false;
    bool isAnswered = false;
  };

  void noteReceived(std::uint32_t sequence) noexcept;

  std::uint32_t multiplier_;
  std::uint32_t next_ = 0;
  std::array<Sent, kRemembered> sent_{};
  std::uint32_t heard_ = 0;
  bool hasHeard_ = false;
  std::int64_t latency_ = 0;
  Counts counts_;
};

}  // namespace haptics::emulators
