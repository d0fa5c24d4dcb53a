#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/peers.h"
#include "haptics/bench/string_reference.h"
#include "haptics/models/finite_elements.h"

namespace haptics::bench {
namespace {

constexpr const char* kFiniteElementFamily = "finite elements";
constexpr const char* kOurDouble = "palpate, force and mesh";
constexpr const char* kOurFloat = "palpate, force and mesh, float";

using peers::StringSolver;

/// Palpate's own solver: the force alone, or with the displacements of the mesh. The benchmark
/// fails if its error exceeds the bound of the precision.
template <typename Scalar>
StringSolver ourString(
    std::string name, const std::vector<double>& stiffnesses, double tool, bool hasMesh) {
  using Elements = models::FiniteElements<Scalar>;
  struct Mesh {
    std::vector<Scalar> stiffnesses;
    std::vector<Scalar> shape;
    std::vector<Scalar> drawn;
  };
  const auto mesh = std::make_shared<Mesh>();
  mesh->stiffnesses.assign(stiffnesses.begin(), stiffnesses.end());
  typename Elements::Parameters p;
  p.start = Scalar{0};
  p.end = static_cast<Scalar>(stiffnesses.size());
  p.elements = static_cast<int>(stiffnesses.size());
  p.toolPosition = static_cast<Scalar>(tool);
  p.contact = Scalar{0};
  p.yieldForce = Scalar(1e30);
  p.elementStiffnesses = mesh->stiffnesses.data();
  const Elements elements(p);
  mesh->shape.resize(stiffnesses.size());
  mesh->drawn.resize(stiffnesses.size());
  elements.writeMeshShape(mesh->shape.data());
  return {std::move(name), [mesh, elements, hasMesh](double y) {
            typename Elements::State state;
            const Scalar force = elements.at(static_cast<Scalar>(y), state).force;
            if (hasMesh) {
              const Scalar* shape = mesh->shape.data();
              Scalar* drawn = mesh->drawn.data();
              const std::size_t count = mesh->shape.size();
              for (std::size_t i = 0; i < count; ++i) drawn[i] = shape[i] * force;
            }
            return static_cast<double>(force);
          }};
}

std::vector<StringSolver> allStrings(const std::vector<double>& k, double tool) {
  auto all = peers::stringPeers(k, tool);
  all.push_back(ourString<double>("palpate, force alone", k, tool, false));
  all.push_back(ourString<double>(kOurDouble, k, tool, true));
  all.push_back(ourString<float>(kOurFloat, k, tool, true));
  return all;
}

/// Bound of the relative error; none for long chains, which lose more digits.
std::optional<double> boundOf(const std::string& method, int elements) {
  if (elements > 1000) return std::nullopt;
  if (method == kOurDouble) return 4e-15;
  if (method == kOurFloat) return 1e-6;
  return std::nullopt;
}

/// Relative error of the force for one unit of travel.
double errorOf(const StringSolver& solver, const StringReference& reference) {
  const double force = solver.solve(1.0);
  if (!std::isfinite(force)) return INFINITY;
  return static_cast<double>(abs(HundredDigits(force) / reference.stiffness - 1));
}

void measureAlike(int elements, const AccuracyRun& run) {
  const std::vector<double> k(static_cast<std::size_t>(elements), 1.0);
  const double tool = std::floor(elements * 2.0 / 3.0) + 0.625;
  const auto all = allStrings(k, tool);
  const StringReference reference(k, tool);
  std::vector<Contestant> contestants;
  for (const auto& solver : all) {
    contestants.push_back({solver.name, [&solver](int steps) {
                             double force = 0.0;
                             for (int i = 0; i < steps; ++i) {
                               force = solver.solve(1.0 + 1e-3 * (i & 1023) + 0.0 * force);
                             }
                             return force;
                           }});
  }
  const auto times = run.times(contestants);
  for (std::size_t i = 0; i < all.size(); ++i) {
    run.report(
        {.family = kFiniteElementFamily,
         .setting = "elements alike",
         .method = all[i].name,
         .parameter = static_cast<double>(elements),
         .error = errorOf(all[i], reference),
         .bound = boundOf(all[i].name, elements),
         .time = times[i]});
  }
}

/// Reports the largest error over random chains whose stiffnesses span 10^±decades.
void measureContrast(int elements, int decades, const AccuracyRun& run) {
  constexpr int kChains = 20;
  std::mt19937_64 random(static_cast<std::uint64_t>(elements * 100 + decades));
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<std::string> names;
  std::vector<double> errors;
  for (int chain = 0; chain < kChains; ++chain) {
    std::vector<double> k(static_cast<std::size_t>(elements));
    // Single-precision numbers, so that all methods solve the same problem.
    for (auto& each : k)
      each = static_cast<double>(static_cast<float>(std::pow(10.0, exponent(random))));
    const double tool = std::uniform_int_distribution<int>(1, elements - 2)(random) + 0.625;
    const StringReference reference(k, tool);
    const auto all = allStrings(k, tool);
    errors.resize(all.size(), 0.0);
    names.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      names[i] = all[i].name;
      errors[i] = std::max(errors[i], errorOf(all[i], reference));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    run.report(
        {.family = kFiniteElementFamily,
         .setting = "elements that differ, N = " + std::to_string(elements),
         .method = names[i],
         .parameter = static_cast<double>(decades),
         .error = errors[i],
         .bound = boundOf(names[i], elements)});
  }
}

}  // namespace

void measureFiniteElements(const AccuracyRun& run) {
  for (const int elements : {5, 10, 15, 100, 1000, 12'445}) {
    if (run.isShortRun && elements > 100) break;
    measureAlike(elements, run);
  }
  for (const int elements : {5, 15, 100}) {
    if (run.isShortRun && elements > 15) break;
    for (const int decades : {0, 1, 2, 3, 4, 6, 9, 12}) measureContrast(elements, decades, run);
  }
}

}  // namespace haptics::bench
