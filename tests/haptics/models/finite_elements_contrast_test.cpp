// Elements of very different stiffness, against the assembled matrix in 100 digits.
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <gtest/gtest.h>

#include "haptics/models/finite_elements.h"
#include "tests/support/long_form.h"

namespace haptics::models {
namespace finite_elements_contrast_test {

using Real = boost::multiprecision::cpp_bin_float_100;

/// A string of elements of length 1, which every number type holds exactly.
template <typename Scalar>
struct Chain {
  std::vector<Scalar> stiffnesses;
  typename FiniteElements<Scalar>::Parameters parameters;

  Chain(int elements, double decades, std::mt19937_64& random) {
    std::uniform_real_distribution<double> exponent(-decades, decades);
    for (int i = 0; i < elements; ++i) {
      stiffnesses.push_back(static_cast<Scalar>(std::pow(10.0, exponent(random))));
    }
    const auto element = std::uniform_int_distribution<int>(0, elements - 1)(random);
    parameters.start = 0;
    parameters.end = static_cast<Scalar>(elements);
    parameters.elements = elements;
    parameters.toolPosition = static_cast<Scalar>(element) + Scalar(0.625);
    parameters.elementStiffnesses = stiffnesses.data();
  }
};

/// Eq. (5)–(11) as printed, for elements that differ, by Thomas' elimination.
template <typename Scalar>
class Reference {
 public:
  explicit Reference(const Chain<Scalar>& chain) : chain_(chain) {
    const int n = chain.parameters.elements;
    std::vector<Real> diagonal(n);
    std::vector<Real> beside(n);
    for (int i = 0; i < n; ++i) {
      diagonal[i] = spring(i) + spring(i + 1);
      beside[i] = -spring(i + 1);
    }
    tool_.resize(n);
    for (int i = 0; i < n; ++i) {
      const Real distance = abs(Real(chain.parameters.toolPosition) - (Real(i) + Real(0.5)));
      if (distance < 1) tool_[i] = 1 - distance;
    }
    const double x = static_cast<double>(chain.parameters.toolPosition);
    if (x < 0.5) tool_[0] = 2 * Real(x);  // between the end and the first midpoint
    if (x > n - 0.5) tool_[n - 1] = 2 * (n - Real(x));
    solve(diagonal, beside);
  }

  Real stiffness() const {
    Real compliance = 0;
    for (std::size_t i = 0; i < tool_.size(); ++i) compliance += tool_[i] * shape_[i];
    return 1 / compliance;
  }
  const std::vector<Real>& shape() const { return shape_; }

 private:
  Real spring(int i) const {
    const auto& k = chain_.stiffnesses;
    if (i == 0) return Real(k.front());
    if (i == static_cast<int>(k.size())) return Real(k.back());
    return 1 / (1 / Real(k[i - 1]) + 1 / Real(k[i]));
  }

  void solve(std::vector<Real> diagonal, const std::vector<Real>& beside) {
    shape_ = tool_;
    for (std::size_t i = 1; i < shape_.size(); ++i) {
      const Real factor = beside[i - 1] / diagonal[i - 1];
      diagonal[i] -= factor * beside[i - 1];
      shape_[i] -= factor * shape_[i - 1];
    }
    shape_.back() /= diagonal.back();
    for (std::size_t i = shape_.size() - 1; i-- > 0;) {
      shape_[i] = (shape_[i] - beside[i] * shape_[i + 1]) / diagonal[i];
    }
  }

  const Chain<Scalar>& chain_;
  std::vector<Real> tool_;
  std::vector<Real> shape_;
};

template <typename Scalar>
double errorOf(Scalar value, const Real& expected) {
  return static_cast<double>(abs(Real(value) / expected - 1));
}

struct Errors {
  double force = 0.0;
  double mesh = 0.0;
};

template <typename Scalar>
Errors largestErrors(int elements, double decades, int chains) {
  std::mt19937_64 random(static_cast<std::uint64_t>(elements) * 100 + 7);
  Errors largest;
  for (int i = 0; i < chains; ++i) {
    const Chain<Scalar> chain(elements, decades, random);
    const Reference<Scalar> reference(chain);
    const FiniteElements<Scalar> model(chain.parameters);
    largest.force = std::max(largest.force, errorOf(model.stiffness(), reference.stiffness()));
    std::vector<Scalar> shape(chain.stiffnesses.size());
    model.writeMeshShape(shape.data());
    for (std::size_t k = 0; k < shape.size(); ++k) {
      largest.mesh = std::max(largest.mesh, errorOf(shape[k], reference.shape()[k]));
    }
  }
  return largest;
}

/// Chains of so many elements that are tried.
int chainsOf(int elements) {
  return elements > 100 ? tests::inLongForm(5, 2) : tests::inLongForm(100, 20);
}

TEST(FiniteElementContrast, LosesNoDigitInDouble) {
  for (const int elements : {1, 2, 5, 15, 100, 1000}) {
    for (const double decades : {1.0, 3.0, 6.0, 12.0}) {
      const auto errors = largestErrors<double>(elements, decades, chainsOf(elements));
      EXPECT_LE(errors.force, 4e-15) << elements << " elements, 10^±" << decades;
      EXPECT_LE(errors.mesh, 4e-15) << elements << " elements, 10^±" << decades;
    }
  }
}

TEST(FiniteElementContrast, LosesNoDigitInFloat) {
  for (const int elements : {1, 2, 5, 15, 100, 1000}) {
    for (const double decades : {1.0, 3.0, 6.0, 12.0}) {
      const auto errors = largestErrors<float>(elements, decades, chainsOf(elements));
      EXPECT_LE(errors.force, 1e-6) << elements << " elements, 10^±" << decades;
      EXPECT_LE(errors.mesh, 1e-6) << elements << " elements, 10^±" << decades;
    }
  }
}

using Elements = FiniteElements<double>;

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

TEST(FiniteElementContrast, AllowsZeroAndInfiniteStiffness) {
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

TEST(FiniteElementContrast, YieldsAtOnceIfTheTissueIsRigid) {
  const double endless = std::numeric_limits<double>::infinity();
  const Elements rigid({.elementStiffness = endless});
  Elements::State state;
  EXPECT_EQ(rigid.at(4.0, state).force, 0.0);
  EXPECT_EQ(rigid.at(4.0 + 1e-12, state).force, 7.0);
}

}  // namespace finite_elements_contrast_test
}  // namespace haptics::models
