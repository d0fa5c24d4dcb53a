// The built-in bodies: closed, with triangles facing outwards, and of the right size.
#include <numbers>

#include <gtest/gtest.h>

#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/shapes/reamer_shape.h"
#include "study/gui/scene/shapes/solids.h"
#include "study/gui/scene/shapes/tool_shapes.h"
#include "tests/study/gui/scene/open_edges.h"

namespace study::gui::scene {
namespace shapes_test {

using haptics::engine::MeshView;

TEST(Solids, HaveTheVolumeOfTheirFormula) {
  constexpr double kPi = std::numbers::pi;
  EXPECT_NEAR(volumeOf(rod(0.0F, 10.0F, 2.0F, 96)), kPi * 4.0 * 10.0, 0.2);
  // Pappus: the volume of a torus is 2π² R r².
  EXPECT_NEAR(volumeOf(fingerRing({5, 0, 0}, 10.0F, 2.0F)), 2.0 * kPi * kPi * 10.0 * 4.0, 25.0);
  EXPECT_EQ(countOpenEdges(rod(0.0F, 10.0F, 2.0F)), 0);
  EXPECT_EQ(countOpenEdges(fingerRing({5, 0, 0}, 10.0F, 2.0F)), 0);
}

TEST(Solids, HaveOpenEdgesWhereASheetEnds) {
  const Mesh mesh = sheet({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}}, 3);
  EXPECT_EQ(countOpenEdges(mesh), 6);
  for (const auto& vertex : mesh.vertices) EXPECT_EQ(vertex.normal, QVector3D(0, 0, 1));
}

TEST(Solids, KeepTheirVolumeWhenCreased) {
  Mesh mesh = loft({slab(0.0F, 0.0F, 4.0F, 3.0F, 0.5F), slab(5.0F, 0.0F, 4.0F, 3.0F, 0.5F)});
  const double before = volumeOf(mesh);
  crease(mesh, 35.0F);
  EXPECT_NEAR(volumeOf(mesh), before, 1e-3);
  EXPECT_EQ(countOpenEdges(mesh), 0);
  for (const auto& vertex : mesh.vertices) EXPECT_NEAR(vertex.normal.length(), 1.0F, 1e-4F);
}

TEST(Solids, KeepOneVertexWhereNormalsAreTheSame) {
  Mesh ball = turned({{0.001F, -5.0F}, {3.0F, -4.0F}, {5.0F, 0.0F}, {3.0F, 4.0F}, {0.001F, 5.0F}});
  const std::size_t before = ball.vertices.size();
  crease(ball, 170.0F);
  EXPECT_EQ(ball.vertices.size(), before);
  crease(ball, 1.0F);
  EXPECT_GT(ball.vertices.size(), 2 * before);
}

TEST(Meshes, KeepOnlyWhatMayBeSeen) {
  QMatrix4x4 view;  // the eye at the origin looks along −z, within 45° of it
  Mesh mesh;
  const auto add = [&](QVector3D a, QVector3D b, QVector3D c) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& corner : {a, b, c}) mesh.vertices.push_back({corner, {0, 0, 1}, {}});
    mesh.triangles.push_back({first, first + 1, first + 2});
  };
  add({1, 0, -10}, {2, 0, -10}, {1, 1, -10});          // in the middle
  add({-50, -50, -10}, {50, -50, -10}, {0, 90, -10});  // all around it
  add({20, 0, -10}, {21, 0, -10}, {20, 1, -10});       // beside the field
  add({1, 0, 10}, {2, 0, 10}, {1, 1, 10});             // behind the eye
  const Mesh seen = visiblePart(mesh, view, 45.0F);
  ASSERT_EQ(seen.triangles.size(), 2U);
  EXPECT_EQ(seen.vertices.size(), 6U);
  EXPECT_EQ(seen.vertices[seen.triangles[1].c].position, QVector3D(0, 90, -10));
}

TEST(PunchShape, IsClosedAndFacesOutwards) {
  const PunchShape punch = punchShape();
  for (const Mesh* body : {&punch.body, &punch.grip, &punch.jaw, &punch.rod, &punch.lever}) {
    EXPECT_EQ(countOpenEdges(*body), 0);
    EXPECT_GT(volumeOf(*body), 10.0);
  }
}

TEST(PunchShape, ClosesItsJawWithItsHandle) {
  const QVector3D tip(8.0F, 0.0F, 0.0F);
  EXPECT_GT(jawPose(1.0F).map(tip).y(), 4.0F);
  EXPECT_NEAR(jawPose(0.0F).map(tip).y(), 0.0F, 1e-4F);
  EXPECT_GT(jawHeight(1.0F, 5.0F), jawHeight(0.5F, 5.0F));
  const QVector3D finger(-109.0F, -71.0F, 0.0F);
  EXPECT_GT((leverPose(1.0F).map(finger) - finger).length(), 10.0F);
  EXPECT_EQ(leverPose(0.0F).map(finger), finger);
}

