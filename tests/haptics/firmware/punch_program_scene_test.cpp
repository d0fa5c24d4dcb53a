// Scenes that the punch's own program renders.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/cut.h"
#include "tests/haptics/firmware/board_bench.h"

namespace haptics::firmware {
namespace punch_program_scene_test {

using namespace board_bench;

std::vector<models::CurveNode<float>> parametricNodes() {
  std::vector<models::CurveNode<float>> nodes;
  const auto cut = recordings::parametricCut();
  for (const auto& node : cut.curve.nodes()) {
    nodes.push_back({static_cast<float>(node.travel), static_cast<float>(node.force)});
  }
  return nodes;
}

std::vector<ModelTable> tablesOf(const std::vector<models::CurveNode<float>>& nodes) {
  std::vector<ModelTable> tables;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (i % kTableChunk == 0) tables.push_back({.first = static_cast<std::uint8_t>(i)});
    ModelTable& table = tables.back();
    table.travel[table.count] = nodes[i].travel;
    table.force[table.count] = nodes[i].force;
    ++table.count;
  }
  return tables;
}

constexpr float kTravelPerCount = 0.00439F;

Model modelOf(ModelKind kind, std::size_t points) {
  const models::KalmanNoise<float> noise;
  return {
      .kind = kind,
      .tableSize = static_cast<std::uint8_t>(points),
      .travelPerCount = kTravelPerCount,
      .millivoltsPerNewton = 1500.0F,
      .largestForce = 8.0F,
      .scheme = static_cast<std::uint8_t>(models::KalmanScheme::AuthorsFirmware),
      .noise = {
          noise.processForce,
          noise.processCovariance,
          noise.processStiffness,
          noise.finiteElements,
          noise.interpolation,
          noise.wandering}};
}

template <typename Message>
std::uint32_t hashOf(const Message& message, std::uint32_t before = 0) {
  const Bytes payload = payloadOf(message);
  return wire::crc32(payload.data(), payload.size(), before);
}

/// The models of the engine, as they would render the same scene.
template <typename Scalar>
class Reference {
 public:
  Reference(ModelKind kind, const std::vector<models::CurveNode<float>>& nodes) : kind_(kind) {
    for (const auto& node : nodes) nodes_.push_back({Scalar(node.travel), Scalar(node.force)});
  }

  Scalar at(Scalar travel) {
    if (kind_ == ModelKind::FiniteElements) return elements_.at(travel, state_).force;
    const models::Interpolation<Scalar> curve(nodes_.data(), nodes_.size(), {});
    const Scalar recorded = curve.at(travel, hint_).force;
    if (kind_ == ModelKind::Interpolation) return recorded;
    const Scalar elastic = elements_.at(travel, state_).force;
    const Scalar travelled = last_ ? travel - *last_ : Scalar{0};
    last_ = travel;
    return filter_.step(travelled, elastic, recorded);
  }

 private:
  using Elements = models::FiniteElements<Scalar>;

  ModelKind kind_;
  std::vector<models::CurveNode<Scalar>> nodes_;
  std::size_t hint_ = 0;
  Elements elements_{typename Elements::Parameters()};
  typename Elements::State state_;
  models::KalmanFilter<Scalar> filter_{
      models::KalmanNoise<Scalar>().factored(), models::KalmanScheme::AuthorsFirmware};
  std::optional<Scalar> last_;
};

/// Of the encoder, in a closing and an opening of a second each.
std::int32_t countsInStroke(int millisecond) {
  return static_cast<std::int32_t>(1300.0 * (1.0 - std::cos(0.00314159 * millisecond)));
}

class PunchRendersTest : public BoardBench {
 protected:
  /// Sends a scene; its hash.
  std::uint32_t teach(const Model& model, const std::vector<models::CurveNode<float>>& nodes) {
    said_.taken.clear();
    send(model);
    std::uint32_t hash = hashOf(model);
    for (const auto& table : tablesOf(nodes)) {
      step();
      send(table);
      hash = hashOf(table, hash);
    }
    step();
    return hash;
  }
  void beginQuick() {
    auto quick = limits();
    quick.largestSlew = 60'000;  // so that the voltage is the model's
    begin(quick);
    greet();
  }
  void arm() {
    send(Arm{.isArmed = true, .expiry = 20});
    step();
  }
  int render(std::uint32_t hash) {
    send(Render{.hash = hash, .expiry = 10});
    return step();
  }

