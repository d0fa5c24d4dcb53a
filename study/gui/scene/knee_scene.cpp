#include "study/gui/scene/knee_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <QRectF>

#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {
namespace {

constexpr double kClosed = 10.0;       // [travel units]
constexpr double kCertainlyCut = 9.3;  // [travel units]
constexpr double kOpenAgain = 4.0;     // [travel units]
constexpr double kPieceFloats = 0.7;   // [s]
constexpr float kShaftInView = 60.0F;  // [mm]
constexpr float kKneeShadow = 2.5F;    // reach [mm]
constexpr float kKneeShadowDepth = 0.5F;
constexpr float kNextBite = 13.0F;  // [°]
constexpr float kMovesOn = 26.0F;   // [°/s]

}  // namespace

KneeScene::KneeScene(const protocols::Anatomy* own) : meniscus_(layout_) {
  KneeSurfaces around = kneeSurfaces(layout_, own);
  add(std::move(around.tibia));
  add(std::move(around.femur));
  add(std::move(around.capsule));
  add(meniscus_.body());
  add({});
  const QMatrix4x4 punch = punchPose(layout_);
  PunchShape shape = punchShape();
  add(std::move(shape.body), punch);
  add(std::move(shape.grip), punch);
  add(std::move(shape.jaw));
  add(std::move(shape.rod));
  add(std::move(shape.lever));
  for (const auto part : {Body, Grip, Jaw, Rod, Lever}) scene_.parts[part].isTool = true;
  scene_.parts[Piece].isShown = false;
  // The shadow of the jaws and the shaft.
  scene_.shadow = {
      .from = punch.map(QVector3D(kJawLength, 0.0F, 0.0F)),
      .along = punch.mapVector(QVector3D(-kShaftInView, 0.0F, 0.0F)),
      .radius = kJawHalfWidth,
      .reach = kKneeShadow,
      .depth = kKneeShadowDepth};
  setUpCamera();
  setUpHandleCamera();
  update({}, 0.0);
}

void KneeScene::add(Mesh mesh, const QMatrix4x4& pose) {
  scene_.parts.push_back({.mesh = std::move(mesh), .pose = pose});
}

void KneeScene::setUpCamera() {
  Shot shot{.place = {0.0, 0.0, 0.66, 1.0}, .isRound = true};
  shot.view.lookAt({-6.0F, 10.5F, 17.0F}, {1.2F, 2.6F, -16.0F}, {-0.05F, 1.0F, 0.0F});
  shot.fieldOfView = 62.0F;
  shot.nearest = 2.0F;
  shot.farthest = 90.0F;
  shot.light = {.place = {2.5F, 3.5F, 0.0F}, .reach = 38.0F, .ambient = 0.09F};
  shot.parts = {Plateau, Condyle, Capsule, Tissue, Piece, Body, Jaw, Rod};
  scene_.shots.push_back(std::move(shot));
}

/// Fits the camera to the whole instrument at its largest width, with the handles apart.
void KneeScene::setUpHandleCamera() {
  update({}, 0.0);
  const QMatrix4x4 toPunch = punchPose(layout_).inverted();
  QRectF box;
  for (const auto part : {Body, Grip, Jaw, Rod, Lever}) {
    const auto pose = toPunch * scene_.parts[part].pose;
    for (const auto& vertex : scene_.parts[part].mesh.vertices) {
      const QPointF place = pose.map(vertex.position).toPointF();
      box = box.united(QRectF(place - QPointF(0.1, 0.1), QSizeF(0.2, 0.2)));
    }
  }
  constexpr double kMargin = 1.1;  // factor of the size; parts nearer to the eye look larger
  constexpr double kDistance = 330.0;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const auto middle = QVector3D(QPointF(box.center()));
  Shot shot{.place = {0.66, 0.05, 0.34, 0.9}, .aspect = box.width() / box.height()};
  // From the side, with the instrument's tip to the left.
  shot.view.lookAt(
      middle - QVector3D(0.0F, 0.0F, static_cast<float>(kDistance)), middle, {0.0F, 1.0F, 0.0F});
  shot.view *= toPunch;
  const double smaller = std::min(box.width(), box.height());
  shot.fieldOfView =
      static_cast<float>(2.0 * kDegrees * std::atan(0.5 * kMargin * smaller / kDistance));
  shot.nearest = 200.0F;
  shot.farthest = 500.0F;
  shot.light = {.place = {-120.0F, 260.0F, 120.0F}, .reach = 0.0F, .ambient = 0.2F};
  shot.parts = {Body, Grip, Jaw, Rod, Lever};
  scene_.shots.push_back(std::move(shot));
}

