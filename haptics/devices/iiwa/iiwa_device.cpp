#include "haptics/devices/iiwa/iiwa_device.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "haptics/devices/device.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

using namespace haptics::wire::fri;
using timing::kMillisecond;

constexpr std::int64_t kMostSilence = 50 * kMillisecond;
constexpr std::int64_t kMissedCycles = 20;
constexpr std::int64_t kFirstMessageTimeout = 2000 * kMillisecond;
constexpr std::uint64_t kLongestAnswerPeriod = 20;  // longest accepted period of answers [ms]
// Longest wait for COMMANDING_ACTIVE: as long as robot programs wait for a client.
constexpr std::int64_t kCommandingTimeout = 10'000 * kMillisecond;

Capabilities capabilitiesOf(const IiwaSettings& settings) {
  return {
      .kind = &reamerKind(),
      .name = "iiwa at " + settings.robot,
      .leastTravel = 0.0,
      .largestTravel = settings.largestTravel,
      .maxForce = settings.maxForce,
      .maxTorque = settings.maxTorque,
      .damping = settings.damping,
      .rate = 200.0,
      .isSimulated = false};
}

Endpoint robotOf(const IiwaSettings& settings) {
  const auto robot = endpointFrom(settings.robot);
  if (!robot || !(settings.axis.norm() > 0.0) || !settings.axis.allFinite()) {
    throw DeviceError(deviceMessage("device.arm_settings", settings.robot));
  }
  return *robot;
}

}  // namespace

IiwaDevice::IiwaDevice(IiwaSettings settings)
    : WireDevice(
          capabilitiesOf(settings),
          {.longestWait = 10 * kMillisecond, .silence = kFirstMessageTimeout}),
      settings_(std::move(settings)),
      kinematics_(settings_.model, settings_.tool),
      guard_(settings_.model, settings_.margins),
      robot_(robotOf(settings_)) {
  settings_.axis.normalize();
}

IiwaDevice::~IiwaDevice() {
  close();
}

SessionState IiwaDevice::state() const noexcept {
  return lastMessage_.connection ? lastMessage_.connection->state : SessionState::Idle;
}

void IiwaDevice::open() {
  close();
  try {
    // For a robot on the loopback interface, bind to loopback only; otherwise to any address, since
    // the system chooses the interface.
    socket_.emplace(
        Endpoint{.address = robot_.isLoopback() ? 0x7F000001U : 0U, .port = settings_.port});
  } catch (const NetworkError& error) {
    throw DeviceError(deviceMessage("device.arm_port", place(), settings_.port, error.what()));
  }
  lastMessage_ = {};
  sequence_ = {};
  resetCounts();
  start_.reset();
  robot_.port = 0;
  answerSequence_ = 0;
  isNew_ = isUnanswered_ = false;
  messagesSinceAnswer_ = 0;
  deviceTime_ = 0;
  jointVelocity_.setZero();
  try {
    awaitMessages();
  } catch (...) {
    socket_.reset();
    throw;
  }
  finishOpening();
}

void IiwaDevice::awaitMessages() {
  const std::int64_t until = timing::now() + kFirstMessageTimeout;
  while (timing::now() < until) {
    if (!waitForMessage(std::min(until, timing::now() + 100 * kMillisecond))) continue;
    isNew_ = false;
    answer(0.0, 0.0);
    const auto period =
        lastMessage_.connection ? lastMessage_.connection->sendPeriod.value_or(5) : 5;
    const auto multiplier =
        lastMessage_.connection ? lastMessage_.connection->receiveMultiplier.value_or(1) : 1;
    const auto between = std::uint64_t{period} * multiplier;
    if (between > kLongestAnswerPeriod) {
      throw DeviceError(deviceMessage("device.arm_slow", place(), between));
    }
    period_ = std::clamp<std::int64_t>(period, 1, 100) * kMillisecond;
    capabilities_.rate = 1e9 / static_cast<double>(period_ * std::max<std::int64_t>(multiplier, 1));
    return;
  }
  throw DeviceError(describeSilence());
}

