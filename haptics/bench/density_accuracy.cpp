// Densities of spheres: error against run time of the ways to fit them.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "haptics/bench/measurement.h"
#include "haptics/bench/tiled_bone.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "haptics/reaming/packing/density_fit.h"

namespace haptics::bench {
namespace {

using reaming::ContactMatrix;
using reaming::DensityFit;

constexpr const char* kDensityFamily = "density";
constexpr std::size_t kDepths = 400;
constexpr int kSeeds = 20;

struct Problem {
  ContactMatrix matrix;
  std::vector<double> forces;
  std::vector<double> uniform;
};

/// The paper's count of spheres against a synthetic dynamic curve.
Problem problemOf(std::size_t count) {
  const auto packing = tiledBone(count);
  const std::vector<double> ones(packing.spheres.size(), 1.0);
  const auto plunge = reaming::plungeInto(reaming::SphereField(packing, ones), 0.026);
  const auto series = reaming::noiselessSeries({.hardness = 0.5});
  std::vector<double> depths;
  Problem problem;
  const double deepest = series.displacement.back();
  for (std::size_t i = 0; i < kDepths; ++i) {
    depths.push_back(deepest * (static_cast<double>(i) + 0.5) / kDepths);
    const auto at =
        std::lower_bound(series.displacement.begin(), series.displacement.end(), depths.back());
    const auto index = static_cast<std::size_t>(at - series.displacement.begin());
    problem.forces.push_back(std::max(0.0, series.force[index]));
  }
  problem.matrix = reaming::contactMatrix(packing, packing.coverage(), plunge, depths);
  problem.uniform.assign(
      problem.matrix.columns(), reaming::uniformDensity(problem.matrix, problem.forces));
  return problem;
}

template <typename Fit>
void measure(
    const std::string& setting,
    const std::string& method,
    double parameter,
    const Report& report,
    Fit fit) {
  const auto start = std::chrono::steady_clock::now();
  const DensityFit result = fit();
  const double time =
      std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  report(
      {.family = kDensityFamily,
       .setting = setting,
       .method = method,
       .parameter = parameter,
       .error = result.error,
       .time = Timing{time, time}});
}

/// Eigen's conjugate gradients for least squares: densities below 0 are cut off afterwards.
DensityFit leastSquares(const Problem& problem, int iterations) {
  const auto& m = problem.matrix;
  Eigen::SparseMatrix<double> a(
      static_cast<Eigen::Index>(m.rows), static_cast<Eigen::Index>(m.columns()));
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t column = 0; column < m.columns(); ++column) {
    for (std::size_t i = m.start[column]; i < m.start[column + 1]; ++i) {
      entries.emplace_back(static_cast<int>(m.row[i]), static_cast<int>(column), m.value[i]);
    }
  }
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::LeastSquaresConjugateGradient<Eigen::SparseMatrix<double>> solver;
  solver.setMaxIterations(iterations);
  solver.compute(a);
  const Eigen::VectorXd x = solver.solve(
      Eigen::Map<const Eigen::VectorXd>(problem.forces.data(), static_cast<Eigen::Index>(m.rows)));
  DensityFit fit{.densities = {x.data(), x.data() + x.size()}};
  for (double& density : fit.densities) density = std::max(0.0, density);
  fit.error = reaming::errorOf(m, fit.densities, problem.forces);
  return fit;
}

/// Seeds of a swarm: the median error and time, and the slowest.
void measureSwarms(
    const std::string& setting,
    const ContactMatrix& matrix,
    const std::vector<double>& forces,
    reaming::SwarmOptions options,
    int seeds,
    double parameter,
    const Report& report) {
  std::vector<double> errors;
  std::vector<double> times;
  for (int seed = 1; seed <= seeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    const auto start = std::chrono::steady_clock::now();
    errors.push_back(reaming::fitSwarm(matrix, forces, options).error);
    times.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count());
  }
  std::sort(errors.begin(), errors.end());
  std::sort(times.begin(), times.end());
  report(
      {.family = kDensityFamily,
       .setting = setting,
       .method = "swarm, median of 20 seeds",
       .parameter = parameter,
       .error = errors[errors.size() / 2],
       .time = Timing{times[times.size() / 2], times.back()}});
}

}  // namespace

void measureDensity(const Report& report) {
  const Problem problem = problemOf(201'532);
  const auto& [matrix, forces, uniform] = problem;
  const std::string all = "all spheres";
  for (const double weight : {1e-2, 1e-4, 1e-6}) {
    measure(all, "palpate, bounded least squares", weight, report, [&] {
      auto fit = reaming::fitNonNegative(matrix, forces, uniform, weight);
      report(
          {.family = kDensityFamily,
           .setting = "above the optimum, at most",
           .method = "palpate, bounded least squares",
           .parameter = weight,
           .error = std::max(fit.gap, 0.0),
           .time = std::nullopt});
      return fit;
    });
  }
  for (const int iterations : {5, 20, 100}) {
    measure(all, "multiplicative (MLEM)", iterations, report, [&, n = iterations] {
      return reaming::fitMultiplicative(matrix, forces, uniform, n);
    });
  }
  for (const int iterations : {20, 100}) {
    measure(all, "Eigen LSCG, cut off at 0", iterations, report, [&, n = iterations] {
      return leastSquares(problem, n);
    });
  }
  for (const int iterations : {1, 8}) {
    measureSwarms(all, matrix, forces, {.iterations = iterations}, kSeeds, iterations, report);
  }
  for (const std::size_t layers : {12, 50}) {
    const auto few = reaming::layered(matrix, reaming::layersOf(matrix, layers), layers);
    const std::vector<double> prior(layers, uniform.front());
    const auto parameter = static_cast<double>(layers);
    measure("layers", "palpate, bounded least squares", parameter, report, [&] {
      return reaming::fitNonNegative(few, forces, prior, 1e-9);
    });
    measureSwarms("layers", few, forces, {.iterations = 500}, kSeeds, parameter, report);
  }
}

}  // namespace haptics::bench
