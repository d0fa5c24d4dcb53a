#include "haptics/reaming/packing/density_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace haptics::reaming {
namespace {

using Vector = Eigen::VectorXd;

Eigen::Map<const Vector> asVector(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// The dual of the bounded problem of fitNonNegative(), and Newton steps on it.
struct Dual {
  const ContactMatrix& matrix;
  std::span<const double> forces;
  std::span<const double> prior;
  double lambda;

  struct Point {
    Vector y;
    std::vector<double> densities;
    Vector rest;  ///< F − y − A ρ(y): the gradient
    double value = 0.0;
    double primal = 0.0;
  };

  /// The optimal densities for given y are a projection, ρ(y) = max(0, ρ₀ + Aᵀy/λ), so the dual is
  /// smooth and unconstrained. Its gradient is `rest`. Any ρ gives an upper bound of the optimum
  /// (`primal`), any y a lower one (`value`), so their difference bounds the error.
  Point at(Vector y) const {
    Point point{.y = std::move(y), .densities = {}, .rest = {}};
    point.densities = matrix.transposedTimes({point.y.data(), matrix.rows});
    double away = 0.0;
    for (std::size_t i = 0; i < point.densities.size(); ++i) {
      point.densities[i] = std::max(0.0, prior[i] + point.densities[i] / lambda);
      away += (point.densities[i] - prior[i]) * (point.densities[i] - prior[i]);
    }
    const auto fittedForce = matrix.times(point.densities);
    const auto missing = (asVector(forces) - asVector(fittedForce)).eval();
    point.rest = missing - point.y;
    point.value = asVector(forces).dot(point.y) - 0.5 * point.y.squaredNorm() +
                  0.5 * lambda * away - point.y.dot(asVector(fittedForce));
    point.primal = 0.5 * missing.squaredNorm() + 0.5 * lambda * away;
    return point;
  }

  /// I + A_S A_Sᵀ / λ with S the spheres of positive density.
  Eigen::MatrixXd curvature(const std::vector<double>& densities) const {
    const auto n = static_cast<Eigen::Index>(matrix.rows);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
      if (!(densities[column] > 0.0)) continue;
      // A sphere has contact at few depths, sorted in increasing order: only the lower triangle is
      // filled, which is all that the Cholesky factorisation reads.
      for (std::size_t i = matrix.start[column]; i < matrix.start[column + 1]; ++i) {
        const double share = matrix.value[i] / lambda;
        double* below = sum.col(matrix.row[i]).data();
        for (std::size_t j = i; j < matrix.start[column + 1]; ++j) {
          below[matrix.row[j]] += share * matrix.value[j];
        }
      }
    }
    sum.diagonal().array() += 1.0;
    return sum;
  }

  /// Line search from @p from along @p step; std::nullopt if the value does not rise. Sets @p end
  /// to the point after the full step.
  std::optional<Point> lineSearch(const Point& from, const Vector& step, Point& end) const {
    constexpr double kLeastShare = 1e-5;
    const double slope = from.rest.dot(step);
    // Armijo's condition, and a strict rise, since near the optimum the required rise is below
    // rounding.
    const auto rises = [&](const Point& point, double share) {
      return point.value > from.value && point.value >= from.value + 1e-4 * share * slope;
    };
    end = at(from.y + step);
    if (rises(end, 1.0)) return end;
    for (double share = 0.5; share > kLeastShare; share *= 0.5) {
      auto point = at(from.y + share * step);
      if (rises(point, share)) return point;
    }
    return std::nullopt;
  }

  /// One Newton step; std::nullopt if only rounding errors are left.
  ///
  /// The curvature includes only the spheres of positive density. If many others become positive
  /// along the step, it is far too small, and the value may not rise anywhere on the step. Then
  /// these spheres are included, too, and the step is repeated until none is missing; the value
  /// rises along that step.
  std::optional<Point> next(const Point& from) const {
    auto counts = from.densities;
    Point end;
    for (bool isMissing = true; isMissing;) {
      const Vector step =
          Eigen::LLT<Eigen::MatrixXd, Eigen::Lower>(curvature(counts)).solve(from.rest);
      if (auto point = lineSearch(from, step, end)) return point;
      isMissing = false;
      for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0.0 || !(end.densities[i] > 0.0)) continue;
        counts[i] = end.densities[i];
        isMissing = true;
      }
    }
    return std::nullopt;
  }
};

}  // namespace