base::Message IiwaDevice::describeSilence() const {
  if (report_.damaged > 0) {
    return deviceMessage("device.arm_unreadable", place(), nameOf(settings_.version));
  }
  if (report_.foreign > 0) {
    std::string other = lastForeignSender_.text();
    other.erase(other.find(':'));
    return deviceMessage(
        "device.arm_elsewhere", place(), settings_.port, other, report_.foreign, other);
  }
  return deviceMessage("device.arm_silent", place(), settings_.port);
}

std::int64_t IiwaDevice::longestSilence() const noexcept {
  return std::min(kMissedCycles * period_, kMostSilence);
}

void IiwaDevice::beginForces() noexcept {
  start_ = settings_.zero ? kinematics_.at(asVector(*settings_.zero)).tool : tool_;
  turn_ = 0.0;
  sequence_ = {};
  lastGoodAt_ = timing::now();
}

void IiwaDevice::awaitReadiness() {
  const std::int64_t until = timing::now() + kCommandingTimeout;
  while (timing::now() < until) {
    if (!waitForMessage(timing::now() + 100 * kMillisecond)) continue;
    isNew_ = false;
    answer(0.0, 0.0);
    if (state() == SessionState::CommandingActive) return;
  }
  throw DeviceError(deviceMessage("device.arm_no_forces", place()));
}

/// Receives until a valid message has arrived or the deadline has passed. If there are several
/// messages, the newest is used.
bool IiwaDevice::waitForMessage(std::int64_t deadline) noexcept {
  while (socket_) {
    const std::int64_t left = deadline - timing::now();
    auto received = socket_->receive(receiveBuffer_, std::max<std::int64_t>(left, 0));
    // The largest number of datagrams that are read before the time is checked again, so that a
    // flood cannot block the loop: half of what a socket holds, and more than a robot sends before
    // it counts as silent.
    constexpr int kBacklog = 128;
    for (int i = 1; received; ++i) {
      const bool hadNew = isNew_;
      if (take(*received, timing::now()) && hadNew) ++report_.skipped;
      if (i == kBacklog) break;
      received = socket_->receive(receiveBuffer_, 0);
    }
    if (isNew_) return true;
    if (timing::now() >= deadline) return false;
  }
  return false;
}

bool IiwaDevice::take(const DatagramSocket::Received& received, std::int64_t at) noexcept {
  const bool isRobot = received.from.address == robot_.address &&
                       (robot_.port == 0 || received.from.port == robot_.port);
  if (!isRobot) {
    ++report_.foreign;
    lastForeignSender_ = received.from;
    return false;
  }
  MonitoringMessage message;
  if (decode({receiveBuffer_.data(), received.size}, settings_.version, message) != Refusal::None) {
    ++report_.damaged;
    return false;
  }
  using Verdict = wire::SequenceCheck<std::uint32_t>::Verdict;
  const auto verdict = sequence_.take(message.header.sequence);
  report_.lost = sequence_.lost();
  report_.doubled = sequence_.duplicates();
  report_.late = sequence_.late();
  report_.restarts = sequence_.restarts();
  if (verdict == Verdict::Doubled || verdict == Verdict::Late) return false;
  robot_.port = received.from.port;  // from now on only the port that sent first is the robot
  lastMessage_ = message;
  updateMotion(at);
  return true;
}

