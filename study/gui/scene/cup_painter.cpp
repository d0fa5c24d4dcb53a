#include "study/gui/scene/cup_painter.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <memory>
#include <utility>

#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/software_renderer.h"

namespace study::gui::scene {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kPace = std::chrono::milliseconds(67);

/// Lowers the thread's priority. On a busy processor it gets a tenth of the time of other threads:
/// enough to make progress, but too little to disturb haptics or the participant's view.
void standBack() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace

/// The cup, used by the drawing thread. A change of colours builds it again in its current state.
class CupPainter::Cup {
 public:
  Cup(const haptics::engine::PackingSpec& spec, SphereColours colours) : spec_(spec) {
    make(colours);
  }

  const QImage& draw(const Wish& wish, double seconds) {
    if (wish.colours != colours_) {
      const Changes past = hip_->spheres()->changesSoFar();
      make(wish.colours);
      for (const auto& change : past) hip_->apply(change);
    }
    for (const auto& change : wish.changes) hip_->apply(change);
    hip_->follow({.travel = wish.depth, .isRunning = wish.isRunning}, seconds);
    return renderer_.draw(hip_->scene(), wish.size);
  }

 private:
  void make(SphereColours colours) {
    colours_ = colours;
    hip_ = std::make_unique<HipScene>(HipScene::Options{.packing = &spec_, .colours = colours});
  }

  const haptics::engine::PackingSpec& spec_;
  SphereColours colours_ = SphereColours::Density;
  std::unique_ptr<HipScene> hip_;
  SoftwareRenderer renderer_;
};

CupPainter::CupPainter(const haptics::engine::PackingSpec& spec, Changes past, QObject* parent)
    : QObject(parent), spec_(spec) {
  next_.changes = std::move(past);
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

CupPainter::~CupPainter() = default;

/// Does not block: if the thread holds the lock, the next call passes the changes.
void CupPainter::handOn(double depth, bool isRunning) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  hasNews_ = hasNews_ || !next_.changes.empty() || isRunning || depth != wish_.depth ||
             next_.colours != wish_.colours || next_.size != wish_.size;
  wish_.changes.insert(wish_.changes.end(), next_.changes.begin(), next_.changes.end());
  next_.changes.clear();
  wish_.colours = next_.colours;
  wish_.size = next_.size;
  wish_.depth = depth;
  wish_.isRunning = isRunning;
  if (hasNews_) woken_.notify_one();
}

void CupPainter::work(const std::stop_token& stop) {
  standBack();
  try {
    measure();
    paint(stop);
  } catch (const std::exception& error) {
    const QString why = QString::fromUtf8(error.what());
    QMetaObject::invokeMethod(
        this, [this, why] { emit failed(why); }, Qt::QueuedConnection);
  }
}

void CupPainter::paint(const std::stop_token& stop) {
  std::unique_ptr<Cup> cup;
  auto before = Clock::now();
  while (!stop.stop_requested()) {
    Wish wish;
    {
      std::unique_lock lock(mutex_);
      if (!woken_.wait(lock, stop, [this] { return hasNews_; })) return;
      std::swap(wish.changes, wish_.changes);
      wish.colours = wish_.colours;
      wish.size = wish_.size;
      wish.depth = wish_.depth;
      wish.isRunning = wish_.isRunning;
      hasNews_ = false;
    }
    if (!cup) cup = std::make_unique<Cup>(spec_, wish.colours);
    if (stop.stop_requested()) return;
    const auto begun = Clock::now();
    const double seconds = std::chrono::duration<double>(begun - before).count();
    before = begun;
    showPicture(cup->draw(wish, std::min(seconds, 0.1)).copy());
    std::unique_lock lock(mutex_);
    woken_.wait_until(lock, stop, begun + kPace, [] { return false; });
  }
}

void CupPainter::measure() {
  const haptics::reaming::SphereField field(
      spec_.bone->packing, spec_.bone->densities(spec_.hardness, spec_.forceScale));
  const DensityRange range = densityRangeOf(field);
  QMetaObject::invokeMethod(
      this, [this, range] { emit measured(range); }, Qt::QueuedConnection);
}

void CupPainter::showPicture(const QImage& picture) {
  QMetaObject::invokeMethod(
      this, [this, picture] { emit painted(picture); }, Qt::QueuedConnection);
}

}  // namespace study::gui::scene
