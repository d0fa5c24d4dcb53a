#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <thread>

#include "base/random.h"
#include "haptics/reaming/packing/density_fit.h"
#include "haptics/timing/stopwatch.h"

namespace haptics::reaming {
namespace {

struct Particle {
  std::vector<double> place;
  std::vector<double> velocity;
  std::vector<double> best;
  double error = std::numeric_limits<double>::infinity();  ///< error at `best`
  base::SplitMix64 random{0};
};

/// Moves one particle. It uses only the particle's own random numbers, so threads do not affect the
/// result.
void move(Particle& particle, const std::vector<double>& best, double most) {
  // The constriction factor of Clerc & Kennedy for φ = 4.1: χ = 0.7298, and χ φ / 2 = 1.49618.
  constexpr double kInertia = 0.7298;
  constexpr double kPull = 1.49618;  // acceleration towards its own best and the swarm's best
  for (std::size_t i = 0; i < particle.place.size(); ++i) {
    double& x = particle.place[i];
    double& v = particle.velocity[i];
    v = kInertia * v + kPull * particle.random.uniform() * (particle.best[i] - x) +
        kPull * particle.random.uniform() * (best[i] - x);
    x += v;
    // A particle that hits a bound stops there; otherwise its velocity would carry it beyond again.
    if (x < 0.0 || x > most) {
      x = x < 0.0 ? 0.0 : most;
      v = 0.0;
    }
  }
}

template <typename Work>
void forEach(std::vector<Particle>& particles, int threads, Work work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < particles.size(); i = next++) work(particles[i]);
  };
  std::vector<std::thread> helpers;
  for (int i = 1; i < threads; ++i) helpers.emplace_back(run);
  run();
  for (auto& helper : helpers) helper.join();
}

}  // namespace

DensityFit fitSwarm(
    const ContactMatrix& matrix, std::span<const double> forces, const SwarmOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const double most = options.most > 0.0 ? options.most : 5.0 * uniformDensity(matrix, forces);
  std::vector<Particle> particles(static_cast<std::size_t>(options.particles));
  base::SplitMix64 seeds(options.seed);
  for (auto& particle : particles) {
    particle.random = base::SplitMix64(seeds.bits());
    particle.place.resize(matrix.columns());
    for (double& x : particle.place) x = most * particle.random.uniform();
    particle.velocity.assign(matrix.columns(), 0.0);
    particle.best = particle.place;
  }
  const auto judge = [&](Particle& particle) {
    const double error = errorOf(matrix, particle.place, forces);
    if (error < particle.error) {
      particle.error = error;
      particle.best = particle.place;
    }
  };
  const auto bestParticle = [&] {
    const auto best = std::ranges::min_element(
        particles, [](const Particle& a, const Particle& b) { return a.error < b.error; });
    return std::pair(best->best, best->error);
  };
  forEach(particles, options.threads, judge);
  auto lead = bestParticle();
  DensityFit fit{.densities = {}, .gap = std::numeric_limits<double>::quiet_NaN()};
  for (; fit.iterations < options.iterations; ++fit.iterations) {
    if (options.seconds > 0.0 && timing::secondsSince(begin) >= options.seconds) break;
    forEach(particles, options.threads, [&](Particle& particle) {
      move(particle, lead.first, most);
      judge(particle);
    });
    lead = bestParticle();
  }
  fit.densities = std::move(lead.first);
  fit.error = lead.second;
  return fit;
}

}  // namespace haptics::reaming
