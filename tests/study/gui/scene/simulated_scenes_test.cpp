// The pictures of both simulations, drawn by the software renderer.
#include <gtest/gtest.h>

#include "haptics/engine/bone_models.h"
#include "haptics/engine/built_in_models.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/software_renderer.h"
#include "tests/study/gui/scene/open_edges.h"

namespace study::gui::scene {
namespace simulated_scenes_test {

constexpr QSize kSize(640, 400);

QImage pictureOf(const SimulatedScene& scene) {
  SoftwareRenderer renderer;
  return renderer.draw(scene.scene(), kSize).copy();
}

int differences(const QImage& a, const QImage& b, const QRect& where) {
  int count = 0;
  for (int y = where.top(); y <= where.bottom(); ++y) {
    for (int x = where.left(); x <= where.right(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int apart = std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) +
                        std::abs(qBlue(p) - qBlue(q));
      count += apart > 40 ? 1 : 0;
    }
  }
  return count;
}

template <typename Is>
int countWhere(const QImage& picture, Is is) {
  int count = 0;
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) count += is(picture.pixel(x, y)) ? 1 : 0;
  }
  return count;
}

bool isGround(QRgb pixel) {
  constexpr Tint kGround = Scene{}.ground;
  return pixel == qRgb(kGround.red, kGround.green, kGround.blue);
}

bool isPainted(QRgb pixel) {
  return !isGround(pixel);
}

QRect scopeOf(const KneeScene& knee, QSize size = kSize) {
  return placeOf(knee.scene().shots.front(), size);
}

QRect handlesOf(const KneeScene& knee, QSize size = kSize) {
  return placeOf(knee.scene().shots.back(), size);
}

/// From widest to narrowest, as panels of pages are.
constexpr QSize kPanels[] = {QSize(880, 400), QSize(640, 400), QSize(556, 400), QSize(480, 400)};

