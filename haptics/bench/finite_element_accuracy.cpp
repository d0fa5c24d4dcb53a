#include <algorithm>
#include <cmath>
#include <random>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/string_peers.h"
#include "haptics/bench/string_reference.h"
#include "haptics/models/finite_elements.h"

namespace haptics::bench {
namespace {

constexpr const char* kFiniteElementFamily = "finite elements";

/// Ours, behind the peers' face: force alone, or with the mesh.
template <typename Scalar>
class OurString final : public peers::StringPeer {
 public:
  OurString(std::string name, const std::vector<double>& k, double tool, bool hasMesh)
      : name_(std::move(name)),
        stiffnesses_(k.begin(), k.end()),
        elements_(parameters(tool)),
        hasMesh_(hasMesh),
        shape_(k.size()),
        drawn_(k.size()),
        mesh_(k.size()) {
    elements_.writeMeshShape(shape_.data());
  }

  std::string name() const override { return name_; }
  double solve(double y) override {
    typename models::FiniteElements<Scalar>::State state;
    const Scalar force = elements_.at(static_cast<Scalar>(y), state).force;
    if (hasMesh_) draw(force);
    return static_cast<double>(force);
  }
  const double* mesh() const override {
    for (std::size_t i = 0; i < drawn_.size(); ++i) mesh_[i] = static_cast<double>(drawn_[i]);
    return mesh_.data();
  }

 private:
  void draw(Scalar force) {
    const Scalar* shape = shape_.data();
    Scalar* drawn = drawn_.data();
    const std::size_t count = shape_.size();
    for (std::size_t i = 0; i < count; ++i) drawn[i] = shape[i] * force;
  }

  typename models::FiniteElements<Scalar>::Parameters parameters(double tool) const {
    typename models::FiniteElements<Scalar>::Parameters p;
    p.start = Scalar{0};
    p.end = static_cast<Scalar>(stiffnesses_.size());
    p.elements = static_cast<int>(stiffnesses_.size());
    p.toolPosition = static_cast<Scalar>(tool);
    p.contact = Scalar{0};
    p.yieldForce = Scalar(1e30);
    p.elementStiffnesses = stiffnesses_.data();
    return p;
  }

  std::string name_;
  std::vector<Scalar> stiffnesses_;
  models::FiniteElements<Scalar> elements_;
  bool hasMesh_;
  std::vector<Scalar> shape_;
  std::vector<Scalar> drawn_;
  mutable std::vector<double> mesh_;
};

using Strings = std::vector<std::unique_ptr<peers::StringPeer>>;

Strings everybody(const std::vector<double>& k, double tool) {
  auto all = peers::stringPeers(k, tool);
  all.push_back(std::make_unique<OurString<double>>("palpate, force alone", k, tool, false));
  all.push_back(std::make_unique<OurString<double>>("palpate, force and mesh", k, tool, true));
  all.push_back(
      std::make_unique<OurString<float>>("palpate, force and mesh, float", k, tool, true));
  return all;
}

double errorOf(double value, const HundredDigits& expected) {
  const double error = static_cast<double>(abs(HundredDigits(value) / expected - 1));
  return std::isfinite(value) ? error : INFINITY;
}

/// Of the force for a unit of travel; a number that is none counts as an error without end.
double forceError(peers::StringPeer& peer, const StringReference& reference) {
  return errorOf(peer.solve(1.0), reference.stiffness);
}

void raceAt(int elements, const Report& report) {
  const std::vector<double> k(static_cast<std::size_t>(elements), 1.0);
  const double tool = std::floor(elements * 2.0 / 3.0) + 0.625;
  auto all = everybody(k, tool);
  const StringReference reference(k, tool);
  std::vector<Contestant> contestants;
  for (const auto& peer : all) {
    contestants.push_back({peer->name(), [&peer](int steps) {
                             double force = 0.0;
                             for (int i = 0; i < steps; ++i) {
                               force = peer->solve(1.0 + 1e-3 * (i & 1023) + 0.0 * force);
                             }
                             return force;
                           }});
  }
  const auto timings = race(contestants);
  for (std::size_t i = 0; i < all.size(); ++i) {
    report(
        {.family = kFiniteElementFamily,
         .setting = "elements alike",
         .method = all[i]->name(),
         .parameter = static_cast<double>(elements),
         .error = forceError(*all[i], reference),
         .time = timings[i]});
  }
  constexpr int kColdRounds = 31;
  constexpr int kMostCold = 100;  // beyond, a dense solver streams its own matrix
  if (elements > kMostCold) return;
  const auto cold = raceCold(contestants, kColdRounds);
  for (std::size_t i = 0; i < all.size(); ++i) {
    report(
        {.family = kFiniteElementFamily,
         .setting = "elements alike, cold",
         .method = all[i]->name(),
         .parameter = static_cast<double>(elements),
         .time = cold[i]});
  }
}

/// The largest error over random chains whose stiffnesses span 10^±decades.
void contrast(int elements, int decades, const Report& report) {
  constexpr int kChains = 20;
  std::mt19937_64 random(static_cast<std::uint64_t>(elements * 100 + decades));
  std::uniform_real_distribution<double> exponent(-decades, decades);
  std::vector<std::string> names;
  std::vector<double> errors;
  for (int chain = 0; chain < kChains; ++chain) {
    std::vector<double> k(static_cast<std::size_t>(elements));
    // As a single-precision number, so that all methods are asked the same.
    for (auto& each : k)
      each = static_cast<double>(static_cast<float>(std::pow(10.0, exponent(random))));
    const double tool = std::uniform_int_distribution<int>(1, elements - 2)(random) + 0.625;
    const StringReference reference(k, tool);
    auto all = everybody(k, tool);
    errors.resize(all.size(), 0.0);
    names.resize(all.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      names[i] = all[i]->name();
      errors[i] = std::max(errors[i], forceError(*all[i], reference));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    report(
        {.family = kFiniteElementFamily,
         .setting = "elements that differ, N = " + std::to_string(elements),
         .method = names[i],
         .parameter = static_cast<double>(decades),
         .error = errors[i]});
  }
}

}  // namespace

void measureFiniteElements(const Report& report) {
  for (const int elements : {5, 10, 15, 100, 1000, 12'445}) raceAt(elements, report);
  for (const int elements : {5, 15, 100}) {
    for (const int decades : {0, 1, 2, 3, 4, 6, 9, 12}) contrast(elements, decades, report);
  }
}

}  // namespace haptics::bench
