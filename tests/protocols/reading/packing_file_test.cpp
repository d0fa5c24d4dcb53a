#include "protocols/reading/packing_file.h"

#include <gtest/gtest.h>

#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace packing_file_test {

namespace reaming = haptics::reaming;

reaming::PackedBone bone() {
  reaming::PackedBone made{.name = "cup", .title = "A cup", .isSynthetic = true};
  made.packing = *reaming::pack(reaming::Acetabulum(), {.count = 50});
  for (std::size_t i = 0; i < 50; ++i) {
    made.minimum.push_back(1.0F + static_cast<float>(i));
    made.average.push_back(1e5F / 3.0F);
    made.maximum.push_back(0.0F);
  }
  return made;
}

std::string complaintAbout(const std::string& text) {
  questionnaires::Problems problems;
  EXPECT_FALSE(readPacking(text, problems));
  return questionnaires::describe(problems.all());
}

TEST(PackingFile, ComesBackAsItWas) {
  auto made = bone();
  made.friction = 0.45;
  questionnaires::Problems problems;
  PackingOrigin origin;
  const auto text = packingAsText(
      made, {.mesh = "hip.stl", .sha256 = "00ff", .material = "bone, dynamic-1", .seed = 9});
  const auto found = readPacking(text, problems, &origin);
  ASSERT_TRUE(found) << questionnaires::describe(problems.all());
  EXPECT_EQ(found->name, "cup");
  EXPECT_TRUE(found->isSynthetic);
  EXPECT_EQ(found->packing.volume, made.packing.volume);
  EXPECT_EQ(found->friction, 0.45);
  EXPECT_EQ(found->minimum, made.minimum);
  EXPECT_EQ(found->average, made.average);
  EXPECT_EQ(found->maximum, made.maximum);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_EQ(found->packing.spheres[i].x, made.packing.spheres[i].x);
    EXPECT_EQ(found->packing.spheres[i].radius, made.packing.spheres[i].radius);
  }
  EXPECT_EQ(origin.mesh, "hip.stl");
  EXPECT_EQ(origin.material, "bone, dynamic-1");
  EXPECT_EQ(origin.seed, 9U);
}

TEST(PackingFile, SaysWhatIsWrong) {
  const auto text = packingAsText(bone(), {.mesh = "hip.stl"});
  const auto has = [](const std::string& words, const char* part) {
    EXPECT_NE(words.find(part), std::string::npos) << words;
  };
  has(complaintAbout(""), "");
  has(complaintAbout("{}"), "'format' is missing; write \"format\": \"palpate-packing-1\"");
  has(complaintAbout(tests::with(text, "palpate-packing-1", "palpate-packing-9")),
      "is written for 'palpate-packing-9'");
  has(complaintAbout(text.substr(0, text.size() - 30)), "damaged");
  has(complaintAbout(text.substr(0, text.size() - 57)), "49 spheres, not 50");
  has(complaintAbout(text + "\n"), "line 52");
  auto spoilt = text;
  spoilt[text.find('\n') + 3] = 'x';
  has(complaintAbout(spoilt), "line 2");
}

std::string withPacking(const std::string& parameters) {
  return tests::reamingProtocol(
      "packing", parameters, R"({"hardness": 1, "packing": "cup.packing", "removal": false})");
}

TEST(PackingFile, IsReadFromTheFolderOfAProtocolAndShared) {
  const auto find = [](const std::string& name) {
    const bool isThere = name == "cup.packing";
    auto fitted = bone();
    fitted.friction = 0.45;
    return isThere ? std::optional(packingAsText(fitted, {.mesh = "hip.stl"})) : std::nullopt;
  };
  const auto loading = tests::load(
      withPacking(R"({"hardness": 0.5, "packing": "cup.packing", "friction": 0.3})"), find);
  ASSERT_TRUE(loading.loaded) << loading.describe();
  const auto specOf = [&](const char* id) {
    return std::get<haptics::engine::PackingSpec>(*loading.loaded->protocol.condition(id)->model);
  };
  EXPECT_EQ(specOf("a").bone, specOf("b").bone);
  EXPECT_TRUE(specOf("a").isRemoved);
  EXPECT_FALSE(specOf("b").isRemoved);
  EXPECT_EQ(specOf("a").options.friction, 0.3);
  EXPECT_EQ(specOf("b").options.friction, 0.45) << "that which the packing was fitted with";
  EXPECT_EQ(specOf("a").bone->packing.spheres.size(), 50U);

  const auto refusalOf = [&](const std::string& parameters) {
    const auto refused = tests::load(withPacking(parameters), find);
    EXPECT_FALSE(refused.loaded);
    return refused.describe();
  };
  const auto has = [](const std::string& words, const char* part) {
    EXPECT_NE(words.find(part), std::string::npos) << words;
  };
  has(refusalOf(R"({"hardness": 0.5, "packing": "none.packing"})"), "there is no file");
  has(refusalOf(R"({"hardness": 0.5, "packing": "cup.json"})"), "no file");
  has(refusalOf(R"({"hardness": 0.5, "removal": false, "cutting_damping": 0.2})"), "only a bone");
  has(refusalOf(R"({"packing": "cup.packing"})"), "hardness");
}

}  // namespace packing_file_test
}  // namespace protocols
