#include "haptics/emulators/fri_monitoring.h"

#include <time.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdio>
#include <string_view>
#include <utility>

#include "haptics/wire/crc32.h"

namespace haptics::emulators {
namespace {

constexpr std::array<std::string_view, 5> kStateNames{
    "idle", "monitoring-wait", "monitoring-ready", "commanding-wait", "commanding-active"};
constexpr std::array<std::string_view, 4> kQualityNames{"poor", "fair", "good", "excellent"};

/// Builds a line of key=value pairs.
class Line {
 public:
  void add(std::string_view key, std::string_view value) {
    if (!text_.empty()) text_ += ' ';
    text_.append(key).append("=").append(value);
  }
  template <std::integral Integer>
  void add(std::string_view key, Integer value) {
    add(key, std::string_view(std::to_string(value)));
  }
  void add(std::string_view key, double value) {
    std::array<char, 32> digits{};
    std::snprintf(digits.data(), digits.size(), "%.6g", value);
    add(key, std::string_view(digits.data()));
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

void addAnswers(Line& line, const FriAnswerMatcher::Counts& counts) {
  line.add("answered", counts.taken);
  line.add("missed", counts.missed);
  line.add("answers_lost", counts.lost);
  line.add("answers_doubled", counts.doubled);
  line.add("answers_late", counts.late);
  line.add("unasked", counts.whileIdle);
  line.add("never_sent", counts.toUnknownMessage);
  line.add("client_restarts", counts.restarts);
  line.add("undecodable", counts.undecodable);
  line.add("wrong_identifier", counts.wrongIdentifier);
  line.add("wrong_joint_count", counts.wrongJointCount);
  line.add("unexpected_sender", counts.unexpectedSender);
}

void addInjected(Line& line, const FriReport& report) {
  for (std::size_t i = 0; i < kFaultNames.size(); ++i) {
    line.add("injected_" + std::string(kFaultNames[i]), report.injected.of[i]);
  }
  line.add("injected_six_joints", report.sixJoints);
  line.add("injected_nan", report.notANumber);
  line.add("injected_wrong_version", report.wrongVersion);
  line.add("injected_stalled", report.stalled);
  line.add("injected_impostor", report.impostors);
  line.add("misled", report.impostorAnswers);
}

}  // namespace

std::string statusOf(const FriReport& report) {
  Line line;
  line.add("state", kStateNames[static_cast<std::size_t>(report.state)]);
  line.add("quality", kQualityNames[static_cast<std::size_t>(report.quality)]);
  line.add("share", report.connection.share);
  line.add("latency", report.connection.latency);
  line.add("jitter", report.connection.jitter);
  line.add("overlay", std::string_view(report.hasOverlay ? "on" : "off"));
  line.add("force_n", report.force);
  line.add("torque_nm", report.torque);
  line.add("travel_m", report.travel);
  line.add("turn_rad", report.turn);
  line.add("zero_at_ns", report.overlayZeroAt);
  line.add("periods", report.periods);
  line.add("late_periods", report.latePeriods);
  line.add("sent", report.messages);
  line.add("datagrams", report.datagrams);
  line.add("unsent", report.unsent);
  addAnswers(line, report.answers);
  addInjected(line, report);
  line.add("end_at_ns", report.endAt);
  line.add("end_joint", report.endJoint);
  line.add("end", "\"" + std::string(nameOf(report.lastEnd)) + "\"");
  return std::move(line).text();
}

namespace {

using wire::fri::Version;

wire::fri::TimeStamp unixTime() noexcept {
  timespec time{};
  clock_gettime(CLOCK_REALTIME, &time);
  return {
      .seconds = static_cast<std::uint32_t>(time.tv_sec),
      .nanoseconds = static_cast<std::uint32_t>(time.tv_nsec)};
}

wire::fri::RobotInfo robotInfo(const FriSession& session, const FriArm& arm) noexcept {
  using wire::fri::DriveState;
  const bool isStopped = session.isStopped();
  wire::fri::RobotInfo info{
      .jointCount = 7,
      .safetyState =
          isStopped ? wire::fri::SafetyState::StopLevel1 : wire::fri::SafetyState::NormalOperation,
      .operationMode = wire::fri::OperationMode::Automatic,
      .controlMode = arm.options().control};
  for (int i = 0; i < 7; ++i) {
    *info.driveStates.add() = isStopped ? DriveState::Off : DriveState::Active;
  }
  return info;
}

wire::fri::IpoData ipoData(
    const FriSession& session, const FriArm& arm, const wire::fri::MonitorData& measured) noexcept {
  wire::fri::IpoData data{
      .jointPosition = arm.heldPosition(),
      .redundancy = wire::fri::Redundancy{.value = arm.heldPosition()[2]},
      .commandMode = arm.options().command,
      .overlay = wire::fri::OverlayType::Joint,
      .trackingPerformance = session.isActive() ? arm.tracking() : 0.0};
  data.pose = measured.pose;
  return data;
}

constexpr std::size_t kJointSize = 9;  // a tag and a double
constexpr std::size_t kJointsSize = 7 * kJointSize;

/// Steps through the first fields of an encoded message.
class FieldWalker {
 public:
  explicit FieldWalker(std::span<std::uint8_t> bytes) noexcept : left_(bytes) {}

