// The measurements of `palpate-bench devices`: a loop in this program, with emulators in separate
// processes.
#include "study/bench/devices.h"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "haptics/devices/device.h"
#include "haptics/devices/iiwa/iiwa_device.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/timing/monotonic_clock.h"
#include "study/app/devices/emulator_process.h"
#include "study/model/user_error.h"
#include "study/trial/hardware_device_set.h"

namespace study::bench {
namespace {

namespace devices = haptics::devices;
using app::EmulatorProcess;
using app::valueIn;
namespace timing = haptics::timing;
using haptics::bench::LinkLoop;
using haptics::bench::LinkRun;

void pauseFor(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

/// Gives all threads of a process real-time priority, if permitted, because a real board does not
/// wait for a processor core.
void raisePriority(const EmulatorProcess& process) {
  const auto threads = "/proc/" + std::to_string(process.id()) + "/task";
  for (const auto& entry : std::filesystem::directory_iterator(threads)) {
    const auto thread = static_cast<pid_t>(std::stoi(entry.path().filename().string()));
    timing::raisePriority(timing::kEmulatorPriority, thread);
  }
}

/// Gives this thread real-time priority, if permitted, while the object exists.
class RealtimePriority {
 public:
  RealtimePriority() { timing::raisePriority(timing::kObserverPriority); }
  ~RealtimePriority() {
    const sched_param none{};
    sched_setscheduler(0, SCHED_OTHER, &none);
  }
  RealtimePriority(const RealtimePriority&) = delete;
  RealtimePriority& operator=(const RealtimePriority&) = delete;
};

/// The keys and values in an emulator's answer to "status".
struct StatusKeys {
  std::string_view forceKey, noForce;  ///< key of the force, and its value without force
  std::string_view armedKey, armed;    ///< key of the arming state, and its value when armed
  std::string_view sent;
  std::string_view faultPrefix;  ///< prefix of FrameFaults::kNames
};
constexpr StatusKeys kSerialStatus{"voltage_mv", "0", "armed", "1", "steps", ""};
constexpr StatusKeys kFriStatus{
    "overlay", "off", "state", "commanding-active", "sent", "injected_"};

/// An emulator and the device that is connected to it.
class EmulatedDevice {
 public:
  static EmulatedDevice punch(int rate) {
    return {
        "punch",
        static_cast<double>(rate),
        kSerialStatus,
        app::emulatedDevice(
            haptics::devices::punchKind(), "punch", {"--rate", std::to_string(rate)})};
  }

  /// @param period  interval between messages [ms].
  static EmulatedDevice arm(int period, const std::string& version = "1.15") {
    auto emulated = app::emulatedDevice(
        haptics::devices::reamerKind(),
        "arm",
        {"--period", std::to_string(period), "--fri-version", version});
    auto& settings = std::get<devices::IiwaSettings>(emulated.entry.settings);
    settings.version = haptics::wire::fri::versionNamed(version).value_or(settings.version);
    return {"arm", 1000.0 / period, kFriStatus, std::move(emulated)};
  }

  const std::string& name() const noexcept { return name_; }
  double rate() const noexcept { return rate_; }  ///< [Hz]
  devices::Device& device() { return *devices_.find(name_); }

  void sendCommand(const std::string& line) {
    if (!emulator_->ask(line).starts_with("ok"))
      throw UserError("An emulator refused the command " + line);
  }

  /// The present state of the emulated device.
  struct EmulatedState {
    bool hasForce = false;
    double force = 0.0;  ///< [N]
    bool isArmed = false;
    std::uint64_t sent = 0;
    FrameFaults injected;
  };
  EmulatedState ask() {
    const std::string status = emulator_->ask("status");
    if (status.empty())
      throw UserError("The emulator of the " + name_ + " does not answer any more.");
    EmulatedState now;
    now.hasForce = valueIn(status, keys_.forceKey) != keys_.noForce;
    now.force = std::abs(std::stod(valueIn(status, "force_n")));
    now.isArmed = valueIn(status, keys_.armedKey) == keys_.armed;
    now.sent = std::stoull(valueIn(status, keys_.sent));
    for (std::size_t i = 0; i < now.injected.of.size(); ++i) {
      const auto key = std::string(keys_.faultPrefix) + std::string(FrameFaults::kNames[i]);
      now.injected.of[i] = std::stoll(valueIn(status, key));
    }
    return now;
  }

 private:
  EmulatedDevice(std::string name, double rate, StatusKeys keys, app::EmulatedDevice emulated)
      : name_(std::move(name)),
        rate_(rate),
        keys_(keys),
        emulator_(std::move(emulated.emulator)),
        devices_({emulated.entry}, {}) {
    raisePriority(*emulator_);
  }

  std::string name_;
  double rate_;
  StatusKeys keys_;
  std::unique_ptr<EmulatorProcess> emulator_;
  HardwareDeviceSet devices_;
};

FrameFaults operator-(const FrameFaults& a, const FrameFaults& b) {
  FrameFaults difference;
  for (std::size_t i = 0; i < a.of.size(); ++i) difference.of[i] = a.of[i] - b.of[i];
  return difference;
}

FrameFaults& operator+=(FrameFaults& a, const FrameFaults& b) {
  for (std::size_t i = 0; i < a.of.size(); ++i) a.of[i] += b.of[i];
  return a;
}

/// The faults that the link detected. A damaged frame also counts as lost.
FrameFaults faultsDetectedBy(const devices::LinkReport& link) {
  const auto number = [](std::uint64_t n) { return static_cast<std::int64_t>(n); };
  return {
      {number(link.lost) - number(link.damaged),
       number(link.doubled),
       number(link.late),
       number(link.damaged)}};
}

/// Waits until samples arrive. Samples that are lost before the first one do not count.
void waitForSamples(const EmulatedDevice& emulated) {
  pauseFor(20.0 / emulated.rate());
}

/// Runs a loop on a device. If the device fails, connects it again as an operator would.
class SupervisedLoop {
 public:
  enum class Start {
    AsInStudies,  ///< with normal priority, as in studies: on a loaded machine the thread may be
                  ///< delayed
    Urgent,       ///< with real-time priority, if permitted
  };

  explicit SupervisedLoop(EmulatedDevice& emulated, Start start = Start::AsInStudies)
      : emulated_(emulated), start_(start) {
    series_ = {.device = emulated.name(), .rate = emulated.rate()};
    emulated_.device().open();
    begin();
  }

  LinkLoop& loop() noexcept { return *loop_; }

  /// Must be called repeatedly. Returns true if the device had failed and was connected again.
  bool reconnectIfFailed() {
    if (!loop_->isOver()) return false;
    endRun();
    constexpr int kTries = 3;
    for (int i = 1; !loop_; ++i) {
      try {
        emulated_.device().open();
        begin();
      } catch (const devices::DeviceError&) {
        if (i == kTries) throw;
      }
    }
    return true;
  }

  LinkSeries finish() {
    endRun();
    return std::move(series_);
  }

 private:
  void begin() {
    std::optional<RealtimePriority> urgent;
    if (start_ == Start::Urgent) urgent.emplace();
    loop_.emplace(emulated_.device());
    urgent.reset();
    sentBefore_ = emulated_.ask().sent;
    waitForSamples(emulated_);
  }

  void endRun() {
    series_.sent += emulated_.ask().sent - sentBefore_;
    series_.runs.push_back(loop_->finish());
    loop_.reset();
  }

  EmulatedDevice& emulated_;
  Start start_;
  LinkSeries series_;
  std::uint64_t sentBefore_ = 0;
  std::optional<LinkLoop> loop_;
};

constexpr double kSupervisionPeriod = 0.005;  // [s] between two calls of reconnectIfFailed()

/// Lets all loops run for @p seconds.
void superviseFor(double seconds, const std::vector<SupervisedLoop*>& all) {
  const std::int64_t until = timing::now() + static_cast<std::int64_t>(1e9 * seconds);
  while (timing::now() < until) {
    pauseFor(kSupervisionPeriod);
    for (auto* one : all) one->reconnectIfFailed();
  }
}

std::vector<LinkSeries> runTogether(double seconds) {
  std::fprintf(stderr, "both devices at once, %g s\n", seconds);
  auto punch = EmulatedDevice::punch(1000);
  auto arm = EmulatedDevice::arm(5);
  SupervisedLoop slow(arm);  // first, because it takes longer until it accepts forces
  SupervisedLoop fast(punch);
  superviseFor(seconds, {&fast, &slow});
  auto first = fast.finish();
  return {std::move(first), slow.finish()};
}

/// Waits for the requested stall of the loop, and measures the time until the device switches its
/// force off.
void watchStall(EmulatedDevice& emulated, LinkLoop& loop, StallSeries& series) {
  constexpr double kPollPeriod = 0.0003;  // [s]
  const RealtimePriority priority;
  while (loop.stalledAt() == 0 && !loop.isOver()) pauseFor(kPollPeriod);
  const std::int64_t begin = loop.stalledAt();
  if (begin == 0) return;
  ++series.stalls;
  const auto standing = emulated.ask();
  bool hadForce = standing.hasForce;
  if (hadForce) series.forces.push_back(standing.force);
  const std::int64_t end = begin + static_cast<std::int64_t>(1e6 * series.duration);
  while (timing::now() < end) {
    pauseFor(kPollPeriod);
    const bool hasForce = emulated.ask().hasForce;
    const std::int64_t at = timing::now();
    if (!hadForce || hasForce || at >= end) continue;
    series.motorOffAfter.push_back(1e-6 * static_cast<double>(at - begin));
    hadForce = false;  // only the first switch-off counts
  }
  pauseFor(0.05);
}

StallSeries measureStalls(EmulatedDevice emulated, double milliseconds, int stalls) {
  std::fprintf(stderr, "%s, stalls of %g ms\n", emulated.name().c_str(), milliseconds);
  StallSeries series{.duration = milliseconds};
  SupervisedLoop supervised(emulated, SupervisedLoop::Start::Urgent);
  for (int i = 0; i < stalls; ++i) {
    superviseFor(0.8, {&supervised});
    supervised.loop().orderStall(static_cast<std::int64_t>(1e6 * milliseconds));
    watchStall(emulated, supervised.loop(), series);
    if (!emulated.ask().isArmed || supervised.loop().isOver()) ++series.disarmed;
  }
  series.link = supervised.finish();
  return series;
}

LinkSeries runAlone(EmulatedDevice emulated, double seconds) {
  std::fprintf(stderr, "%s at %g Hz\n", emulated.name().c_str(), emulated.rate());
  SupervisedLoop supervised(emulated);
  superviseFor(seconds, {&supervised});
  return supervised.finish();
}

/// Injects @p wanted faults of each kind, @p perRound at a time with a pause after each round,
/// until the device fails. @p perRound must be so small that the link survives a round.
void injectInRounds(EmulatedDevice& emulated, LinkLoop& loop, int wanted, int perRound) {
  constexpr double kPause = 40.0;  // frames: the arm's controller requires that 90 of 100 are
                                   // answered
  const auto begin = emulated.ask().injected;
  for (int done = 0; done < wanted && !loop.isOver();) {
    const int now = std::min(perRound, wanted - done);
    for (const auto& name : FrameFaults::kNames)
      emulated.sendCommand(fmt::format("{} {}", name, now));
    done += now;
    const auto isDone = [&] {
      const auto of = (emulated.ask().injected - begin).of;
      return std::ranges::all_of(of, [&](std::int64_t n) { return n >= done; });
    };
    const std::int64_t until = timing::now() + 10 * timing::kSecond;
    while (!isDone() && !loop.isOver()) {
      if (timing::now() > until)
        throw UserError("An emulator does not inject the faults it was told to.");
      pauseFor(1.0 / emulated.rate());
    }
    pauseFor(kPause / emulated.rate());
  }
}

/// Injects faults of each kind, in blocks of a hundred. If the device fails meanwhile, the block is
/// repeated.
FaultCounts countFaults(EmulatedDevice emulated, int faults, int perRound) {
  constexpr int kPerCount = 100;
  constexpr int kMostRepeated = 20;
  FaultCounts counts{.device = emulated.name()};
  emulated.device().open();
  for (int done = 0; done < faults;) {
    std::fprintf(stderr, "%s, counting: %d of %d\n", emulated.name().c_str(), done, faults);
    const int now = std::min(kPerCount, faults - done);
    std::optional<RealtimePriority> urgent(std::in_place);
    LinkLoop loop(emulated.device());
    urgent.reset();
    waitForSamples(emulated);
    const auto before = emulated.ask().injected;
    injectInRounds(emulated, loop, now, perRound);
    const bool isWhole = !loop.isOver();
    const auto run = loop.finish();
    if (isWhole) {
      counts.injected += emulated.ask().injected - before;
      counts.found += faultsDetectedBy(run.link);
      done += now;
    } else if (++counts.repeated > kMostRepeated) {
      throw UserError("The link fails too often to count on it. " + run.fault);
    } else {
      pauseFor(0.5);  // until the injected faults are over
      emulated.device().open();
    }
  }
  return counts;
}

}  // namespace

double LinkSeries::seconds() const {
  double all = 0.0;
  for (const auto& run : runs) all += run.seconds;
  return all;
}

const LinkRun& LinkSeries::longest() const {
  return *std::ranges::max_element(
      runs, [](const auto& a, const auto& b) { return a.seconds < b.seconds; });
}

std::uint64_t LinkSeries::sum(std::uint64_t devices::LinkReport::*of) const {
  std::uint64_t all = 0;
  for (const auto& run : runs) all += run.link.*of;
  return all;
}

std::int64_t LinkSeries::faults() const {
  return std::ranges::count_if(runs, [](const auto& run) { return !run.fault.empty(); });
}

bool DeviceMeasurement::isExact() const {
  return std::ranges::all_of(
      counts, [](const auto& count) { return count.injected.of == count.found.of; });
}

DeviceMeasurement measureDevices(const DeviceBenchOptions& options) {
  const auto isWanted = [&](const std::string& part) {
    const auto& wanted = options.parts;
    return wanted.empty() || std::ranges::find(wanted, part) != wanted.end();
  };
  DeviceMeasurement measured;
  if (isWanted("together")) measured.together = runTogether(options.seconds);
  if (isWanted("stalls")) {
    const int stalls = static_cast<int>(std::clamp(options.seconds / 4.0, 1.0, 10.0));
    for (const double duration : {5.0, 20.0, 50.0, 100.0}) {
      measured.stalls.push_back(measureStalls(EmulatedDevice::punch(1000), duration, stalls));
      measured.stalls.push_back(measureStalls(EmulatedDevice::arm(5), duration, stalls));
    }
  }
  if (isWanted("rates")) {
    const double seconds = std::min(3.0, options.seconds);
    for (const int rate : {200, 500, 1000, 2000, 4000}) {
      measured.sweep.push_back(runAlone(EmulatedDevice::punch(rate), seconds));
    }
    for (const int period : {5, 3, 2, 1}) {
      measured.sweep.push_back(runAlone(EmulatedDevice::arm(period), seconds));
    }
  }
  if (isWanted("counts")) {
    measured.counts.push_back(countFaults(EmulatedDevice::punch(1000), options.faults, 5));
    // FRI before 2.7 has no checksum, so a damaged byte may go undetected.
    measured.counts.push_back(countFaults(EmulatedDevice::arm(2, "2.7"), options.faults, 1));
  }
  return measured;
}

}  // namespace study::bench
