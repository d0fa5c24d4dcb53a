#include "haptics/models/finite_elements.h"

#include <cmath>
#include <vector>

#include <Eigen/Dense>
#include <gtest/gtest.h>

namespace haptics::models {
namespace {

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

TEST(FiniteElements, ReproduceReadingAOfThePaper) {
  // paper-discrepancies §5.1, "A, paper weights" at x = 1.5.
  const auto stiffness = [](int elements) { return Elements({.elements = elements}).stiffness(); };
  EXPECT_NEAR(stiffness(5), 1.714, 5e-4);
  EXPECT_NEAR(stiffness(10), 1.600, 5e-4);
  EXPECT_NEAR(stiffness(15), 1.622, 5e-4);
  EXPECT_NEAR(stiffness(100), 1.509, 5e-4);
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
  const double force = 3.0;
  const Eigen::VectorXd mesh = assembled.k.lu().solve(assembled.c * force);
  const Elements elements(p);
  for (int i = 0; i < p.elements; ++i) {
    EXPECT_NEAR(elements.displacement(i + 1, force), mesh(i), 1e-14);
  }
}

TEST(FiniteElements, MeshFollowsTheTool) {
  // Eq. (9): what gives way at the tool is the penetration.
  const Elements::Parameters p{};
  const Elements elements(p);
  const Assembled assembled(p);
  const double penetration = 1.3;
  const double force = elements.at(p.contact + penetration).force;
  double atTool = 0.0;
  for (int i = 0; i < p.elements; ++i) {
    atTool += assembled.c(i) * elements.displacement(i + 1, force);
  }
  EXPECT_NEAR(atTool, penetration, 1e-13);
}

TEST(FiniteElements, ConvergeToTheExactString) {
  // A string of tension kᵉ/2 held at both ends: T L / ((x − a)(b − x)) = 1.5 at x = 1.5.
  EXPECT_NEAR(Elements({.elements = 100'000}).stiffness(), 1.5, 1e-4);
}

TEST(FiniteElements, AreElasticThenYieldAndNeverPull) {
  const Elements elements({});
  EXPECT_EQ(elements.at(3.9).force, 0.0);
  EXPECT_DOUBLE_EQ(elements.at(5.0).force, elements.stiffness());
  EXPECT_EQ(elements.at(9.0).force, 7.0);
  EXPECT_EQ(elements.at(9.0).stiffness, 0.0);
  EXPECT_EQ(elements.at(1e300).force, 7.0);
}

TEST(FiniteElements, HaveNoForceForWhatIsNoNumber) {
  const auto response = Elements({}).at(std::nan(""));
  EXPECT_FALSE(response.isDefined);
  EXPECT_EQ(response.force, 0.0);
}

TEST(FiniteElements, KnowUnsoundParameters) {
  EXPECT_TRUE(Elements::isSound({}));
  EXPECT_FALSE(Elements::isSound({.elements = 0}));
  EXPECT_FALSE(Elements::isSound({.elementStiffness = 0.0}));
  EXPECT_FALSE(Elements::isSound({.toolPosition = 2.0}));
  EXPECT_FALSE(Elements::isSound({.yieldForce = -1.0}));
  EXPECT_FALSE(Elements::isSound({.contact = std::nan("")}));
}

}  // namespace
}  // namespace haptics::models
