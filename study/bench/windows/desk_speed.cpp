#include "study/bench/windows/desk_speed.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <vector>

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTemporaryDir>
#include <QTimer>

#include "protocols/load_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/operator_window.h"
#include "study/model/user_error.h"

namespace study::bench {
namespace {

constexpr int kSessions = 20;

/// Processor time of this thread [s].
double processorTimeOfThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A sample of a hand that closes and opens once a second.
haptics::engine::TickSample strokeAt(std::uint64_t tick) {
  const double phase = 0.00628 * static_cast<double>(tick);
  haptics::engine::TickSample sample;
  sample.tick = tick;
  sample.travel = 6.0 - 6.0 * std::cos(phase);
  sample.velocity = 37.7 * std::sin(phase);
  sample.force = std::max(0.0, 0.8 * (sample.travel - 4.0));
  return sample;
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

/// Adds the waiting times of every page of one session [ms]. Trials are skipped.
void measureSession(gui::OperatorWindow& window, std::vector<double>& waits) {
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
    QCoreApplication::processEvents();  // everything else that timers do
  }
  window.close();
}

}  // namespace

PlotSpeed measurePlots(double seconds) {
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
  return {shown / past, (processorTimeOfThread() - before) / past};
}

std::vector<double> measurePageChanges(const std::string& folder) {
  const QTemporaryDir place(
      QString::fromStdString(folder) + QStringLiteral("/palpate-bench-XXXXXX"));
  if (!place.isValid()) throw UserError(folder + " takes no folder for the measurement.");
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
    measureSession(window, waits);
  }
  return waits;
}

}  // namespace study::bench
