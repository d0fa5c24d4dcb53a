// Force and mesh of elements of very different stiffness, against the matrix in 100 digits.
#include "haptics/bench/string_reference.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/models/finite_elements.h"
#include "tests/support/long_form.h"

namespace haptics::bench {
namespace string_reference_test {

/// A chain whose stiffnesses single precision holds exactly.
struct Chain {
  std::vector<double> stiffnesses;
  double tool = 0.0;

  Chain(int elements, double decades, std::mt19937_64& random) {
    std::uniform_real_distribution<double> exponent(-decades, decades);
    for (int i = 0; i < elements; ++i) {
      stiffnesses.push_back(
          static_cast<double>(static_cast<float>(std::pow(10.0, exponent(random)))));
    }
    tool = std::uniform_int_distribution<int>(0, elements - 1)(random) + 0.625;
  }
};

template <typename Scalar>
double errorOf(Scalar value, const HundredDigits& expected) {
  return static_cast<double>(abs(HundredDigits(value) / expected - 1));
}

/// The larger of the relative errors of the force and of the worst midpoint.
template <typename Scalar>
double worstErrorOf(const Chain& chain, const StringReference& reference) {
  const std::vector<Scalar> stiffnesses(chain.stiffnesses.begin(), chain.stiffnesses.end());
  typename models::FiniteElements<Scalar>::Parameters parameters;
  parameters.start = Scalar{0};
  parameters.end = static_cast<Scalar>(stiffnesses.size());
  parameters.elements = static_cast<int>(stiffnesses.size());
  parameters.toolPosition = static_cast<Scalar>(chain.tool);
  parameters.elementStiffnesses = stiffnesses.data();
  const models::FiniteElements<Scalar> model(parameters);
  double worst = errorOf(model.stiffness(), reference.stiffness);
  std::vector<Scalar> shape(stiffnesses.size());
  model.writeMeshShape(shape.data());
  for (std::size_t i = 0; i < shape.size(); ++i) {
    worst = std::max(worst, errorOf(shape[i], reference.shape[i]));
  }
  return worst;
}

TEST(StringReference, IsTheForceAndTheMeshOfFiniteElementsToTheLastDigits) {
  for (const int elements : {1, 2, 5, 15, 100, 1000}) {
    const int chains = elements > 100 ? tests::inLongForm(5, 2) : tests::inLongForm(100, 20);
    for (const double decades : {1.0, 3.0, 6.0, 12.0}) {
      std::mt19937_64 random(static_cast<std::uint64_t>(elements) * 100 + 7);
      for (int i = 0; i < chains; ++i) {
        const Chain chain(elements, decades, random);
        const StringReference reference(chain.stiffnesses, chain.tool);
        ASSERT_LE(worstErrorOf<double>(chain, reference), 4e-15) << elements << ", ±" << decades;
        ASSERT_LE(worstErrorOf<float>(chain, reference), 1e-6) << elements << ", ±" << decades;
      }
    }
  }
}

}  // namespace string_reference_test
}  // namespace haptics::bench
