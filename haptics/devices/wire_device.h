#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

#include "haptics/devices/device.h"
#include "haptics/devices/messages.h"
#include "haptics/timing/clock_statistics.h"

namespace haptics::devices {

/// Base of devices with a connection: the device sends messages, the host answers each, and these
/// messages set the pace of the loop.
///
/// One thread at a time uses the connection. Until the first tick after arm() that is a thread of
/// this class, the keep-alive thread: it receives, answers with no force, and detects silence. From
/// that tick on it is the thread of the loop. The first fault closes the connection, and only
/// open() makes a new one. A derived class calls close() in its destructor, because that thread
/// calls its virtual functions.
class WireDevice : public Device, private Pacer {
 public:
  const Capabilities& capabilities() const noexcept override { return capabilities_; }
  Pacer* pacer() noexcept override { return this; }

  void close() noexcept override;
  void arm() override;
  void disarm() noexcept override;
  Lifecycle lifecycle() const noexcept override {
    return lifecycle_.load(std::memory_order_acquire);
  }
  base::Message fault() const override;
  LinkReport link() override;

 protected:
  /// Time limits of the keep-alive thread.
  struct KeepAliveLimits {
    /// Longest wait for a message; after each wait the thread checks whether it is to stop [ns].
    std::int64_t longestWait;
    std::int64_t silence;  ///< time without a message that is a fault [ns]
  };

  WireDevice(Capabilities capabilities, KeepAliveLimits limits);

  /// The port or address that messages name: "/dev/ttyACM0".
  virtual std::string place() const = 0;
  virtual bool isConnected() const noexcept = 0;
  /// Closes the connection. If the protocol can transmit a reason, it is told @p isFault.
  virtual void disconnect(bool isFault) noexcept = 0;
  /// Waits for a message until @p deadline [ns]; sets isNew_ if one has arrived.
  virtual bool waitForMessage(std::int64_t deadline) noexcept = 0;
  /// Answers a message with no force; called by the keep-alive thread.
  virtual void keepAlive() noexcept = 0;

  /// Waits until the device accepts forces. @throws DeviceError if it does not; the connection
  /// stays open.
  virtual void awaitReadiness() {}
  /// Tells the device to accept forces; called after resetCounts().
  virtual void beginForces() noexcept = 0;
  /// Tells the device to accept no more forces.
  virtual void stopForces() noexcept {}

  bool wait(std::int64_t deadline) noexcept override;

  /// The last step of open(), once the device is connected.
  void finishOpening();
  void startKeepAlive();
  void resumeKeepAlive() noexcept;
  void stopKeepAlive() noexcept;
  bool isKeepAliveRunning() const noexcept { return keepAliveThread_.joinable(); }

  void setLifecycle(Lifecycle state) noexcept { lifecycle_.store(state); }
  /// The result of a check of a device that cannot be connected.
  static CheckResult noConnection(const DeviceError& error);
  /// The result about the drift of the device's clock [parts per million].
  static CheckResult driftFinding(double drift);
  /// Changes the state from Open to Checked, unless a result is Fail or the device has failed in
  /// the meantime.
  void setCheckedUnlessFailed(const std::vector<CheckResult>& results) noexcept;
  void fail(DeviceFault why) noexcept;
  void resetCounts() noexcept;

  Capabilities capabilities_;
  LinkReport report_;
  timing::ClockDrift drift_;
  bool isNew_ = false;           ///< a message has arrived that read() has not used
  bool isUnanswered_ = false;    ///< a message has arrived that has not been answered
  std::int64_t deviceTime_ = 0;  ///< device time of the last message, in the device's own unit
  std::int64_t hostTime_ = 0;    ///< host time of its arrival [ns]
  /// When answers were sent, at index sequence number modulo 64 [ns].
  std::array<std::int64_t, 64> sentAt_{};

 private:
  KeepAliveLimits keepAliveLimits_;
  std::atomic<Lifecycle> lifecycle_{Lifecycle::Closed};
  // The first fault since open(). The joint is written first: a thread that reads the new kind
  // reads the new joint, too.
  std::atomic<int> faultJoint_{0};
  std::atomic<const base::MessageKind*> faultKind_{nullptr};
  std::jthread keepAliveThread_;
};

}  // namespace haptics::devices
