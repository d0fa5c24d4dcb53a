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

/// The dual of the bounded problem at some y: all that a step needs.
struct Dual {
  const ContactMatrix& matrix;
  std::span<const double> forces;
  std::span<const double> prior;
  double lambda;

  struct Point {
    Vector y;
    std::vector<double> densities;
    Vector rest;  ///< F − y − A ρ(y): the slope
    double value = 0.0;
    double primal = 0.0;
  };

  /// The best densities for given y are a projection, ρ(y) = max(0, ρ₀ + Aᵀy/λ): that is what makes
  /// the dual smooth and free of bounds. Its gradient is `rest`; any ρ gives an upper bound of the
  /// optimum (`primal`) and any y a lower one (`value`), so their difference bounds the error.
  Point at(Vector y) const {
    Point point{.y = std::move(y), .densities = {}, .rest = {}};
    point.densities = matrix.transposedTimes({point.y.data(), matrix.rows});
    double away = 0.0;
    for (std::size_t i = 0; i < point.densities.size(); ++i) {
      point.densities[i] = std::max(0.0, prior[i] + point.densities[i] / lambda);
      away += (point.densities[i] - prior[i]) * (point.densities[i] - prior[i]);
    }
    const auto felt = matrix.times(point.densities);
    const auto missing = (asVector(forces) - asVector(felt)).eval();
    point.rest = missing - point.y;
    point.value = asVector(forces).dot(point.y) - 0.5 * point.y.squaredNorm() +
                  0.5 * lambda * away - point.y.dot(asVector(felt));
    point.primal = 0.5 * missing.squaredNorm() + 0.5 * lambda * away;
    return point;
  }

