#include "haptics/reaming/packing/triangle_mesh.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::reaming {
namespace triangle_mesh_test {

/// A box from a corner to the opposite one: 12 triangles, right side out.
TriangleMesh box(Vec3 low, Vec3 high) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.push_back(
        {(i & 1) != 0 ? high.x : low.x,
         (i & 2) != 0 ? high.y : low.y,
         (i & 4) != 0 ? high.z : low.z});
  }
  mesh.triangles = {
      {0, 2, 1},
      {1, 2, 3},
      {4, 5, 6},
      {5, 7, 6},
      {0, 1, 4},
      {1, 5, 4},
      {2, 6, 3},
      {3, 6, 7},
      {0, 4, 2},
      {2, 4, 6},
      {1, 3, 5},
      {3, 7, 5}};
  return mesh;
}

std::string all(const std::vector<std::string>& problems) {
  std::string text;
  for (const auto& problem : problems) text += problem + "\n";
  return text;
}

TEST(TriangleMesh, ABoxHasAnInside) {
  const auto mesh = box({0.0, 0.0, 0.0}, {0.03, 0.02, 0.01});
  EXPECT_NEAR(mesh.volume(), 6e-6, 1e-18);
  EXPECT_EQ(all(problemsOf(mesh)), "");
  EXPECT_EQ(likelyUnit(mesh), 1.0);
  EXPECT_EQ(likelyUnit(box({}, {30.0, 20.0, 10.0})), 0.001);
  EXPECT_EQ(likelyUnit(box({}, {1e-4, 1e-4, 1e-4})), 0.0);
}

TEST(TriangleMesh, GivesTheReasonsWhyItHasNoInterior) {
  auto open = box({}, {0.03, 0.02, 0.01});
  open.triangles.pop_back();
  EXPECT_NE(all(problemsOf(open)).find("open: 3 edges"), std::string::npos);
  auto turned = box({}, {0.03, 0.02, 0.01});
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_NE(all(problemsOf(turned)).find("face opposite ways"), std::string::npos);
  auto crowded = box({}, {0.03, 0.02, 0.01});
  crowded.vertices.push_back({0.1, 0.1, 0.1});
  crowded.triangles.push_back({0, 1, 8});
  EXPECT_NE(all(problemsOf(crowded)).find("more than two triangles"), std::string::npos);
  auto cut = box({}, {0.03, 0.02, 0.01});
  const auto other = box({0.011, 0.007, 0.004}, {0.041, 0.027, 0.018});
  for (const auto& v : other.vertices) cut.vertices.push_back(v);
  for (const auto& t : other.triangles) cut.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  EXPECT_NE(all(problemsOf(cut)).find("cuts itself"), std::string::npos);
  EXPECT_NE(all(problemsOf({})).find("fewer than four"), std::string::npos);
  auto nowhere = box({}, {0.03, 0.02, 0.01});
  nowhere.vertices[3].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(all(problemsOf(nowhere)).find("no number"), std::string::npos);
  EXPECT_NE(
      all(problemsOf(box({}, {0.03, 0.02, 0.0}))).find("encloses nothing"), std::string::npos);
}

