// Compiled twice: the second time with fused multiply-add, and with another name for the namespace
// 'models', so that the linker keeps both. Use only the models and plain numbers here.
#include "haptics/bench/stability.h"
#include "haptics/models/finite_elements.h"
#include "haptics/models/hermite_curve.h"
#include "haptics/models/kalman_filter.h"

#ifndef PALPATE_KERNELS
#define PALPATE_KERNELS plain
#endif

namespace haptics::bench {
namespace PALPATE_KERNELS {
namespace {

template <typename Scalar>
Scalar chainStiffness(const Scalar* elementStiffnesses, int elements, Scalar tool) {
  typename models::FiniteElements<Scalar>::Parameters p;
  p.start = Scalar{0};
  p.end = static_cast<Scalar>(elements);
  p.elements = elements;
  p.toolPosition = tool;
  p.elementStiffnesses = elementStiffnesses;
  return models::FiniteElements<Scalar>(p).stiffness();
}

template <typename Scalar>
FilterStressResult stressTest(const FilterStressTest& a) {
  const models::KalmanNoise<Scalar> noise{
      .processForce = static_cast<Scalar>(a.q11),
      .processCovariance = static_cast<Scalar>(a.q12),
      .processStiffness = static_cast<Scalar>(a.q22),
      .finiteElements = static_cast<Scalar>(a.rElastic),
      .interpolation = static_cast<Scalar>(a.rRecorded),
      .wandering = static_cast<Scalar>(a.q22)};
  FilterStressResult verdict;
  verdict.isNoiseRefused = noise.invalidReason() != nullptr;
  if (verdict.isNoiseRefused) return verdict;
  models::KalmanFilter<Scalar> filter(
      noise.factored(), static_cast<models::KalmanScheme>(a.scheme));
  for (long i = 0; i < a.steps; ++i) {
    const Scalar travelled = a.isResting ? Scalar{0} : static_cast<Scalar>(a.travelled[i]);
    const Scalar force = filter.step(travelled, Scalar{3}, Scalar{2});
    const auto& p = filter.variances();
    verdict.negative += p.force < Scalar{0} || p.rest < Scalar{0} ? 1 : 0;
    verdict.notFinite += force - force == Scalar{0} ? 0 : 1;
    verdict.force = static_cast<double>(force);
  }
  return verdict;
}

bool cubic(const double a[3], const double b[3], double x, double& force) {
  const auto segment =
      models::CubicSegment<double>::between({a[0], a[1], a[2]}, {b[0], b[1], b[2]});
  const models::HermiteCurve<double> curve(&segment, 1);
  if (!models::HermiteCurve<double>::isSound(&segment, 1)) return false;
  size_t hint = 0;
  force = curve.at(x, hint).force;
  return true;
}

}  // namespace

extern const StabilityKernels kKernels;
const StabilityKernels kKernels{
#ifdef __FMA__
    "fused multiply-add",
#else
    "each operation rounded",
#endif
    &chainStiffness<double>,
    &chainStiffness<float>,
    &stressTest<double>,
    &stressTest<float>,
    &cubic};

}  // namespace PALPATE_KERNELS
}  // namespace haptics::bench
