// Bone of spheres: what a step of contact and of removal takes, beside others who find spheres.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/sphere_peers.h"
#include "haptics/bench/tiled_bone.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/plunge.h"
#include "haptics/reaming/bone/sphere_kernel.h"
#include "haptics/reaming/packing/acetabulum.h"
#include "haptics/reaming/packing/packing_builder.h"

namespace haptics::bench {
namespace {

using reaming::Packing;
using reaming::Plunge;
using reaming::SphereField;

constexpr const char* kPackingFamily = "packing";
constexpr double kRadius = 0.026;  // of the reamer [m]
constexpr double kDensity = 2e5;   // [N/m²]

/// Where a step is: to and fro between 6 and 12 mm, a little further each time.
double depthOf(std::size_t step) {
  return 0.009 - 0.003 * std::cos(0.01 * static_cast<double>(step));
}

/// Over all groups there are, with the same inner loop: what the cells are worth.
double overAll(const SphereField& field, const reaming::Reamer& reamer) {
  const reaming::Stretch all{0, static_cast<std::uint32_t>(field.groups().size())};
  const reaming::KernelReamer tool{
      .z = static_cast<float>(reamer.centre.z), .radius = static_cast<float>(reamer.radius)};
  reaming::KernelSums sums;
  reaming::addSpheres(field.groups().data(), std::span(&all, 1), tool, false, sums);
  return std::numbers::pi * reamer.radius * sums.of[reaming::KernelSums::Pressing];
}

/// How much the area departs from its mean while the reamer goes through [%].
double ripple(const SphereField& field, const Plunge& plunge) {
  std::vector<double> areas;
  double mean = 0.0;
  constexpr int kPlaces = 400;
  for (int i = 0; i < kPlaces; ++i) {
    areas.push_back(field.touch(plunge.at(0.006 + 0.006 * i / kPlaces), false).area);
    mean += areas.back() / kPlaces;
  }
  double worst = 0.0;
  for (const double area : areas) worst = std::max(worst, std::abs(area / mean - 1.0));
  return 100.0 * worst;
}

Contestant contestant(
    const std::string& name,
    const Plunge& plunge,
    std::function<double(const reaming::Reamer&)> felt) {
  return {name, [felt = std::move(felt), plunge, next = std::size_t{0}](int steps) mutable {
            double sum = 0.0;
            for (int i = 0; i < steps; ++i) sum += felt(plunge.at(depthOf(next++)));
            return sum;
          }};
}

/// A packing of its own where that is there soon, copies of a small one where it is not.
Packing boneOf(std::size_t count) {
  const bool isSoon = count <= 250'000;
  return isSoon ? *reaming::pack(reaming::Acetabulum(), {.count = count}) : tiledBone(count);
}

void raceContacts(const Packing& packing, bool isCold, const Report& report) {
  const std::size_t count = packing.spheres.size();
  const std::vector<double> densities(packing.spheres.size(), kDensity);
  const SphereField field(packing, densities);
  const Plunge plunge = reaming::plungeInto(field, kRadius);
  std::vector<Contestant> contestants{
      contestant("palpate", plunge, [&](const auto& r) { return field.touch(r, false).pressing; }),
      contestant(
          "all of them, same loop", plunge, [&](const auto& r) { return overAll(field, r); })};
  const auto peers = peers::spherePeers(packing, densities);
  for (const auto& peer : peers) {
    contestants.push_back(
        contestant(peer->name(), plunge, [&](const auto& r) { return peer->pressing(r); }));
  }
  constexpr int kRounds = 41;
  const auto timings = isCold ? raceCold(contestants, kRounds) : race(contestants);
  const double error = ripple(field, plunge);
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    report(
        {.family = kPackingFamily,
         .setting = isCold ? "contact, cold" : "contact",
         .method = contestants[i].method,
         .parameter = static_cast<double>(count),
         .error = error,
         .time = timings[i]});
  }
}

/// Single steps of a bone that is reamed at a feed, each timed for itself.
void timeRemoval(
    const Packing& packing,
    double feed,
    bool isCold,
    const std::string& setting,
    const Report& report) {
  using Clock = std::chrono::steady_clock;
  constexpr double kTick = 0.001;
  const std::vector<double> densities(packing.spheres.size(), kDensity);
  reaming::Bone bone(packing, densities, {.coverage = packing.coverage(), .cuttingDamping = 100.0});
  const Plunge plunge = reaming::plungeInto(bone.field(), kRadius);
  double depth = -0.0005;
  while (bone.tool().centre.z < plunge.start + 0.006) {  // in, as fast as it goes
    bone.step(plunge.at(depth), kTick);
    depth = std::min(depth + 2e-5, 0.016);
  }
  // Then at the feed: the coupling is wound up already, so the tool goes as the device does.
  std::vector<std::uint64_t> other(isCold ? std::size_t{10} << 20U : 0, 1);
  std::uint64_t sum = 0;
  std::vector<double> times;
  const int steps = isCold ? 300 : 1500;
  for (int i = 0; i < steps; ++i) {
    for (auto& word : other) sum += word++;
    depth += feed * kTick;
    const auto start = Clock::now();
    const auto felt = bone.step(plunge.at(depth), kTick);
    times.push_back(std::chrono::duration<double, std::nano>(Clock::now() - start).count());
    sum += felt.contact.touched > 0 ? 1U : 0U;
  }
  [[maybe_unused]] static volatile std::uint64_t sink = 0;
  sink = sum;
  std::sort(times.begin(), times.end());
  report(
      {.family = kPackingFamily,
       .setting = setting,
       .method = "palpate",
       .parameter = static_cast<double>(packing.spheres.size()),
       .error = std::nullopt,
       .time = Timing{times[times.size() / 2], times[times.size() * 99 / 100]}});
}

}  // namespace

void measurePacking(const Report& report) {
  raceContacts(boneOf(50'000), false, report);
  const Packing published = boneOf(201'532);
  raceContacts(published, false, report);
  raceContacts(published, true, report);
  timeRemoval(published, 0.002, false, "removal at 2 mm/s", report);
  timeRemoval(published, 0.002, true, "removal at 2 mm/s, cold", report);
  raceContacts(boneOf(1'000'000), false, report);
  for (const std::size_t count : {1'000'000, 3'100'000, 4'100'000}) {
    timeRemoval(boneOf(count), 0.0005, false, "removal at 0.5 mm/s", report);
  }
}

}  // namespace haptics::bench
