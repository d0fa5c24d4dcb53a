#include "study/app/devices/device_rehearse.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "haptics/devices/device.h"
#include "haptics/timing/standstill_watch.h"
#include "study/app/command_options.h"
#include "study/app/devices/device_report.h"
#include "study/app/devices/emulator_process.h"
#include "study/app/simulated_endings.h"
#include "study/cohort/simulated_participant.h"
#include "study/model/user_error.h"
#include "study/session/verification.h"
#include "study/storage/event_log.h"
#include "study/storage/records.h"
#include "study/trial/hardware_device_set.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

namespace fs = std::filesystem;

std::vector<EmulatedDevice> emulatedDevicesFor(
    const protocols::Protocol& protocol, const RehearseArguments& arguments) {
  std::vector<EmulatedDevice> emulated;
  for (const auto& need : protocol.devices) {
    const bool isSerial = need.kind->wire == haptics::devices::Wire::Serial;
    // Firmware has no hand whose movements a seed could choose.
    std::vector<std::string> options{"--seed", std::to_string(arguments.seed)};
    if (isSerial && !arguments.firmware.empty()) options = {"--firmware", arguments.firmware};
    if (isSerial) {
      const auto port = fs::absolute(arguments.out) / (need.id + "-port");
      options.insert(options.end(), {"--link", port.string()});
    }
    emulated.push_back(emulatedDevice(*need.kind, need.id, options));
    fmt::print("Emulating '{}': {}\n", need.id, emulated.back().emulator->ready());
  }
  return emulated;
}

/// The new folder of a rehearsal. The destructor removes it unless something was recorded in it.
class RehearsalFolder {
 public:
  explicit RehearsalFolder(const std::string& path) : path_(path) {
    if (!fs::create_directories(path_)) {
      throw UserError(path + " is there already. Name a folder that is not.");
    }
  }
  ~RehearsalFolder() {
    std::error_code ignored;
    if (!isKept_) fs::remove_all(path_, ignored);
  }
  RehearsalFolder(const RehearsalFolder&) = delete;
  RehearsalFolder& operator=(const RehearsalFolder&) = delete;

  void keep() noexcept { isKept_ = true; }

 private:
  fs::path path_;
  bool isKept_ = false;
};

/// Checks the emulated devices and prints the findings. Repeats the check if the computer stalled
/// during it. Returns whether all checks passed.
bool runDeviceCheck(
    const std::string& deviceFile,
    const protocols::Protocol& protocol,
    const RehearseArguments& arguments,
    haptics::timing::StandstillWatch& watch) {
  constexpr int kMostChecks = 5;
  for (int i = 1;; ++i) {
    watch.restart();
    HardwareDeviceSet deviceSet(
        loadDevices(deviceFile), [&](const protocols::DeviceRequirement& need) {
          return simulatedHandFor(need, arguments.seed, {}, 0);
        });
    const auto found = checkAll(deviceSet, &protocol, 2.0);
    std::fputs(checksAsText(found).c_str(), stdout);
    if (isFit(found)) return true;
    if (watch.longest() < kDeviceTimeout || i == kMostChecks) return false;
    fmt::print(
        "This computer stood still for {} ms during the check: checked again.\n",
        watch.longest().count());
  }
}

/// Prints the final sentence of a failed rehearsal. Returns the exit status.
int failed(const haptics::timing::StandstillWatch& watch, const std::string& what) {
  const auto verdict = verdictOf(false, watch.longest());
  if (verdict == RehearsalVerdict::Inconclusive) {
    fmt::print(
        "REHEARSAL NOT JUDGED: this computer stood still for {} ms; a device waits {} ms. End "
        "other "
        "programs, and try again. What went wrong meanwhile: {}\n",
        watch.longest().count(),
        kDeviceTimeout.count(),
        what);
  } else {
    fmt::print("REHEARSAL FAILED: {}\n", what);
  }
  return static_cast<int>(verdict);
}

/// The text of an event for the terminal, without the clock offset of a link.
std::string terminalTextOf(const storage::Event& event) {
  if (event.kind != EventKind::DeviceLink) return storage::describe(event);
  constexpr std::string_view kLink =
      "received {received}, lost {lost}, doubled {doubled}, late {late}, damaged {damaged}, "
      "foreign {foreign}, restarts {restarts}, skipped {skipped}, stale {stale}, poor {poor}, "
      "unsent {unsent}, clipped {clipped}, expired {expired}; round trip p50 {trip_p50_us:.0f} "
      "us, p99 {trip_p99_us:.0f} us, largest {trip_max_us:.0f} us";
  std::string words = base::filled(kLink, event.values);
  const auto add = [&](std::string_view value, std::string_view pattern) {
    if (event.value(value) != nullptr) words += base::filled(pattern, event.values);
  };
  add("drift_ppm", ", drift {drift_ppm:+.2f} ppm");
  add("leaps", ", leaps of the position {leaps}");
  return words;
}

void printLinks(Study& study) {
  for (const auto& event : study.events().read(std::nullopt)) {
    if (event.kind != EventKind::DeviceLink && event.kind != EventKind::DeviceFault) continue;
    const auto visit = event.visit.value_or(VisitKey{});
    fmt::print(
        "session {} step {} attempt {}: {}\n",
        static_cast<std::int64_t>(visit.session),
        visit.step,
        visit.attempt,
        terminalTextOf(event));
  }
}

