// An anatomy from a file: it is drawn in its place, and nothing else changes.
#include "study/gui/scene/shapes/knee_anatomy.h"

#include <gtest/gtest.h>

#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/software_renderer.h"
#include "tests/study/gui/pictures.h"

namespace study::gui::scene {
namespace knee_anatomy_test {

constexpr QSize kSize(640, 400);

protocols::Anatomy anatomyIn(const std::string& obj) {
  questionnaires::Problems problems;
  auto anatomy = protocols::readAnatomy(obj, problems);
  EXPECT_TRUE(anatomy) << questionnaires::describe(problems.all());
  EXPECT_TRUE(problems.all().empty()) << questionnaires::describe(problems.all());
  return anatomy.value_or(protocols::Anatomy());
}

/// A ridge from left to right at the top of the picture.
std::string ridge(const std::string& name) {
  return "o " + name +
         "\n"
         "v -30 6 0 0.2 0.4 1\nv 30 6 0 0.2 0.4 1\nv 30 16 4 0.2 0.4 1\nv -30 16 4 0.2 0.4 1\n"
         "vn 0 0 1\nf 1//1 2//1 3//1 4//1\n";
}

QImage pictureOf(const SimulatedScene& scene) {
  SoftwareRenderer renderer;
  return renderer.draw(scene.scene(), kSize).copy();
}

/// The share of pixels that differ clearly in the rows from @p top to @p bottom [%].
double shareOfDifferences(const QImage& a, const QImage& b, int top, int bottom) {
  int count = 0;
  for (int y = top; y < bottom; ++y) {
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y);
      const QRgb q = b.pixel(x, y);
      const int apart = std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) +
                        std::abs(qBlue(p) - qBlue(q));
      count += apart > 40 ? 1 : 0;
    }
  }
  return 100.0 * count / ((bottom - top) * a.width());
}

TEST(KneeAnatomy, ReadsBackTheBuiltInKnee) {
  const auto own = anatomyIn(kneeAsObj({}));
  EXPECT_EQ(own.surfaces.size(), 3U);
  const QImage before = pictureOf(KneeScene());
  const QImage after = pictureOf(KneeScene(&own));
  tests::keepPicture(after, QStringLiteral("knee-written-and-read"));
  EXPECT_LT(shareOfDifferences(before, after, 0, kSize.height()), 0.5);
}

TEST(KneeAnatomy, ReplacesTheSurfaceOfTheSameName) {
  const auto own = anatomyIn(ridge("femur"));
  const KneeScene knee(&own);
  const KneeScene ours;
  EXPECT_EQ(knee.scene().parts[1].mesh.vertices.size(), 4U);
  EXPECT_EQ(knee.scene().parts[0].mesh.vertices.size(), ours.scene().parts[0].mesh.vertices.size());
  const QImage before = pictureOf(ours);
  const QImage after = pictureOf(knee);
  tests::keepPicture(after, QStringLiteral("knee-with-a-ridge"));
  EXPECT_GT(shareOfDifferences(before, after, 0, 150), 20.0);
  EXPECT_EQ(shareOfDifferences(before, after, 250, kSize.height()), 0.0);  // tibia and handles
  // Through the arthroscope it has the blue of its vertices.
  const QRgb middle = after.pixel(placeOf(knee.scene().shots.front(), kSize).center().x(), 60);
  EXPECT_GT(qBlue(middle), qRed(middle) + 40);
}

TEST(KneeAnatomy, HasItsOriginAtThePunchsBite) {
  const auto own = anatomyIn(ridge("femur"));
  const KneeLayout layout;
  const QVector3D corner =
      kneeSurfaces(layout, &own).femur.vertices.front().position - punchMouth(layout);
  EXPECT_NEAR((corner - QVector3D(-30.0F, 6.0F, 0.0F)).length(), 0.0F, 1e-4F);
  // The bite is 5.6 mm from the hinge, on the lower jaw.
  EXPECT_NEAR(
      (punchPose(layout).map(QVector3D(5.6F, 0, 0)) - punchMouth(layout)).length(), 0.0F, 1e-4F);
}

TEST(KneeAnatomy, DoesNotReplaceTheMeniscus) {
  const auto own = anatomyIn(ridge("tibia"));
  const KneeScene knee(&own);
  EXPECT_EQ(knee.meniscus().body().vertices.size(), KneeScene().meniscus().body().vertices.size());
}

}  // namespace knee_anatomy_test
}  // namespace study::gui::scene
