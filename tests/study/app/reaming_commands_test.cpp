// The commands from measured series to a bone that a protocol can name.
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"

namespace reaming_commands_test {

using tests::says;

class ReamingCommands : public testing::Test {
 protected:
  tests::Finished palpate(std::vector<std::string> call) const {
    call.insert(call.begin(), tests::releaseProgram());
    return tests::run(call);
  }
  std::string output(const std::vector<std::string>& call) const {
    const auto finished = palpate(call);
    EXPECT_EQ(finished.status, 0) << finished.error;
    return finished.out;
  }
  std::string refusal(const std::vector<std::string>& call) const {
    const auto finished = palpate(call);
    EXPECT_NE(finished.status, 0);
    return finished.error;
  }
  /// An OBJ file of a box of 60 × 60 × 20 units that extends in +z; with a hole if @p isOpen.
  std::string box(const std::string& name, double scale, bool isOpen) const {
    std::string text;
    for (int i = 0; i < 8; ++i) {
      const double corner[]{
          scale * ((i & 1) != 0 ? 30.0 : -30.0),
          scale * ((i & 2) != 0 ? 30.0 : -30.0),
          scale * ((i & 4) != 0 ? 20.0 : 0.0)};
      text += "v";
      for (const double x : corner) text += " " + std::to_string(x);
      text += "\n";
    }
    text +=
        "f 1 3 2\nf 2 3 4\nf 5 6 7\nf 6 8 7\nf 1 2 5\nf 2 6 5\n"
        "f 3 7 4\nf 4 7 8\nf 1 5 3\nf 3 5 7\nf 2 4 6\n";
    if (!isOpen) text += "f 4 8 6\n";
    return folder_.write(name, text);
  }

  /// A file of a static test of one specimen.
  std::string staticTest(double hardness) const {
    const auto series = haptics::reaming::syntheticSeries(
        {.set = haptics::reaming::TestSet::Static, .hardness = hardness});
    return folder_.write(
        "static-" + std::to_string(hardness) + ".csv", haptics::reaming::asText(series));
  }

