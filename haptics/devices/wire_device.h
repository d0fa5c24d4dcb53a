#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <thread>

#include "haptics/devices/device.h"
#include "haptics/timing/clock_statistics.h"

namespace haptics::devices {

/// A device at the other end of a wire that sets the pace of the loop: it sends, and is answered.
///
/// One thread talks to the wire at a time. Before the first tick after arm() that is a thread of
/// the device, the keeper: it listens, answers without a force, and notices silence. From that tick
/// on it is the thread of the loop. The connection is given up at the first fault, and only open()
/// makes it again. A device that derives from this calls close() in its destructor: the keeper uses
/// it.
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
  std::string fault() const override;
  LinkReport link() override;

 protected:
  /// How the keeper waits.
  struct KeepAliveState {
    std::int64_t turn;     ///< for a message at most, before it looks again [ns]
    std::int64_t silence;  ///< that is a fault [ns]
  };

  WireDevice(Capabilities capabilities, KeepAliveState keeping);

  /// "The punch on /dev/ttyACM0".
  virtual std::string name() const = 0;
  virtual bool isConnected() const noexcept = 0;
  /// Closes the connection; @p isFault is sent as the reason where the protocol has one.
  virtual void disconnect(bool isFault) noexcept = 0;
  /// Waits for a message until @p deadline [ns]; isNew_ is set if one has come.
  virtual bool waitForMessage(std::int64_t deadline) noexcept = 0;
  /// The keeper's answer to a message: no force.
  virtual void keepAlive() noexcept = 0;

  /// Waits until the device accepts forces. @throws DeviceError  if it does not; its connection is
  /// kept alive.
  virtual void awaitReadiness() {}
  /// It is to take forces from here on; nothing has been counted yet.
  virtual void beginForces() noexcept = 0;
  /// It is to take none any more.
  virtual void endForces() noexcept {}

  bool wait(std::int64_t deadline) noexcept override;

  /// The last step of open(): the connection is made.
  void beginKeeping();
  void startKeeper();
  void resumeKeeper() noexcept;
  void stopKeeper() noexcept;
  bool isKept() const noexcept { return keeper_.joinable(); }

  void setLifecycle(Lifecycle state) noexcept { lifecycle_.store(state); }
  /// From Open to Checked, unless it has failed meanwhile.
  void setChecked() noexcept;
  /// @param why  in words that last as long as the program.
  void fail(const char* why) noexcept;
  void resetCounts() noexcept;

  Capabilities capabilities_;
  LinkReport report_;
  timing::ClockDrift drift_;
  bool isNew_ = false;                     ///< a message has come and is not used yet
  bool isUnanswered_ = false;              ///< and one that has not been answered
  std::int64_t deviceTime_ = 0;            ///< of the last message, in the device's own unit
  std::int64_t hostTime_ = 0;              ///< when that came [ns]
  std::array<std::int64_t, 64> sentAt_{};  ///< answers, by their number [ns]

 private:
  KeepAliveState keeping_;
  std::atomic<Lifecycle> lifecycle_{Lifecycle::Closed};
  std::atomic<const char*> why_{""};
  std::jthread keeper_;
};

}  // namespace haptics::devices
