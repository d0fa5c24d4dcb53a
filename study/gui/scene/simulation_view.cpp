#include "study/gui/scene/simulation_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>
#include <QScreen>

#include "haptics/timing/monotonic_clock.h"

namespace study::gui::scene {
namespace {

namespace timing = haptics::timing;
constexpr double kMostOnProcessor =
    1920.0 * 1080.0;  // pixels; larger views are drawn at a lower resolution
constexpr double kMostOnCard = 2560.0 * 1600.0;

}  // namespace

SimulationView::SimulationView(
    std::unique_ptr<SimulatedScene> scene, RendererWithRemark graphics, QWidget* parent, Pace pace)
    : QWidget(parent), scene_(std::move(scene)), graphics_(std::move(graphics)), pace_(pace) {
  setAttribute(Qt::WA_TransparentForMouseEvents);  // the page under it handles the mouse
  setAttribute(Qt::WA_OpaquePaintEvent);
  setFocusPolicy(Qt::NoFocus);
  setMinimumSize(320, 200);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  frameTimer_.setSingleShot(true);
  frameTimer_.setTimerType(Qt::PreciseTimer);
  connect(&frameTimer_, &QTimer::timeout, this, &SimulationView::drawNext);
  beginCounting();
  frameTimer_.start(0);
}

void SimulationView::beginCounting() {
  statistics_.emplace(period());
  lostChanges_ = 0;
}

ViewReport SimulationView::report() const {
  ViewReport report = statistics_->report();
  report.renderer = graphics_.renderer->name().toStdString();
  report.lostChanges = lostChanges_;
  return report;
}

/// The intended interval between frames [ns].
std::int64_t SimulationView::period() const {
  const double rate = screen() != nullptr ? screen()->refreshRate() : 60.0;
  const double refresh = 1e9 / std::clamp(rate, 30.0, 240.0);
  const bool isHalved = pace_ == Pace::Display && graphics_.renderer->isOnProcessor();
  return std::llround(isHalved ? 2.0 * refresh : refresh);
}

QSize SimulationView::pictureSize() const {
  const double most = graphics_.renderer->isOnProcessor() ? kMostOnProcessor : kMostOnCard;
  const double pixels =
      std::max(1.0, devicePixelRatioF() * devicePixelRatioF() * width() * height());
  const double scale = devicePixelRatioF() * std::min(1.0, std::sqrt(most / pixels));
  return (QSizeF(size()) * scale).toSize().expandedTo({1, 1});
}

void SimulationView::drawNext() {
  const std::int64_t now = timing::now();
  due_ = std::max(due_ + period(), now);
  if (isVisible()) {
    update();
  } else {
    frameTimer_.start(static_cast<int>(period() / timing::kMillisecond));
  }
}

void SimulationView::paintEvent(QPaintEvent* /*event*/) {
  const TrialSnapshot snapshot = snapshotSource_ ? snapshotSource_() : TrialSnapshot{};
  if (snapshot.isRunning && !wasRunning_) beginCounting();
  wasRunning_ = snapshot.isRunning;
  const double seconds =
      sinceLast_.isValid() ? 1e-9 * static_cast<double>(sinceLast_.nsecsElapsed()) : 0.0;
  sinceLast_.start();
  scene_->update(snapshot, std::min(seconds, 0.1));
  if (snapshot.bone != nullptr) lostChanges_ = static_cast<std::int64_t>(snapshot.bone->lost());
  const QImage& picture = graphics_.renderer->draw(scene_->scene(), pictureSize());
  QPainter painter(this);
  painter.drawImage(rect(), picture);
  paintedState_ = snapshot;
  // The window shows its contents when this event has been handled. The frame counts as shown then.
  QTimer::singleShot(0, this, &SimulationView::noteShown);
}

void SimulationView::noteShown() {
  if (!paintedState_) return;
  const std::int64_t now = timing::now();
  if (paintedState_->isRunning) statistics_->add(now, paintedState_->sampleTime);
  paintedState_.reset();
  const std::int64_t wait = pace_ == Pace::Unbound ? 0 : due_ - now;
  frameTimer_.start(static_cast<int>(std::max<std::int64_t>(0, wait) / timing::kMillisecond));
}

}  // namespace study::gui::scene