  const std::vector<models::CurveNode<float>> cut_ = parametricNodes();
};

TEST_F(PunchRendersTest, AgreesOnAScenePieceByPiece) {
  greet();
  const Model model = modelOf(ModelKind::Interpolation, cut_.size());
  const auto tables = tablesOf(cut_);
  ASSERT_GT(tables.size(), 2U);
  send(model);
  step();
  std::uint32_t hash = hashOf(model);
  ASSERT_EQ(said_.taken.size(), 1U);
  EXPECT_EQ(said_.taken[0].hash, hash);
  EXPECT_EQ(said_.taken[0].verdict, ModelVerdict::Incomplete);
  for (const auto& table : tables) {
    send(table);
    step();
    hash = hashOf(table, hash);
    EXPECT_EQ(said_.taken.back().hash, hash);
    const bool isLast = &table == &tables.back();
    EXPECT_EQ(
        said_.taken.back().verdict, isLast ? ModelVerdict::Accepted : ModelVerdict::Incomplete);
  }
}

TEST_F(PunchRendersTest, TakesPiecesInTheirOrderOnly) {
  greet();
  const auto tables = tablesOf(cut_);
  send(modelOf(ModelKind::Interpolation, cut_.size()));
  send(tables[1]);
  step();
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::Incomplete);
  for (const auto& table : tables) send(table);
  send(tables.back());  // once more
  steps(3);
  ASSERT_EQ(said_.taken.size(), tables.size() + 3);
  EXPECT_EQ(said_.taken[said_.taken.size() - 2].verdict, ModelVerdict::Accepted);
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::Incomplete);
  EXPECT_EQ(said_.taken.back().hash, said_.taken[said_.taken.size() - 2].hash);
}

TEST_F(PunchRendersTest, RefusesAModelThatIsUnsound) {
  greet();
  auto backwards = cut_;
  std::swap(backwards[3], backwards[4]);
  teach(modelOf(ModelKind::Interpolation, cut_.size()), backwards);
  EXPECT_EQ(said_.taken.back().verdict, ModelVerdict::InvalidModel);

  const auto verdictOn = [&](const auto& spoil) {
    Model model = modelOf(ModelKind::Kalman, cut_.size());
    spoil(model);
    teach(model, cut_);
    return said_.taken.back().verdict;
  };
  EXPECT_EQ(verdictOn([](Model&) {}), ModelVerdict::Accepted);
  EXPECT_EQ(verdictOn([](Model& m) { m.toolPosition = m.end; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.elements = 0; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.equationVariants = 3U << 1U; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.rampLength = 0.0F; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.largestForce = -1.0F; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.noise[0] = -1.0F; }), ModelVerdict::InvalidModel);
  EXPECT_EQ(verdictOn([](Model& m) { m.noise[1] = 100.0F; }), ModelVerdict::InvalidModel);
}

TEST_F(PunchRendersTest, TakesNoModelWhileItIsArmed) {
  greetAndArm();
  send(modelOf(ModelKind::FiniteElements, 0));
  hold(0, 1);
  ASSERT_EQ(said_.taken.size(), 1U);
  EXPECT_EQ(said_.taken[0].verdict, ModelVerdict::Armed);
}

TEST_F(PunchRendersTest, RendersOnlyTheSceneThatIsMeant) {
  greet();
  bench_.position = 1300;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(render(hash + 1), 0);
    EXPECT_FALSE(state().isRendering);
  }
  for (int i = 0; i < 10; ++i) render(hash);
  EXPECT_TRUE(state().isRendering);
  EXPECT_GT(bench_.voltage, 1000);
  for (int i = 0; i < 10; ++i) render(hash + 1);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_FALSE(state().isRendering);
}

TEST_F(PunchRendersTest, RendersNoIncompleteOrMissingScene) {
  greet();
  bench_.position = 1300;
  steps(20);
  const Model model = modelOf(ModelKind::Interpolation, cut_.size());
  send(model);
  arm();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(render(hashOf(model)), 0);
  begin(limits());
  greetAndArm();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(render(0), 0);
}

TEST_F(PunchRendersTest, StopsRenderingWithoutCommands) {
  greet();
  bench_.position = 1300;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (int i = 0; i < 20; ++i) render(hash);
  const int full = bench_.voltage;
  ASSERT_GT(full, 1200);
  steps(10);
  EXPECT_EQ(bench_.voltage, full);
  EXPECT_EQ(step(), full - 1200);
  steps(9);
  EXPECT_EQ(bench_.voltage, 0);
  EXPECT_TRUE(has(kExpired));
}

