#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/devices/datagram_socket.h"
#include "haptics/emulators/fri_controller.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/fri_message.h"

namespace tests {

/// The smallest client of a robot's controller: answers what it can read and counts the rest. It
/// protects nobody.
class AnsweringClient {
 public:
  struct Seen {
    std::uint64_t datagrams = 0;
    std::uint64_t sound = 0;
    std::uint64_t doubled = 0;
    std::uint64_t late = 0;
    std::uint64_t foreign = 0;  ///< not from the controller
    std::uint64_t malformed = 0;
    std::uint64_t jointCount = 0;
    std::uint64_t notFinite = 0;
  };

  explicit AnsweringClient(haptics::wire::fri::Version version) : version_(version) {}

  const haptics::devices::Endpoint& endpoint() const { return socket_.local(); }
  void expect(const haptics::devices::Endpoint& controller) { controller_ = controller; }

  /// Takes one datagram, for which it waits at most @p wait [ns], and answers it if it should.
  bool hear(std::int64_t wait);
  /// Takes one and does not answer.
  bool overhear(std::int64_t wait);

  /// Numbers below the highest that never came.
  std::uint64_t missing() const;
  const Seen& seen() const { return seen_; }
  const haptics::wire::fri::MonitoringMessage& message() const { return message_; }
  std::uint64_t answers() const { return answers_; }
  void send(const haptics::wire::fri::CommandMessage& command);
  /// What it would answer to the last message.
  haptics::wire::fri::CommandMessage answer() const;

  std::optional<haptics::wire::fri::Vector6> wrench;
  std::optional<haptics::wire::fri::Joints> torque;
  double offset = 0.0;         ///< added to the position of joint 7 while active [rad]
  std::uint32_t every = 1;     ///< answers each so manieth message
  std::uint32_t sequence = 0;  ///< of its next answer

 private:
  bool isForAnswer() const;
  void note(haptics::wire::fri::Refusal refusal);
  void follow(std::uint32_t number);

  haptics::wire::fri::Version version_;
  haptics::devices::DatagramSocket socket_{haptics::devices::Endpoint{}};
  haptics::devices::Endpoint controller_;
  haptics::wire::fri::MonitoringMessage message_;
  Seen seen_;
  std::vector<int> arrived_;
  std::uint32_t next_ = 0;
  std::uint64_t answers_ = 0;
};

}  // namespace tests