  /// I + A_S A_Sᵀ / λ over the spheres that are not at their bound.
  Eigen::MatrixXd curvature(const std::vector<double>& densities) const {
    const auto n = static_cast<Eigen::Index>(matrix.rows);
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
      if (!(densities[column] > 0.0)) continue;
      // A sphere touches few depths, in rising order: only the lower triangle is filled, which is
      // all that the Cholesky factorisation reads.
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

  /// From @p from along @p step as far as the value rises enough; std::nullopt if it does not.
  /// Leaves in @p end where the whole step leads.
  std::optional<Point> along(const Point& from, const Vector& step, Point& end) const {
    constexpr double kLeastShare = 1e-5;
    const double slope = from.rest.dot(step);
    // Armijo's condition, and a strict rise: near the optimum the promised rise is below rounding.
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

  /// Newton's step up; std::nullopt if rounding is all that is left.
  ///
  /// Newton's curvature knows only the spheres above their bound. Where many leave theirs on the
  /// way it is far too small, and the step may rise nowhere: then those count as well, until none
  /// is missing. A step that knows every sphere on its way rises.
  std::optional<Point> next(const Point& from) const {
    auto counts = from.densities;
    Point end;
    for (bool isMissing = true; isMissing;) {
      const Vector step =
          Eigen::LLT<Eigen::MatrixXd, Eigen::Lower>(curvature(counts)).solve(from.rest);
      if (auto point = along(from, step, end)) return point;
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
  const auto felt = matrix.times(densities);
  const double wanted = asVector(forces).norm();
  const double off = (asVector(felt) - asVector(forces)).norm();
  return wanted > 0.0 ? off / wanted : (off > 0.0 ? 1.0 : 0.0);
}

double uniformDensity(const ContactMatrix& matrix, std::span<const double> forces) {
  const std::vector<double> ones(matrix.columns(), 1.0);
  const auto felt = matrix.times(ones);
  const double square = asVector(felt).squaredNorm();
  // Least squares with one unknown: (A 1)·F / |A 1|².
  return square > 0.0 ? std::max(0.0, asVector(felt).dot(asVector(forces)) / square) : 0.0;
}

DensityFit fitNonNegative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    double weight) {
  constexpr int kMostSteps = 60;  // at each weight
  // relative, at the requested weight: far below a noticeable force
  constexpr double kGap = 1e-9;
  constexpr double kGapOnTheWay = 1e-2;  // before that only a start for the next weight is needed
  constexpr double kEase = 0.3;          // from one weight to the next
  double squares = 0.0;
  for (const double v : matrix.value) squares += v * v;
  const double row = squares / static_cast<double>(matrix.rows);  // mean squared
  const auto gapOf = [](const Dual::Point& p) {
    return p.primal > 0.0 ? (p.primal - p.value) / p.primal : 0.0;
  };
  DensityFit fit;
  Dual::Point point;
  Vector y = Vector::Zero(static_cast<Eigen::Index>(matrix.rows));
  // The smaller the weight, the farther Newton's method goes astray from where it begins: from a
  // weight at which it cannot, down to the one that is wanted. Densities stay as they are if y
  // shrinks with the weight.
  double eased = std::max(weight, 1.0);
  while (true) {
    // λ is a share of the mean squared row, so that the fit does not depend on units; a matrix of
    // zeros still needs a λ to divide by.
    const Dual dual{matrix, forces, prior, std::max(eased * row, 1e-300)};
    const double goal = eased > weight ? kGapOnTheWay : kGap;
    point = dual.at(std::move(y));
    for (int step = 0; step < kMostSteps && gapOf(point) > goal; ++step) {
      auto next = dual.next(point);
      if (!next) break;
      point = std::move(*next);
      ++fit.iterations;
    }
    if (!(eased > weight)) break;
    const double easier = std::max(weight, kEase * eased);
    y = easier / eased * point.y;
    eased = easier;
  }
  fit.gap = gapOf(point);
  fit.densities = std::move(point.densities);
  fit.error = errorOf(matrix, fit.densities, forces);
  return fit;
}

DensityFit fitMultiplicative(
    const ContactMatrix& matrix,
    std::span<const double> forces,
    std::span<const double> prior,
    int iterations) {
  DensityFit fit{.densities = {prior.begin(), prior.end()}, .iterations = iterations};
  const std::vector<double> ones(matrix.rows, 1.0);
  const auto whole = matrix.transposedTimes(ones);
  std::vector<double> ratio(matrix.rows);
  for (int i = 0; i < iterations; ++i) {
    const auto felt = matrix.times(fit.densities);
    for (std::size_t row = 0; row < matrix.rows; ++row) {
      // Where nothing is felt no density can change it: 1 leaves all as they are.
      ratio[row] = felt[row] > 0.0 ? std::max(forces[row], 0.0) / felt[row] : 1.0;
    }
    const auto factor = matrix.transposedTimes(ratio);
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
      if (whole[column] > 0.0) fit.densities[column] *= factor[column] / whole[column];
    }
  }
  fit.gap = std::numeric_limits<double>::quiet_NaN();
  fit.error = errorOf(matrix, fit.densities, forces);
  return fit;
}

namespace {

/// Of every sphere that of its layer; below the last layer that is touched it goes on as there.
std::vector<double> spread(
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

/// @param layerOf  the layer of each column of @p matrix.
BoneFit fitInLayers(
    const ContactMatrix& matrix,
    std::span<const double> wanted,
    double uniform,
    std::span<const std::uint32_t> layerOf,
    std::size_t layers) {
  BoneFit fit;
  // A dozen unknowns are well determined by the curve; they are the prior of the spheres, of which
  // there are far more than depths.
  const auto few = layered(matrix, layerOf, layers);
  fit.layers = fitNonNegative(few, wanted, std::vector<double>(layers, uniform), 1e-9);
  fit.spheres = fitNonNegative(matrix, wanted, spread(few, layerOf, fit.layers.densities));
  fit.densities = fit.spheres.densities;
  fit.touchedShare = touchedShare(matrix);
  return fit;
}

/// Rows of force and torque, each divided by the norm of its target and multiplied by |F|.
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
  const auto few = layered(matrix, layerOf, layers);
  fit.layers.error = errorOf(few, fit.layers.densities, forces);
  fit.spheres.error = errorOf(matrix, fit.densities, forces);
  return fit;
}

double bestFriction(
    const ContactMatrix& matrix, std::span<const double> forces, TorqueRows torque) {
  constexpr int kTried = 13;  // each a quarter more than the last
  const std::vector<double> alike(matrix.columns(), uniformDensity(matrix, forces));
  const auto levers = torque.levers.times(alike);
  const double square = asVector(levers).squaredNorm();
  const double one = square > 0.0 ? asVector(levers).dot(asVector(torque.torques)) / square : 0.0;
  if (!(one > 0.0)) return 0.0;
  double best = one;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kTried; ++i) {
    torque.friction = one * std::exp2(-3.0 + 4.0 * i / (kTried - 1));
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
    const auto few = layered(matrix, layerOf, layers);
    fit.layers = fitSwarm(few, forces, options);
    fit.spheres = fit.layers;
    fit.spheres.densities = spread(few, layerOf, fit.layers.densities);
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