  tests::ScratchFolder folder_;
};

TEST_F(ReamingCommands, MakeABoneForAProtocolFromSeries) {
  const std::string series = folder_ / "series";
  EXPECT_TRUE(says(output({"material", "synthesise", series}), "synthetic"));
  const std::string material = folder_ / "bone.json";
  const auto said = output(
      {"material",
       "fit",
       "--dynamic-1",
       series + "/synthetic-specimen-3--dynamic-1.csv",
       series + "/synthetic-specimen-9--dynamic-1.csv",
       "--out",
       material});
  EXPECT_TRUE(says(said, "dynamic-1   2 series"));
  EXPECT_TRUE(says(said, "SYNTHETIC"));
  const std::string built = folder_ / "cup.packing";
  EXPECT_TRUE(
      says(output({"packing", "build", "--count", "1500", "--out", built}), "1500 spheres"));
  const std::string fitted = folder_ / "bone.packing";
  const auto fit = output(
      {"packing",
       "fit",
       built,
       "--material",
       material,
       "--out",
       fitted,
       "--report",
       folder_ / "report"});
  EXPECT_TRUE(says(fit, "of the spheres are touched"));
  EXPECT_TRUE(says(fit, "SYNTHETIC"));
  EXPECT_EQ(fit.find("WARNING"), std::string::npos) << fit;
  const std::string other = folder_ / "other.packing";
  EXPECT_TRUE(says(
      refusal({"packing", "fit", material, "--material", material, "--out", other}),
      "spheres are wanted here"));
  EXPECT_TRUE(says(
      refusal({"packing", "fit", built, "--material", built, "--out", other}),
      "--material wants a material"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/packing.html"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "report/packing-forces.csv"));
  const auto protocol = folder_.write("protocol.json", R"({
    "$schema": "protocol-1.schema.json",
    "study": {"id": "bone", "title": "Bone", "version": "1"},
    "languages": ["en"], "cohorts": [{"id": "all", "title": "All", "planned": 2}],
    "devices": [{"id": "arm", "kind": "reamer", "max_force_n": 140,
                 "max_force_rate_n_per_s": 5000}],
    "conditions": [
      {"id": "curve", "title": "Curve", "scene": {"device": "arm", "model": "material",
       "parameters": {"hardness": 0.5, "force_scale": 0.2, "material": "bone.json"}}},
      {"id": "kept", "title": "Kept", "scene": {"device": "arm", "model": "packing", "parameters":
       {"hardness": 0.5, "force_scale": 0.2, "packing": "bone.packing", "removal": false}}},
      {"id": "reamed", "title": "Reamed", "scene": {"device": "arm", "model": "packing",
       "parameters": {"hardness": 0.5, "force_scale": 0.2, "packing": "bone.packing"}}}],
    "labels": {"policy": "random"},
    "phases": [{"id": "consent", "type": "consent", "instrument": "consent-reaming"},
               {"id": "felt", "type": "block", "conditions": ["curve", "kept", "reamed"],
                "order": {"type": "balancedLatinSquare"}, "minimum_cuts": 1}]})");
  for (const std::string condition : {"curve", "reamed"}) {
    const auto cost = output({"scene", "explain", protocol, "--condition", condition, "--cost"});
    EXPECT_TRUE(says(cost, "as it is"));
    EXPECT_TRUE(says(cost, "felt from SYNTHETIC"));
    EXPECT_EQ(cost.find("measured curves"), std::string::npos) << cost;
    EXPECT_TRUE(
        says(cost, condition == "curve" ? "20,000 spheres that are reamed" : "the curve alone"));
    const std::string played = folder_ / (condition + ".csv");
    output({"scene", "play", protocol, "--condition", condition, "--out", played});
    EXPECT_EQ(tests::contentOf(played).find(",,"), std::string::npos) << "a step without a force";
  }
  const std::string inside = folder_ / "inside";
  EXPECT_TRUE(says(
      refusal(
          {"scene", "play", protocol, "--condition", "reamed", "--from", "0.005", "--out", inside}),
      "so there is nothing to draw"));
  EXPECT_FALSE(std::filesystem::exists(inside + ".csv"));
  const std::string study = folder_ / "study";
  output({"study", "create", study, "--protocol", protocol, "--seed", "1"});
  EXPECT_TRUE(says(output({"study", "simulate", study, "--participants", "1"}), "1 simulated"));
  const std::string report = folder_ / "report.html";
  output({"report", study, "--run-mode", "simulated", "--out", report});
  const auto page = tests::contentOf(report);
  EXPECT_TRUE(says(page, "Felt against the material"));
  EXPECT_TRUE(says(page, " SYNTHETIC, neither recorded"));
  EXPECT_TRUE(says(page, "bone.json"));
  EXPECT_TRUE(says(page, "bone.packing"));
}

TEST_F(ReamingCommands, WriteOnlyRenderableMaterialsWithinTheRequestedError) {
  std::vector<std::string> call{"material", "fit", "--static"};
  for (const double hardness : {0.1, 0.5, 0.9}) call.push_back(staticTest(hardness));
  const auto with = [&](const std::vector<std::string>& more) {
    auto longer = call;
    longer.insert(longer.end(), more.begin(), more.end());
    return longer;
  };
  const std::string out = folder_ / "m.json";
  EXPECT_TRUE(says(refusal(with({"--axis", "normalised", "--out", out})), "lies over depth"));
  EXPECT_TRUE(
      says(refusal(with({"--axis", "normalised-series", "--out", out})), "lies over depth"));
  EXPECT_TRUE(says(refusal(with({"--spline", "linear", "--out", out})), "straight lines have two"));
  EXPECT_TRUE(
      says(refusal(with({"--nodes", "12", "--error", "0.1"})), "Leave one of the two away"));
  EXPECT_TRUE(says(
      refusal(with({"--nodes", "optimal", "--spline", "pchip"})), "cannot be found for pchip"));
  EXPECT_TRUE(says(refusal(with({"--nodes", "thinned", "--error", "0.0005"})), "cannot be had"));
  EXPECT_FALSE(std::filesystem::exists(out));
  EXPECT_TRUE(
      says(output(with({"--nodes", "12"})), "nodes 12 / 12 / 12 (minimum, average, maximum)"));
  EXPECT_TRUE(
      says(output(with({"--envelope", "single-sample"})), "(minimum, middle-specimen, maximum)"));
  const std::string report = folder_ / "report";
  output(with({"--spline", "cubic-natural", "--error", "0.41", "--report", report}));
  for (const std::string file :
       {"material-series-01.csv",
        "material-series-01-force-normalised.svg",
        "material-envelope-static-force.csv",
        "material-specimens-static.csv",
        "material-splines-static-force-maximum.svg"}) {
    EXPECT_TRUE(std::filesystem::exists(report + "/" + file)) << file;
  }
  // The error in the report is that of the spline that was asked for.
  const auto curves = tests::contentOf(report + "/material-curves.csv");
  EXPECT_EQ(std::count(curves.begin(), curves.end(), '\n'), 4) << curves;
}

TEST_F(ReamingCommands, CompareTwoSplinesOnTwelveNodes) {
  std::vector<std::string> call{"material", "compare", "--static", staticTest(0.5)};
  EXPECT_TRUE(says(refusal(call), "There are static/force/minimum, static/force/average"));
  call.insert(call.end(), {"--curve", "static/force/maximum", "--report", folder_ / "figure"});
  const auto said = output(call);
  EXPECT_TRUE(says(said, "static/force/maximum: 12 nodes, placed for cubic-natural"));
  EXPECT_TRUE(says(said, "cubic-natural: |e_a| with a floor of 10 N up to "));
  EXPECT_TRUE(says(said, "hermite-data-slope: |e_a| with a floor of 10 N up to "));
  EXPECT_TRUE(says(said, "mm, where cubic-natural is worst)"));
  EXPECT_TRUE(
      std::filesystem::exists(folder_ / "figure/figure-7-splines-static-force-maximum.svg"));
}

TEST_F(ReamingCommands, MarkARealShapeOfSyntheticMaterialAsSynthetic) {
  const std::string built = folder_ / "box.packing";
  output({"packing", "build", box("box.obj", 1.0, false), "--count", "500", "--out", built});
  EXPECT_EQ(tests::contentOf(built).find("\"synthetic\":true"), std::string::npos);
  const std::string fitted = folder_ / "fitted.packing";
  EXPECT_TRUE(says(
      output({"packing", "fit", built, "--material", "parametric", "--out", fitted}), "SYNTHETIC"));
  EXPECT_TRUE(says(tests::contentOf(fitted), "\"synthetic\":true"));
}

TEST_F(ReamingCommands, FitACornerToEveryCurve) {
  // With 12,000 spheres the first steps of the solver once went wrong, and it gave up without a
  // message.
  const std::string series = folder_ / "series";
  output({"material", "synthesise", series});
  const std::string material = folder_ / "bone.json";
  output(
      {"material",
       "fit",
       "--dynamic-1",
       series + "/synthetic-specimen-3--dynamic-1.csv",
       series + "/synthetic-specimen-9--dynamic-1.csv",
       "--out",
       material});
  const auto corner = folder_.write(
      "corner.obj", "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  const std::string built = folder_ / "corner.packing";
  output({"packing", "build", corner, "--count", "12000", "--out", built});
  const auto said =
      output({"packing", "fit", built, "--material", material, "--out", folder_ / "f.packing"});
  EXPECT_EQ(said.find("was not fitted"), std::string::npos) << said;
  EXPECT_EQ(said.find("; 0 steps"), std::string::npos) << said;
}

TEST_F(ReamingCommands, FillAMeshOrReportWhyNot) {
  const std::string out = folder_ / "box.packing";
  EXPECT_TRUE(says(
      output({"packing", "build", box("box.obj", 1.0, false), "--count", "500", "--out", out}),
      "72.0 cm³"));
  EXPECT_TRUE(says(
      palpate({"packing",
               "build",
               box("m.obj", 0.001, false),
               "--count",
               "9",
               "--out",
               folder_ / "m.packing"})
          .error,
      "its numbers are metres"));
  EXPECT_TRUE(
      says(refusal({"packing", "build", "--count", "9", "--out", out}), "is there already"));
  EXPECT_TRUE(
      says(refusal({"packing", "build", "--count", "9", "--out", folder_ / "x"}), ".packing"));
  const std::string other = folder_ / "other.packing";
  EXPECT_TRUE(says(
      refusal({"packing", "build", box("o.obj", 1.0, true), "--out", other}), "open: 3 edges"));
  EXPECT_TRUE(
      says(refusal({"packing", "build", box("h.obj", 1e4, false), "--out", other}), "--unit"));
  EXPECT_TRUE(says(refusal({"packing", "build", folder_ / "none.stl", "--out", other}), "no file"));
  EXPECT_TRUE(says(
      refusal({"packing", "build", folder_.write("text.stl", "no mesh"), "--out", other}),
      "no STL, OBJ or PLY file"));
}

TEST_F(ReamingCommands, FitDensitiesBySwarmOptimisation) {
  const std::string built = folder_ / "cup.packing";
  output({"packing", "build", "--count", "800", "--out", built});
  const auto fit = [&](const std::string& out, const std::vector<std::string>& more) {
    std::vector<std::string> call{
        "packing", "fit", built, "--material", "parametric", "--out", folder_ / out};
    call.insert(call.end(), more.begin(), more.end());
    return call;
  };
  const std::vector<std::string> swarm{"--method", "swarm", "--iterations", "200"};
  EXPECT_TRUE(says(
      output(fit("swarm.packing", swarm)),
      "a particle swarm (12 layers, 40 particles, 200 steps, seed 1)"));
  const auto first = tests::contentOf(folder_ / "swarm.packing");
  EXPECT_TRUE(says(first, "\"fitted\":true"));
  EXPECT_TRUE(says(first, "by a particle swarm"));
  // The same seed gives the same bone, and a scene can use it.
  output(fit("again.packing", swarm));
  EXPECT_EQ(tests::contentOf(folder_ / "again.packing"), first);
  EXPECT_TRUE(says(refusal(fit("x.packing", {"--layers", "6"})), "add --method swarm"));
}

}  // namespace reaming_commands_test