TEST(ReamerShape, IsAHollowHemisphereWithTeeth) {
  const ReamerShape reamer = reamerShape(26.0F);
  EXPECT_EQ(countOpenEdges(reamer.cap), 0);
  EXPECT_EQ(countOpenEdges(reamer.shaft), 0);
  const double hemisphere = 2.0 / 3.0 * std::numbers::pi * 26.0 * 26.0 * 26.0;
  EXPECT_GT(volumeOf(reamer.cap), 0.15 * hemisphere);
  EXPECT_LT(volumeOf(reamer.cap), 0.6 * hemisphere);
  float farthest = 0.0F;
  for (const auto& vertex : reamer.cap.vertices) {
    farthest = std::max(farthest, vertex.position.length());
  }
  EXPECT_GT(farthest, 26.3F);  // includes the teeth
  EXPECT_LT(farthest, 27.5F);
}

TEST(ReamerShape, HasAnOutlineOfItsSizeInThinWires) {
  const Mesh outline = reamerOutline(26.0F);
  EXPECT_EQ(countOpenEdges(outline), 0);
  EXPECT_LT(volumeOf(outline), 700.0);
  float top = 0.0F;
  for (const auto& vertex : outline.vertices) top = std::max(top, vertex.position.z());
  EXPECT_NEAR(top, 26.0F, 0.6F);
}

class MeniscusTest : public testing::Test {
 protected:
  /// A string with one node per displacement.
  static std::vector<MeshView::Point> stringOf(const std::vector<double>& displacements) {
    std::vector<MeshView::Point> points;
    for (const double displacement : displacements) {
      points.push_back({0.5 + 0.25 * static_cast<double>(points.size()), displacement});
    }
    return points;
  }

  KneeLayout layout_;
  Meniscus meniscus_{layout_};
};

TEST_F(MeniscusTest, IsAClosedWedge) {
  EXPECT_EQ(countOpenEdges(meniscus_.body()), 0);
  EXPECT_GT(volumeOf(meniscus_.body()), 500.0);
  EXPECT_FALSE(meniscus_.hasPiece());
}

TEST_F(MeniscusTest, DeformsLikeTheFiniteElements) {
  const Mesh before = meniscus_.body();
  meniscus_.squeeze({.string = stringOf({0, 1, 2, 3, 4, 2, 0}), .openness = 1.0F});
  const Mesh& after = meniscus_.body();
  ASSERT_EQ(after.vertices.size(), before.vertices.size());
  float deepest = 0.0F;
  for (std::size_t i = 0; i < before.vertices.size(); ++i) {
    const float sunk = before.vertices[i].position.y() - after.vertices[i].position.y();
    EXPECT_GT(sunk, -0.2F);
    deepest = std::max(deepest, sunk);
  }
  EXPECT_GT(deepest, 0.5F);
  EXPECT_LT(deepest, 4 * 0.4F);
  EXPECT_EQ(countOpenEdges(after), 0);
  meniscus_.squeeze({});
  EXPECT_EQ(meniscus_.body().vertices[500].position, before.vertices[500].position);
}

TEST_F(MeniscusTest, NeverIntersectsTheJaw) {
  for (const float openness : {0.6F, 0.3F, 0.1F}) {
    meniscus_.squeeze({.string = {}, .openness = openness});
    const QMatrix4x4 toPunch = punchPose(layout_).inverted();
    for (const auto& vertex : meniscus_.body().vertices) {
      const QVector3D place = toPunch.map(vertex.position);
      const bool isBetweenTheJaws =
          place.x() > 0.5F && place.x() < kJawLength && std::abs(place.z()) < kJawHalfWidth;
      if (!isBetweenTheJaws) continue;
      EXPECT_LT(place.y(), std::max(jawHeight(openness, place.x()), 0.27F)) << openness;
      EXPECT_GT(place.y(), 0.0F) << openness;
    }
  }
}

TEST_F(MeniscusTest, BodyAndPieceHaveTheVolumeBeforeTheCut) {
  const double whole = volumeOf(meniscus_.body());
  meniscus_.cut();
  meniscus_.squeeze({});
  ASSERT_TRUE(meniscus_.hasPiece());
  EXPECT_EQ(countOpenEdges(meniscus_.body()), 0);
  EXPECT_EQ(countOpenEdges(meniscus_.piece()), 0);
  const double piece = volumeOf(meniscus_.piece());
  EXPECT_GT(piece, 5.0);
  EXPECT_LT(volumeOf(meniscus_.body()), whole - 0.9 * piece);
  EXPECT_NEAR(volumeOf(meniscus_.body()) + piece, whole, 0.005 * whole);
  meniscus_.removePiece();
  EXPECT_FALSE(meniscus_.hasPiece());
}

TEST_F(MeniscusTest, IsUncutUnderThePunchAfterMovingOn) {
  const double whole = volumeOf(meniscus_.body());
  meniscus_.cut();
  meniscus_.removePiece();
  meniscus_.moveOn(40.0F);
  meniscus_.cut();
  meniscus_.squeeze({});
  EXPECT_NEAR(volumeOf(meniscus_.body()) + 2.0 * volumeOf(meniscus_.piece()), whole, 0.01 * whole);
}

}  // namespace shapes_test
}  // namespace study::gui::scene