/// Updates position and velocity from the message in lastMessage_, which arrived at @p at [ns].
void IiwaDevice::updateMotion(std::int64_t at) noexcept {
  const std::int64_t before = deviceTime_;
  hostTime_ = at;
  isNew_ = true;
  ++report_.received;
  const auto& data = lastMessage_.monitorData;
  if (data && data->timestamp) {
    deviceTime_ = data->timestamp->seconds * timing::kSecond + data->timestamp->nanoseconds;
    drift_.add(deviceTime_, at);
  } else {
    deviceTime_ += period_;
  }
  if (lastMessage_.header.reflected != lastReflected_) {
    lastReflected_ = lastMessage_.header.reflected;
    const std::int64_t sent = sentAt_[lastReflected_ % sentAt_.size()];
    if (sent != 0) report_.roundTrip.add(1e-3 * static_cast<double>(at - sent));
  }
  const auto multiplier =
      lastMessage_.connection ? lastMessage_.connection->receiveMultiplier.value_or(1) : 1;
  if (++messagesSinceAnswer_ >= std::max<std::uint32_t>(multiplier, 1)) {
    messagesSinceAnswer_ = 0;
    isUnanswered_ = true;
  }
  if (!data || !data->measuredPosition) return;
  const JointVector joints = asVector(*data->measuredPosition);
  // Messages are at least a period apart; time stamps that are closer are imprecise.
  const std::int64_t apart = deviceTime_ - before;
  const double dt = apart > 0 ? 1e-9 * static_cast<double>(std::max(apart, period_)) : 0.0;
  // Weight of the newest message in the velocity (a low-pass over a few messages)
  constexpr double kShare = 0.3;
  if (before != 0 && dt > 0.0)
    jointVelocity_ += kShare * ((joints - joints_) / dt - jointVelocity_);
  joints_ = joints;
  const auto place = kinematics_.at(joints);
  tool_ = place.tool;
  jacobian_ = place.jacobian;
  velocity_ = settings_.axis.dot((jacobian_ * jointVelocity_).head<3>());
  if (!start_) return;
  travel_ = displacementAlong(settings_.axis, *start_, tool_);
  const double turn = settings_.axis.dot(rotationVectorBetween(start_->rotation, tool_.rotation));
  turn_ += std::remainder(turn - turn_, 2.0 * std::numbers::pi);  // also counts angles beyond ±π
}

/// Returns the reason to end a trial, if there is one.
DeviceFault IiwaDevice::reasonToEndTrial() const noexcept {
  if (sequence_.restarts() > 0) return "fault.new_session";
  if (state() != SessionState::CommandingActive) return "fault.not_commanding";
  if (lastMessage_.robotInfo) {
    const auto& info = *lastMessage_.robotInfo;
    if (info.safetyState.value_or(SafetyState::NormalOperation) != SafetyState::NormalOperation) {
      return "fault.safety_stop";
    }
    for (const auto drive : info.driveStates) {
      if (drive != DriveState::Active) return "fault.drives";
    }
  }
  if (!lastMessage_.monitorData || !lastMessage_.monitorData->measuredPosition) {
    return "fault.no_joints";
  }
  return {};
}

bool IiwaDevice::isReamerOn() const noexcept {
  if (settings_.pedal.empty()) return true;
  if (!lastMessage_.monitorData) return false;
  for (const auto& input : lastMessage_.monitorData->inputs) {
    if (input.name.text() == settings_.pedal) return input.digital.value_or(0) != 0;
  }
  return false;
}

DeviceSample IiwaDevice::read(double) noexcept {
  stopKeepAlive();
  if (lifecycle() == Lifecycle::Faulted || !socket_) return {.status = DeviceStatus::NotAnswering};
  DeviceSample sample{
      .status = DeviceStatus::Stale,
      .travel = travel_,
      .velocity = velocity_,
      .turn = turn_,
      .isReamerOn = isReamerOn(),
      .deviceTime = deviceTime_};
  if (!isNew_) {
    ++report_.stale;
    if (timing::now() - hostTime_ <= longestSilence()) return sample;
    fail("fault.missed_cycles");
    return {.status = DeviceStatus::NotAnswering};
  }
  isNew_ = false;
  DeviceFault wrong = reasonToEndTrial();
  if (!wrong) {
    const auto& torque = lastMessage_.monitorData->measuredTorque;
    wrong = guard_.reasonNotToCommand(
        joints_, jointVelocity_, torque ? asVector(*torque) : JointVector(JointVector::Zero()));
  }
  const bool isGood =
      lastMessage_.connection && lastMessage_.connection->quality >= ConnectionQuality::Good;
  if (isGood) lastGoodAt_ = hostTime_;
  if (!wrong && hostTime_ - lastGoodAt_ > kMostSilence) {
    wrong = "fault.poor_connection";
  }
  if (wrong) {
    fail(wrong);
    return {.status = DeviceStatus::Faulted};
  }
  if (isGood) {
    sample.status = DeviceStatus::Ok;
  } else {
    ++report_.poorConnectionSamples;
  }
  return sample;
}

