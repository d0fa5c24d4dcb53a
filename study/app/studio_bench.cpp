#include "study/app/studio_bench.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>

#include <QDir>
#include <QElapsedTimer>
#include <QEventLoop>
#include <QTimer>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/devices/simulated_hand.h"
#include "haptics/engine/parametric_bone.h"
#include "haptics/reaming/packing/acetabulum.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "protocols/reading/anatomy_file.h"
#include "questionnaires/json/document.h"
#include "study/app/desk_bench.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/trial/live_trial.h"

namespace study::app {
namespace {

namespace scene = gui::scene;
using haptics::devices::SimulatedDevice;
using haptics::devices::SimulatedHand;

constexpr QSize kPictureSize(1280, 800);
constexpr double kTargetOnCard = 60.0;       // pictures a second
constexpr double kTargetOnProcessor = 25.0;  // pictures a second

struct Settings {
  double seconds = 8.0;
  std::size_t spheres = 201'532;
  QString folder;
  scene::RendererChoice renderer = scene::RendererChoice::Best;
  scene::SphereColours colours = scene::SphereColours::Neutral;
  std::optional<protocols::Anatomy> knee;  ///< in place of ours
};

/// A simulation with somebody at work in it.
struct Subject {
  const haptics::devices::DeviceKind* device = nullptr;
  haptics::engine::SceneSpec spec;
  haptics::engine::SafetyLimits limits;
  SimulatedHand::Person person;
  std::unique_ptr<scene::SimulatedScene> scene;
  double making = 0.0;  ///< of the scene [ms]
};

struct Measured {
  ViewReport view;
  double bytesPerFrame = 0.0;
  std::uint64_t allBytes = 0;  ///< of all spheres that there are
  double making = 0.0;         ///< of the scene [ms]
  TrialRecord felt;            ///< how well the hand was served meanwhile
  bool isOnProcessor = false;
  QString remark;
};

/// Reads the knee that is asked for, if one is; whether it can be drawn. What there is to say about
/// it goes to the person who asked.
bool readKnee(const QString& path, Settings& settings) {
  if (path.isEmpty()) return true;
  questionnaires::Problems problems;
  try {
    const auto text = questionnaires::readTextFile(path.toStdString(), protocols::kLargestAnatomy);
    settings.knee = protocols::readAnatomy(text, problems);
  } catch (const questionnaires::Error& error) {
    problems.add("", error.what());
  }
  std::fputs(questionnaires::inWords(problems.all()).c_str(), stderr);
  return settings.knee.has_value();
}

bool readSettings(const QCommandLineParser& parser, Settings& settings) {
  const std::map<QString, scene::SphereColours> colours{
      {QStringLiteral("neutral"), scene::SphereColours::Neutral},
      {QStringLiteral("density"), scene::SphereColours::Density},
      {QStringLiteral("removal"), scene::SphereColours::Removal}};
  const std::map<QString, scene::RendererChoice> renderers{
      {QStringLiteral("best"), scene::RendererChoice::Best},
      {QStringLiteral("finest"), scene::RendererChoice::Finest},
      {QStringLiteral("software"), scene::RendererChoice::Software}};
  const auto colour = colours.find(parser.value(QStringLiteral("colours")));
  const auto renderer = renderers.find(parser.value(QStringLiteral("renderer")));
  bool isNumber = false;
  settings.seconds = parser.value(QStringLiteral("seconds")).toDouble(&isNumber);
  bool isCount = false;
  settings.spheres = parser.value(QStringLiteral("spheres")).toULong(&isCount);
  settings.folder = parser.value(QStringLiteral("out"));
  const bool isSound = isNumber && settings.seconds >= 0.5 && settings.seconds <= 600.0 &&
                       isCount && settings.spheres >= 1000 && colour != colours.end() &&
                       renderer != renderers.end();
  if (!isSound) return false;
  settings.colours = colour->second;
  settings.renderer = renderer->second;
  return settings.folder.isEmpty() || QDir().mkpath(settings.folder);
}

Subject kneeSubject(const Settings& settings) {
  Subject subject;
  subject.device = &haptics::devices::punchKind();
  subject.spec = {.model = haptics::engine::FiniteElementsSpec{}, .isVisualised = true};
  subject.limits = {.maxForce = 8.0, .maxRate = 3000.0};
  QElapsedTimer clock;
  clock.start();
  subject.scene = std::make_unique<scene::KneeScene>(settings.knee ? &*settings.knee : nullptr);
  subject.making = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  return subject;
}

/// Our own cup in so many spheres, as hard as the curves that we ship.
std::shared_ptr<const haptics::reaming::PackedBone> cupOf(std::size_t spheres) {
  auto bone = std::make_shared<haptics::reaming::PackedBone>();
  std::printf("packing %zu spheres\n", spheres);
  std::fflush(stdout);
  bone->packing = *pack(haptics::reaming::Acetabulum(), {.count = spheres});
  fitTo(*bone, haptics::engine::parametricCurves(), 100);
  return bone;
}

Subject hipSubject(const Settings& settings) {
  Subject subject;
  subject.device = &haptics::devices::reamerKind();
  subject.spec.model = haptics::engine::PackingSpec{
      .bone = cupOf(settings.spheres), .hardness = 0.5, .forceScale = 0.15};
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
      .packing = haptics::engine::partsOf(subject.spec.model).packing,
      .colours = settings.colours});
  subject.making = 1e-6 * static_cast<double>(clock.nsecsElapsed());
  return subject;
}

