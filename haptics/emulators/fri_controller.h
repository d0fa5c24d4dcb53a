#pragma once

#include <array>
#include <cstdint>
#include <mutex>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>

#include "haptics/devices/datagram_socket.h"
#include "haptics/emulators/fri_answers.h"
#include "haptics/emulators/fri_arm.h"
#include "haptics/emulators/fri_monitoring.h"
#include "haptics/emulators/fri_orders.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/emulators/impairment.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// CLOCK_MONOTONIC of this machine [ns].
std::int64_t monotonicTime() noexcept;

/// Emulates the robot controller's side of KUKA's Fast Robot Interface, with a simulated arm and
/// surgeon, without code of KUKA's. It is not a model of KUKA's timing, nor a safety device.
///
/// Each period one message goes out, and the arm moves for a period with the last command; answers
/// are judged as they come. A forbidden command ends the motion at once, and missing commands end
/// it at the next period: the overlay becomes zero, and the arm is held at its position. Thresholds
/// are with ConnectionQuality, states and their rules with FriSession, limits with FriLimits.
///
/// One thread steps and receives, or runs; any thread commands and asks for the report. After
/// construction step() and receive() neither allocate, throw nor wait for another thread.
class FriController {
 public:
  struct Options {
    wire::fri::Version version = wire::fri::Version::V1_15;
    devices::Endpoint client{.port = 30200};
    devices::Endpoint local;  ///< port 0: any that is free
    /// Without it client and local address must be in 127.0.0.0/8.
    bool allowsOtherHosts = false;
    int sendPeriod = 5;         ///< [ms], 1 to 100
    int receiveMultiplier = 1;  ///< the receive period, that many send periods, is 100 ms at most
    FriArm::Options arm;
    FriLimits limits;
    FriSession::Stay stay;
    bool queuesAgain = false;        ///< the program tries again after a motion that failed
    Impairment::Options impairment;  ///< random faults, and their seed
    std::int64_t (*clock)() noexcept = monotonicTime;  ///< [ns], for latencies and zeroAt
  };

  /// @throws std::invalid_argument  if the options are not valid.
  /// @throws devices::NetworkError  if the local address cannot be had.
  explicit FriController(const Options& options);

  /// One period: takes orders, advances the state, sends a message, moves the arm.
  void step() noexcept;

  /// Takes one datagram, if one comes before @p deadline [ns of the clock]; false if none does.
  bool receive(std::int64_t deadline) noexcept;

  /// Steps every send period, and receives in between, until @p stop asks to end.
  void run(const std::stop_token& stop) noexcept;

  /// Any thread. Takes one line, effective from the next period:
  ///
  /// | line                  | what happens                                                     |
  /// |-----------------------|------------------------------------------------------------------|
  /// | drop N                | N messages are not sent                                          |
  /// | double N              | N are sent twice                                                 |
  /// | reorder N             | N change places with their successors                            |
  /// | delay N MS            | N are sent MS later (rounded up to periods)                      |
  /// | garbage N             | before N messages comes a datagram of chance                     |
  /// | damage N              | in N messages a byte is another; before 2.7 it may go unnoticed  |
  /// | stall MS              | nothing is sent; the time counts as unanswered                   |
  /// | wrong-version         | frames as another version from now on; once more: no longer      |
  /// | six-joints N          | N messages have six measured joints                              |
  /// | nan N                 | in N messages a measured joint is no number                      |
  /// | quality poor, good    | Poor is sent and acted upon in place of the measured; no longer  |
  /// | safety-stop           | stops; drives off, until safety-reset                            |
  /// | impostor N            | with N messages comes another from another port                  |
  /// | motion                | the program queues its motion again                              |
  /// | idle                  | the session ends                                                 |
  /// | restart               | the controller starts again, counters from 0                     |
  /// | status                | nothing; the reply is status()                                   |
  struct Reply {
    bool isTaken = false;
    std::string text;  ///< the status, or in a sentence why the line was not taken
  };
  Reply command(std::string_view line);

  /// Any thread: as of the last step or datagram.
  FriReport report() const;
  /// The report in one line of key=value.
  std::string status() const;

  const devices::Endpoint& local() const noexcept { return socket_.local(); }
  /// Where impostor datagrams come from.
  const devices::Endpoint& impostor() const noexcept { return impostor_.local(); }
  const Options& options() const noexcept { return options_; }

 private:
  using Buffer = std::array<std::uint8_t, wire::fri::kLargestDatagram + 1>;

  void takeOrders() noexcept;
  void closePeriod() noexcept;
  void goOn() noexcept;
  void sendMessage() noexcept;
  void sendImpostor(const wire::fri::MonitoringMessage& message) noexcept;
  void hand(std::span<std::uint8_t> datagram, wire::fri::Version framing) noexcept;
  bool corrupt(std::span<std::uint8_t> datagram, wire::fri::Version framing) noexcept;
  void readImpostor() noexcept;
  void take(std::span<const std::uint8_t> datagram) noexcept;
  void act(const wire::fri::CommandMessage& answer) noexcept;
  void stopMotion(FriEndReason end, int joint = 0) noexcept;
  void brake() noexcept;
  void restart() noexcept;
  void noteOverlay() noexcept;
  void publish() noexcept;
  wire::fri::ConnectionQuality quality() const noexcept;

  Options options_;
  devices::DatagramSocket socket_;
  devices::DatagramSocket impostor_;
  Impairment impairment_;
  FriOrders orders_;
  FriArm arm_;
  FriCommandCheck judge_;
  FriSession session_;
  FriAnswers answers_;
  ConnectionQuality connection_;
  wire::fri::CommandMessage answer_;
  wire::fri::Joints lastPosition_{};  ///< that was commanded [rad]
  int sinceCommand_ = 1;              ///< periods since lastPosition_
  int sinceAnswered_ = 0;             ///< periods since the message that was last answered
  int inBlock_ = 0;                   ///< periods of the present receive period
  bool isBlockAnswered_ = false;
  int missed_ = 0;  ///< answers in a row
  bool isWrongVersion_ = false;
  bool hadOverlay_ = false;
  Buffer out_{};
  Buffer in_{};
  Buffer impostorOut_{};
  FriReport report_;  ///< the stepping thread's
  mutable std::mutex gate_;
  FriReport published_;  ///< shared between threads, behind the mutex
};

}  // namespace haptics::emulators
