#include "study/gui/scene/hip_scene.h"

#include <algorithm>
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
constexpr float kPelvisThickness = 4.5F;  // [mm]
constexpr Tint kPelvis{178, 166, 148, 40};
const QVector3D kEye(-70.0F, -200.0F, -58.0F);  // in the bone's frame [mm]
const QVector3D kMiddle(1.0F, 0.0F, 10.0F);

/// Half of a hollow hemisphere [mm]: a section at y = 0, and its opening at z = 0. The rings go
/// from one end of the edge between the two to the other, where they have no area: a cap of loft()
/// that is a crescent would cover the cup.
Mesh halfShell(float inner, float outer) {
  std::vector<Ring> rings;
  constexpr int kRings = 56;
  constexpr int kSteps = 24;
  for (int i = 0; i <= kRings; ++i) {
    const float along = std::numbers::pi_v<float> * static_cast<float>(i) / kRings;
    Ring ring;
    for (const float radius : {inner, outer}) {
      for (int k = 0; k <= kSteps; ++k) {
        const int step = radius == inner ? k : kSteps - k;
        const float turned = 0.5F * std::numbers::pi_v<float> * static_cast<float>(step) / kSteps;
        const QVector3D out(0.0F, std::sin(turned), std::cos(turned));
        ring.push_back(radius * (std::sin(along) * out + QVector3D(std::cos(along), 0.0F, 0.0F)));
      }
    }
    rings.push_back(std::move(ring));
  }
  Mesh shell = loft(rings);
  crease(shell, 30.0F);
  return shell;
}

/// What is seen of the pelvis around a cup of radius @p inner [mm]: its section at y = 0, and its
/// rim at z = 0. Its other surfaces would only cost time.
Mesh pelvisAround(float inner) {
  constexpr std::uint32_t kSteps = 48;
  constexpr QVector3D kAlong(1.0F, 0.0F, 0.0F);
  Mesh mesh;
  for (const bool isSection : {true, false}) {
    const QVector3D up = isSection ? QVector3D(0.0F, 0.0F, 1.0F) : QVector3D(0.0F, 1.0F, 0.0F);
    const QVector3D normal =
        isSection ? QVector3D(0.0F, -1.0F, 0.0F) : QVector3D(0.0F, 0.0F, -1.0F);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i <= kSteps; ++i) {
      const float angle = std::numbers::pi_v<float> * static_cast<float>(i) / kSteps;
      const QVector3D out = std::cos(angle) * kAlong + std::sin(angle) * up;
      for (const float radius : {inner, inner + kPelvisThickness})
        mesh.vertices.push_back({radius * out, normal, kPelvis});
    }
    for (std::uint32_t a = first; a < first + 2 * kSteps; a += 2) {
      // Facing the eye: the corners of the two planes run in opposite directions.
      mesh.triangles.push_back(isSection ? Triangle{a, a + 1, a + 3} : Triangle{a, a + 3, a + 1});
      mesh.triangles.push_back(isSection ? Triangle{a, a + 3, a + 2} : Triangle{a, a + 2, a + 3});
    }
  }
  return mesh;
}

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
  addPelvis(extentOf(field));
}

/// Adds half of a hollow hemisphere, with the shape of the parametric packing.
void HipScene::addUncutBone() {
  addPelvis(kPlainOuter);
  Mesh bone = halfShell(kPlainInner, kPlainOuter);
  paint(bone, kPlainBone);
  scene_.parts.push_back({.mesh = std::move(bone)});
  start_ = -std::sqrt(kPlainRadius * kPlainRadius - kPlainInner * kPlainInner);
}

/// Adds the pelvis around a bone of radius @p radius [mm]: it shows that the bone goes on, and
/// where it is cut open.
void HipScene::addPelvis(float radius) {
  scene_.parts.push_back({.mesh = pelvisAround(radius)});
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
