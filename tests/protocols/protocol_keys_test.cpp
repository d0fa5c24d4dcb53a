// What becomes of each key of a protocol.
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/model_names.h"
#include "haptics/recordings/cut.h"
#include "protocols/load_protocol.h"
#include "protocols/reading/anatomy_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace protocols {
namespace protocol_keys_test {

namespace engine = haptics::engine;
namespace models = haptics::models;
using haptics::devices::punchKind;
using haptics::devices::reamerKind;

Protocol readGood(const std::string& name) {
  questionnaires::Problems problems;
  const auto folder = tests::repository() / "tests/protocols/data/good";
  const auto loaded = loadProtocolFile((folder / (name + ".json")).string(), problems);
  EXPECT_TRUE(loaded.has_value()) << name << "\n" << describe(problems.all());
  return loaded ? loaded->protocol : Protocol();
}

template <typename Spec>
Spec sceneOf(const Protocol& protocol, std::string_view condition) {
  return std::get<Spec>(protocol.condition(condition)->model.value());
}

TEST(ProtocolKeys, DescribeTheStudy) {
  const auto protocol = readGood("every-key");
  EXPECT_EQ(protocol.study.id, "everything");
  EXPECT_EQ(protocol.study.title, "Every key there is");
  EXPECT_EQ(protocol.study.version, "2.1");
  EXPECT_EQ(protocol.study.authors, (std::vector<std::string>{"A. Author", "B. Author"}));
  EXPECT_EQ(protocol.study.organizations, std::vector<std::string>{"A laboratory"});
  EXPECT_EQ(protocol.study.date, "2026-11-20");
  EXPECT_EQ(protocol.study.description, "For the tests.");
  EXPECT_EQ(protocol.languages, (std::vector<std::string>{"en", "de"}));
  EXPECT_EQ(protocol.seed, 42U);
  EXPECT_TRUE(protocol.isOpenLabel);
  EXPECT_EQ(protocol.instrumentFiles, std::vector<std::string>{"instruments/comfort.json"});
  EXPECT_EQ(protocol.texts.at("institution").in("de"), "A laboratory");
  EXPECT_EQ(protocol.texts.at("contact").in("de"), "Frau Author");
}

TEST(ProtocolKeys, DescribeCohortsAndDevices) {
  const auto protocol = readGood("every-key");
  EXPECT_EQ(protocol.cohort("surgeons")->title.in("de"), "Chirurginnen und Chirurgen");
  EXPECT_EQ(protocol.cohort("surgeons")->planned, 12);
  EXPECT_EQ(protocol.cohort("others")->title.in("de"), "Others");
  EXPECT_EQ(protocol.device("punch")->kind, &punchKind());
  EXPECT_EQ(protocol.device("punch")->maxForce, 7.5);
  EXPECT_EQ(protocol.device("punch")->maxForceRate, 500.0);
  EXPECT_EQ(protocol.device("punch")->maxTorque, 5.0);
  EXPECT_EQ(protocol.device("punch")->maxTorqueRate, 50.0);
  EXPECT_EQ(protocol.device("reamer")->kind, &reamerKind());
  EXPECT_EQ(protocol.device("reamer")->maxTorque, 3.0);
  EXPECT_EQ(protocol.device("reamer")->maxTorqueRate, 40.0);
  EXPECT_EQ(protocol.labels.policy, LabelPolicy::Condition);
  EXPECT_EQ(protocol.labels.prefix.in("de"), "Variante");
}

TEST(ProtocolKeys, DescribeTheScenes) {
  const auto protocol = readGood("every-key");
  const auto* recorded = protocol.condition("recorded");
  EXPECT_EQ(recorded->title, "Recorded");
  EXPECT_EQ(recorded->device, "punch");
  EXPECT_TRUE(recorded->isVisualised);
  EXPECT_EQ(recorded->tissueDrawing, engine::TissueDrawing::Force);
  EXPECT_EQ(recorded->anatomy, "anatomies/square.obj");
  ASSERT_NE(recorded->knee, nullptr);
  EXPECT_EQ(recorded->knee->surfaces.size(), 1U);
  const auto cut = sceneOf<engine::InterpolationSpec>(protocol, "recorded");
  ASSERT_EQ(cut.curve.size(), 2U);  // cuts/two-points.json
  EXPECT_EQ(cut.curve[1].force, 4.25);
  const auto curve = cut.options;
  EXPECT_EQ(curve.extrapolation, models::Extrapolation::Hold);
  EXPECT_EQ(curve.rampLength, 0.5);

  const auto elastic = sceneOf<engine::FiniteElementsSpec>(protocol, "elastic").parameters;
  EXPECT_EQ(elastic.elements, 10);
  EXPECT_EQ(elastic.start, 0.25);
  EXPECT_EQ(elastic.end, 3.0);
  EXPECT_EQ(elastic.toolPosition, 1.25);
  EXPECT_EQ(elastic.elementStiffness, 2.0);
  EXPECT_EQ(elastic.contact, 3.5);
  EXPECT_EQ(elastic.yieldForce, 6.5);
  EXPECT_EQ(elastic.boundary, models::BoundaryCondition::B);
  EXPECT_EQ(elastic.weights, models::ToolInterpolation::ExactKink);
  EXPECT_EQ(elastic.yielding, models::YieldLaw::ReturnMap);
  EXPECT_FALSE(protocol.condition("elastic")->isVisualised);
  EXPECT_EQ(protocol.condition("elastic")->tissueDrawing, engine::TissueDrawing::Penetration);
  EXPECT_FALSE(protocol.condition("elastic")->anatomy.has_value());
}

TEST(ProtocolKeys, DescribeTheKalmanFilter) {
  const auto protocol = readGood("every-key");
  const auto fused = sceneOf<engine::KalmanSpec>(protocol, "fused");
  EXPECT_EQ(fused.interpolation.options.extrapolation, models::Extrapolation::Zero);
  EXPECT_EQ(fused.scheme, models::KalmanScheme::Sequential);
  EXPECT_EQ(fused.smoothing, models::Smoothing::TwoPoint);
  EXPECT_FALSE(fused.isProcessAsPrinted);
  EXPECT_EQ(fused.finiteElements.parameters.elements, 3);
  EXPECT_EQ(fused.finiteElements.elementStiffnesses, (std::vector{1.0, 2.5, 1.0}));
  EXPECT_EQ(fused.noise.wandering, 5.5);
  EXPECT_EQ(fused.noise.processForce, 6.1);
  EXPECT_EQ(fused.noise.processCovariance, 0.25);
  EXPECT_EQ(fused.noise.processStiffness, 7.0);
  EXPECT_EQ(fused.noise.finiteElements, 0.01);
  EXPECT_EQ(fused.noise.interpolation, 0.3);
}

TEST(ProtocolKeys, DescribeTheMaterial) {
  const auto bone = sceneOf<engine::MaterialSpec>(readGood("every-key"), "bone");
  EXPECT_EQ(bone.hardness, 0.25);
  EXPECT_EQ(bone.forceScale, 0.5);
  ASSERT_EQ(bone.nodes.size(), 3U);
  EXPECT_EQ(bone.nodes[1].depth, 0.005);
  EXPECT_EQ(bone.nodes[1].lower, 30.0);
  EXPECT_EQ(bone.nodes[1].upper, 330.0);
  EXPECT_FALSE(bone.isRemoved);
}

TEST(ProtocolKeys, DescribeTheReamer) {
  const auto protocol = readGood("every-key");
  const auto reamer = protocol.condition("bone")->scene().reamer;
  EXPECT_EQ(reamer.speed, -2.5);
  EXPECT_EQ(reamer.teeth, 6);
  EXPECT_DOUBLE_EQ(reamer.feedPerTooth, 0.05e-3);
}

TEST(ProtocolKeys, DescribeThePacking) {
  const auto bone = sceneOf<engine::PackingSpec>(readGood("every-key-of-a-packing"), "soft");
  ASSERT_NE(bone.bone, nullptr);
  EXPECT_EQ(bone.hardness, 0.25);
  EXPECT_EQ(bone.forceScale, 0.5);
  EXPECT_TRUE(bone.isRemoved);
  EXPECT_EQ(bone.options.coupling, 40'000.0);
  EXPECT_EQ(bone.options.cuttingDamping, 1'500.0);
  EXPECT_EQ(bone.options.friction, 0.2);
}

/// 'palpate scene explain' says of every pass why a scene has it or not.
TEST(ProtocolKeys, DescribeEveryModelInScenesOfTheSamePasses) {
  // Said only of a scene that has the pass which they are a part of.
  const std::set<std::string> kParts{
      "opening branch of the recorded cut", "torque about the tool's axis"};
  std::set<std::string_view> models;
  std::set<std::set<std::string>> passes;
  for (const auto* file : {"every-key", "every-key-of-a-packing"}) {
    const auto protocol = readGood(file);
    for (const auto& condition : protocol.conditions) {
      models.insert(engine::infoOf(condition.model.value()).name);
      std::set<std::string> names;
      const engine::CompiledScene scene(condition.scene());
      for (const auto& pass : scene.passes()) {
        if (!kParts.contains(pass.name)) names.insert(pass.name);
      }
      passes.insert(std::move(names));
    }
  }
  EXPECT_EQ(models, (std::set(engine::kModelNames.begin(), engine::kModelNames.end())));
  EXPECT_EQ(passes.size(), 1U) << testing::PrintToString(passes);
}

TEST(ProtocolKeys, DescribeThePhasesOfASession) {
  const auto protocol = readGood("every-key");
  std::vector<PhaseType> types;
  for (const auto& phase : protocol.phases) types.push_back(phase.type);
  using enum PhaseType;
  EXPECT_EQ(
      types,
      (std::vector{
          Information,
          Consent,
          Form,
          Benchmark,
          Block,
          Preference,
          Break,
          Block,
          Block,
          Interview,
          Debrief}));
  EXPECT_EQ(protocol.phase("background")->instrument, "background");
  EXPECT_EQ(protocol.phase("real")->text.in("de"), "Bitte schneiden Sie.");
  EXPECT_EQ(protocol.phase("real")->minimumCuts, 4);
  EXPECT_EQ(protocol.phase("best")->block, "first");
  EXPECT_EQ(protocol.phase("rest")->seconds, 90.5);
}

TEST(ProtocolKeys, DescribeABlock) {
  const auto protocol = readGood("every-key");
  const auto& first = protocol.phase("first")->trials;
  EXPECT_EQ(first.conditions, (std::vector<std::string>{"recorded", "elastic", "fused"}));
  EXPECT_EQ(first.isVisualised, false);
  EXPECT_EQ(first.order.type, OrderType::Complete);
  EXPECT_EQ(first.minimumCuts, 5);
  ASSERT_EQ(first.questionnaires.size(), 2U);
  EXPECT_EQ(first.questionnaires[0].itemSetFor("elastic"), "2");
  EXPECT_EQ(first.questionnaires[0].itemSetFor("fused"), "");
  EXPECT_EQ(first.questionnaires[1].instrument, "comfort");
  const auto& second = protocol.phase("second")->trials;
  EXPECT_FALSE(second.isVisualised.has_value());
  EXPECT_EQ(second.order.type, OrderType::Reversed);
  EXPECT_EQ(second.order.of, "first");
}

TEST(ProtocolKeys, DescribeTheAnalysisPlanAndTheSimulation) {
  const auto protocol = readGood("every-key");
  const auto& family = protocol.analysis.families.at(0);
  EXPECT_EQ(family.id, "methods");
  EXPECT_EQ(family.title, "Methods");
  EXPECT_EQ(family.instrument, "comfort");
  EXPECT_EQ(family.items, std::vector<std::string>{"pleasant"});
  EXPECT_EQ(family.blocks, std::vector<std::string>{"first"});
  EXPECT_EQ(family.comparisons.at(1).first, "fused");
  EXPECT_EQ(family.comparisons.at(1).second, "elastic");
  EXPECT_EQ(family.test, TestType::Welch);
  EXPECT_EQ(family.correction, CorrectionType::None);
  EXPECT_EQ(family.alpha, 0.01);
  EXPECT_EQ(family.equivalenceBound, 0.5);
  EXPECT_EQ(protocol.simulation.realismOf("recorded"), 1.5);
  EXPECT_EQ(protocol.simulation.realismOf("fused"), 0.0);
  EXPECT_EQ(protocol.simulation.participantStandardDeviation, 0.1);
  EXPECT_EQ(protocol.simulation.interactionStandardDeviation, 0.2);
  EXPECT_EQ(protocol.simulation.residualStandardDeviation, 0.3);
}

TEST(ProtocolKeys, MayBeLeftOutWhereSomethingIsUsual) {
  const auto protocol = readGood("smallest");
  EXPECT_FALSE(protocol.seed.has_value());
  EXPECT_FALSE(protocol.isOpenLabel);
  EXPECT_EQ(protocol.cohorts.at(0).planned, 0);
  EXPECT_EQ(protocol.labels.prefix.in("en"), "Alternative");
  EXPECT_TRUE(protocol.phase("felt")->trials.questionnaires.empty());
  EXPECT_TRUE(protocol.analysis.families.empty());
  EXPECT_EQ(protocol.simulation.participantStandardDeviation, 0.5);
  EXPECT_EQ(protocol.simulation.interactionStandardDeviation, 0.5);
  EXPECT_EQ(protocol.simulation.residualStandardDeviation, 0.8);
  EXPECT_EQ(readGood("break-as-long-as-you-like").phases.back().seconds, 0.0);
  EXPECT_EQ(readGood("largest-seed").seed, std::uint64_t{1} << 53);
}

TEST(ProtocolKeys, HaveSoundDefaultsForModels) {
  const auto interpolation = readGood("usual-interpolation");
  const auto soft = sceneOf<engine::InterpolationSpec>(interpolation, "soft");
  const auto parametric = haptics::recordings::parametricCut().curve.nodes().size() + 1;
  EXPECT_EQ(soft.curve.size(), parametric);
  const auto options = soft.options;
  EXPECT_EQ(options.extrapolation, models::Extrapolation::RampOut);
  EXPECT_EQ(options.rampLength, 1.5);

  const auto kalman = readGood("usual-kalman");
  const auto fused = sceneOf<engine::KalmanSpec>(kalman, "soft");
  EXPECT_EQ(fused.interpolation.options.extrapolation, models::Extrapolation::Absent);
  EXPECT_EQ(fused.interpolation.curve.size(), parametric);
  EXPECT_EQ(fused.finiteElements.parameters.elements, 5);
  EXPECT_EQ(fused.finiteElements.parameters.yieldForce, 7.0);
  EXPECT_EQ(fused.finiteElements.parameters.contact, 4.0);
  EXPECT_EQ(fused.scheme, models::KalmanScheme::SpaceDomain);
  EXPECT_EQ(fused.smoothing, models::Smoothing::None);
  EXPECT_EQ(fused.noise.processForce, 6.1024);
  EXPECT_EQ(fused.noise.processCovariance, 0.2772);
  EXPECT_EQ(fused.noise.processStiffness, 7.0275);
  EXPECT_EQ(fused.noise.wandering, 7.0275);
  EXPECT_EQ(fused.noise.finiteElements, 0.001);
  EXPECT_EQ(fused.noise.interpolation, 7.742);

  const auto bone = sceneOf<engine::MaterialSpec>(readGood("usual-material"), "soft");
  EXPECT_EQ(bone.forceScale, 1.0);
  EXPECT_EQ(bone.nodes.size(), engine::parametricMaterial().size());
  EXPECT_TRUE(bone.isRemoved);
  const auto reamer = readGood("usual-material").condition("soft")->scene().reamer;
  EXPECT_DOUBLE_EQ(reamer.mostFeed(), 0.002);
}

TEST(ProtocolKeys, WithoutAReamerMeanNoFeedLimitInRelease01) {
  questionnaires::Problems problems;
  const auto text = tests::contentOf(
      (tests::repository() / "tests/protocols/data/good/usual-material.json").string());
  const auto loaded = loadProtocol(text, std::vector<SourceFile>{}, problems, Defaults::Release01);
  ASSERT_TRUE(loaded.has_value()) << describe(problems.all());
  EXPECT_FALSE(sceneOf<engine::MaterialSpec>(loaded->protocol, "soft").isRemoved);
  EXPECT_TRUE(std::isinf(loaded->protocol.condition("soft")->scene().reamer.mostFeed()));
}

}  // namespace protocol_keys_test
}  // namespace protocols