void IiwaDevice::command(double force, double torque) noexcept {
  if (isKeepAliveRunning() || !socket_) return;
  answer(force, torque);
  if (lifecycle() == Lifecycle::Armed) setLifecycle(Lifecycle::Running);
}

/// Answers the newest message, at most once, if an answer is due.
void IiwaDevice::answer(double force, double torque) noexcept {
  if (!isUnanswered_ || !socket_) return;
  isUnanswered_ = false;
  const SessionState session = state();
  if (session == SessionState::Idle) return;
  CommandMessage message;
  message.header = {
      .identifier = kCommand,
      .sequence = answerSequence_,
      .reflected = lastMessage_.header.sequence};
  const bool isCommanding =
      session == SessionState::CommandingWait || session == SessionState::CommandingActive;
  const bool isFirstSeries = settings_.version < Version::V2_5;
  if (isCommanding) {
    message.data.emplace();
    message.data->jointPosition =
        // decode() guarantees ipoData and its joint position in the commanding states.
        lastMessage_.ipoData->jointPosition;
    const bool isActive = session == SessionState::CommandingActive &&
                          lifecycle() != Lifecycle::Open &&
                          lastMessage_.connection->quality >= ConnectionQuality::Good;
    writeOverlay(*message.data, isActive ? force : 0.0, isActive ? torque : 0.0);
  } else if (isFirstSeries && lastMessage_.monitorData) {
    const auto& data = *lastMessage_.monitorData;
    message.data.emplace();
    message.data->jointPosition =
        data.commandedPosition ? data.commandedPosition : data.measuredPosition;
  }
  std::array<std::uint8_t, kLargestDatagram> bytes{};
  const std::size_t count = encode(message, settings_.version, bytes);
  sentAt_[answerSequence_ % sentAt_.size()] = timing::now();
  ++answerSequence_;
  if (count == 0 || !socket_->send({bytes.data(), count}, robot_)) ++report_.unsent;
}

/// Writes the force (positive against advancing) and the torque about the axis as the robot expects
/// them.
void IiwaDevice::writeOverlay(CommandData& data, double force, double torque) noexcept {
  bool isClipped = false;
  const auto limitedTo = [&](double requested, double most) {
    const double given = std::isfinite(requested) ? std::clamp(requested, -most, most) : 0.0;
    isClipped = isClipped || given != requested;
    return given;
  };
  Wrench wrench;
  wrench.head<3>() = -limitedTo(force, capabilities_.maxForce) * settings_.axis;
  wrench.tail<3>() = limitedTo(torque, capabilities_.maxTorque) * settings_.axis;
  const JointVector joints = jacobian_.transpose() * wrench;
  const double share = guard_.allowedFactor(joints);
  if (share < 1.0 || isClipped) ++report_.clipped;
  if (settings_.overlay == IiwaOverlay::JointTorque) {
    data.jointTorque = asJoints(share * joints);
    return;
  }
  const bool isInTool = settings_.wrenchFrame == WrenchFrame::Tool;
  const Eigen::Matrix3d toFrame =
      isInTool ? Eigen::Matrix3d(tool_.rotation.transpose()) : Eigen::Matrix3d::Identity();
  const Eigen::Vector3d f = share * (toFrame * wrench.head<3>());
  const Eigen::Vector3d m = share * (toFrame * wrench.tail<3>());
  // KUKA's angles A, B and C are rotations about z, y and x; the torques τA, τB and τC have the
  // same order.
  data.wrench = Vector6{f.x(), f.y(), f.z(), m.z(), m.y(), m.x()};
}

}  // namespace haptics::devices
