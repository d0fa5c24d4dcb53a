#include "study/app/desk_bench.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QStorageInfo>
#include <QTemporaryDir>
#include <QTimer>

#include "protocols/load_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/operator_window.h"

namespace study::app {
namespace {

constexpr double kMostOfACore = 0.10;
constexpr double kLongestPageChange = 50.0;  // [ms], 99 % of them
constexpr int kSessions = 20;

/// Of this thread [s].
double processorTimeOfThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Somebody who closes and opens once a second.
haptics::engine::TickSample strokeAt(std::uint64_t tick) {
  const double phase = 0.00628 * static_cast<double>(tick);
  haptics::engine::TickSample sample;
  sample.tick = tick;
  sample.travel = 6.0 - 6.0 * std::cos(phase);
  sample.velocity = 37.7 * std::sin(phase);
  sample.force = std::max(0.0, 0.8 * (sample.travel - 4.0));
  return sample;
}

bool benchPlots(double seconds) {
  constexpr int kPictureEvery = 16;  // [ms]
  gui::LivePlot plot;
  plot.resize(760, 260);
  plot.show();
  QEventLoop loop;
  QTimer pictures;
  QElapsedTimer clock;
  std::uint64_t tick = 0;
  int shown = 0;
  QObject::connect(&pictures, &QTimer::timeout, &plot, [&] {
    for (; tick < static_cast<std::uint64_t>(clock.elapsed()); ++tick) plot.add(strokeAt(tick));
    plot.refresh();
    ++shown;
  });
  pictures.setTimerType(Qt::PreciseTimer);
  QTimer::singleShot(static_cast<int>(1000.0 * seconds), &loop, &QEventLoop::quit);
  const double before = processorTimeOfThread();
  clock.start();
  pictures.start(kPictureEvery);
  loop.exec();
  const double past = 1e-3 * static_cast<double>(clock.elapsed());
  const double share = (processorTimeOfThread() - before) / past;
  const bool isCheap = share <= kMostOfACore;
  std::printf(
      "\nLive plots, three channels of %.0f s at 1 kHz\n"
      "  pictures a second   %7.1f\n"
      "  of a core           %7.1f %%   at most %.0f %%   %s\n",
      gui::LivePlot::kShown,
      shown / past,
      100.0 * share,
      100.0 * kMostOfACore,
      isCheap ? "PASS" : "MISSED");
  std::fflush(stdout);
  return isCheap;
}

void answerAll(gui::SessionController& controller, const SimulatedParticipant& person) {
  const auto& session = controller.session();
  int place = 0;
  for (const auto& item : session.items()) {
    const auto response = person.answer(session, item);
    ++place;
    if (!response) continue;
    controller.answer(
        {.item = item.id,
         .response = *response,
         .itemOrder = place,
         .language = session.language()});
  }
  while (session.step().kind == StepKind::Benchmark &&
         session.benchmarkCuts() < session.step().minimumCuts) {
    controller.countBenchmarkCut();
  }
}

/// From pressing Next until the page after it is drawn [ms], of every page of one session. Nothing
/// is felt: trials are skipped.
void goThroughASession(gui::OperatorWindow& window, std::vector<double>& waits) {
  auto& controller = *window.controller();
  const auto& session = controller.session();
  const auto& truth = session.protocol().protocol.simulation;
  const SimulatedParticipant person(
      truth, 1, session.cohort(), static_cast<std::uint64_t>(session.slot()));
  while (!session.isOver()) {
    const bool isTrial = session.step().kind == StepKind::Trial;
    if (!isTrial) answerAll(controller, person);
    QElapsedTimer clock;
    clock.start();
    isTrial ? controller.skipStep(QStringLiteral("nothing is felt in a measurement"))
            : controller.finishStep();
    QCoreApplication::sendPostedEvents();
    window.participantWindow()->repaint();
    waits.push_back(1e-6 * static_cast<double>(clock.nsecsElapsed()));
    QCoreApplication::processEvents();  // the rest: what goes on by timers
  }
  window.close();
}

double quantile(std::vector<double> values, double q) {
  const auto place = static_cast<std::size_t>(q * static_cast<double>(values.size() - 1));
  std::nth_element(
      values.begin(), values.begin() + static_cast<std::ptrdiff_t>(place), values.end());
  return values[place];
}

bool benchPages(const QString& folder) {
  const QTemporaryDir place(folder + QStringLiteral("/palpate-bench-XXXXXX"));
  if (!place.isValid()) {
    std::fprintf(stderr, "%s takes no folder for the measurement.\n", qPrintable(folder));
    return false;
  }
  SystemClock clock;
  questionnaires::Problems problems;
  const auto protocol = protocols::loadProtocolFile("punch-face-validity", problems);
  auto study =
      Study::create(place.filePath(QStringLiteral("study")).toStdString(), *protocol, clock, 1);
  std::vector<double> waits;
  for (int i = 0; i < kSessions; ++i) {
    gui::OperatorWindow window(study);
    window.show();
    window.enrol(
        {.cohort = protocol->protocol.cohorts.front().id,
         .runMode = RunMode::Pilot,
         .language = "en",
         .code = {}});
    goThroughASession(window, waits);
  }
  const double p99 = quantile(waits, 0.99);
  const bool isQuick = p99 <= kLongestPageChange;
  std::printf(
      "\nPages of a participant, answers on the disk first (%s)\n"
      "  page changes        %7zu\n"
      "  each                %7.1f ms (median), %.1f ms (99 %%)   at most %.0f ms   %s\n",
      QStorageInfo(place.path()).fileSystemType().constData(),
      waits.size(),
      quantile(waits, 0.5),
      p99,
      kLongestPageChange,
      isQuick ? "PASS" : "MISSED");
  std::fflush(stdout);
  return isQuick;
}

}  // namespace

bool benchDesk(double seconds, const QString& folder) {
  const bool isCheap = benchPlots(seconds);
  return benchPages(folder) && isCheap;
}

}  // namespace study::app
