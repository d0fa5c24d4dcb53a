#include "study/gui/scene/hip_scene.h"

#include <cmath>
#include <numbers>

#include "haptics/reaming/bone/sphere_field.h"
#include "study/gui/scene/shapes/solids.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {
namespace {

constexpr float kPerMetre = 1000.0F;
constexpr float kTurnsPerSecond = 1.5F;  // slower than a real reamer, so that the motion is visible
constexpr float kPlainRadius = 26.0F;    // [mm]
constexpr float kPlainInner = 25.5F;
constexpr float kPlainOuter = 41.0F;
constexpr float kHipShadow = 4.0F;  // reach [mm]
constexpr float kHipShadowDepth = 0.55F;
constexpr Tint kPlainBone{226, 208, 180, 50};
const QVector3D kEye(-70.0F, -200.0F, -58.0F);  // in the bone's frame [mm]
const QVector3D kMiddle(1.0F, 0.0F, 10.0F);

}  // namespace

HipScene::HipScene(const Options& options) {
  const float radius = options.packing == nullptr
                           ? kPlainRadius
                           : kPerMetre * static_cast<float>(options.packing->bone->reamerRadius);
  ReamerShape reamer = reamerShape(radius);
  scene_.parts.push_back({.mesh = std::move(reamer.cap), .isTool = true});
  scene_.parts.push_back({.mesh = std::move(reamer.shaft), .isTool = true});
  scene_.shadow = {.radius = radius, .reach = kHipShadow, .depth = kHipShadowDepth};
  options.packing == nullptr ? addUncutBone() : addSpheres(options);
  setUpCamera();
  // Colours with a meaning need even light to be read.
  constexpr float kEven = 0.28F;
  if (options.colours != SphereColours::Neutral) scene_.shots.front().light.ambient = kEven;
  update({}, 0.0);
}

void HipScene::addSpheres(const Options& options) {
  const auto& spec = *options.packing;
  const haptics::reaming::SphereField field(
      spec.bone->packing, spec.bone->densities(spec.hardness, spec.forceScale));
  const auto plunge = haptics::reaming::plungePathInto(field, spec.bone->reamerRadius);
  start_ = kPerMetre * static_cast<float>(plunge.start);
  spheres_ = std::make_unique<SphereCloud>(
      field, SphereCloud::Options{.eye = kEye, .isHalved = true, .colours = options.colours});
  scene_.spheres = spheres_.get();
}

/// Adds half of a hollow hemisphere, with the shape of the parametric packing.
void HipScene::addUncutBone() {
  std::vector<Ring> rings;
  constexpr int kRings = 48;
  constexpr int kSteps = 28;
  for (int i = 0; i <= kRings; ++i) {
    const float around = std::numbers::pi_v<float> * static_cast<float>(i) / kRings;
    const QVector3D out(std::cos(around), std::sin(around), 0.0F);
    Ring ring;
    for (const float radius : {kPlainInner, kPlainOuter}) {
      for (int k = 0; k <= kSteps; ++k) {
        const int step = radius == kPlainInner ? k : kSteps - k;
        const float polar = 0.5F * std::numbers::pi_v<float> * static_cast<float>(step) / kSteps;
        ring.push_back(radius * (std::sin(polar) * out + QVector3D(0, 0, std::cos(polar))));
      }
    }
    rings.push_back(std::move(ring));
  }
  Mesh bone = loft(rings);
  paint(bone, kPlainBone);
  crease(bone, 30.0F);
  scene_.parts.push_back({.mesh = std::move(bone)});
  start_ = -std::sqrt(kPlainRadius * kPlainRadius - kPlainInner * kPlainInner);
}

void HipScene::setUpCamera() {
  Shot shot;
  // The opening of the acetabulum points up and left, as a surgeon sees it.
  shot.view.lookAt(kEye, kMiddle, {-0.55F, 0.0F, 0.62F});
  shot.fieldOfView = 22.0F;
  shot.nearest = 60.0F;
  shot.farthest = 420.0F;
  shot.light = {.place = {-90.0F, 150.0F, 60.0F}, .reach = 0.0F, .ambient = 0.16F};
  shot.ground = {22, 26, 32, 0};
  shot.parts = {Cap, Shaft};
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
    spin_ = std::fmod(spin_ + 360.0F * kTurnsPerSecond * static_cast<float>(seconds), 360.0F);
  }
  QMatrix4x4 pose;
  pose.translate(0.0F, 0.0F, start_ + kPerMetre * static_cast<float>(depth_));
  pose.rotate(spin_, 0.0F, 0.0F, 1.0F);
  scene_.shadow.from = pose.column(3).toVector3D();
  scene_.parts[Cap].pose = pose;
  scene_.parts[Shaft].pose = pose;
}

}  // namespace study::gui::scene
