#include "study/gui/scene/bone_colours_painter.h"

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
void lowerPriority() {
  constexpr int kNice = 10;
  setpriority(PRIO_PROCESS, static_cast<id_t>(gettid()), kNice);
}

}  // namespace

/// The bone, used by the drawing thread. A change of colours builds it again in its current state.
class BoneColoursPainter::Bone {
 public:
  Bone(const haptics::engine::PackingSpec& spec, SphereColours colours) : spec_(spec) {
    make(colours);
  }

  const QImage& draw(const Request& request, double seconds) {
    if (request.colours != colours_) {
      const Changes pastChanges = hip_->spheres()->changesSoFar();
      make(request.colours);
      for (const auto& change : pastChanges) hip_->apply(change);
    }
    for (const auto& change : request.changes) hip_->apply(change);
    hip_->update({.travel = request.depth, .isRunning = request.isRunning}, seconds);
    return renderer_.draw(hip_->scene(), request.size);
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

BoneColoursPainter::BoneColoursPainter(
    const haptics::engine::PackingSpec& spec, Changes pastChanges, QObject* parent)
    : QObject(parent), spec_(spec) {
  next_.changes = std::move(pastChanges);
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

BoneColoursPainter::~BoneColoursPainter() = default;

/// Does not block: if the thread holds the lock, the next call passes the changes.
void BoneColoursPainter::submit(double depth, bool isRunning) {
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (!lock.owns_lock()) return;
  hasChanges_ = hasChanges_ || !next_.changes.empty() || isRunning || depth != request_.depth ||
                next_.colours != request_.colours || next_.size != request_.size;
  request_.changes.insert(request_.changes.end(), next_.changes.begin(), next_.changes.end());
  next_.changes.clear();
  request_.colours = next_.colours;
  request_.size = next_.size;
  request_.depth = depth;
  request_.isRunning = isRunning;
  if (hasChanges_) woken_.notify_one();
}

void BoneColoursPainter::work(const std::stop_token& stop) {
  lowerPriority();
  try {
    measure();
    paint(stop);
  } catch (const std::exception& error) {
    const QString why = QString::fromUtf8(error.what());
    QMetaObject::invokeMethod(
        this, [this, why] { emit failed(why); }, Qt::QueuedConnection);
  }
}

void BoneColoursPainter::paint(const std::stop_token& stop) {
  std::unique_ptr<Bone> bone;
  auto before = Clock::now();
  while (!stop.stop_requested()) {
    Request request;
    {
      std::unique_lock lock(mutex_);
      if (!woken_.wait(lock, stop, [this] { return hasChanges_; })) return;
      std::swap(request.changes, request_.changes);
      request.colours = request_.colours;
      request.size = request_.size;
      request.depth = request_.depth;
      request.isRunning = request_.isRunning;
      hasChanges_ = false;
    }
    if (!bone) bone = std::make_unique<Bone>(spec_, request.colours);
    if (stop.stop_requested()) return;
    const auto begun = Clock::now();
    const double seconds = std::chrono::duration<double>(begun - before).count();
    before = begun;
    showPicture(bone->draw(request, std::min(seconds, 0.1)).copy());
    std::unique_lock lock(mutex_);
    woken_.wait_until(lock, stop, begun + kPace, [] { return false; });
  }
}

void BoneColoursPainter::measure() {
  const haptics::reaming::SphereField field(
      spec_.bone->packing, spec_.bone->densities(spec_.hardness, spec_.forceScale));
  const DensityRange range = densityRangeOf(field);
  QMetaObject::invokeMethod(
      this, [this, range] { emit measured(range); }, Qt::QueuedConnection);
}

void BoneColoursPainter::showPicture(const QImage& picture) {
  QMetaObject::invokeMethod(
      this, [this, picture] { emit painted(picture); }, Qt::QueuedConnection);
}

}  // namespace study::gui::scene
