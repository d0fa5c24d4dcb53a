// A knee of somebody's own: read, checked, told about, kept.
#include "protocols/reading/anatomy_file.h"

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "protocols/model/messages.h"
#include "questionnaires/json/document.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"

namespace protocols {
namespace anatomy_file_test {

using tests::says;

/// An object with a square of @p size that lies @p below the origin.
/// @param first  the number of its first corner.
std::string square(const std::string& name, int size, int below, int first = 1) {
  const std::string half = std::to_string(size / 2);
  const std::string height = " -" + std::to_string(below) + " ";
  std::string text = name.empty() ? "" : "o " + name + "\n";
  text += "v -" + half + height + half + "\n";
  text += "v " + half + height + half + "\n";
  text += "v " + half + height + "-" + half + "\n";
  text += "v -" + half + height + "-" + half + "\n";
  text += "vn 0 1 0\nf";
  for (int corner = first; corner < first + 4; ++corner)
    text += " " + std::to_string(corner) + "//1";
  return text + "\n";
}

std::string withoutNormals(const std::string& text) {
  return tests::with(tests::with(text, "//1", ""), "vn 0 1 0\n", "");
}

std::string complaintAbout(const std::string& text) {
  questionnaires::Problems problems;
  EXPECT_FALSE(readAnatomy(text, problems)) << "nothing was wrong";
  return questionnaires::describe(problems.all());
}

TEST(AnatomyFile, TakesItsSurfacesByTheirNames) {
  questionnaires::Problems problems;
  const auto knee = readAnatomy(
      "mtllib /etc/hostname\n" + square("tibia", 60, 2) + square("femur", 40, 1, 5), problems);
  ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
  EXPECT_TRUE(problems.all().empty()) << questionnaires::describe(problems.all());
  const auto* tibia = knee->find(kTibia);
  ASSERT_NE(tibia, nullptr);
  EXPECT_EQ(tibia->triangles.size(), 2U);
  ASSERT_EQ(tibia->places.size(), 4U);
  for (const auto& place : tibia->places) EXPECT_EQ(place[1], -2.0F);
  for (const auto& normal : tibia->normals) EXPECT_EQ(normal[1], 1.0F);
  EXPECT_TRUE(tibia->colours.empty());
  ASSERT_NE(knee->find(kFemur), nullptr);
  EXPECT_EQ(knee->find(kCapsule), nullptr);
}

TEST(AnatomyFile, TakesGroupsAsWell) {
  questionnaires::Problems problems;
  const auto knee =
      readAnatomy(tests::with(square("tibia", 60, 2), "o tibia", "g tibia"), problems);
  ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
  EXPECT_NE(knee->find(kTibia), nullptr);
}

TEST(AnatomyFile, MakesOneSurfaceOfAnObjectInSeveralMaterials) {
  questionnaires::Problems problems;
  const auto text = tests::with(
      square("tibia", 60, 2),
      "f 1//1 2//1 3//1 4//1",
      "usemtl bone\nf 1//1 2//1 3//1\nusemtl rim\nf 1//1 3//1 4//1");
  const auto knee = readAnatomy(text, problems);
  ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
  ASSERT_EQ(knee->surfaces.size(), 1U);
  EXPECT_EQ(knee->surfaces[0].triangles.size(), 2U);
  EXPECT_EQ(knee->surfaces[0].normals.size(), knee->surfaces[0].places.size());
}

TEST(AnatomyFile, MakesNormalsWhereThereAreNoneAndSaysSo) {
  questionnaires::Problems problems;
  const auto knee = readAnatomy(withoutNormals(square("tibia", 60, 2)), problems);
  ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].path, "object 'tibia'");
  EXPECT_EQ(problems.all()[0].what, message("no_normals"));
  for (const auto& normal : knee->find(kTibia)->normals) EXPECT_NEAR(normal[1], 1.0F, 1e-5F);
}

TEST(AnatomyFile, MendsNormalsWithoutADirectionAndSaysSo) {
  for (const char* none : {"vn 0 0 0\n", "vn nan 0 0\n"}) {
    questionnaires::Problems problems;
    const auto knee =
        readAnatomy(tests::with(square("tibia", 60, 2), "vn 0 1 0\n", none), problems);
    ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
    ASSERT_EQ(problems.all().size(), 1U);
    EXPECT_EQ(problems.all()[0].what, message("normals_without_direction", 4));
    for (const auto& normal : knee->find(kTibia)->normals) EXPECT_NEAR(normal[1], 1.0F, 1e-5F);
  }
}

TEST(AnatomyFile, LeavesOutWhatIsThereForOrientation) {
  questionnaires::Problems problems;
  const auto knee = readAnatomy(square("tibia", 60, 2) + square("meniscus", 20, 1, 5), problems);
  ASSERT_TRUE(knee) << questionnaires::describe(problems.all());
  EXPECT_EQ(knee->surfaces.size(), 1U);
}

TEST(AnatomyFile, NamesTheReasonWhenItRefusesAMesh) {
  EXPECT_TRUE(says(complaintAbout(""), "no mesh that can be read"));
  EXPECT_TRUE(says(complaintAbout("this is a letter, and no mesh at all\n"), "save it as OBJ"));
  EXPECT_TRUE(says(complaintAbout(square("patella", 60, 2)), "nothing of the knee has this name"));
  EXPECT_TRUE(says(complaintAbout(square("patella", 60, 2)), "object 'patella'"));
  EXPECT_TRUE(says(complaintAbout(square("", 60, 2)), "object without a name"));
  EXPECT_TRUE(says(complaintAbout(square("meniscus", 60, 2)), "no object in it replaces anything"));
  EXPECT_TRUE(says(complaintAbout("o tibia\nv 0 0 0\nv 0 30 0\nl 1 2\n"), "triangle"));
}

