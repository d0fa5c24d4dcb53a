// Fits of densities: error against run time of several methods.
#include <algorithm>
#include <chrono>
#include <vector>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "haptics/bench/measurement.h"
#include "haptics/filters/averages.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "haptics/reaming/packing/density_fit.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::bench {
namespace {

using reaming::ContactMatrix;
using reaming::DensityFit;

constexpr const char* kDensityFamily = "density";
constexpr const char* kBoundedLeastSquares = "palpate, bounded least squares";
constexpr std::size_t kDepths = 400;
constexpr int kSeeds = 5;

struct Problem {
  ContactMatrix matrix;
  std::vector<double> forces;
  std::vector<double> uniform;
};

/// A packing of @p count spheres and the forces of a synthetic dynamic series.
Problem syntheticProblem(std::size_t count) {
  const auto packing = *reaming::pack(reaming::Acetabulum(), {.count = count});
  const std::vector<double> ones(packing.spheres.size(), 1.0);
  const auto plunge = reaming::plungePathInto(reaming::SphereField(packing, ones), 0.026);
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
void timeFit(
    const std::string& setting,
    const std::string& method,
    double parameter,
    const AccuracyRun& run,
    Fit fit) {
  const auto start = std::chrono::steady_clock::now();
  const DensityFit result = fit();
  const double time = nanosecondsSince(start);
  run.report(
      {.family = kDensityFamily,
       .setting = setting,
       .method = method,
       .parameter = parameter,
       .error = result.error,
       .time = Timing{time, time}});
}

/// Eigen's conjugate gradients for least squares; negative densities are set to 0 afterwards.
DensityFit eigenLeastSquares(const Problem& problem, int iterations) {
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

/// Reports the median error and time of the swarm over several seeds, and the largest time.
void timeSwarms(
    const std::string& setting,
    const ContactMatrix& matrix,
    const std::vector<double>& forces,
    int iterations,
    double parameter,
    const AccuracyRun& run) {
  std::vector<double> errors;
  std::vector<double> times;
  for (int seed = 1; seed <= kSeeds; ++seed) {
    reaming::SwarmOptions options{.iterations = iterations};
    options.seed = static_cast<std::uint64_t>(seed);
    const auto start = std::chrono::steady_clock::now();
    errors.push_back(reaming::fitSwarm(matrix, forces, options).error);
    times.push_back(nanosecondsSince(start));
  }
  run.report(
      {.family = kDensityFamily,
       .setting = setting,
       .method = "swarm, median of " + std::to_string(kSeeds) + " seeds",
       .parameter = parameter,
       .error = filters::upperMedian(errors),
       .time = Timing{filters::upperMedian(times), std::ranges::max(times)}});
}

/// Fits one density per layer, by bounded least squares and by the swarm.
void fitLayers(const Problem& problem, std::size_t layers, const AccuracyRun& run) {
  const auto few =
      reaming::summedByLayer(problem.matrix, reaming::layersOf(problem.matrix, layers), layers);
  const std::vector<double> prior(layers, problem.uniform.front());
  const auto parameter = static_cast<double>(layers);
  timeFit("layers", kBoundedLeastSquares, parameter, run, [&] {
    return reaming::fitNonNegative(few, problem.forces, prior, 1e-9);
  });
  if (!run.isShortRun) timeSwarms("layers", few, problem.forces, 500, parameter, run);
}

}  // namespace

void measureDensity(const AccuracyRun& run) {
  const Problem problem = syntheticProblem(run.isShortRun ? 5000 : 201'532);
  const std::string all = "all spheres";
  for (const double weight : {1e-2, 1e-4, 1e-6}) {
    double gap = 0.0;
    timeFit(all, kBoundedLeastSquares, weight, run, [&] {
      auto fit = reaming::fitNonNegative(problem.matrix, problem.forces, problem.uniform, weight);
      gap = std::max(fit.gap, 0.0);
      return fit;
    });
    run.report(
        {.family = kDensityFamily,
         .setting = "above the optimum, at most",
         .method = kBoundedLeastSquares,
         .parameter = weight,
         .error = gap,
         .bound = 0.01});
  }
  for (const std::size_t layers : {12, 50}) fitLayers(problem, layers, run);
  if (run.isShortRun) return;
  for (const int iterations : {20, 100}) {
    timeFit(all, "Eigen LSCG, cut off at 0", iterations, run, [&, n = iterations] {
      return eigenLeastSquares(problem, n);
    });
  }
  constexpr int kSwarmIterations = 8;
  timeSwarms(all, problem.matrix, problem.forces, kSwarmIterations, kSwarmIterations, run);
}

}  // namespace haptics::bench