scene::Look lookAt(const LiveTrial& live, const Trial& trial) {
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

void savePicture(scene::SimulationView& view, const Settings& settings, int number) {
  if (settings.folder.isEmpty()) return;
  const bool isKnee = dynamic_cast<scene::KneeScene*>(&view.scene()) != nullptr;
  const QString name = QStringLiteral("%1-%2.png")
                           .arg(isKnee ? QStringLiteral("knee") : QStringLiteral("hip"))
                           .arg(number);
  const QString path = QDir(settings.folder).filePath(name);
  if (!view.grab().save(path)) std::fprintf(stderr, "%s cannot be written.\n", qPrintable(path));
}

std::uint64_t bytesOfAllSpheres(const haptics::engine::SceneSpec& spec) {
  const auto* packing = haptics::engine::partsOf(spec.model).packing;
  return packing == nullptr ? 0
                            : packing->bone->packing.spheres.size() * sizeof(scene::SphereInstance);
}

Measured measure(Subject subject, const Settings& settings) {
  SimulatedHand hand(subject.person);
  SimulatedDevice device(*subject.device, hand);
  Measured measured{.allBytes = bytesOfAllSpheres(subject.spec), .making = subject.making};
  Trial trial(
      device, {.scene = subject.spec, .limits = subject.limits, .keep = [](int, const auto&) {}});
  scene::SimulationView view(
      std::move(subject.scene),
      scene::openGraphics(settings.renderer),
      scene::SimulationView::Pace::Unbound);
  measured.remark = view.remark();
  measured.isOnProcessor = view.renderer().isOnProcessor();
  view.resize(kPictureSize);
  view.show();
  wait(0.5);  // until the window is there, and everything has been handed on once
  const auto bytesBefore = view.renderer().sphereBytes();
  LiveTrial live(trial);
  view.follow([&] { return lookAt(live, trial); });
  constexpr int kPictures = 5;
  for (int i = 0; i < kPictures; ++i) {
    wait(settings.seconds / kPictures);
    measured.view = view.report();
    savePicture(view, settings, i + 1);
  }
  measured.bytesPerFrame = static_cast<double>(view.renderer().sphereBytes() - bytesBefore) /
                           static_cast<double>(std::max<std::int64_t>(1, measured.view.frames));
  view.follow({});
  measured.felt = live.finish(TrialEnding::Finished);
  return measured;
}

/// Prints what was measured; whether the targets were met.
bool tell(const QString& name, const Measured& measured) {
  const auto& view = measured.view;
  const double target = measured.isOnProcessor ? kTargetOnProcessor : kTargetOnCard;
  const double rate = view.frameMedian > 0.0 ? 1000.0 / view.frameMedian : 0.0;
  const bool isFast = rate >= target;
  const bool isFresh = view.latencyMedian <= 2.0 * view.frameMedian;
  const auto verdict = [](bool isMet) { return isMet ? "PASS" : "MISSED"; };
  std::printf(
      "\n%s, %d x %d, drawn by %s\n",
      qPrintable(name),
      kPictureSize.width(),
      kPictureSize.height(),
      view.renderer.c_str());
  std::printf(
      "  pictures a second   %7.1f (median)   at least %.0f   %s\n", rate, target, verdict(isFast));
  std::printf(
      "  from one to the next %6.1f ms (median), %.1f ms (99 %%)\n",
      view.frameMedian,
      view.frameP99);
  std::printf(
      "  latency             %7.1f ms (median), %.1f ms (99 %%)   at most two pictures (%.1f ms)   "
      "%s\n",
      view.latencyMedian,
      view.latencyP99,
      2.0 * view.frameMedian,
      verdict(isFresh));
  std::printf(
      "  pictures            %7lld, %lld refreshes at %.0f Hz without a new one\n",
      static_cast<long long>(view.frames),
      static_cast<long long>(view.dropped),
      1000.0 / view.period);
  std::printf("  made ready in       %7.0f ms, before the trial\n", measured.making);
  std::printf(
      "  the hand meanwhile  %7lld ticks, %lld of them late by a period or more\n",
      static_cast<long long>(measured.felt.ticks),
      static_cast<long long>(measured.felt.lateTicks.value_or(0)));
  bool isSparing = true;
  if (measured.allBytes > 0) {
    isSparing = measured.bytesPerFrame < 0.05 * static_cast<double>(measured.allBytes);
    std::printf(
        "  about spheres       %7.0f bytes a picture, of %llu of all   at most 5 %%   %s\n",
        measured.bytesPerFrame,
        static_cast<unsigned long long>(measured.allBytes),
        verdict(isSparing));
    std::printf("  changes not shown   %7lld\n", static_cast<long long>(view.lostChanges));
  }
  std::fflush(stdout);
  return isFast && isFresh && isSparing;
}

}  // namespace

int benchStudio(const QCommandLineParser& parser) {
  Settings settings;
  if (!readSettings(parser, settings)) {
    std::fputs(
        "palpate-studio --bench: one of --seconds (0.5 to 600), --spheres (at least 1000), "
        "--colours (neutral, density, removal), --renderer (best, finest, software) or --out (a "
        "folder "
        "that can be written) makes no sense.\n",
        stderr);
    return 2;
  }
  if (!readKnee(parser.value(QStringLiteral("anatomy")), settings)) return 2;
  const auto knee = measure(kneeSubject(settings), settings);
  if (!knee.remark.isEmpty()) std::printf("%s\n", qPrintable(knee.remark));
  const bool isKneeGood = tell(QStringLiteral("Punch and knee"), knee);
  const bool isHipGood =
      tell(QStringLiteral("Reamer and cup"), measure(hipSubject(settings), settings));
  const QString place = settings.folder.isEmpty() ? QDir::tempPath() : settings.folder;
  const bool isDeskGood = benchDesk(settings.seconds, place);
  return isKneeGood && isHipGood && isDeskGood ? 0 : 1;
}

}  // namespace study::app