TriangleMesh both(TriangleMesh one, const TriangleMesh& other) {
  const auto first = static_cast<std::uint32_t>(one.vertices.size());
  for (const auto& v : other.vertices) one.vertices.push_back(v);
  for (const auto& t : other.triangles) {
    one.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return one;
}

TEST(TriangleMesh, OfSeveralPartsHasOneInsideOnly) {
  const auto outer = box({}, {0.04, 0.04, 0.04});
  const auto inner = box({0.01, 0.01, 0.01}, {0.03, 0.03, 0.03});
  auto hollow = inner;
  for (auto& t : hollow.triangles) std::swap(t[1], t[2]);
  auto aside = box({0.07, 0.0, 0.0}, {0.09, 0.02, 0.02});
  EXPECT_EQ(all(problemsOf(both(outer, hollow))), "");
  EXPECT_EQ(all(problemsOf(both(outer, aside))), "");
  EXPECT_NE(all(problemsOf(both(outer, inner))).find("wrong way"), std::string::npos);
  for (auto& t : aside.triangles) std::swap(t[1], t[2]);
  EXPECT_NE(all(problemsOf(both(outer, aside))).find("wrong way"), std::string::npos);
  const MeshSolid solid(both(outer, hollow));
  EXPECT_GT(solid.nearest({0.005, 0.02, 0.02}).distance, 0.0);
  EXPECT_LT(solid.nearest({0.02, 0.02, 0.02}).distance, 0.0);
}

TEST(TriangleMesh, CutsItselfAlsoWhereOnlyEdgesMeet) {
  const auto cut = both(box({}, {1.0, 1.0, 1.0}), box({0.5, 0.5, 0.0}, {1.5, 1.5, 1.0}));
  EXPECT_NE(all(problemsOf(cut)).find("cuts itself"), std::string::npos);
}

TEST(TriangleMesh, IsNotRepairedIfAVertexIsNaN) {
  auto mesh = box({}, {0.03, 0.02, 0.01});
  mesh.vertices[0].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(repair(mesh).empty());
  EXPECT_NE(all(problemsOf(mesh)).find("no number"), std::string::npos);
}

TEST(TriangleMesh, ReportsEveryRepair) {
  auto mesh = box({}, {0.03, 0.02, 0.01});
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);  // inside out
  for (auto& t : mesh.triangles) {                       // and every corner for itself
    for (auto& corner : t) {
      mesh.vertices.push_back(mesh.vertices[corner]);
      corner = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    }
  }
  mesh.triangles.push_back(mesh.triangles.front());
  mesh.triangles.push_back({1, 1, 2});
  const auto repairs = all(repair(mesh));
  EXPECT_NE(repairs.find("36 corners were joined"), std::string::npos) << repairs;
  EXPECT_NE(repairs.find("2 triangles without area"), std::string::npos) << repairs;
  EXPECT_NE(repairs.find("inside out"), std::string::npos) << repairs;
  EXPECT_EQ(all(problemsOf(mesh)), "");
  EXPECT_NEAR(mesh.volume(), 6e-6, 1e-18);
}

/// Of a place to the surface of a box, below 0 outside.
double exactly(Vec3 p, Vec3 high) {
  const double in = std::min({p.x, p.y, p.z, high.x - p.x, high.y - p.y, high.z - p.z});
  if (in >= 0.0) return in;
  const Vec3 off{
      std::max({-p.x, 0.0, p.x - high.x}),
      std::max({-p.y, 0.0, p.y - high.y}),
      std::max({-p.z, 0.0, p.z - high.z})};
  return -length(off);
}

TEST(MeshSolid, HasEveryDistanceOfABox) {
  const Vec3 high{0.03, 0.02, 0.01};
  const MeshSolid solid(box({}, high));
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> around(-0.02, 0.05);
  for (int i = 0; i < 5000; ++i) {
    const Vec3 place{around(random), around(random), around(random)};
    const auto found = solid.nearest(place);
    ASSERT_NEAR(found.distance, exactly(place, high), 1e-12);
    // The distance grows along its direction.
    const auto step = solid.nearest(place + 1e-6 * found.inward);
    ASSERT_NEAR(step.distance, found.distance + 1e-6, 1e-9);
  }
}

TEST(MeshSolid, CanBeFilled) {
  const MeshSolid solid(box({}, {0.03, 0.02, 0.01}));
  const auto packing = *pack(solid, {.count = 1000});
  EXPECT_LE(flawsOf(packing, solid).overlap, 1e-9);
  EXPECT_LE(flawsOf(packing, solid).protrusion, 1e-9);
  EXPECT_GT(packing.coverage(), 0.6);
}

}  // namespace triangle_mesh_test
}  // namespace haptics::reaming
