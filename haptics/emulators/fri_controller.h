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
#include "haptics/emulators/fri_fault_queue.h"
#include "haptics/emulators/fri_monitoring.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/emulators/impairment.h"
#include "haptics/timing/monotonic_clock.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// Emulates the robot controller's side of KUKA's Fast Robot Interface, with a simulated arm and
/// surgeon and without KUKA's code. It does not model KUKA's timing, and is not a safety device.
///
/// Each period it sends one message and moves the arm with the last command; answers are checked
/// when they arrive. A forbidden command ends the motion at once, and missing commands end it at
/// the next period: the overlay becomes zero, and the arm is held at its position. See
/// ConnectionQuality for thresholds, FriSession for the states and FriLimits for limits.
///
/// One thread calls step() and receive(), or run(); any thread may call command() and report().
/// After construction step() and receive() neither allocate, throw nor wait for another thread.
class FriController {
 public:
  struct Options {
    wire::fri::Version version = wire::fri::Version::V1_15;
    devices::Endpoint client{.port = 30200};
    devices::Endpoint local;  ///< port 0: any free port
    /// If false, client and local address must be in 127.0.0.0/8.
    bool allowsOtherHosts = false;
    int sendPeriod = 5;  ///< [ms], 1 to 100
    /// Receive period / send period; the receive period is at most 100 ms.
    int receiveMultiplier = 1;
    FriArm::Options arm;
    FriLimits limits;
    FriSession::DwellTimes dwellTimes;
    bool restartsMotion = false;     ///< the robot's program restarts a motion that failed
    Impairment::Options impairment;  ///< random faults of messages
    std::int64_t (*clock)() noexcept = timing::now;  ///< [ns], for latencies and overlayZeroAt
  };

  /// @throws std::invalid_argument  if the options are not valid.
  /// @throws devices::NetworkError  if the socket cannot be bound to the local address.
  explicit FriController(const Options& options);

  /// Performs one period: executes orders, advances the state, sends a message, moves the arm.
  void step() noexcept;

  /// Processes one datagram, if one arrives before @p deadline [ns of the clock]; returns whether
  /// one did.
  bool receive(std::int64_t deadline) noexcept;

  /// Calls step() every send period, and receive() in between, until @p stop is requested.
  void run(const std::stop_token& stop) noexcept;

  /// Executes a command, effective from the next period. Any thread.
  ///
  /// | line              | effect                                                       |
  /// |-------------------|--------------------------------------------------------------|
  /// | drop N            | the next N messages are not sent                             |
  /// | double N          | N messages are sent twice                                    |
  /// | reorder N         | N messages change places with their successors               |
  /// | delay N MS        | N messages are sent MS later (rounded up to periods)         |
  /// | garbage N         | a datagram of random bytes is sent before each of N messages |
  /// | damage N          | a byte is changed in N messages; undetectable before 2.7     |
  /// | stall MS          | no messages for MS; the time counts as unanswered            |
  /// | wrong-version     | toggles: messages are framed as another version              |
  /// | six-joints N      | N messages have six measured joints                          |
  /// | nan N             | a measured joint is NaN in N messages                        |
  /// | quality poor|good | poor: the quality is Poor; good: it is measured again        |
  /// | safety-stop       | ends the motion, drives are off until safety-reset           |
  /// | impostor N        | N messages are accompanied by a forged one from another port |
  /// | motion            | the program queues its motion again                          |
  /// | idle              | ends the session                                             |
  /// | restart           | restarts the controller, with counters from 0                |
  /// | status            | none; the reply is status()                                  |
  struct Reply {
    bool isAccepted = false;  ///< the command was accepted
    std::string text;         ///< the status, or the reason why the command was not accepted
  };
  Reply command(std::string_view line);

  /// The report after the last step or datagram. Any thread.
  FriReport report() const;
  /// The report as one line of key=value pairs.
  std::string status() const;

  const devices::Endpoint& local() const noexcept { return socket_.local(); }
  /// The address from which impostor datagrams are sent.
  const devices::Endpoint& impostor() const noexcept { return impostor_.local(); }
  const Options& options() const noexcept { return options_; }

 private:
  using Buffer = std::array<std::uint8_t, wire::fri::kLargestDatagram + 1>;

  /// Executes the events that command() has ordered since the last period.
  void executeEvents() noexcept;
  void closePeriod() noexcept;
  /// Advances the session, and lets the arm follow its state.
  void advanceState() noexcept;
  void sendMessage() noexcept;
  void sendImpostor(const wire::fri::MonitoringMessage& message) noexcept;
  /// Passes a datagram to the client, with the faults that are due.
  void passToClient(std::span<std::uint8_t> datagram, wire::fri::Version sentVersion) noexcept;
  bool corrupt(std::span<std::uint8_t> datagram, wire::fri::Version sentVersion) noexcept;
  void readImpostor() noexcept;
  void processDatagram(std::span<const std::uint8_t> datagram) noexcept;
  void execute(const wire::fri::CommandMessage& answer) noexcept;
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
  FriFaultQueue faultQueue_;
  FriArm arm_;
  FriCommandCheck commandCheck_;
  FriSession session_;
  FriAnswerMatcher answers_;
  ConnectionQuality connection_;
  wire::fri::CommandMessage answer_;
  wire::fri::Joints lastPosition_{};  ///< joint position of the last command [rad]
  int periodsSinceCommand_ = 1;       ///< periods since lastPosition_
  int periodsSinceAnswered_ = 0;      ///< periods since the last message that was answered
  int periodsInReceivePeriod_ = 0;    ///< number of periods in the present receive period so far
  bool isReceivePeriodAnswered_ = false;  ///< an answer was accepted in the present receive period
  int missingAnswers_ = 0;                ///< number of consecutive missing answers
  bool isWrongVersion_ = false;
  bool hadOverlay_ = false;
  Buffer sendBuffer_{};
  Buffer receiveBuffer_{};
  Buffer impostorBuffer_{};
  FriReport report_;  ///< used by the stepping thread only
  mutable std::mutex mutex_;
  FriReport published_;  ///< copy for other threads, protected by mutex_
};

}  // namespace haptics::emulators
