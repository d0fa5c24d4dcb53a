#include "protocols/reading/material_file.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "haptics/reaming/material/synthetic_series.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace material_file_test {

namespace reaming = haptics::reaming;

std::string fittedJson() {
  const std::vector series{
      reaming::syntheticSeries({.hardness = 0.2, .seed = 1}),
      reaming::syntheticSeries({.hardness = 0.9, .seed = 2})};
  const reaming::FitOptions options{.wantedError = 0.2};
  return materialAsJson(
      "bone", "Bone", true, reaming::fitMaterial(series, options), options, {{"a.csv", ""}, {}});
}

std::string complaintAbout(const std::string& json) {
  questionnaires::Problems problems;
  EXPECT_FALSE(readMaterial(json, problems));
  return questionnaires::describe(problems.all());
}

TEST(MaterialFile, ComesBackAsItWas) {
  const std::vector series{reaming::syntheticSeries({.seed = 1})};
  const reaming::FitOptions options;
  const auto fit = reaming::fitMaterial(series, options);
  questionnaires::Problems problems;
  const auto material =
      readMaterial(materialAsJson("bone", "Bone", true, fit, options, {{"a.csv", "00"}}), problems);
  ASSERT_TRUE(material) << questionnaires::describe(problems.all());
  EXPECT_TRUE(material->isSynthetic);
  ASSERT_EQ(material->sets.size(), 1U);
  const auto& wanted = fit.sets[0].force.average.spline.nodes;
  const auto& found = material->sets[0].force.average;
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].position, wanted[i].position);
    EXPECT_EQ(found[i].force, wanted[i].force);
    EXPECT_EQ(found[i].slope, wanted[i].slope);
  }
  EXPECT_FALSE(material->sets[0].torque.isEmpty());
}

TEST(MaterialFile, WritesTheMiddleSpecimenUnderItsOwnKey) {
  std::vector<reaming::Series> series;
  for (const double hardness : {0.2, 0.5, 0.9}) {
    series.push_back(reaming::syntheticSeries({.hardness = hardness, .seed = 1}));
  }
  const reaming::FitOptions options{
      .envelope = reaming::EnvelopeRule::SingleSample, .wantedError = 0.2};
  const auto fit = reaming::fitMaterial(series, options);
  const auto json = materialAsJson("bone", "Bone", true, fit, options, {{}, {}, {}});
  EXPECT_NE(json.find("\"middle_specimen\""), std::string::npos);
  EXPECT_EQ(json.find("\"average\""), std::string::npos);
  questionnaires::Problems problems;
  const auto material = readMaterial(json, problems);
  ASSERT_TRUE(material) << questionnaires::describe(problems.all());
  EXPECT_EQ(material->sets[0].force.average.size(), fit.sets[0].force.average.spline.nodes.size());
}

TEST(MaterialFile, SaysHowManySpecimensCountAtEachDepth) {
  std::vector<reaming::Series> series;
  for (const double hardness : {0.2, 0.9}) {
    series.push_back(
        reaming::syntheticSeries({.set = reaming::TestSet::Static, .hardness = hardness}));
  }
  const auto fit = reaming::fitMaterial(series, {});
  const auto json = nlohmann::json::parse(materialAsJson("bone", "Bone", true, fit, {}, {{}, {}}));
  const auto& provenance = json.at("provenance");
  EXPECT_EQ(provenance.at("settings").at("axis"), "depth");
  EXPECT_EQ(provenance.at("series").at(1).at("ended_at_force_limit"), true);
  const auto& specimens = provenance.at("errors").at("static").at("specimens");
  ASSERT_EQ(specimens.size(), 2U);
  EXPECT_EQ(specimens.at(0).at("measured"), 2);
  EXPECT_EQ(specimens.at(0).at("held"), 0);
  EXPECT_EQ(specimens.at(1).at("measured"), 1);
  EXPECT_EQ(specimens.at(1).at("held"), 1);
  EXPECT_NEAR(specimens.at(1).at("from_m").get<double>(), fit.series[1].largestDisplacement, 1e-5);
}

TEST(MaterialFile, SaysWhatIsWrong) {
  const auto json = fittedJson();
  EXPECT_NE(
      complaintAbout(tests::with(json, "palpate-material-1", "palpate-material-9"))
          .find("this is written for 'palpate-material-9'"),
      std::string::npos);
  EXPECT_NE(
      complaintAbout(tests::with(json, "\"average\"", "\"middle\"")).find("middle"),
      std::string::npos);
  EXPECT_NE(complaintAbout("{}").find("'format' is missing"), std::string::npos);
  EXPECT_NE(
      complaintAbout(tests::with(json, "\"depth_m\": 0.0,", "\"depth_m\": 0.9,"))
          .find("does not lie deeper"),
      std::string::npos);
}