double errorOf(
    const ContactMatrix& matrix,
    std::span<const double> densities,
    std::span<const double> forces) {
  const auto fittedForce = matrix.times(densities);
  const double wanted = asVector(forces).norm();
  const double off = (asVector(fittedForce) - asVector(forces)).norm();
  return wanted > 0.0 ? off / wanted : (off > 0.0 ? 1.0 : 0.0);
}

double uniformDensity(const ContactMatrix& matrix, std::span<const double> forces) {
  const std::vector<double> ones(matrix.columns(), 1.0);
  const auto fittedForce = matrix.times(ones);
  const double square = asVector(fittedForce).squaredNorm();
  // Least squares with one unknown: (A 1)·F / |A 1|².
  return square > 0.0 ? std::max(0.0, asVector(fittedForce).dot(asVector(forces)) / square) : 0.0;
}

DensityFit fitNonNegative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    double weight) {
  constexpr int kMostSteps = 60;  // per weight
  // relative duality gap at the requested weight: far below a noticeable force
  constexpr double kFinalGap = 1e-9;
  // At larger weights only a start for the next weight is needed.
  constexpr double kIntermediateGap = 1e-2;
  constexpr double kWeightFactor = 0.3;  // factor by which the weight falls from step to step
  double squares = 0.0;
  for (const double v : matrix.value) squares += v * v;
  const double row = squares / static_cast<double>(matrix.rows);  // mean squared norm of a row
  const auto gapOf = [](const Dual::Point& p) {
    return p.primal > 0.0 ? (p.primal - p.value) / p.primal : 0.0;
  };
  DensityFit fit;
  Dual::Point point;
  Vector y = Vector::Zero(static_cast<Eigen::Index>(matrix.rows));
  // With a small weight Newton's method may diverge from a bad start. So begin with a weight at
  // which it converges, and reduce it. Scaling y with the weight keeps the densities.
  double weightNow = std::max(weight, 1.0);
  while (true) {
    // λ is relative to the mean squared norm of a row, so the fit does not depend on units. The
    // bound avoids a division by zero for a zero matrix.
    const Dual dual{matrix, forces, prior, std::max(weightNow * row, 1e-300)};
    const double goal = weightNow > weight ? kIntermediateGap : kFinalGap;
    point = dual.at(std::move(y));
    for (int step = 0; step < kMostSteps && gapOf(point) > goal; ++step) {
      auto next = dual.next(point);
      if (!next) break;
      point = std::move(*next);
      ++fit.iterations;
    }
    if (!(weightNow > weight)) break;
    const double nextWeight = std::max(weight, kWeightFactor * weightNow);
    y = nextWeight / weightNow * point.y;
    weightNow = nextWeight;
  }
  fit.gap = gapOf(point);
  fit.densities = std::move(point.densities);
  fit.error = errorOf(matrix, fit.densities, forces);
  return fit;
}

namespace {

/// Density of every sphere: that of its layer; spheres below the last touched layer get that
/// layer's.
std::vector<double> spreadOverSpheres(
    const ContactMatrix& few,
    std::span<const std::uint32_t> layerOf,
    const std::vector<double>& densities) {
  double below = 0.0;
  for (std::size_t layer = 0; layer < densities.size(); ++layer) {
    if (few.isTouched(layer)) below = densities[layer];
  }
  std::vector<double> all;
  all.reserve(layerOf.size());
  for (const auto layer : layerOf) {
    all.push_back(layer < densities.size() ? densities[layer] : below);
  }
  return all;
}

double touchedShare(const ContactMatrix& matrix) {
  std::size_t touched = 0;
  for (std::size_t i = 0; i < matrix.columns(); ++i) touched += matrix.isTouched(i) ? 1 : 0;
  return static_cast<double>(touched) / static_cast<double>(matrix.columns());
}

}  // namespace

