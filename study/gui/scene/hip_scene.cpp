#include "study/gui/scene/hip_scene.h"

#include <algorithm>
#include <cmath>

#include <QVector2D>
#include <QtMath>

#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/pelvis.h"
#include "study/gui/scene/shapes/reamer_shape.h"

namespace study::gui::scene {
namespace {

constexpr float kPerMetre = 1000.0F;
constexpr float kTurnsPerSecond = 1.5F;  // slower than a real reamer, so that the motion is visible
constexpr float kPlainRadius = 26.0F;    // [mm]
constexpr float kPlainInner = 25.5F;
constexpr float kPlainOuter = 41.0F;
constexpr float kOverlap = 1.2F;    // of the outermost spheres and the bone around them [mm]
constexpr float kHipShadow = 6.0F;  // reach [mm]
constexpr float kHipShadowDepth = 0.6F;
const QVector3D kEye(-70.0F, -200.0F, -58.0F);  // in the bone's frame [mm]
const QVector3D kMiddle(1.0F, 0.0F, 10.0F);

/// The distance of the outermost point of the spheres from the middle of the cup's opening [mm].
float extentOf(const haptics::reaming::SphereField& field) {
  float extent = 0.0F;
  for (std::size_t slot = 0; slot < field.slotCount(); ++slot) {
    const auto centre = field.centre(slot);
    const auto radius = field.group(slot).radius[slot % haptics::reaming::kLanes];
    if (radius <= 0.0) continue;  // an empty slot
    const QVector3D place(
        static_cast<float>(centre.x), static_cast<float>(centre.y), static_cast<float>(centre.z));
    extent = std::max(extent, kPerMetre * (place.length() + static_cast<float>(radius)));
  }
  return extent;
}

}  // namespace

HipScene::HipScene(const Options& options) {
  const float radius = options.packing == nullptr
                           ? kPlainRadius
                           : kPerMetre * static_cast<float>(options.packing->bone->reamerRadius);
  addReamer(radius, options.colours != SphereColours::Neutral);
  options.packing == nullptr ? addUncutBone() : addSpheres(options);
  setUpCamera();
  // Colours with a meaning need even light to be read.
  constexpr float kEven = 0.28F;
  if (options.colours != SphereColours::Neutral) scene_.shots.front().light.ambient = kEven;
  update({}, 0.0);
}

/// Adds the reamer with its shadow. As an outline it does not hide the bone in front of it.
void HipScene::addReamer(float radius, bool isOutline) {
  ReamerShape reamer =
      isOutline ? ReamerShape{.cap = reamerOutline(radius), .shaft = {}} : reamerShape(radius);
  scene_.parts.push_back({.mesh = std::move(reamer.cap), .isTool = true});
  scene_.parts.push_back({.mesh = std::move(reamer.shaft), .isTool = true});
  const float depth = isOutline ? 0.0F : kHipShadowDepth;
  scene_.shadows[0] = {.radius = radius, .reach = kHipShadow, .depth = depth};
}

void HipScene::addSpheres(const Options& options) {
  const auto& spec = *options.packing;
  const haptics::reaming::SphereField field(
      spec.bone->packing, spec.bone->densities(spec.hardness, spec.forceScale));
  const auto plunge = haptics::reaming::plungePathInto(field, spec.bone->reamerRadius);
  startZ_ = kPerMetre * static_cast<float>(plunge.start);
  spheres_ = std::make_unique<SphereCloud>(
      field, SphereCloud::Options{.eye = kEye, .isHalved = true, .colours = options.colours});
  scene_.spheres = spheres_.get();
  addPelvis(extentOf(field) - kOverlap);
}

/// Adds half of a hollow hemisphere, with the shape of the parametric packing.
void HipScene::addUncutBone() {
  addPelvis(kPlainOuter - kOverlap);
  scene_.parts.push_back({.mesh = halfShell(kPlainInner, kPlainOuter)});
  startZ_ = -std::sqrt(kPlainRadius * kPlainRadius - kPlainInner * kPlainInner);
}

/// Adds the pelvis around a bone of radius @p radius [mm]: it shows that the bone goes on, and
/// where it is cut open.
void HipScene::addPelvis(float radius) {
  scene_.parts.push_back({.mesh = pelvisAround(radius)});
}

/// Fits the camera to the bone.
void HipScene::setUpCamera() {
  constexpr float kMargin = 1.07F;          // factor of the size
  constexpr float kWidth = 1.15F;           // of the narrowest panel, by its height
  const QVector3D up(-0.55F, 0.0F, 0.62F);  // the opening points down and left
  QVector3D middle = kMiddle;
  float half = 0.0F;
  for (int round = 0; round < 2; ++round) {
    QMatrix4x4 view;
    view.lookAt(kEye, middle, up);
    QRectF box;
    for (const auto& vertex : scene_.parts[Pelvis].mesh.vertices) {
      const QVector3D at = view.map(vertex.position);
      constexpr double kPoint = 1e-6;  // a box without a size is not united
      box |= QRectF(QPointF(at.x() / -at.z(), at.y() / -at.z()), QSizeF(kPoint, kPoint));
    }
    half = 0.5F * static_cast<float>(std::max(box.height(), box.width() / kWidth));
    const float distance = (middle - kEye).length();
    const QVector3D aside(QVector2D(box.center()), 0.0F);
    middle += distance * view.inverted().mapVector(aside);
  }
  Shot shot;
  shot.view.lookAt(kEye, middle, up);
  shot.fieldOfView = 2.0F * qRadiansToDegrees(std::atan(kMargin * half));
  shot.nearest = 60.0F;
  shot.farthest = 420.0F;
  shot.light = {.place = {-80.0F, 110.0F, 120.0F}, .reach = 0.0F, .ambient = 0.14F};
  shot.parts = {Cap, Shaft, Pelvis};
  if (spheres_ == nullptr) shot.parts.push_back(Acetabulum);
  shot.showsSpheres = spheres_ != nullptr;
  scene_.shots.push_back(std::move(shot));
}

void HipScene::apply(const haptics::engine::SphereChange& change) {
  if (spheres_ != nullptr) spheres_->apply(change);
}

void HipScene::update(const TrialSnapshot& snapshot, double seconds) {
  depth_ = snapshot.travel;
  if (snapshot.bone != nullptr && spheres_ != nullptr) {
    haptics::engine::SphereChange change;
    while (snapshot.bone->next(change)) {
      spheres_->apply(change);
      if (listener_) listener_(change);
    }
    depth_ = snapshot.bone->depth();
  }
  if (snapshot.isRunning) {
    spinAngle_ =
        std::fmod(spinAngle_ + 360.0F * kTurnsPerSecond * static_cast<float>(seconds), 360.0F);
  }
  QMatrix4x4 pose;
  pose.translate(0.0F, 0.0F, startZ_ + kPerMetre * static_cast<float>(depth_));
  pose.rotate(spinAngle_, 0.0F, 0.0F, 1.0F);
  scene_.shadows[0].from = pose.column(3).toVector3D();
  scene_.parts[Cap].pose = pose;
  scene_.parts[Shaft].pose = pose;
}

}  // namespace study::gui::scene
