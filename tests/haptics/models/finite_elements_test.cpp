#include "haptics/models/finite_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace haptics::models {
namespace finite_elements_test {

using Elements = FiniteElements<double>;

/// The paper's way, written out: K of eq. (5)–(6) as printed, c of eq. (7)–(8), LU for eq. (10).
struct Assembled {
  Eigen::MatrixXd k;
  Eigen::VectorXd c;

  explicit Assembled(const Elements::Parameters& p) {
    const double length = (p.end - p.start) / p.elements;
    const double k1 = 3.0 * p.elementStiffness / (2.0 * length);
    const double k2 = p.elementStiffness / length;
    const double k3 = p.elementStiffness / (2.0 * length);
    k = Eigen::MatrixXd::Zero(p.elements, p.elements);
    c = Eigen::VectorXd::Zero(p.elements);
    for (int i = 0; i < p.elements; ++i) {
      k(i, i) = i == 0 || i == p.elements - 1 ? k1 : k2;
      if (i > 0) k(i, i - 1) = k(i - 1, i) = -k3;
      const double middle = p.start + (i + 0.5) * length;
      c(i) = std::max(0.0, 1.0 - std::abs(p.toolPosition - middle) / length);
    }
  }

  double stiffness() const { return 1.0 / c.dot(k.lu().solve(c)); }
};

/// Of the paper's string, at its tool.
double stiffness(int elements, BoundaryCondition boundary, ToolInterpolation weights) {
  return Elements({.elements = elements, .boundary = boundary, .weights = weights}).stiffness();
}

TEST(FiniteElements, ReproduceReadingAOfThePaper) {
  // Solved from eq. (3) to (11) of the punch paper, tool at 1.5.
  EXPECT_NEAR(stiffness(5, BoundaryCondition::A, ToolInterpolation::Paper), 1.714, 5e-4);
  EXPECT_NEAR(stiffness(10, BoundaryCondition::A, ToolInterpolation::Paper), 1.600, 5e-4);
  EXPECT_NEAR(stiffness(15, BoundaryCondition::A, ToolInterpolation::Paper), 1.622, 5e-4);
  EXPECT_NEAR(stiffness(100, BoundaryCondition::A, ToolInterpolation::Paper), 1.509, 5e-4);
}

TEST(FiniteElements, ReproduceReadingB) {
  EXPECT_NEAR(stiffness(5, BoundaryCondition::B, ToolInterpolation::Paper), 1.338, 5e-4);
  EXPECT_NEAR(stiffness(10, BoundaryCondition::B, ToolInterpolation::Paper), 1.413, 5e-4);
  EXPECT_NEAR(stiffness(15, BoundaryCondition::B, ToolInterpolation::Paper), 1.488, 5e-4);
  EXPECT_NEAR(stiffness(100, BoundaryCondition::B, ToolInterpolation::Paper), 1.491, 5e-4);
}

TEST(FiniteElements, ReproduceWhatTheAuthorsFirmwareRenders) {
  EXPECT_NEAR(
      stiffness(5, BoundaryCondition::B, ToolInterpolation::AuthorsFirmware), 1.055718, 1e-6);
  EXPECT_NEAR(stiffness(10, BoundaryCondition::B, ToolInterpolation::AuthorsFirmware), 1.413, 5e-4);
  EXPECT_NEAR(stiffness(15, BoundaryCondition::B, ToolInterpolation::AuthorsFirmware), 1.147, 5e-4);
}

TEST(FiniteElements, HaveNoRippleWithExactKink) {
  // Exactly a string of tension kᵉ/2, wherever the tool is; the paper's weights add up to 48 %
  // between the first midpoint and the last.
  double ripple = 0.0;
  for (int i = 1; i < 1000; ++i) {
    const double x = 0.5 + 1.5 * i / 1000.0;
    const double string = 0.5 * 1.5 / ((x - 0.5) * (2.0 - x));
    const Elements exact({.toolPosition = x, .weights = ToolInterpolation::ExactKink});
    EXPECT_NEAR(exact.stiffness() / string, 1.0, 1e-13);
    if (x < 0.65 || x > 1.85) continue;
    ripple = std::max(ripple, Elements({.toolPosition = x}).stiffness() / string - 1.0);
  }
  EXPECT_NEAR(ripple, 0.48, 0.005);
}

std::vector<double> shapeOf(const Elements& elements) {
  std::vector<double> shape(elements.elements());
  elements.writeMeshShape(shape.data());
  return shape;
}

TEST(FiniteElements, EqualTheAssembledMatrixSolvedByLu) {
  for (const int elements : {2, 3, 5, 10, 15, 100}) {
    for (const double tool : {0.9, 1.1, 1.25, 1.5, 1.7}) {
      const Elements::Parameters p{.elements = elements, .toolPosition = tool};
      const double length = 1.5 / elements;
      if (tool < 0.5 + length / 2 || tool > 2.0 - length / 2) continue;  // beside a fixed end
      const double expected = Assembled(p).stiffness();
      EXPECT_NEAR(Elements(p).stiffness() / expected, 1.0, 1e-11) << elements << " at " << tool;
    }
  }
}

TEST(FiniteElements, GiveTheMeshThatTheMatrixGives) {
  const Elements::Parameters p{};
  const Assembled assembled(p);
  const Eigen::VectorXd mesh = assembled.k.lu().solve(assembled.c);
  const auto shape = shapeOf(Elements(p));
  for (int i = 0; i < p.elements; ++i) EXPECT_NEAR(shape[i], mesh(i), 1e-14);
}

TEST(FiniteElements, MeshFollowsTheTool) {
  // Eq. (9): what gives way at the tool is the penetration.
  const Elements::Parameters p{};
  const Elements elements(p);
  const Assembled assembled(p);
  const double penetration = 1.3;
  Elements::State state;
  const double force = elements.at(p.contact + penetration, state).force;
  const auto shape = shapeOf(elements);
  double atTool = 0.0;
  for (int i = 0; i < p.elements; ++i) atTool += assembled.c(i) * shape[i] * force;
  EXPECT_NEAR(atTool, penetration, 1e-13);
}

TEST(FiniteElements, BendTheMeshAsAStringWhereTheToolIsANodeOfItsOwn) {
  const Elements::Parameters p{.elements = 15, .weights = ToolInterpolation::ExactKink};
  const Elements elements(p);
  const auto shape = shapeOf(elements);
  for (int node = 1; node <= p.elements; ++node) {
    const double x = elements.position(node);
    const double near = std::min(x, p.toolPosition);
    const double far = std::max(x, p.toolPosition);
    EXPECT_NEAR(shape[node - 1], (near - 0.5) * (2.0 - far) / (0.5 * 1.5), 1e-14);
  }
}

TEST(FiniteElements, ConvergeToTheExactString) {
  // A string of tension kᵉ/2 held at both ends: T L / ((x − a)(b − x)) = 1.5 at x = 1.5.
  EXPECT_NEAR(Elements({.elements = 100'000}).stiffness(), 1.5, 1e-4);
}

TEST(FiniteElements, AreElasticThenYieldAndNeverPull) {
  const Elements elements({});
  Elements::State state;
  EXPECT_EQ(elements.at(3.9, state).force, 0.0);
  EXPECT_DOUBLE_EQ(elements.at(5.0, state).force, elements.stiffness());
  EXPECT_EQ(elements.at(9.0, state).force, 7.0);
  EXPECT_EQ(elements.at(9.0, state).stiffness, 0.0);
  EXPECT_EQ(elements.at(1e300, state).force, 7.0);
}

TEST(FiniteElements, ReplayTheCutOnOpeningWithClip) {
  const Elements elements({});
  Elements::State state;
  const double closing = elements.at(5.0, state).force;
  elements.at(10.0, state);
  EXPECT_EQ(elements.at(5.0, state).force, closing);
}

TEST(FiniteElements, DeformPermanentlyWithReturnMap) {
  const Elements elements({.yielding = YieldLaw::ReturnMap});
  Elements::State state;
  elements.at(10.0, state);
  EXPECT_NEAR(state.offset, 6.0 - 7.0 / elements.stiffness(), 1e-14);
  EXPECT_NEAR(elements.at(9.9, state).force, 7.0 - 0.1 * elements.stiffness(), 1e-13);
  EXPECT_EQ(elements.at(5.0, state).force, 0.0);  // nothing is left to press on
  EXPECT_EQ(elements.at(10.1, state).force, 7.0);
  elements.at(3.0, state);  // the next bite is into tissue that is whole
  EXPECT_DOUBLE_EQ(elements.at(5.0, state).force, elements.stiffness());
}

TEST(FiniteElements, DissipateTheEnergyOfACutWithReturnMap) {
  const auto energyOf = [](YieldLaw yielding) {
    const Elements elements({.yielding = yielding});
    Elements::State state;
    double energy = 0.0;
    for (int i = -10'000; i <= 10'000; ++i) {  // to 10 and back
      const double direction = i < 0 ? 1.0 : -1.0;
      energy += direction * elements.at(10.0 - std::abs(i) * 7e-4, state).force * 7e-4;
    }
    return energy;
  };
  const double stiffness = Elements({}).stiffness();
  EXPECT_NEAR(energyOf(YieldLaw::Clip), 0.0, 0.01);
  EXPECT_NEAR(energyOf(YieldLaw::ReturnMap), 7.0 * (6.0 - 7.0 / stiffness), 0.02);
}

double stiffnessOf(const std::vector<double>& stiffnesses, double tool, ToolInterpolation weights) {
  const int count = static_cast<int>(stiffnesses.size());
  return Elements({.start = 0,
                   .end = static_cast<double>(count),
                   .elements = count,
                   .toolPosition = tool,
                   .weights = weights,
                   .elementStiffnesses = stiffnesses.data()})
      .stiffness();
}

TEST(FiniteElements, AllowZeroAndInfiniteStiffness) {
  const double endless = std::numeric_limits<double>::infinity();
  for (const auto weights : {ToolInterpolation::Paper, ToolInterpolation::ExactKink}) {
    // Three elements, the tool at the middle of the second one: 1.5 of flexibility on each side.
    EXPECT_DOUBLE_EQ(stiffnessOf({1, 1, 1}, 1.5, weights), 2.0 / 1.5 / 2.0 * 1.0);
    // Torn on the left, it hangs on the right side alone; torn on both, on nothing.
    EXPECT_DOUBLE_EQ(stiffnessOf({0, 1, 1}, 1.5, weights), 1.0 / 3.0);
    EXPECT_EQ(stiffnessOf({0, 1, 0}, 1.5, weights), 0.0);
    // A rigid left side is a wall at the tool's own element.
    EXPECT_DOUBLE_EQ(stiffnessOf({endless, 1, 1}, 1.5, weights), 1.0 + 1.0 / 3.0);
    EXPECT_EQ(stiffnessOf({endless, endless, endless}, 1.5, weights), endless);
  }
}

TEST(FiniteElements, YieldAtOnceIfTheTissueIsRigid) {
  const double endless = std::numeric_limits<double>::infinity();
  const Elements rigid({.elementStiffness = endless});
  Elements::State state;
  EXPECT_EQ(rigid.at(4.0, state).force, 0.0);
  EXPECT_EQ(rigid.at(4.0 + 1e-12, state).force, 7.0);
}

TEST(FiniteElements, HaveNoForceForNaN) {
  Elements::State state;
  const auto response = Elements({}).at(std::nan(""), state);
  EXPECT_FALSE(response.isDefined);
  EXPECT_EQ(response.force, 0.0);
}

TEST(FiniteElements, RejectUnsoundParameters) {
  EXPECT_TRUE(Elements::isSound({}));
  EXPECT_FALSE(Elements::isSound({.elements = 0}));
  EXPECT_FALSE(Elements::isSound({.elementStiffness = -1.0}));
  EXPECT_FALSE(Elements::isSound({.elementStiffness = std::nan("")}));
  EXPECT_FALSE(Elements::isSound({.toolPosition = 2.0}));
  EXPECT_FALSE(Elements::isSound({.yieldForce = -1.0}));
  EXPECT_FALSE(Elements::isSound({.contact = std::nan("")}));
  const Elements::Parameters inTheLast{
      .toolPosition = 1.75, .weights = ToolInterpolation::AuthorsFirmware};
  EXPECT_FALSE(Elements::isSound(inTheLast));
}

}  // namespace finite_elements_test
}  // namespace haptics::models