namespace {

/// @param layerOf  layer of each column of @p matrix.
BoneFit fitInLayers(
    const ContactMatrix& matrix,
    std::span<const double> wanted,
    double uniform,
    std::span<const std::uint32_t> layerOf,
    std::size_t layers) {
  BoneFit fit;
  // The curve determines a dozen unknowns well. They are the prior of the spheres, of which there
  // are far more than depths.
  const auto few = summedByLayer(matrix, layerOf, layers);
  fit.layers = fitNonNegative(few, wanted, std::vector<double>(layers, uniform), 1e-9);
  fit.spheres =
      fitNonNegative(matrix, wanted, spreadOverSpheres(few, layerOf, fit.layers.densities));
  fit.densities = fit.spheres.densities;
  fit.touchedShare = touchedShare(matrix);
  return fit;
}

/// The equations of force and torque; those of the torque are scaled by |F| / |T|.
struct JointProblem {
  ContactMatrix matrix;
  std::vector<double> wanted;

  JointProblem(const ContactMatrix& force, std::span<const double> forces, const TorqueRows& torque)
      : wanted(forces.begin(), forces.end()) {
    const double torques = asVector(torque.torques).norm();
    const double weight = torques > 0.0 ? asVector(forces).norm() / torques : 0.0;
    matrix = stacked(force, torque.levers, weight * torque.friction);
    for (const double t : torque.torques) wanted.push_back(weight * t);
  }
};

}  // namespace

BoneFit fitBone(const ContactMatrix& matrix, std::span<const double> forces, std::size_t layers) {
  return fitInLayers(
      matrix, forces, uniformDensity(matrix, forces), layersOf(matrix, layers), layers);
}

BoneFit fitBone(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    const TorqueRows& torque,
    std::size_t layers) {
  const JointProblem joint(matrix, forces, torque);
  const auto layerOf = layersOf(matrix, layers);
  auto fit =
      fitInLayers(joint.matrix, joint.wanted, uniformDensity(matrix, forces), layerOf, layers);
  const auto few = summedByLayer(matrix, layerOf, layers);
  fit.layers.error = errorOf(few, fit.layers.densities, forces);
  fit.spheres.error = errorOf(matrix, fit.densities, forces);
  return fit;
}

double bestFriction(
    const ContactMatrix& matrix, std::span<const double> forces, TorqueRows torque) {
  constexpr int kTriedFrictions = 13;  // tried values; each is 1.26 times the last
  const std::vector<double> alike(matrix.columns(), uniformDensity(matrix, forces));
  const auto levers = torque.levers.times(alike);
  const double square = asVector(levers).squaredNorm();
  const double one = square > 0.0 ? asVector(levers).dot(asVector(torque.torques)) / square : 0.0;
  if (!(one > 0.0)) return 0.0;
  double best = one;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTriedFrictions; ++i) {
    torque.friction = one * std::exp2(-3.0 + 4.0 * i / (kTriedFrictions - 1));
    const JointProblem joint(matrix, forces, torque);
    const double error = fitNonNegative(joint.matrix, joint.wanted, alike).error;
    if (!(error < least)) continue;
    least = error;
    best = torque.friction;
  }
  return best;
}

BoneFit fitBoneBySwarm(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::size_t layers,
    const SwarmOptions& options) {
  BoneFit fit;
  fit.touchedShare = touchedShare(matrix);
  if (layers > 0) {
    const auto layerOf = layersOf(matrix, layers);
    const auto few = summedByLayer(matrix, layerOf, layers);
    fit.layers = fitSwarm(few, forces, options);
    fit.spheres = fit.layers;
    fit.spheres.densities = spreadOverSpheres(few, layerOf, fit.layers.densities);
  } else {
    fit.spheres = fitSwarm(matrix, forces, options);
    auto& densities = fit.spheres.densities;
    double sum = 0.0;
    for (std::size_t i = 0; i < densities.size(); ++i) {
      if (matrix.isTouched(i)) sum += densities[i];
    }
    const double touched = fit.touchedShare * static_cast<double>(densities.size());
    for (std::size_t i = 0; i < densities.size(); ++i) {
      if (!matrix.isTouched(i)) densities[i] = touched > 0.0 ? sum / touched : 0.0;
    }
    fit.layers = fit.spheres;
  }
  fit.densities = fit.spheres.densities;
  return fit;
}

}  // namespace haptics::reaming