TEST_F(PunchRendersTest, GivesTheVoltageOfAForceThatNoMotorHasWithinItsLimit) {
  beginQuick();
  Model model = modelOf(ModelKind::FiniteElements, 0);
  model.millivoltsPerNewton = 1e38F;
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(model, {});
  arm();
  for (int i = 0; i < 20; ++i) render(hash);
  EXPECT_EQ(bench_.voltage, 12000);
  EXPECT_TRUE(has(kSaturated));
}

TEST_F(PunchRendersTest, BoundsTheForceOfItsScene) {
  beginQuick();
  Model model = modelOf(ModelKind::FiniteElements, 0);
  model.largestForce = 2.0F;
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(model, {});
  arm();
  EXPECT_EQ(render(hash), 3000);
}

TEST_F(PunchRendersTest, RendersNoMoreThanTheHostLetsThrough) {
  beginQuick();
  bench_.position = 2000;
  steps(20);
  const auto hash = teach(modelOf(ModelKind::FiniteElements, 0), {});
  arm();
  for (const std::int16_t most : std::initializer_list<std::int16_t>{32767, 3000, 0, 500}) {
    send(Render{.hash = hash, .expiry = 10, .most = most});
    EXPECT_EQ(step(), most == 32767 ? 10'500 : most);
    EXPECT_FALSE(has(kSaturated));
  }
  send(Render{.hash = hash, .expiry = 10, .most = -1});
  EXPECT_EQ(step(), 500);  // is none
  EXPECT_EQ(state().badFrames, 1);
}

class PunchRendersAsTheEngine : public PunchRendersTest,
                                public testing::WithParamInterface<ModelKind> {};

TEST_P(PunchRendersAsTheEngine, InSinglePrecisionToTheLastBit) {
  beginQuick();
  const auto nodes =
      GetParam() == ModelKind::FiniteElements ? std::vector<models::CurveNode<float>>() : cut_;
  const auto hash = teach(modelOf(GetParam(), nodes.size()), nodes);
  ASSERT_EQ(said_.taken.back().verdict, ModelVerdict::Accepted);
  ASSERT_EQ(said_.taken.back().hash, hash);
  arm();
  Reference<float> reference(GetParam(), nodes);
  int least = 0;
  int most = 0;
  for (int i = 0; i < 2000; ++i) {
    bench_.position = countsInStroke(i);
    const int millivolts = render(hash);
    const float force = reference.at(kTravelPerCount * static_cast<float>(bench_.position));
    const float bounded = std::clamp(force, -8.0F, 8.0F);
    ASSERT_EQ(millivolts, static_cast<int>(bounded * 1500.0F)) << i;
    least = std::min(least, millivolts);
    most = std::max(most, millivolts);
  }
  EXPECT_GT(most, 6000);
  EXPECT_GT(least, -12000);
  EXPECT_EQ(state().faults, 0);
}

TEST_P(PunchRendersAsTheEngine, AndInDoublePrecisionToATenThousandth) {
  OnDeviceScene scene;
  const auto nodes =
      GetParam() == ModelKind::FiniteElements ? std::vector<models::CurveNode<float>>() : cut_;
  const Model model = modelOf(GetParam(), nodes.size());
  const Bytes payload = payloadOf(model);
  scene.take(model, payload.data(), payload.size());
  for (const auto& table : tablesOf(nodes)) scene.take(table, payload.data(), payload.size());
  ASSERT_TRUE(scene.isReady());
  Reference<double> reference(GetParam(), nodes);
  for (int i = 0; i < 2000; ++i) {
    const auto counts = countsInStroke(i);
    const double expected = reference.at(static_cast<double>(kTravelPerCount) * counts);
    ASSERT_NEAR(
        scene.forceAt(scene.travelAt(counts)), expected, 1e-4 * std::max(1.0, std::abs(expected)))
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Models,
    PunchRendersAsTheEngine,
    testing::Values(ModelKind::Interpolation, ModelKind::FiniteElements, ModelKind::Kalman),
    [](const auto& parameter) {
      return parameter.param == ModelKind::Kalman          ? "Kalman"
             : parameter.param == ModelKind::Interpolation ? "Interpolation"
                                                           : "FiniteElements";
    });

}  // namespace punch_program_scene_test
}  // namespace haptics::firmware
