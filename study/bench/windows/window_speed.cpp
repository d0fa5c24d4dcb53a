#include "study/bench/windows/window_speed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <vector>

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

#include "haptics/devices/hand.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "study/app/command_options.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/home/home_window.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/model/user_error.h"
#include "study/trial/live_trial.h"

namespace study::bench {
namespace {

constexpr int kSessions = 20;

/// Processor time of this thread [s].
double processorTimeOfThread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// A sample of a hand that closes and opens the tool once a second.
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
    controller.changeBenchmarkCuts(1);
  }
}

/// Adds the waiting time for each page of one session [ms]. Trials are skipped.
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
    QCoreApplication::processEvents();  // so that pending timers run
  }
  window.close();
}

}  // namespace

PlotSpeed measurePlots(double seconds) {
  constexpr int kPictureInterval = 16;  // [ms]
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
  pictures.start(kPictureInterval);
  loop.exec();
  const double past = 1e-3 * static_cast<double>(clock.elapsed());
  return {shown / past, (processorTimeOfThread() - before) / past};
}

std::vector<double> measurePageChanges(const std::string& folder) {
  const QTemporaryDir place(
      QString::fromStdString(folder) + QStringLiteral("/palpate-bench-XXXXXX"));
  if (!place.isValid()) throw UserError(folder + " takes no folder for the measurement.");
  SystemClock clock;
  const auto protocol = app::loadValidProtocol("punch-face-validity");
  auto study =
      Study::create(place.filePath(QStringLiteral("study")).toStdString(), protocol, clock, 1);
  std::vector<double> waits;
  for (int i = 0; i < kSessions; ++i) {
    gui::OperatorWindow window(study);
    window.show();
    window.enrol(
        {.cohort = protocol.protocol.cohorts.front().id,
         .runMode = RunMode::Pilot,
         .language = "en",
         .code = {}});
    measureSession(window, waits);
  }
  return waits;
}

double measureHome(const std::string& folder, int studies) {
  const QTemporaryDir place(
      QString::fromStdString(folder) + QStringLiteral("/palpate-bench-XXXXXX"));
  if (!place.isValid()) throw UserError(folder + " takes no folder for the measurement.");
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, place.path());
  SystemClock clock;
  const auto protocol = app::loadValidProtocol("punch-face-validity");
  const auto first = place.filePath(QStringLiteral("study")).toStdString();
  Study::create(first, protocol, clock, 1);
  for (int i = 0; i < studies; ++i) {
    const auto copy = place.filePath(QStringLiteral("study-%1").arg(i));
    std::filesystem::copy(first, copy.toStdString(), std::filesystem::copy_options::recursive);
    gui::addRecentStudy(copy, QString::fromStdString(protocol.protocol.study.title));
  }
  QElapsedTimer time;
  time.start();
  gui::HomeWindow home;
  home.show();
  home.grab();
  return 1e-6 * static_cast<double>(time.nsecsElapsed());
}

