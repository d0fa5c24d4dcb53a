#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::bench::peers {

/// A spline through given nodes, from one library.
struct Spline {
  std::string name;
  std::function<double(double x)> at;
  /// Evaluates at all xs in sequence, each only after the last is complete, to measure latency.
  /// Returns the last value.
  std::function<double(std::span<const double> xs)> sweep;
};

/// @param evaluate  returns the value at x. A template parameter, so that the compiler can inline
///                  it into the loop.
template <typename Evaluate>
Spline splineOf(std::string name, Evaluate evaluate) {
  const auto sweep = [evaluate](std::span<const double> xs) mutable {
    double last = 0.0;
    for (const double x : xs) last = evaluate(x + last * 0.0);  // depends on the last result
    return last;
  };
  return {std::move(name), evaluate, sweep};
}

/// Boost's PCHIP and makima, GSL's natural cubic and Steffen's spline (where GSL is installed), and
/// for up to 100 nodes Eigen's cubic spline, whose fit takes O(n³).
std::vector<Spline> splinePeers(const std::vector<double>& xs, const std::vector<double>& ys);

/// A solver of the paper's string of finite elements.
struct StringSolver {
  std::string name;
  /// Returns the force at the tool [N] for a displacement y [travel units]; also computes the
  /// displacements of all midpoints, unless the name says otherwise.
  std::function<double(double y)> solve;
};

/// Solvers that form the matrix, for elements of length 1 and boundary A as in StringReference.
/// Dense LU in every step (as in the paper's program) and dense LU factorised once are included up
/// to 1000 unknowns; sparse LDLᵀ factorised once and Thomas' algorithm in every step always.
std::vector<StringSolver> stringPeers(
    const std::vector<double>& elementStiffnesses, double toolPosition);

/// Another search for the spheres that a reamer's surface cuts, nanoflann's k-d tree of centres:
/// the same Σ a ρ [N], summed one by one. Nothing if it was not installed at build time.
/// @param packing, densities  must outlive the result.
std::function<double(const reaming::Reamer&)> nanoflannPressing(
    const reaming::Packing& packing, const std::vector<double>& densities);

/// Noise of eq. (22)–(24) of the punch paper, the same for all peers.
struct KalmanNoiseValues {
  double q11 = 6.1024, q12 = 0.2772, q22 = 7.0275;
  double rElastic = 0.001, rRecorded = 7.742;
  double start11 = 6.1024, start22 = 7.0275;  ///< initial variances; the initial covariance is 0
};

/// How a textbook filter updates P: P − K H P, or Joseph's form (I − K H) P (I − K H)ᵀ + K R Kᵀ.
enum class Correction { Standard, Joseph };

/// The `sequential` filter in textbook form, with the three distinct entries of P.
template <typename Scalar, Correction kForm>
struct TextbookFilter {
  Scalar f{}, z{}, p11{}, p12{}, p22{};
  KalmanNoiseValues n;

  explicit TextbookFilter(const KalmanNoiseValues& numbers) : n(numbers) {
    p11 = Scalar(n.start11);
    p22 = Scalar(n.start22);
  }
  Scalar step(Scalar d, Scalar elastic, Scalar recorded) {
    f += z * d;
    p11 += d * (Scalar(2) * p12 + d * p22) + Scalar(n.q11);
    p12 += d * p22 + Scalar(n.q12);
    p22 += Scalar(n.q22);
    correct(elastic, Scalar(n.rElastic));
    correct(recorded, Scalar(n.rRecorded));
    return f;
  }
  bool hasNegativeVariance() const { return p11 < Scalar(0) || p22 < Scalar(0); }

 private:
  void correct(Scalar measured, Scalar r) {
    const Scalar inverse = Scalar(1) / (p11 + r);
    const Scalar k1 = p11 * inverse;
    const Scalar k2 = p12 * inverse;
    const Scalar innovation = measured - f;
    f += k1 * innovation;
    z += k2 * innovation;
    if constexpr (kForm == Correction::Standard) {
      p22 -= k2 * p12;
      p12 -= k2 * p11;
      p11 -= k1 * p11;
    } else {
      const Scalar a = Scalar(1) - k1;
      const Scalar old11 = p11;
      const Scalar old12 = p12;
      p11 = a * a * old11 + k1 * k1 * r;
      p12 = a * (old12 - k2 * old11) + k1 * k2 * r;
      p22 = p22 - Scalar(2) * k2 * old12 + k2 * k2 * old11 + k2 * k2 * r;
    }
  }
};

template <typename Scalar>
using StandardFilter = TextbookFilter<Scalar, Correction::Standard>;
template <typename Scalar>
using JosephFilter = TextbookFilter<Scalar, Correction::Joseph>;

/// Runs a Kalman filter with Eigen's matrices, of fixed or of dynamic size, for @p steps steps of
/// length @p travelled [travel units], each with the measured forces 3 N and 2 N. Returns the last
/// force [N].
double eigenFixed(const KalmanNoiseValues& numbers, int steps, double travelled);
double eigenDynamic(const KalmanNoiseValues& numbers, int steps, double travelled);

/// Names and versions of the compared libraries.
std::string versions();

}  // namespace haptics::bench::peers