TEST(AnatomyFile, RefusesNumbersThatAreNotFinite) {
  const auto sound = square("tibia", 60, 2);
  EXPECT_TRUE(says(
      complaintAbout(tests::with(sound, "v -30 -2 30\n", "v -30 nan 30\n")), "lies at no number"));
  EXPECT_TRUE(says(
      complaintAbout(tests::with(sound, "v -30 -2 30\n", "v inf -2 30\n")), "lies at no number"));
  EXPECT_FALSE(complaintAbout(tests::with(sound, "4//1", "9//1")).empty());
}

TEST(AnatomyFile, KnowsAKneesSizeAndPlace) {
  EXPECT_TRUE(says(complaintAbout(square("tibia", 10, 2)), "likely centimetres"));
  EXPECT_TRUE(says(complaintAbout(square("tibia", 900, 2)), "no knee's size"));
  const auto metres =
      tests::with(tests::with(square("tibia", 60, 2), "30", "0.030"), " -2 ", " -0.002 ");
  EXPECT_TRUE(says(complaintAbout(metres), "likely metres"));
  EXPECT_TRUE(says(complaintAbout(square("tibia", 60, 300)), "would not be seen"));
}

TEST(AnatomyFile, RefusesMoreThanCanBeDrawnInTime) {
  auto text = square("tibia", 60, 2);
  for (std::size_t i = 0; i < kMostTriangles; ++i) text += "f 1//1 2//1 3//1\n";
  EXPECT_TRUE(says(complaintAbout(text), "30002 triangles are more than can be drawn in time"));
}

/// usualProtocol() whose conditions are seen, each with an anatomy of its own.
std::string seeing(const std::string& first, const std::string& second) {
  auto json = tests::usualProtocol();
  for (const auto& [yield, knee] : {std::pair("3", first), std::pair("6", second)}) {
    const std::string parameters =
        std::string(R"("parameters": { "yield_force_n": )") + yield + " }";
    json = tests::with(
        json, parameters, parameters + R"(, "visualisation": true, "anatomy": ")" + knee + "\"");
  }
  return json;
}

TEST(AnatomyOfAProtocol, IsReadOnceSharedKeptAndListed) {
  int asked = 0;
  const auto find = [&](const std::string& name) -> std::optional<std::string> {
    asked += name == "knee.obj" ? 1 : 0;
    return name == "knee.obj" ? std::optional(square("tibia", 60, 2)) : std::nullopt;
  };
  const auto loading = tests::load(seeing("knee.obj", "knee.obj"), find);
  ASSERT_TRUE(loading.loaded) << loading.describe();
  const auto& conditions = loading.loaded->protocol.conditions;
  ASSERT_NE(conditions[0].knee, nullptr);
  EXPECT_EQ(conditions[0].knee, conditions[1].knee);
  EXPECT_EQ(asked, 1);
  ASSERT_FALSE(loading.loaded->files.empty());
  EXPECT_EQ(loading.loaded->files[0].text, square("tibia", 60, 2));
  ASSERT_EQ(loading.loaded->sources.size(), 1U);
  EXPECT_EQ(loading.loaded->sources[0].kind, "anatomy");
  EXPECT_EQ(loading.loaded->sources[0].conditions.size(), 2U);
  EXPECT_TRUE(says(describe(loading.loaded->sources[0]), "(anatomy 'knee.obj'), tibia"));
}

TEST(AnatomyOfAProtocol, HasItsProblemsAtItsPlace) {
  const auto find = [](const std::string& name) -> std::optional<std::string> {
    return name == "knee.obj" ? std::optional(square("patella", 60, 2)) : std::nullopt;
  };
  const auto refused = tests::load(seeing("knee.obj", "../knee.obj"), find);
  EXPECT_FALSE(refused.loaded);
  EXPECT_TRUE(says(refused.describe(), "knee.obj object 'patella'"));
  EXPECT_TRUE(says(refused.describe(), "$.conditions[1].scene.anatomy"));
  EXPECT_TRUE(says(refused.describe(), "outside the protocol's folder"));
  const auto none = tests::load(seeing("hip.obj", "hip.obj"), find);
  EXPECT_TRUE(says(none.describe(), "there is no file 'hip.obj'"));
}

TEST(AnatomyOfAProtocol, IsWarnedOf) {
  const auto find = [](const std::string&) { return std::optional(square("tibia", 60, 2)); };
  const auto other = tests::load(seeing("one.obj", "other.obj"), find);
  ASSERT_TRUE(other.loaded) << other.describe();
  EXPECT_TRUE(says(other.describe(), "can be told apart by what is seen"));
  const auto same = tests::load(seeing("one.obj", "one.obj"), find);
  EXPECT_FALSE(says(same.describe(), "can be told apart"));
  const auto unseen = tests::load(
      tests::with(
          seeing("one.obj", "one.obj"), "\"visualisation\": true", "\"visualisation\": false"),
      find);
  ASSERT_TRUE(unseen.loaded) << unseen.describe();
  EXPECT_TRUE(says(unseen.describe(), "it is never seen"));
}

TEST(AnatomyOfAProtocol, IsFoundBesideAFile) {
  const tests::ScratchFolder folder;
  folder.write("protocol.json", seeing("knee.obj", "knee.obj"));
  folder.write("knee.obj", square("femur", 60, 2));
  questionnaires::Problems problems;
  const auto loaded = loadProtocolFile(folder / "protocol.json", problems);
  ASSERT_TRUE(loaded) << questionnaires::describe(problems.all());
  EXPECT_NE(loaded->protocol.conditions[0].knee->find(kFemur), nullptr);
}

}  // namespace anatomy_file_test
}  // namespace protocols
