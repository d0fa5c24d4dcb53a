#include "study/app/devices/device_emulate.h"

#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <mutex>
#include <thread>

#include "haptics/emulators/fri_controller.h"
#include "haptics/emulators/punch_emulator.h"
#include "haptics/timing/monotonic_clock.h"
#include "study/app/devices/qemu_punch.h"
#include "study/model/user_error.h"

namespace study::app {
namespace {

namespace emulators = haptics::emulators;
namespace timing = haptics::timing;

volatile std::sig_atomic_t isStopRequested = 0;

void end(int) {
  isStopRequested = 1;
}

void printLine(const std::string& line) {
  std::fputs((line + "\n").c_str(), stdout);
  std::fflush(stdout);
}

/// Answers each line of the input by one line, until a signal, the end of the requested time, or
/// "quit". The end of the input ends it only with @p arguments.endsWithInput.
void executeInput(
    const EmulateArguments& arguments,
    const std::string& help,
    const std::function<std::string(const std::string&)>& runCommandLine) {
  struct sigaction action {};
  action.sa_handler = end;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  const double seconds = arguments.seconds;
  std::string buffer;
  bool hasInput = true;
  const std::int64_t until =
      seconds > 0.0 ? timing::now() + static_cast<std::int64_t>(1e9 * seconds) : INT64_MAX;
  while (isStopRequested == 0 && timing::now() < until) {
    pollfd watched{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
    constexpr int kPollPeriod = 50;  // [ms]: longest delay until a signal or the end of the time is
                                     // noticed
    if (poll(&watched, hasInput ? 1 : 0, kPollPeriod) <= 0) continue;
    std::array<char, 512> bytes{};
    const ssize_t count = read(STDIN_FILENO, bytes.data(), bytes.size());
    if (count <= 0) hasInput = false;
    if (!hasInput && arguments.endsWithInput) return;
    if (count > 0) buffer.append(bytes.data(), static_cast<std::size_t>(count));
    for (auto at = buffer.find('\n'); at != std::string::npos; at = buffer.find('\n')) {
      const std::string line = buffer.substr(0, at);
      buffer.erase(0, at + 1);
      if (line == "quit") return;
      if (!line.empty()) printLine(line == "help" ? "There are: " + help : runCommandLine(line));
    }
  }
}

/// Raises the priority of this thread and of the threads that it starts, if permitted, because this
/// thread holds a lock that the emulator's loop needs.
void raiseOwnPriority() {
  timing::raisePriority(timing::kEmulatorPriority);
}

}  // namespace

int emulateSerial(const EmulateArguments& arguments) {
  if (!arguments.firmware.empty()) {
    QemuPunch board(arguments.firmware, arguments.link);
    printLine("ready port=" + board.port() + " qemu_pid=" + std::to_string(board.id()));
    executeInput(
        arguments, QemuPunch::help(), [&](const std::string& line) { return board.command(line); });
    return 0;
  }
  raiseOwnPriority();
  emulators::PunchEmulator::Options options{.kind = arguments.kind, .link = {}};
  options.link = arguments.link;
  options.clockDrift = arguments.clockDrift;
  options.seed = arguments.seed;
  options.limits.rate = static_cast<std::uint16_t>(arguments.rate);
  // keeps the maximum speed in counts per second for rates other than 1 kHz
  options.limits.maxCountsPerStep = options.limits.maxCountsPerStep * 1000 / arguments.rate;
  const auto& hand = arguments.kind->hand;
  options.person.closed = hand.typicalReach;
  options.person.stiffness = arguments.kind->grip.stiffness;
  options.person.damping = arguments.kind->grip.damping;
  options.person.variation = 0.1;
  options.person.seed = arguments.seed;
  emulators::PunchEmulator punch(options);
  std::mutex gate;
  std::jthread loop([&](const std::stop_token& stop) {
    const std::int64_t period = timing::kSecond / options.limits.rate;
    std::int64_t due = timing::now();
    while (!stop.stop_requested()) {
      {
        const std::lock_guard lock(gate);
        punch.step();
      }
      due += period;
      if (timing::now() - due > 100 * period) due = timing::now();  // do not catch up on lost time
      timing::sleepUntil(due);
    }
  });
  printLine("ready port=" + punch.port());
  const std::string help(emulators::PunchEmulator::help());
  executeInput(arguments, help, [&](const std::string& line) {
    const std::lock_guard lock(gate);
    if (line == "status") return punch.status();
    const std::string wrong = punch.command(line);
    return wrong.empty() ? "ok " + line : "error " + wrong;
  });
  return 0;
}

int emulateIiwa(const EmulateArguments& arguments) {
  raiseOwnPriority();
  namespace fri = haptics::wire::fri;
  emulators::FriController::Options options;
  const auto client = haptics::devices::endpointFrom(arguments.client, 30200);
  if (!client) throw UserError("'" + arguments.client + "' is no address such as 127.0.0.1:30200.");
  options.client = *client;
  options.version = fri::versionNamed(arguments.version).value_or(fri::Version::V1_15);
  options.sendPeriod = arguments.period;
  options.restartsMotion = true;
  options.impairment.seed = arguments.seed;
  options.arm.model = arguments.model == "iiwa7" ? haptics::devices::IiwaModel::Iiwa7
                                                 : haptics::devices::IiwaModel::Iiwa14;
  options.arm.person.closeTime = arguments.advance;
  const bool isTorque = arguments.overlay == "torque";
  options.arm.command = isTorque ? fri::ClientCommandMode::Torque : fri::ClientCommandMode::Wrench;
  options.arm.control =
      isTorque ? fri::ControlMode::JointImpedance : fri::ControlMode::CartesianImpedance;
  emulators::FriController controller(options);
  std::jthread loop([&](const std::stop_token& stop) { controller.run(stop); });
  printLine("ready client=" + arguments.client + " local=" + controller.local().text());
  executeInput(arguments, emulators::FriFaultQueue::help(), [&](const std::string& line) {
    const auto reply = controller.command(line);
    if (!reply.isAccepted) return "error " + reply.text;
    return reply.text.empty() ? "ok " + line : reply.text;
  });
  return 0;
}

}  // namespace study::app
