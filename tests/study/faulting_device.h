#pragma once

#include <atomic>

#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"

namespace tests {

/// A punch that stands still and reports a fault after fail().
class FaultingDevice final : public haptics::devices::Device {
 public:
  const haptics::devices::Capabilities& capabilities() const noexcept override {
    return capabilities_;
  }
  haptics::devices::DeviceSample read(double /*dt*/) noexcept override {
    using enum haptics::devices::DeviceStatus;
    return {.status = isFaulty_.load(std::memory_order_relaxed) ? Faulted : Ok};
  }
  void command(double /*force*/, double /*torque*/) noexcept override {}
  base::Message fault() const override {
    return base::Message::verbatim(
        isFaulty_.load(std::memory_order_relaxed) ? "The encoder has failed." : "");
  }

  /// May be called by any thread.
  void fail() noexcept { isFaulty_.store(true, std::memory_order_relaxed); }

 private:
  haptics::devices::Capabilities capabilities_ =
      haptics::devices::simulated(haptics::devices::punchKind());
  std::atomic<bool> isFaulty_{false};
};

}  // namespace tests