namespace {

namespace scene = gui::scene;
using haptics::devices::SimulatedDevice;
using haptics::devices::SimulatedHand;

/// A scene, and the hand that moves in it.
struct Subject {
  std::string name;
  std::string picture;  ///< part of the names of image files
  const haptics::devices::DeviceKind* device = nullptr;
  haptics::engine::SceneSpec spec;
  haptics::engine::SafetyLimits limits;
  SimulatedHand::Person person;
  std::unique_ptr<scene::SimulatedScene> scene;
  double buildTime = 0.0;  ///< time to build the scene [ms]
};

Subject kneeSubject(const SimulationOptions& options) {
  Subject subject{
      .name = "punch and knee", .picture = "knee", .device = &haptics::devices::punchKind()};
  subject.spec = {.model = haptics::engine::FiniteElementsSpec{}, .isVisualised = true};
  subject.limits = {.maxForce = 8.0, .maxRate = 3000.0};
  QElapsedTimer clock;
  clock.start();
  subject.scene = std::make_unique<scene::KneeScene>(options.knee ? &*options.knee : nullptr);
  subject.buildTime = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  return subject;
}

/// The built-in bone with @p spheres spheres, whose densities are fitted to the built-in curves.
std::shared_ptr<const haptics::reaming::PackedBone> cupOf(std::size_t spheres) {
  auto bone = std::make_shared<haptics::reaming::PackedBone>();
  std::fprintf(stderr, "packing %zu spheres\n", spheres);
  bone->packing = *pack(haptics::reaming::Acetabulum(), {.count = spheres});
  fitBoneToMaterial(*bone, haptics::engine::parametricCurves(), {}, {.depths = 100});
  return bone;
}

Subject hipSubject(const SimulationOptions& options) {
  Subject subject{
      .name = "reamer and cup", .picture = "hip", .device = &haptics::devices::reamerKind()};
  subject.spec.model = haptics::engine::PackingSpec{
      .bone = cupOf(options.spheres), .hardness = 0.5, .forceScale = 0.15};
  subject.spec.isVisualised = true;
  subject.limits = {.maxForce = 140.0, .maxRate = 5000.0, .maxVelocity = 1.0};
  subject.person = {
      .closed = 0.028,
      .pauseTime = 0.2,
      .closeTime = 1.2,
      .openTime = 0.8,
      .stiffness = 6000.0,
      .damping = 150.0};
  QElapsedTimer clock;
  clock.start();
  subject.scene = std::make_unique<scene::HipScene>(scene::HipScene::Options{
      .packing = haptics::engine::partsOf(subject.spec.model).packing, .colours = options.colours});
  subject.buildTime = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  return subject;
}

scene::TrialSnapshot snapshotOf(const LiveTrial& live, const Trial& trial) {
  const auto status = live.status();
  return {
      .travel = status.travel,
      .force = status.force,
      .isCutThrough = status.isCutThrough,
      .isRunning = true,
      .sampleTime = status.sampleTime,
      .mesh = trial.scene().mesh(),
      .bone = trial.scene().bone()};
}

void wait(double seconds) {
  QEventLoop loop;
  QTimer::singleShot(static_cast<int>(1000.0 * seconds), &loop, &QEventLoop::quit);
  loop.exec();
}

void savePicture(scene::SimulationView& view, const std::string& folder, const QString& name) {
  if (folder.empty()) return;
  const QString path = QDir(QString::fromStdString(folder)).filePath(name);
  if (!view.grab().save(path)) std::fprintf(stderr, "%s cannot be written.\n", qPrintable(path));
}

double bytesOfAllSpheres(const haptics::engine::SceneSpec& spec) {
  const auto* packing = haptics::engine::partsOf(spec.model).packing;
  if (packing == nullptr) return 0.0;
  return static_cast<double>(packing->bone->packing.spheres.size() * sizeof(scene::SphereInstance));
}

SimulationSpeed measure(Subject subject, const SimulationOptions& options) {
  std::fprintf(stderr, "%s\n", subject.name.c_str());
  const auto picture = QString::fromStdString(subject.picture);
  SimulatedHand hand(subject.person);
  SimulatedDevice device(*subject.device, hand);
  SimulationSpeed measured{.name = subject.name, .buildTime = subject.buildTime};
  measured.allBytes = bytesOfAllSpheres(subject.spec);
  Trial trial(
      device,
      {.scene = subject.spec, .limits = subject.limits, .storeChunk = [](int, const auto&) {}});
  scene::SimulationView view(
      std::move(subject.scene),
      scene::makeRenderer(options.renderer),
      nullptr,
      scene::SimulationView::Pace::Unbound);
  measured.remark = view.remark().toStdString();
  view.resize(options.size.first, options.size.second);
  view.show();
  wait(0.5);  // until the window is shown and all spheres have been sent once
  const auto bytesBefore = view.renderer().sphereBytes();
  LiveTrial live(trial);
  view.setSnapshotSource([&] { return snapshotOf(live, trial); });
  constexpr int kPictures = 5;
  for (int i = 0; i < kPictures; ++i) {
    wait(options.seconds / kPictures);
    measured.view = view.report();
    savePicture(view, options.folder, QStringLiteral("%1-%2.png").arg(picture).arg(i + 1));
  }
  measured.size = {view.pictureSize().width(), view.pictureSize().height()};
  measured.longest = view.longestInterval();
  measured.bytesPerFrame = static_cast<double>(view.renderer().sphereBytes() - bytesBefore) /
                           static_cast<double>(std::max<std::int64_t>(1, measured.view.frames));
  view.setSnapshotSource({});
  measured.trialRecord = live.finish(TrialEnding::Finished);
  return measured;
}

}  // namespace

SimulationSpeed measureKnee(const SimulationOptions& options) {
  return measure(kneeSubject(options), options);
}

SimulationSpeed measureCup(const SimulationOptions& options) {
  return measure(hipSubject(options), options);
}

}  // namespace study::bench