/// Runs the simulated participants. @throws DeviceError  if a device could not be connected again.
std::vector<SimulatedSessionResult> runParticipants(
    Study& study,
    SimulatedClock& clock,
    const RehearseArguments& arguments,
    const std::string& deviceFile,
    haptics::timing::StandstillWatch& watch) {
  const auto printEvent = [](const SimulationEvent& done) {
    using Kind = SimulationEvent::Kind;
    if (done.kind == Kind::Answer || done.kind == Kind::Enrolment) return;
    fmt::print("{}\n", done.what);
    std::fflush(stdout);
  };
  auto endings = simulateCohorts(
      study, clock, arguments.participants, arguments.seed, printEvent, deviceFile, &watch);
  printLinks(study);
  return endings;
}

/// Whether all that was found about a trial is what a busy computer causes, which is no fault of
/// the devices. Lateness adds to the damping that passivity requires.
bool isOfBusyComputer(const storage::StoredTrial& trial) {
  constexpr std::array<std::string_view, 5> kReasonsOfLateness{
      "trial.device_silent", "trial.rate", "trial.late", "trial.lost_beats", "trial.damping"};
  return std::ranges::all_of(trial.reasons, [&](const base::Message& reason) {
    return std::ranges::any_of(
        kReasonsOfLateness, [&](std::string_view key) { return reason.key().starts_with(key); });
  });
}

/// Prints the verdict on each trial. Returns how many failed, and not for a busy computer.
std::uint64_t printTrials(Study& study) {
  std::uint64_t failures = 0;
  for (const auto& trial : storage::Records(study.database()).trials()) {
    const auto reasons = base::describe(trial.reasons);
    fmt::print(
        "session {} step {} attempt {}: {}{}{}\n",
        static_cast<std::int64_t>(trial.step.visit.session),
        trial.step.visit.step,
        trial.step.visit.attempt,
        nameOf(trial.verdict),
        reasons.empty() ? "" : ", ",
        reasons);
    if (trial.verdict == Verdict::Fail && !isOfBusyComputer(trial)) ++failures;
  }
  return failures;
}

/// Prints the final sentence. @return the exit status.
int printVerdict(
    Study& study,
    const RehearseArguments& arguments,
    const std::vector<SimulatedSessionResult>& endings,
    const haptics::timing::StandstillWatch& watch) {
  const bool isSound = verify(study).isSound();
  const std::string place = (fs::path(arguments.out) / "study").string();
  const auto firstIncomplete = std::ranges::find_if(
      endings, [](const auto& ending) { return ending.state != SessionState::Completed; });
  if (firstIncomplete != endings.end()) {
    return failed(
        watch,
        fmt::format(
            "{} The study is {}{}.",
            describe(*firstIncomplete),
            place,
            isSound ? "" : " and does NOT verify"));
  }
  if (const auto failures = printTrials(study); failures > 0) {
    return failed(
        watch,
        fmt::format(
            "{} did not pass the checks, for the reasons above. The study is {}.",
            words::counted(failures, "trial"),
            place));
  }
  fmt::print(
      "{} '{}' on emulated devices. The study is {} and {}.\n",
      words::counted(
          static_cast<std::uint64_t>(arguments.participants),
          "simulated participant has completed",
          "simulated participants have completed"),
      arguments.protocol,
      place,
      isSound ? "verifies" : "does NOT verify");
  return static_cast<int>(isSound ? RehearsalVerdict::Passed : RehearsalVerdict::Failed);
}

}  // namespace

RehearsalVerdict verdictOf(bool isPassed, std::chrono::milliseconds longestStall) noexcept {
  if (isPassed) return RehearsalVerdict::Passed;
  return longestStall < kDeviceTimeout ? RehearsalVerdict::Failed : RehearsalVerdict::Inconclusive;
}

int rehearse(const RehearseArguments& arguments) {
  const auto protocol = loadValidProtocol(arguments.protocol);
  RehearsalFolder folder(arguments.out);
  const auto emulated = emulatedDevicesFor(protocol.protocol, arguments);
  const auto deviceFile = fs::path(arguments.out) / kDeviceFileName;
  std::vector<DeviceEntry> entries;
  for (const auto& device : emulated) entries.push_back(device.entry);
  std::ofstream(deviceFile) << devicesAsJson(entries);
  haptics::timing::StandstillWatch watch;
  if (!runDeviceCheck(deviceFile.string(), protocol.protocol, arguments, watch)) {
    return failed(
        watch,
        "the emulated devices did not pass their check. Nothing was recorded, and " +
            arguments.out + " is gone again.");
  }
  watch.restart();
  SimulatedClock clock;
  auto study = Study::create(fs::path(arguments.out) / "study", protocol, clock, arguments.seed);
  folder.keep();
  try {
    const auto endings = runParticipants(study, clock, arguments, deviceFile.string(), watch);
    return printVerdict(study, arguments, endings, watch);
  } catch (const haptics::devices::DeviceError& error) {
    return failed(watch, error.what());
  }
}

}  // namespace study::app