TEST(MaterialFile, SaysOnceThatItsDepthsAreInAnotherUnit) {
  const std::string node = R"("force_n": 1, "slope_n_per_m": 1)";
  const std::string curve = R"([{"depth_m": 0, )" + node + R"(}, {"depth_m": 7.5, )" + node +
                            R"(}, {"depth_m": 15.2, )" + node + "}]";
  const auto complaint = complaintAbout(
      R"({"format": "palpate-material-1", "name": "bone", "title": "Bone", "sets": [)"
      R"({"test_set": "static", "force": {"minimum": )" +
      curve + R"(, "average": )" + curve + R"(, "maximum": )" + curve + "}}]}");
  EXPECT_NE(complaint.find("the curves go 15.2 m deep"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("millimetres"), std::string::npos) << complaint;
  EXPECT_EQ(complaint.find("does not lie deeper"), std::string::npos) << complaint;
  EXPECT_EQ(std::count(complaint.begin(), complaint.end(), '$'), 1) << complaint;
}

TEST(MaterialFile, IsFeltAtItsHardness) {
  questionnaires::Problems problems;
  const auto material = readMaterial(fittedJson(), problems);
  ASSERT_TRUE(material);
  const auto& curves = material->sets[0].force;
  const auto forceAt = [](const reaming::CurveNodes& nodes, double x) {
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
      if (x > nodes[i + 1].position) continue;
      return haptics::models::CubicSegment<double>::between(nodes[i], nodes[i + 1]).at(x).force;
    }
    return nodes.back().force;
  };
  for (const double x : {0.001, 0.0042, 0.006, 0.0083}) {
    const double soft = forceAt(curves.minimum, x);
    const double middle = forceAt(curves.average, x);
    const double hard = forceAt(curves.maximum, x);
    EXPECT_NEAR(forceAt(reaming::curveOf(curves, 0.0), x), soft, 1e-6);
    EXPECT_NEAR(forceAt(reaming::curveOf(curves, 0.25), x), 0.5 * (soft + middle), 1e-6);
    EXPECT_NEAR(forceAt(reaming::curveOf(curves, 0.5), x), middle, 1e-6);
    EXPECT_NEAR(forceAt(reaming::curveOf(curves, 0.9), x), 0.2 * middle + 0.8 * hard, 1e-6);
    EXPECT_NEAR(forceAt(reaming::curveOf(curves, 1.0), x), hard, 1e-6);
  }
}

std::string withMaterial(const std::string& parameters) {
  return tests::reamingProtocol("material", parameters, R"({"hardness": 1})");
}

TEST(MaterialFile, IsReadFromTheFolderOfTheProtocol) {
  const auto find = [](const std::string& name) {
    return name == "bone.json" ? std::optional(fittedJson()) : std::nullopt;
  };
  const auto loading = tests::load(
      withMaterial(R"({"hardness": 0.5, "material": "bone.json", "force_scale": 0.2})"), find);
  ASSERT_TRUE(loading.loaded) << loading.describe();
  const auto& spec =
      std::get<haptics::engine::MaterialSpec>(*loading.loaded->protocol.condition("a")->model);
  EXPECT_FALSE(spec.curves.isEmpty());
  EXPECT_FALSE(spec.isMeasured);
  const auto& sources = loading.loaded->sources;
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(describe(sources[0]), "SYNTHETIC: Bone (material 'bone.json'), test set dynamic-1");
  EXPECT_EQ(sources[0].conditions, std::vector<std::string>{"a"});
  EXPECT_TRUE(sources[1].isSynthetic);
  EXPECT_NE(describe(sources[1]).find("built into the program"), std::string::npos);
  EXPECT_EQ(spec.jitter.rms, 0.0);
  EXPECT_TRUE(haptics::engine::problemsOf({.model = spec}).empty());

  const auto shaken = tests::load(
      withMaterial(
          R"({"hardness": 0.5, "material": "bone.json", "jitter": true, "jitter_seed": 7})"),
      find);
  ASSERT_TRUE(shaken.loaded) << shaken.describe();
  const auto& noisy =
      std::get<haptics::engine::MaterialSpec>(*shaken.loaded->protocol.condition("a")->model);
  EXPECT_GT(noisy.jitter.rms, 0.1);
  EXPECT_EQ(noisy.jitterSeed, 7U);

  const auto refusalOf = [&](const std::string& parameters) {
    const auto refused = tests::load(withMaterial(parameters), find);
    EXPECT_FALSE(refused.loaded);
    return refused.describe();
  };
  EXPECT_NE(
      refusalOf(R"({"hardness": 0.5, "material": "none.json"})").find("there is no file"),
      std::string::npos);
  EXPECT_NE(
      refusalOf(R"({"hardness": 0.5, "material": "bone.json", "test_set": "static"})")
          .find("has no test set 'static'"),
      std::string::npos);
  EXPECT_NE(
      refusalOf(R"({"hardness": 0.5, "test_set": "static"})").find("only a fitted material"),
      std::string::npos);
}

}  // namespace material_file_test
}  // namespace protocols