TEST(SoftwareRenderer, SmoothsTheEdgesOfBodies) {
  Part part;
  part.mesh.vertices = {
      {{-20.0F, -8.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {200, 200, 200, 0}},
      {{20.0F, -5.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {200, 200, 200, 0}},
      {{-20.0F, 15.0F, 0.0F}, {0.0F, 0.0F, 1.0F}, {200, 200, 200, 0}}};
  part.mesh.triangles = {{0, 1, 2}};
  Shot shot;
  shot.view.lookAt({0.0F, 0.0F, 60.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F});
  shot.light = {.place = {0.0F, 0.0F, 10.0F}, .reach = 0.0F};
  shot.parts = {0};
  Scene scene;
  scene.parts = {part};
  scene.shots = {shot};
  SoftwareRenderer renderer;
  const auto picture = renderer.draw(scene, kSize).copy();
  int largest = 0;
  for (int x = 0; x < picture.width(); ++x) {
    largest = std::max(largest, qGreen(picture.pixel(x, 200)));
  }
  ASSERT_GT(largest, 100);
  // Between the colour of the body and that of the ground, as a step has none.
  const int between = countWhere(picture, [&](QRgb pixel) {
    return qGreen(pixel) > largest / 5 && qGreen(pixel) < 4 * largest / 5;
  });
  EXPECT_GT(between, 300) << "its edges are longer than that [px]";
}

TEST(SoftwareRenderer, ShowsClosedToolsWhollyByTheirFronts) {
  Scene knee = KneeScene().scene();
  knee.shadows = {};
  SoftwareRenderer renderer;
  const QImage fronts = renderer.draw(knee, kSize).copy();
  for (auto& part : knee.parts) part.isTool = false;
  EXPECT_LT(differences(fronts, renderer.draw(knee, kSize), fronts.rect()), 10);
}

TEST(KneeScene, ShowsADiscAndThePunchBesideIt) {
  const KneeScene knee;
  const QImage picture = pictureOf(knee);
  const QRect scope = scopeOf(knee);
  EXPECT_TRUE(isGround(picture.pixel(2, 2)));
  EXPECT_TRUE(isPainted(picture.pixel(scope.center())));
  const double disc = 0.25 * 3.14159 * scope.width() * scope.height();
  const int painted = countWhere(picture, isPainted);
  EXPECT_GT(painted, 0.99 * disc);
  EXPECT_LT(painted, 1.15 * disc);
}

TEST(KneeScene, FillsItsPanelWithTheScopeAndKeepsThePunchOutOfIt) {
  const KneeScene knee;
  Scene alone = knee.scene();
  alone.shots.pop_back();
  for (const QSize size : kPanels) {
    EXPECT_GT(scopeOf(knee, size).height(), 0.95 * size.height());
    SoftwareRenderer renderer;
    const QImage scope = renderer.draw(alone, size).copy();
    const QImage both = renderer.draw(knee.scene(), size).copy();
    const QRect place = handlesOf(knee, size);
    EXPECT_TRUE(both.rect().contains(place)) << size.width();
    EXPECT_GT(place.height(), 0.25 * size.height()) << size.width();
    int covered = 0;
    for (int y = place.top(); y <= place.bottom(); ++y) {
      for (int x = place.left(); x <= place.right(); ++x)
        covered += isPainted(scope.pixel(x, y)) && both.pixel(x, y) != scope.pixel(x, y) ? 1 : 0;
    }
    EXPECT_EQ(covered, 0) << size.width();
  }
}

TEST(KneeScene, ClosesJawAndHandlesWithTheTravel) {
  KneeScene knee;
  const QImage open = pictureOf(knee);
  EXPECT_EQ(differences(open, pictureOf(knee), open.rect()), 0);
  knee.update({.travel = 8.0}, 0.016);
  const QImage closed = pictureOf(knee);
  EXPECT_GT(differences(open, closed, scopeOf(knee)), 500);
  EXPECT_GT(differences(open, closed, handlesOf(knee)), 200);
}

TEST(KneeScene, ShowsTheWholeInstrumentWithItsHandlesApart) {
  KneeScene knee;
  knee.update({.travel = -0.5}, 0.016);  // as far apart as they go
  for (const QSize size : {QSize(640, 400), QSize(1800, 700), QSize(1024, 500)}) {
    SoftwareRenderer renderer;
    const QImage picture = renderer.draw(knee.scene(), size).copy();
    const QRect view = placeOf(knee.scene().shots.back(), size);
    int painted = 0;
    for (int x = view.left() + 1; x < view.right(); ++x) {
      for (int y = view.top() + 1; y < view.bottom(); ++y) {
        if (isGround(picture.pixel(x, y))) continue;
        ++painted;
        const bool isAtTheEdge = x < view.left() + 3 || x > view.right() - 3 ||
                                 y < view.top() + 3 || y > view.bottom() - 3;
        EXPECT_FALSE(isAtTheEdge) << size.width() << ": " << x << ", " << y;
      }
    }
    EXPECT_GT(painted, 0.04 * view.width() * view.height());
  }
}

TEST(KneeScene, DeformsWithTheFiniteElements) {
  const haptics::engine::MeshView mesh{
      haptics::engine::FiniteElementsSpec{}, haptics::engine::TissueDrawing::Force};
  KneeScene knee;
  knee.update({.travel = 3.9}, 0.016);
  const QImage before = pictureOf(knee);
  knee.update({.travel = 3.9, .force = 6.0, .mesh = &mesh}, 0.016);
  EXPECT_GT(differences(before, pictureOf(knee), scopeOf(knee)), 300);
}

TEST(KneeScene, ShowsTissueAtTheToolAtAnyForce) {
  const haptics::engine::MeshView mesh{haptics::engine::FiniteElementsSpec{}};
  const auto volumeAt = [&](double travel, double force, bool isPressed) {
    KneeScene knee;
    knee.update({.travel = travel, .force = force, .mesh = isPressed ? &mesh : nullptr}, 0.016);
    return volumeOf(knee.meniscus().body());
  };
  EXPECT_LT(volumeAt(5.5, 2.0, true), volumeAt(5.5, 2.0, false));
  EXPECT_EQ(volumeAt(5.5, 2.0, true), volumeAt(5.5, 0.0, true));
  EXPECT_EQ(volumeAt(3.9, 2.0, true), volumeAt(3.9, 2.0, false)) << "before the contact";
}

TEST(KneeScene, CutsOncePerClosureAndMovesToTheNextBite) {
  KneeScene knee;
  const QImage whole = pictureOf(knee);
  for (int i = 0; i < 5; ++i) knee.update({.travel = 8.0, .isCutThrough = true}, 0.016);
  EXPECT_TRUE(knee.meniscus().hasPiece());
  for (const double travel : {9.9, 8.0, 9.9}) {
    knee.update({.travel = travel, .isCutThrough = true}, 0.016);
  }
  KneeScene once;
  once.update({.travel = 9.9, .isCutThrough = true}, 0.016);
  for (int i = 0; i < 100; ++i) {
    for (auto* scene : {&knee, &once}) scene->update({.travel = 0.0}, 0.016);
  }
  EXPECT_FALSE(knee.meniscus().hasPiece());
  EXPECT_EQ(volumeOf(knee.meniscus().body()), volumeOf(once.meniscus().body()));
  EXPECT_GT(differences(whole, pictureOf(knee), scopeOf(knee)), 300);
}

TEST(KneeScene, FillsTheScopeDuringABite) {
  KneeScene knee;
  knee.update({.travel = 9.5}, 0.016);
  for (int i = 0; i < 3; ++i) knee.update({.travel = 5.5}, 0.016);
  Scene bare = knee.scene();
  bare.ground = {0, 255, 0, 0};
  SoftwareRenderer renderer;
  const QImage picture = renderer.draw(bare, kSize).copy();
  const QRect scope = scopeOf(knee);
  int empty = 0;
  for (int y = scope.top(); y <= scope.bottom(); ++y) {
    for (int x = scope.left(); x <= scope.right(); ++x) {
      const QPoint away = QPoint(x, y) - scope.center();
      if (std::hypot(away.x(), away.y()) > 0.48 * scope.width()) continue;
      empty += picture.pixel(x, y) == qRgb(0, 255, 0) ? 1 : 0;
    }
  }
  EXPECT_EQ(empty, 0);
}

TEST(KneeScene, ShowsTheBiteBesideThePunchAfterACut) {
  KneeScene knee;
  const QImage whole = pictureOf(knee);
  knee.update({.travel = 9.9, .isCutThrough = true}, 0.016);
  for (int i = 0; i < 100; ++i) knee.update({.travel = 0.0}, 0.016);
  const QRect scope = scopeOf(knee);
  // To the left of the jaws, which look the same before and after.
  const QRect beside(scope.left(), scope.top(), scope.width() / 2, scope.height());
  EXPECT_GT(differences(whole, pictureOf(knee), beside), 800);
}

TEST(KneeScene, CutsWhenTheJawsMeetEvenWithoutAYield) {
  KneeScene knee;
  knee.update({.travel = 9.5}, 0.016);
  EXPECT_TRUE(knee.meniscus().hasPiece());
}

class HipSceneTest : public testing::Test {
 protected:
  /// Reams to @p depth [m] and withdraws the reamer.
  void ream(double depth) {
    while (!model_.respond({.travel = -0.002}).isDefined) {
    }
    double travel = -0.002;
    for (; travel < depth; travel += 2e-5) model_.respond({.travel = travel});
    for (; travel > -0.02; travel -= 2e-5) model_.respond({.travel = travel});
  }

  haptics::engine::PackingSpec spec_{
      .bone = haptics::engine::parametricBone(), .hardness = 0.5, .forceScale = 0.15};
  haptics::engine::RemovalModel model_{spec_, true, haptics::engine::Reamer::withoutFeedLimit()};
};

bool isBone(QRgb pixel) {
  return qRed(pixel) > qBlue(pixel) + 8 && qRed(pixel) > 60;
}

/// Bone from the inside is redder than at the surface.
bool isFreshBone(QRgb pixel) {
  return qRed(pixel) > qBlue(pixel) + 40;
}

TEST_F(HipSceneTest, ShowsRemovedBone) {
  HipScene hip({.packing = &spec_});
  const TrialSnapshot back{.travel = -0.02, .bone = model_.view()};
  hip.update(back, 0.016);
  const QImage before = pictureOf(hip);
  EXPECT_GT(countWhere(before, isBone), 5000);
  ream(0.012);
  hip.update(back, 0.016);
  const QImage after = pictureOf(hip);
  EXPECT_GT(differences(before, after, before.rect()), 2000);
  EXPECT_GT(countWhere(after, isFreshBone), countWhere(before, isFreshBone) + 2000);
}

TEST_F(HipSceneTest, FillsItsPanelWithTheCup) {
  for (const bool isPlain : {false, true}) {
    const HipScene hip({.packing = isPlain ? nullptr : &spec_});
    Scene cup = hip.scene();
    for (const std::size_t reamer : {0U, 1U}) cup.parts[reamer].isShown = false;
    for (const QSize size : kPanels) {
      SoftwareRenderer renderer;
      const QImage picture = renderer.draw(cup, size).copy();
      QRect box;
      for (int y = 0; y < size.height(); ++y) {
        for (int x = 0; x < size.width(); ++x)
          if (isPainted(picture.pixel(x, y))) box |= QRect(x, y, 1, 1);
      }
      EXPECT_GT(box.height(), 0.8 * size.height()) << size.width();
      EXPECT_TRUE(picture.rect().adjusted(2, 2, -2, -2).contains(box)) << size.width();
      EXPECT_NEAR(box.center().x(), size.width() / 2.0, 0.08 * size.height()) << size.width();
    }
  }
}

TEST_F(HipSceneTest, ShowsTheBoneBehindTheReamerInColours) {
  const HipScene hip({.packing = &spec_, .colours = SphereColours::Density});
  Scene bare = hip.scene();
  for (const std::size_t reamer : {0U, 1U}) bare.parts[reamer].isShown = false;
  SoftwareRenderer renderer;
  const QImage with = renderer.draw(hip.scene(), kSize).copy();
  const QImage without = renderer.draw(bare, kSize).copy();
  const int hidden = differences(with, without, with.rect());
  EXPECT_GT(hidden, 500) << "its outline is drawn";
  EXPECT_LT(hidden, kSize.width() * kSize.height() / 30);
}

TEST_F(HipSceneTest, PlacesTheReamerWhereTheBoneStopsIt) {
  HipScene hip({.packing = &spec_});
  const auto capAt = [&] { return hip.scene().parts[0].pose.column(3).z(); };
  const float start = capAt();
  hip.update({.travel = 0.03, .bone = model_.view()}, 0.016);
  EXPECT_NEAR(capAt(), start, 0.1F);  // the hand is ahead of the reamer, which the bone stops
  hip.update({.travel = 0.03}, 0.016);
  EXPECT_NEAR(capAt(), start + 30.0F, 0.1F);
}

TEST(ContactShadow, IsDeepestAtTheToolAndEndsAtItsReach) {
  const ContactShadow rod{
      .from = {0, 0, 0}, .along = {10, 0, 0}, .radius = 1.0F, .reach = 4.0F, .depth = 0.5F};
  EXPECT_FLOAT_EQ(lightAfterShadow(rod, {5, 1, 0}), 0.5F);
  EXPECT_FLOAT_EQ(lightAfterShadow(rod, {5, 3, 0}), 1.0F - 0.5F * 0.25F);
  EXPECT_FLOAT_EQ(lightAfterShadow(rod, {13, 0, 0}), 1.0F - 0.5F * 0.25F);
  EXPECT_FLOAT_EQ(lightAfterShadow(rod, {5, 5, 0}), 1.0F);
  EXPECT_FLOAT_EQ(lightAfterShadow({}, {5, 1, 0}), 1.0F);
}

/// How much darker the shadow makes a scene's picture, by pixel; and nowhere brighter, but for
/// edges, which are smoothed in the direction of their own brightness.
int darkened(const Scene& scene) {
  constexpr int kSmoothed = 16;  // of 255
  SoftwareRenderer renderer;
  const QImage with = renderer.draw(scene, kSize).copy();
  Scene bare = scene;
  bare.shadows = {};
  const QImage without = renderer.draw(bare, kSize).copy();
  int darker = 0;
  for (int y = 0; y < with.height(); ++y) {
    for (int x = 0; x < with.width(); ++x) {
      const int change = qGray(with.pixel(x, y)) - qGray(without.pixel(x, y));
      EXPECT_LE(change, kSmoothed);
      if (change < -3) ++darker;
    }
  }
  return darker;
}

TEST_F(HipSceneTest, HasAShadowWhereTheReamerIsNear) {
  const int pixels = kSize.width() * kSize.height();
  const int darker = darkened(HipScene(HipScene::Options{}).scene());
  EXPECT_GT(darker, pixels / 500);
  EXPECT_LT(darker, pixels / 3);
}

TEST(KneeScene, HasAShadowWhereThePunchIsNear) {
  const int pixels = kSize.width() * kSize.height();
  const int darker = darkened(KneeScene().scene());
  EXPECT_GT(darker, pixels / 500);
  EXPECT_LT(darker, pixels / 3);
}

TEST_F(HipSceneTest, SpinsWhileATrialRuns) {
  HipScene hip({.packing = &spec_});
  const auto poseOf = [&] { return hip.scene().parts[0].pose; };
  const QMatrix4x4 still = poseOf();
  hip.update({}, 0.1);
  EXPECT_EQ(poseOf(), still);
  hip.update({.isRunning = true}, 0.1);
  EXPECT_NE(poseOf(), still);
}

TEST_F(HipSceneTest, ShowsDensitiesOnRequestOnly) {
  const HipScene neutral({.packing = &spec_});
  const HipScene density({.packing = &spec_, .colours = SphereColours::Density});
  const QImage grey = pictureOf(neutral);
  EXPECT_GT(differences(grey, pictureOf(density), grey.rect()), 5000);
}

TEST(PlainCup, IsShownWithoutABoneOfSpheres) {
  const HipScene hip({});
  EXPECT_EQ(hip.spheres(), nullptr);
  ASSERT_EQ(hip.scene().parts.size(), 4U) << "also the pelvis around it";
  EXPECT_EQ(countOpenEdges(hip.scene().parts[3].mesh), 0);
  EXPECT_GT(countWhere(pictureOf(hip), isBone), 5000);
}

}  // namespace simulated_scenes_test
}  // namespace study::gui::scene
