#include "haptics/wire/sketch_line.h"

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace haptics::wire {
namespace sketch_line_test {

SketchMesh meshIn(std::string_view line) {
  const auto read = parseSketchLine(line);
  const auto* mesh = read ? std::get_if<SketchMesh>(&*read) : nullptr;
  if (mesh == nullptr) ADD_FAILURE() << "no mesh in '" << line << "'";
  return mesh != nullptr ? *mesh : SketchMesh{};
}

SketchMesh meshOf(std::size_t count) {
  SketchMesh mesh;
  mesh.count = count;
  for (std::size_t i = 0; i < count; ++i) mesh.displacements[i] = static_cast<double>(i);
  return mesh;
}

TEST(SketchLine, ReadsAMeshOfFive) {
  const auto mesh = meshIn("0.58,1.74,2.90,3.33,1.11\r\n");
  ASSERT_EQ(mesh.count, 5U);
  EXPECT_DOUBLE_EQ(mesh.displacements[0], 0.58);
  EXPECT_DOUBLE_EQ(mesh.displacements[4], 1.11);
  EXPECT_DOUBLE_EQ(mesh.toolDisplacement(), 3.33);
}

TEST(SketchLine, ReadsAMeshOfTenAboveTheTissue) {
  const auto mesh = meshIn("-0.20,-0.61,-1.01,-1.42,-1.82,-2.23,-2.63,-2.02,-1.21,-0.40");
  ASSERT_EQ(mesh.count, 10U);
  EXPECT_DOUBLE_EQ(mesh.toolDisplacement(), -2.63);
}

// x = 1.5 lies two thirds along the string: in element floor(2 N / 3).
TEST(SketchLine, TakesTheToolsElementAsTheVisualiserDoes) {
  EXPECT_EQ(meshOf(2).toolDisplacement(), 1.0);
  EXPECT_EQ(meshOf(3).toolDisplacement(), 2.0);
  EXPECT_EQ(meshOf(4).toolDisplacement(), 2.0);
  EXPECT_EQ(meshOf(5).toolDisplacement(), 3.0);
  EXPECT_EQ(meshOf(10).toolDisplacement(), 6.0);
  EXPECT_EQ(meshOf(15).toolDisplacement(), 10.0);
  EXPECT_EQ(meshOf(64).toolDisplacement(), 42.0);
  EXPECT_EQ(SketchMesh{}.toolDisplacement(), 0.0);
}

TEST(SketchLine, ReadsForces) {
  const auto read = parseSketchLine("3.41\t4.28\t3.85\t\r\n");
  ASSERT_TRUE(read && std::holds_alternative<SketchForces>(*read));
  const auto& forces = std::get<SketchForces>(*read);
  EXPECT_DOUBLE_EQ(forces.finiteElements, 3.41);
  EXPECT_DOUBLE_EQ(forces.interpolation, 4.28);
  EXPECT_DOUBLE_EQ(forces.average, 3.85);
}

TEST(SketchLine, RefusesOtherLines) {
  for (const std::string_view line :
       {"",
        "\r\n",
        "Motor ready.",
        "MOT: Align sensor.",
        "1.00",
        "1.00,",
        ",1.00",
        "1.00,,2.00",
        "1.00, 2.00",
        "1.00;2.00",
        "1,00\t2,00\t3,00\t",
        "1.00,nan",
        "inf,1.00",
        "ovf,1.00",
        "1e3,1.00",
        "0x1p3,1.00",
        "+1.00,1.00",
        "--1.00,1.00",
        "1.0.0,2.00",
        "1.00,2.0\n0",
        "1.00\t2.00\t3.00",
        "1.00\t2.00\t",
        "1.00\t2.00\t3.00\t4.00\t",
        "\t\t\t",
        "1.00,2.00\t3.00\t4.00\t",
        "1234567890123456789012345.00,1.00"}) {
    EXPECT_FALSE(parseSketchLine(line)) << "'" << line << "'";
  }
}

TEST(SketchLine, BoundsTheNumberOfFields) {
  const auto lineOf = [](std::size_t fields) {
    std::string line = "0.01";
    for (std::size_t i = 1; i < fields; ++i) line += ",0.01";
    return line;
  };
  EXPECT_EQ(meshIn(lineOf(SketchMesh::kMost)).count, SketchMesh::kMost);
  EXPECT_FALSE(parseSketchLine(lineOf(SketchMesh::kMost + 1)));
  EXPECT_FALSE(parseSketchLine(lineOf(100'000)));
}

TEST(SketchLine, SurvivesGarbage) {
  std::mt19937 random(1);
  const std::string_view likely = "0123456789.,-\t\r\nenaif";
  for (int i = 0; i < 100'000; ++i) {
    std::string line(random() % 40, ' ');
    for (char& c : line) {
      c = random() % 8 == 0 ? static_cast<char>(random() % 256) : likely[random() % likely.size()];
    }
    const auto read = parseSketchLine(line);
    if (!read || !std::holds_alternative<SketchMesh>(*read)) continue;
    const auto& mesh = std::get<SketchMesh>(*read);
    EXPECT_GE(mesh.count, 2U);
    EXPECT_LE(mesh.count, SketchMesh::kMost);
  }
}

}  // namespace sketch_line_test
}  // namespace haptics::wire
