#include "study/gui/scene/knee_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include <QRectF>

#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/scene/shapes/tool_shapes.h"

namespace study::gui::scene {
namespace {

constexpr double kClosed = 10.0;          // [travel units]
constexpr double kSurelyCutTravel = 9.3;  // [travel units]
constexpr double kReopenedTravel = 4.0;   // [travel units]
constexpr double kPieceFloatTime = 0.7;   // [s]
constexpr float kShaftInView = 60.0F;     // [mm]
constexpr float kScopeField = 62.0F;      // [°]
constexpr float kKneeShadow = 3.2F;       // reach [mm]
constexpr float kKneeShadowDepth = 0.6F;
constexpr float kAngleBetweenBites = 25.0F;           // [°]: the bites do not touch
constexpr float kTissueTurnSpeed = 60.0F;             // [°/s]
constexpr double kRadian = 180.0 / std::numbers::pi;  // [°]

/// Where the scope's view and the instrument's handle lie in a picture of a given size [px]: the
/// scope nearly as high as the picture, and the handle in the room beside it.
struct KneePlaces {
  QRectF scope;
  QRectF instrument;
};

KneePlaces placesIn(QSizeF size) {
  constexpr double kWidest = 1.8;     // of the group, in heights of the picture
  constexpr double kMargin = 0.0175;  // of the same
  const double high = std::min(size.height(), size.width() / 1.15);
  const double wide = std::min(size.width(), kWidest * high);
  const double margin = kMargin * high;
  const double left = 0.5 * (size.width() - wide);
  const double top = 0.5 * (size.height() - high);
  const double across = high - 2.0 * margin;
  const double tall = std::clamp(0.66 + 1.2 * (wide / high - 1.39), 0.4, 0.93) * high;
  constexpr double kSlim = 0.56;  // width of the instrument, with its handles apart, by its height
  return {
      {left + margin, top + margin, across, across},
      {left + wide - margin - kSlim * tall, top + high - margin - tall, kSlim * tall, tall}};
}

QRectF scopeIn(QSizeF size) {
  return placesIn(size).scope;
}

QRectF instrumentIn(QSizeF size) {
  return placesIn(size).instrument;
}

/// From the knee's frame to the arthroscope's.
QMatrix4x4 scopeView() {
  QMatrix4x4 view;
  view.lookAt({-6.0F, 8.6F, 15.0F}, {0.8F, 2.6F, -16.0F}, {-0.05F, 1.0F, 0.0F});
  return view;
}

/// The mark at the rim of a scope's view, which shows its orientation: a black triangle just before
/// the eye.
Mesh rimMark(float fieldOfView, float distance) {
  const float rim = distance * std::tan(0.5F * fieldOfView / static_cast<float>(kRadian));
  constexpr Tint kBlack{0, 0, 0, 0};
  Mesh mark;
  for (const QVector2D& corner : {QVector2D(-0.03F, 1.02F), {0.0F, 0.955F}, {0.03F, 1.02F}}) {
    mark.vertices.push_back(
        {{rim * corner.x(), rim * corner.y(), -distance}, {0.0F, 0.0F, 1.0F}, kBlack});
  }
  mark.triangles = {{0, 1, 2}};
  return mark;
}

}  // namespace

KneeScene::KneeScene(const protocols::Anatomy* own) : meniscus_(layout_) {
  const KneeSurfaces around = kneeSurfaces(layout_, own);
  add(visiblePart(around.tibia, scopeView(), 0.5F * kScopeField));
  add(visiblePart(around.femur, scopeView(), 0.5F * kScopeField));
  add(visiblePart(around.capsule, scopeView(), 0.5F * kScopeField));
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
  // The shadow of the lower jaw and the shaft; update() adds that of the upper jaw.
  scene_.shadows[0] = {
      .from = punch.map(QVector3D(kJawLength, 0.0F, 0.0F)),
      .along = punch.mapVector(QVector3D(-kShaftInView, 0.0F, 0.0F)),
      .radius = kJawHalfWidth,
      .reach = kKneeShadow,
      .depth = kKneeShadowDepth};
  setUpCamera();
  scene_.shots.push_back(handleOfInstrument());
  scene_.shots.back().placeIn = instrumentIn;
  update({}, 0.0);
}

void KneeScene::add(Mesh mesh, const QMatrix4x4& pose) {
  scene_.parts.push_back({.mesh = std::move(mesh), .pose = pose});
}

void KneeScene::setUpCamera() {
  Shot shot{.placeIn = scopeIn, .isRound = true};
  shot.view = scopeView();
  shot.fieldOfView = kScopeField;
  shot.nearest = 2.0F;
  shot.farthest = 90.0F;
  shot.light = {.place = {1.5F, 2.5F, 0.0F}, .reach = 25.0F, .power = 2.2F, .ambient = 0.1F};
  constexpr float kBeforeTheEye = 2.2F;  // [mm]
  add(rimMark(shot.fieldOfView, kBeforeTheEye), shot.view.inverted());
  // From front to back, so that little is drawn that is hidden later.
  shot.parts = {RimMark, Jaw, Body, Rod, Piece, Tissue, Condyle, Plateau, Capsule};
  scene_.shots.push_back(std::move(shot));
}

Shot KneeScene::wholeInstrument() const {
  return sideOf({Body, Grip, Jaw, Rod, Lever});
}

Shot KneeScene::handleOfInstrument() const {
  return sideOf({Grip, Lever});
}

/// Fits the camera to parts of the instrument at their largest width, with the handles apart.
Shot KneeScene::sideOf(const std::vector<std::size_t>& parts) const {
  const QMatrix4x4 toPunch = punchPose(layout_).inverted();
  const std::array poses{QMatrix4x4(), QMatrix4x4(), jawPose(1.0F), rodPose(1.0F), leverPose(1.0F)};
  QRectF box;
  for (const auto part : parts) {
    for (const auto& vertex : scene_.parts[part].mesh.vertices) {
      const QPointF place = poses[part - Body].map(vertex.position).toPointF();
      box = box.united(QRectF(place - QPointF(0.1, 0.1), QSizeF(0.2, 0.2)));
    }
  }
  constexpr double kMargin = 1.1;  // factor of the size; parts nearer to the eye look larger
  constexpr double kDistance = 330.0;
  const auto middle = QVector3D(QPointF(box.center()));
  Shot shot{.aspect = box.width() / box.height()};
  // From the side, with the instrument's tip to the left.
  shot.view.lookAt(
      middle - QVector3D(0.0F, 0.0F, static_cast<float>(kDistance)), middle, {0.0F, 1.0F, 0.0F});
  shot.view *= toPunch;
  const double smaller = std::min(box.width(), box.height());
  shot.fieldOfView =
      static_cast<float>(2.0 * kRadian * std::atan(0.5 * kMargin * smaller / kDistance));
  shot.nearest = 200.0F;
  shot.farthest = 500.0F;
  shot.light = {.place = {-120.0F, 260.0F, 120.0F}, .reach = 0.0F, .ambient = 0.28F};
  shot.parts = parts;
  return shot;
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
  const QMatrix4x4& jaw = scene_.parts[Jaw].pose;
  scene_.shadows[1] = {
      .from = jaw.map(QVector3D(0.0F, 0.4F, 0.0F)),
      .along = jaw.mapVector(QVector3D(kJawLength - 0.8F, 0.0F, 0.0F)),
      .radius = 1.0F,
      .reach = kKneeShadow,
      .depth = kKneeShadowDepth};

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
  const bool isThrough = snapshot.isCutThrough || snapshot.travel > kSurelyCutTravel;
  if (!isCut_ && snapshot.travel > kReopenedTravel && isThrough) {
    isCut_ = true;
    timeSinceRelease_ = 0.0;
    meniscus_.cut();
  } else if (isCut_ && snapshot.travel < kReopenedTravel) {
    isCut_ = false;
    remainingShift_ += kAngleBetweenBites;
  }
}

/// A held piece lies slightly apart. A released piece floats away, and the tissue moves to the next
/// bite.
void KneeScene::movePiece(double seconds) {
  if (!isCut_ && meniscus_.hasPiece()) {
    timeSinceRelease_ += seconds;
    if (timeSinceRelease_ > kPieceFloatTime) meniscus_.removePiece();
  }
  if (remainingShift_ > 0.0F && !meniscus_.hasPiece()) {
    const float step = std::min(remainingShift_, kTissueTurnSpeed * static_cast<float>(seconds));
    meniscus_.moveOn(step);
    remainingShift_ -= step;
  }
  const auto share = static_cast<float>(timeSinceRelease_ / kPieceFloatTime);
  QVector3D middle = pointOnArc(layout_, layout_.toolAngle, layout_.innerRadius + 1.6F);
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
