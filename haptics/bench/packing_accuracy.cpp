// Bone of spheres: run time of a step of contact and of removal, compared with other searches.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/bench/measurement.h"
#include "haptics/bench/peers/peers.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/bone/sphere_kernel.h"
#include "haptics/reaming/packing/packing_builder.h"
#include "haptics/reaming/packing/solids.h"

namespace haptics::bench {
namespace {

using reaming::Packing;
using reaming::PlungePath;
using reaming::SphereField;

constexpr const char* kPackingFamily = "packing";
constexpr double kReachOfReamer = 0.026;  // radius of the reamer [m]
constexpr double kDensity = 2e5;          // [N/m²]

/// Depth of the reamer in a step: it oscillates between 6 and 12 mm.
double depthOf(std::size_t step) {
  return 0.009 - 0.003 * std::cos(0.01 * static_cast<double>(step));
}

/// A loop over all groups of spheres with the same kernel, without the search by cells.
double pressingOverAll(const SphereField& field, const reaming::Reamer& reamer) {
  const reaming::GroupRange all{0, static_cast<std::uint32_t>(field.groups().size())};
  const reaming::KernelReamer tool{
      .z = static_cast<float>(reamer.centre.z), .radius = static_cast<float>(reamer.radius)};
  reaming::KernelSums sums;
  reaming::addSpheres(field.groups().data(), std::span(&all, 1), tool, false, sums);
  return std::numbers::pi * reamer.radius * sums.of[reaming::KernelSums::Pressing];
}

/// Largest deviation of the contact area from its mean while the reamer advances [%].
double areaRipple(const SphereField& field, const PlungePath& plunge) {
  std::vector<double> areas;
  double mean = 0.0;
  constexpr int kDepthCount = 400;
  for (int i = 0; i < kDepthCount; ++i) {
    areas.push_back(field.touch(plunge.at(0.006 + 0.006 * i / kDepthCount), false).area);
    mean += areas.back() / kDepthCount;
  }
  double worst = 0.0;
  for (const double area : areas) worst = std::max(worst, std::abs(area / mean - 1.0));
  return 100.0 * worst;
}

Contestant contestant(
    const std::string& name,
    const PlungePath& plunge,
    std::function<double(const reaming::Reamer&)> response) {
  return {name, [response = std::move(response), plunge, next = std::size_t{0}](int steps) mutable {
            double sum = 0.0;
            for (int i = 0; i < steps; ++i) sum += response(plunge.at(depthOf(next++)));
            return sum;
          }};
}

Packing boneOf(std::size_t spheres) {
  return *reaming::pack(reaming::Acetabulum(), {.count = spheres});
}

/// Largest relative difference of the force Σ a ρ from that of a loop over all spheres.
double largestDifference(const SphereField& field, const PlungePath& plunge) {
  double largest = 0.0;
  for (std::size_t step = 0; step < 300; ++step) {
    const auto reamer = plunge.at(depthOf(step));
    const double all = pressingOverAll(field, reamer);
    largest = std::max(largest, std::abs(field.touch(reamer, false).pressing / all - 1.0));
  }
  return largest;
}

void compareContacts(const Packing& packing, const AccuracyRun& run) {
  const std::vector<double> densities(packing.spheres.size(), kDensity);
  const SphereField field(packing, densities);
  const PlungePath plunge = reaming::plungePathInto(field, kReachOfReamer);
  const auto count = static_cast<double>(packing.spheres.size());
  run.report(
      {.family = kPackingFamily,
       .setting = "pressure, relative to a loop over all spheres",
       .method = "palpate",
       .parameter = count,
       .error = largestDifference(field, plunge),
       .bound = 1e-5});
  std::vector<Contestant> contestants{
      contestant("palpate", plunge, [&](const auto& r) { return field.touch(r, false).pressing; }),
      contestant("all of them, same loop", plunge, [&](const auto& r) {
        return pressingOverAll(field, r);
      })};
  if (auto pressing = peers::nanoflannPressing(packing, densities)) {
    contestants.push_back(contestant("nanoflann", plunge, std::move(pressing)));
  }
  constexpr int kColdRounds = 41;
  const double error = areaRipple(field, plunge);
  const std::pair<const char*, std::vector<std::optional<Timing>>> settings[]{
      {"contact", run.times(contestants)},
      {"contact, cold", run.coldTimes(contestants, kColdRounds)}};
  for (const auto& [setting, times] : settings) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      run.report(
          {.family = kPackingFamily,
           .setting = setting,
           .method = contestants[i].method,
           .parameter = count,
           .error = error,
           .time = times[i]});
    }
  }
}

/// Times single steps of a bone that is reamed at 2 mm/s.
void timeRemoval(const Packing& packing, bool isCold, const AccuracyRun& run) {
  constexpr double kFeed = 0.002;  // [m/s]
  constexpr double kTick = 0.001;  // [s]
  const std::vector<double> densities(packing.spheres.size(), kDensity);
  reaming::Bone bone(packing, densities, {.coverage = packing.coverage(), .cuttingDamping = 100.0});
  const PlungePath plunge = reaming::plungePathInto(bone.field(), kReachOfReamer);
  double depth = -0.0005;
  while (bone.tool().centre.z <
         plunge.start + 0.006) {  // advance into the bone as fast as possible
    bone.step(plunge.at(depth), kTick);
    depth = std::min(depth + 2e-5, 0.016);
  }
  // Then advance at the feed: the coupling is already under tension, so the tool follows the
  // device.
  std::vector<std::uint64_t> other(isCold ? std::size_t{10} << 20U : 0, 1);
  std::uint64_t sum = 0;
  std::vector<double> times;
  const int steps = isCold ? 300 : 1500;
  for (int i = 0; i < steps; ++i) {
    for (auto& word : other) sum += word++;
    depth += kFeed * kTick;
    const auto start = std::chrono::steady_clock::now();
    const auto response = bone.step(plunge.at(depth), kTick);
    times.push_back(nanosecondsSince(start));
    sum += response.contact.touched > 0 ? 1U : 0U;
  }
  [[maybe_unused]] static volatile std::uint64_t sink = 0;
  sink = sum;
  std::ranges::sort(times);
  run.report(
      {.family = kPackingFamily,
       .setting = isCold ? "removal at 2 mm/s, cold" : "removal at 2 mm/s",
       .method = "palpate",
       .parameter = static_cast<double>(packing.spheres.size()),
       .time = Timing{times[times.size() / 2], times[times.size() * 99 / 100]}});
}

}  // namespace

void measurePacking(const AccuracyRun& run) {
  if (run.isShortRun) return compareContacts(boneOf(5000), run);
  compareContacts(boneOf(50'000), run);
  const Packing published = boneOf(201'532);  // number of spheres in the reaming paper
  compareContacts(published, run);
  timeRemoval(published, false, run);
  timeRemoval(published, true, run);
}

}  // namespace haptics::bench