  /// The content of the next field, if it has number @p number and is length-delimited; otherwise
  /// empty.
  std::span<std::uint8_t> next(std::uint8_t number) noexcept {
    constexpr unsigned kLengthDelimited = 2;
    if (left_.empty() ||
        left_.front() != (static_cast<unsigned>(number) << 3U | kLengthDelimited)) {
      return {};
    }
    std::size_t at = 1;
    std::size_t size = 0;
    for (unsigned shift = 0; at < left_.size() && shift < 21; shift += 7) {
      const std::uint8_t byte = left_[at++];
      size |= static_cast<std::size_t>(byte & 0x7FU) << shift;
      if (byte < 0x80U) break;
    }
    if (size > left_.size() - at) return {};
    const auto field = left_.subspan(at, size);
    left_ = left_.subspan(at + size);
    return field;
  }

 private:
  std::span<std::uint8_t> left_;
};

std::span<std::uint8_t> payloadOf(std::span<std::uint8_t> datagram, Version version) noexcept {
  if (version != Version::V2_7) return datagram;
  constexpr std::size_t kFrame = 8;  // length and CRC
  return datagram.size() > kFrame ? datagram.subspan(4, datagram.size() - kFrame)
                                  : std::span<std::uint8_t>();
}

void renewCrc(std::span<std::uint8_t> datagram, Version version) noexcept {
  if (version != Version::V2_7) return;
  const auto payload = payloadOf(datagram, version);
  std::uint32_t crc = wire::crc32(payload.data(), payload.size());
  for (std::uint8_t& byte : datagram.last(4)) {
    byte = static_cast<std::uint8_t>(crc & 0xFFU);
    crc >>= 8U;
  }
}

/// The measured joint positions, tags and values, in a message that encode() has written.
std::span<std::uint8_t> measuredJoints(std::span<std::uint8_t> payload) noexcept {
  FieldWalker message(payload);
  message.next(1);  // header
  message.next(2);  // robot info
  FieldWalker monitorData(message.next(3));
  const auto joints = monitorData.next(1);
  return joints.size() == kJointsSize ? joints : std::span<std::uint8_t>();
}

}  // namespace

wire::fri::MonitoringMessage monitoringMessage(
    const FriLinkFields& link, const FriSession& session, const FriArm& arm) noexcept {
  wire::fri::MonitoringMessage message;
  message.header.sequence = link.sequence;
  message.header.reflected = link.reflected;
  message.robotInfo = robotInfo(session, arm);
  message.monitorData = arm.measured();
  message.monitorData->timestamp = unixTime();
  message.connection = {
      .state = session.state(),
      .quality = link.quality,
      .sendPeriod = link.sendPeriod,
      .receiveMultiplier = link.receiveMultiplier};
  if (session.isCommanding()) {
    message.ipoData = ipoData(session, arm, *message.monitorData);
  }
  return message;
}

bool leaveOutJoint(std::span<std::uint8_t> datagram, Version version) noexcept {
  const auto joints = measuredJoints(payloadOf(datagram, version));
  if (joints.empty()) return false;
  constexpr std::uint8_t kUnknownFieldTag = 2U << 3U | 1U;  // number 2, a double
  joints[6 * kJointSize] = kUnknownFieldTag;
  renewCrc(datagram, version);
  return true;
}

bool setFirstJointToNaN(std::span<std::uint8_t> datagram, Version version) noexcept {
  const auto joints = measuredJoints(payloadOf(datagram, version));
  if (joints.empty()) return false;
  constexpr std::array<std::uint8_t, 8> kNotANumber{0, 0, 0, 0, 0, 0, 0xF8, 0x7F};
  std::copy(kNotANumber.begin(), kNotANumber.end(), joints.begin() + 1);
  renewCrc(datagram, version);
  return true;
}

}  // namespace haptics::emulators
