#include "study/gui/desk/self_test.h"

#include <chrono>
#include <cstdlib>
#include <thread>

#include <QGuiApplication>
#include <QScreen>

#include "study/gui/scene/renderer.h"
#include "study/gui/widgets/desk_language.h"
#include "study/model/study_files.h"
#include "study/model/trial_record.h"
#include "study/model/user_error.h"
#include "study/storage/study_schema.h"
#include "study/trial/hardware_device_set.h"

namespace study::gui {
namespace {

using haptics::devices::CheckResult;
using haptics::devices::Finding;
using haptics::engine::RealtimeLoop;

constexpr double kRate = 1000.0;  // [Hz]
constexpr int kCommits = 40;
constexpr double kPromptCommit = 0.02;  // [s]: not noticeable between pages
constexpr double kSlowCommit = 0.2;     // [s]: clearly noticeable between pages

/// A text of these windows, in the language of the desk.
template <typename... Arguments>
base::Message inWords(std::string_view english, Arguments&&... arguments) {
  return base::Message::verbatim(translated(english, std::forward<Arguments>(arguments)...));
}

std::vector<FindingLine> testDevices(const SelfTestOptions& options, const Progress& progress) {
  const auto own = options.study / kDeviceFileName;
  const std::string file = !options.deviceFile.empty() ? options.deviceFile : own.string();
  if (options.deviceFile.empty() && (options.study.empty() || !std::filesystem::exists(own))) {
    return {
        {"devices",
         {Finding::Pass,
          inWords("device file"),
          inWords("none: devices are virtual, moved with the mouse or the space bar")},
         "",
         false}};
  }
  std::vector<FindingLine> lines;
  const auto anyHand = [](const protocols::DeviceRequirement& need) {
    return simulatedHandFor(need, 1, {}, 0);
  };
  try {
    HardwareDeviceSet deviceSet(loadDevices(file), anyHand);
    for (const auto& entry : deviceSet.entries()) {
      announceProgress(progress, kUnknownShare, translated("listening to {}", entry.id));
      for (auto& result :
           preflight(*deviceSet.find(entry.id), nullptr, entry.id, options.seconds)) {
        result.what =
            base::Message::verbatim(entry.id + ": " + deskText(result.what).toStdString());
        lines.push_back({"devices", std::move(result), ""});
      }
    }
  } catch (const UserError& error) {
    lines.push_back(
        {"devices",
         {Finding::Fail,
          inWords("device file"),
          base::Message::verbatim(error.what()),
          inWords("Correct the device file.")},
         ""});
  }
  return lines;
}

FindingLine testClock(double seconds) {
  // Loads each tick about as much as a scene of a study does.
  volatile double sink = 0.0;
  RealtimeLoop loop({.rate = kRate}, [&sink](double dt, double) {
    for (int i = 0; i < 2000; ++i) sink = sink + dt;
  });
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
  const bool isRealtime = loop.isRealtime();
  return evaluateTiming(loop.finish(), isRealtime, kRate);
}

FindingLine testCommits(const std::filesystem::path& folder) {
  try {
    return evaluateCommitTimes(storage::measureCommits(folder, kCommits), folder.string());
  } catch (const storage::StorageError& error) {
    return {
        "saving",
        {Finding::Fail,
         inWords("saving an answer"),
         base::Message::verbatim(error.what()),
         inWords("Choose a folder that may be written.")},
        ""};
  }
}

FindingLine testFile(const char* what, const std::string& file, const storage::Schema& schema) {
  const auto name = std::filesystem::path(file).filename().string();
  std::string problems;
  try {
    problems = storage::Database::open(file, schema, storage::Database::Access::ReadOnly)
                   .quickCheckProblems();
  } catch (const storage::StorageError& error) {
    problems = error.what();
  }
  if (problems.empty())
    return {"saving", {Finding::Pass, inWords(what), inWords("no damage found")}, name};
  return {
      "saving",
      {Finding::Fail,
       inWords(what),
       inWords("the file {} is damaged", name),
       inWords("Do not go on with it: restore the study from a copy.")},
      problems};
}

constexpr int kLeastWide = 1280;
constexpr int kLeastHigh = 800;
constexpr double kLeastRefresh = 50.0;  // [Hz]

FindingLine judgeScreen(const QScreen& screen) {
  const QSize size = screen.geometry().size();
  CheckResult found{
      .what = QGuiApplication::screens().size() < 2
                  ? inWords("your screen")
                  : base::Message::verbatim(screen.name().toStdString()),
      .measured = inWords("{} × {} points", size.width(), size.height())};
  if (size.width() < kLeastWide || size.height() < kLeastHigh) {
    found.finding = Finding::Warn;
    found.fix =
        inWords("The windows need 1280 × 800 points: choose a higher resolution or less scaling.");
  } else if (screen.refreshRate() < kLeastRefresh) {
    found.finding = Finding::Warn;
    found.fix = inWords("Pictures come late: choose a refresh rate of 50 Hz or more.");
  }
  return {
      "screen",
      found,
      translated("scale {:g}, {:.0f} Hz", screen.devicePixelRatio(), screen.refreshRate())};
}

/// Tests which renderer is available by opening one.
FindingLine judgeGraphics() {
  const auto graphics = scene::makeRenderer();
  const bool isFast = graphics.remark.isEmpty();
  return {
      "screen",
      {isFast ? Finding::Pass : Finding::Warn,
       inWords("pictures of simulations"),
       inWords(
           isFast ? "drawn by the graphics card"
                  : "drawn by the processor: complete, but coarser and slower"),
       isFast ? base::Message()
              : inWords("To have a graphics card draw them, sit at the computer itself instead of "
                        "a remote desktop, and install the card's driver.")},
      translated("drawn by {}", graphics.renderer->name().toStdString())};
}

}  // namespace

FindingLine evaluateTiming(const RealtimeLoop::Report& report, bool isRealtime, double rate) {
  constexpr double kRoughShare = 0.05;
  const auto ticks = static_cast<std::int64_t>(report.ticks);
  const auto late = static_cast<std::int64_t>(report.lateTicks);
  CheckResult found{.what = inWords("timing of forces"), .measured = {}};
  const char* words = "good: {} of {} updates of the force came late";
  if (static_cast<double>(late) > kRoughShare * static_cast<double>(ticks)) {
    words = "poor: {} of {} updates of the force came late";
    found.finding = Finding::Fail;
    found.fix = inWords("Forces would feel rough. Close other programs, or use another computer.");
  } else if (isOftenLate(late, ticks)) {
    words = "fair: {} of {} updates of the force came late";
    found.finding = Finding::Warn;
    found.fix = inWords("Trials would be marked. Close other programs; leave power saving off.");
  } else if (!isRealtime) {
    found.finding = Finding::Warn;
    found.fix = inWords(
        "Other programs can delay forces. Allow real-time priority: the page on devices, \"Real "
        "time\", says how.");
  }
  found.measured = inWords(words, late, ticks);
  return {
      "timing",
      found,
      translated(
          "{:g} Hz for {:.1f} s: late by {:.0f} µs (median), {:.0f} µs (99 of 100), {:.0f} µs "
          "(latest); {}",
          rate,
          report.seconds,
          report.lateness.quantile(0.5),
          report.lateness.quantile(0.99),
          report.lateness.largest(),
          translated(isRealtime ? "real-time priority" : "ordinary priority"))};
}

FindingLine evaluateCommitTimes(const storage::CommitTimes& times, const std::string& folder) {
  CheckResult found{.what = inWords("saving an answer"), .measured = {}};
  const char* words = "fast: {:.1f} ms";
  if (times.median > kSlowCommit) {
    words = "very slow: {:.0f} ms";
    found.finding = Finding::Fail;
    found.fix = inWords("Every page would wait. Put the study on a disk inside this computer.");
  } else if (times.median > kPromptCommit) {
    words = "slow: {:.0f} ms";
    found.finding = Finding::Warn;
    found.fix = inWords("Pages come slowly. A disk inside this computer, an SSD, is faster.");
  }
  found.measured = inWords(words, 1e3 * times.median);
  return {
      "saving",
      found,
      translated(
          "median of {}; longest {:.1f} ms; in {}", times.commits, 1e3 * times.longest, folder)};
}

std::vector<FindingLine> testComputer(const SelfTestOptions& options, const Progress& progress) {
  auto lines = testDevices(options, progress);
  announceProgress(progress, kUnknownShare, "testing the timing: a thousand steps a second");
  lines.push_back(testClock(options.seconds));
  announceProgress(progress, kUnknownShare, "writing to the disk");
  const char* home = std::getenv("HOME");  // NOLINT(concurrency-mt-unsafe): no thread sets it
  lines.push_back(testCommits(
      !options.study.empty() ? options.study
                             : std::filesystem::path(home == nullptr ? "." : home)));
  if (options.study.empty()) return lines;
  announceProgress(progress, kUnknownShare, "looking through the databases");
  const StudyFiles files{options.study};
  lines.push_back(testFile("answers", files.study(), storage::studySchema()));
  lines.push_back(testFile("recordings", files.traces(), storage::traceSchema()));
  lines.push_back(testFile("file of names", files.identity(), storage::identitySchema()));
  return lines;
}

std::vector<FindingLine> testScreens() {
  std::vector<FindingLine> lines;
  const auto screens = QGuiApplication::screens();
  for (const auto* screen : screens) lines.push_back(judgeScreen(*screen));
  if (screens.size() < 2) {
    lines.push_back(
        {"screen",
         {Finding::Warn,
          inWords("participant's screen"),
          inWords("there is one screen only"),
          inWords("Connect a second one: the participant's window goes there by itself.")},
         ""});
  }
  lines.push_back(judgeGraphics());
  return lines;
}

}  // namespace study::gui