void KneeScene::update(const TrialSnapshot& snapshot, double seconds) {
  updateCut(snapshot);
  movePiece(seconds);
  const auto openness =
      static_cast<float>(std::clamp(1.0 - snapshot.travel / kClosed, -0.02, 1.05));
  const QMatrix4x4 punch = punchPose(layout_);
  scene_.parts[Jaw].pose = punch * jawPose(openness);
  scene_.parts[Rod].pose = punch * rodPose(openness);
  scene_.parts[Lever].pose = punch * leverPose(openness);

  Meniscus::TissueLoad squeeze{.string = {}, .openness = openness};
  if (snapshot.mesh != nullptr) squeeze.string = snapshot.mesh->at(snapshot.travel, snapshot.force);
  meniscus_.squeeze(squeeze);
  scene_.parts[Tissue].mesh = meniscus_.body();
  ++scene_.parts[Tissue].revision;
  auto& piece = scene_.parts[Piece];
  piece.isShown = meniscus_.hasPiece();
  if (!piece.isShown) return;
  piece.mesh = meniscus_.piece();
  ++piece.revision;
}

/// Cuts the tissue once per closure, and releases the piece when the hand opens.
void KneeScene::updateCut(const TrialSnapshot& snapshot) {
  const bool isThrough = snapshot.isCutThrough || snapshot.travel > kCertainlyCut;
  if (!isCut_ && snapshot.travel > kOpenAgain && isThrough) {
    isCut_ = true;
    released_ = 0.0;
    meniscus_.cut();
  } else if (isCut_ && snapshot.travel < kOpenAgain) {
    isCut_ = false;
    remainingShift_ += kNextBite;
  }
}

/// A held piece lies slightly apart. A released piece floats away, and the tissue moves to the next
/// bite.
void KneeScene::movePiece(double seconds) {
  if (!isCut_ && meniscus_.hasPiece()) {
    released_ += seconds;
    if (released_ > kPieceFloats) meniscus_.removePiece();
  }
  if (remainingShift_ > 0.0F && !meniscus_.hasPiece()) {
    const float step = std::min(remainingShift_, kMovesOn * static_cast<float>(seconds));
    meniscus_.moveOn(step);
    remainingShift_ -= step;
  }
  const auto share = static_cast<float>(released_ / kPieceFloats);
  QVector3D middle = onArc(layout_, layout_.toolAngle, layout_.innerRadius + 1.6F);
  middle.setY(1.4F);
  const QVector3D inwards = (layout_.arcCentre - middle).normalized();
  auto& pose = scene_.parts[Piece].pose;
  pose.setToIdentity();
  // Moves the piece out of the open jaws to their left, so that it does not pass through them.
  const QVector3D left = -punchPose(layout_).column(2).toVector3D();
  pose.translate(
      middle + (0.35F + 2.0F * share) * inwards + 5.0F * share * left +
      QVector3D(0.0F, 1.5F * share, 0.0F));
  pose.rotate(70.0F * share, 0.3F, 0.2F, 1.0F);
  pose.scale(1.0F - 0.85F * share * share);
  pose.translate(-middle);
}

}  // namespace study::gui::scene
