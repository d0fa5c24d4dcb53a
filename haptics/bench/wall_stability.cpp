// A hand on a virtual wall: for which stiffness and damping it is stable (Z-width; Colgate & Brown
// 1994).
#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/bench/stability.h"
#include "haptics/engine/passivity.h"

namespace haptics::bench {
namespace {

constexpr double kMass = 0.004;         // mass of the simulated punch [N·s²/travel unit]
constexpr double kWallTravel = 5.0;     // travel at which the wall begins [travel units]
constexpr double kHandStiffness = 3.0;  // stiffness of a hand [N/travel unit]
constexpr double kHandTarget = 5.4;  // travel that the hand aims at, inside the wall [travel units]
constexpr double kSeconds = 2.0;     // simulated time [s]
constexpr double kWindow = 0.4;      // duration over which the amplitude is measured [s]
constexpr double kWindowDistance = 1.0;  // time between two such windows [s]
constexpr double kMechanismStep = 1e-5;  // time step of the simulated mechanism [s]

struct Range {
  double low = INFINITY;
  double high = -INFINITY;

  void extendTo(double least, double most) {
    low = std::min(low, least);
    high = std::max(high, most);
  }
  double width() const { return high - low; }
};

/// Simulates a wall: the mechanism moves quasi-continuously; the force is computed from the encoder
/// once per tick, and held.
class Wall {
 public:
  explicit Wall(VirtualWall& point)
      : point_(point),
        period_(1.0 / point.rate),
        observer_(
            {.deviceDamping = point.damping,
             .tolerance = 1e-3,
             .mostDamping = point.hasPassivityController ? kMass / period_ : 0.0,
             .leastVelocity = 1e-6}),
        pendingForces_(static_cast<std::size_t>(point.delay), 0.0) {}

  void run() {
    const int ticks = static_cast<int>(kSeconds * point_.rate);
    for (int i = 0; i < ticks; ++i) {
      tick();
      if (!std::isfinite(travel_) || std::abs(travel_) > 1e6) {
        point_.amplitude = INFINITY;
        return;
      }
      const double left = (ticks - i) / point_.rate;
      if (left <= kWindow) lateRange_.extendTo(lowInTick_, highInTick_);
      if (left > kWindowDistance && left <= kWindowDistance + kWindow)
        earlyRange_.extendTo(lowInTick_, highInTick_);
    }
    point_.amplitude = lateRange_.width();
  }

  void judge() {
    // An oscillation that decays, however slowly, is stable. So is an oscillation of a few encoder
    // steps, since linear theory does not exclude such a limit cycle.
    const bool isDecaying = point_.amplitude < 0.7 * earlyRange_.width();
    point_.isStable = isDecaying || point_.amplitude < std::max(1e-3, 4.0 * point_.quantum);
    const engine::Passivity passivity{
        .stiffness = point_.stiffness, .period = period_, .filterDelay = point_.delay * period_};
    constexpr double kRounding = 1e-9;  // tolerance, because the inequality of eq. (25) is strict
    point_.isPassivityUnproven = passivity.requiredDamping() * (1.0 + kRounding) >= point_.damping;
    point_.isDetectedByObserver = observer_.least() < -1e-3;
  }

 private:
  double encoderTravel() const {
    return point_.quantum > 0.0 ? point_.quantum * std::round(travel_ / point_.quantum) : travel_;
  }

  void tick() {
    observer_.observe(force_, travel_ - last_, velocity_, period_);
    last_ = travel_;
    const double beyond = encoderTravel() - kWallTravel;
    double wanted = beyond > 0.0 ? point_.stiffness * beyond : 0.0;
    if (beyond > 0.0) wanted = observer_.damped(wanted, velocity_, period_);
    pendingForces_.push_back(wanted);
    force_ = pendingForces_.front();
    pendingForces_.erase(pendingForces_.begin());
    lowInTick_ = highInTick_ = travel_;
    const int inside = std::max(1, static_cast<int>(std::lround(period_ / kMechanismStep)));
    const double dt = period_ / inside;
    for (int i = 0; i < inside; ++i) {
      const double push = kHandStiffness * (kHandTarget - travel_);
      velocity_ += dt * (push - force_ - point_.damping * velocity_) / kMass;
      travel_ += dt * velocity_;
      lowInTick_ = std::min(lowInTick_, travel_);
      highInTick_ = std::max(highInTick_, travel_);
    }
  }

  VirtualWall& point_;
  double period_;
  engine::EnergyObserver observer_;
  std::vector<double> pendingForces_;
  double travel_ = 4.5;
  double velocity_ = 0.0;
  double last_ = 4.5;
  double force_ = 0.0;
  Range earlyRange_, lateRange_;
  double lowInTick_ = 0.0, highInTick_ = 0.0;
};

VirtualWall simulatedWall(VirtualWall point) {
  Wall wall(point);
  wall.run();
  wall.judge();
  return point;
}

}  // namespace

void sweepWalls(double effort, StabilityResult& result) {
  const int stiffnesses = effort >= 1.0 ? 19 : 7;
  for (const double rate : {375.0, 1000.0, 4000.0}) {
    for (const double damping : {0.01, 0.02, 0.05, 0.1, 0.2}) {
      const double limit = engine::Passivity{.period = 1.0 / rate}.allowedStiffness(damping);
      for (int i = 0; i < stiffnesses; ++i) {
        // From 0.1 to 100 times the passive limit.
        const double ratio = std::pow(10.0, -1.0 + 3.0 * i / (stiffnesses - 1));
        VirtualWall point{.rate = rate, .stiffness = ratio * limit, .damping = damping};
        result.walls.push_back(simulatedWall(point));
        point.hasPassivityController = true;
        result.walls.push_back(simulatedWall(point));
        if (rate != 1000.0) continue;
        point.hasPassivityController = false;
        point.delay = 1;
        result.walls.push_back(simulatedWall(point));
        point.delay = 0;
        for (const double quantum : {0.0439, 0.176}) {
          point.quantum = quantum;
          result.walls.push_back(simulatedWall(point));
        }
      }
    }
  }
  int unexpected = 0;
  int unnoticed = 0;
  int unstable = 0;
  for (const auto& wall : result.walls) {
    if (wall.isStable) continue;
    ++unstable;
    unexpected += wall.isPassivityUnproven ? 0 : 1;
    unnoticed += wall.isDetectedByObserver || wall.quantum > 0.0 ? 0 : 1;
  }
  SweepChecks checks(result, "wall");
  checks.add(
      "walls that vibrate although eq. (25) says that they are passive", 0.0, unexpected, 0.0);
  checks.add("walls that vibrate and the energy observer does not notice", 0.0, unnoticed, 0.0);
  // A sweep without any vibrating wall would prove nothing.
  checks.add(
      "walls that vibrate: at least 20, hence 20 minus their number", 0.0, 20.0 - unstable, 0.0);
}

}  // namespace haptics::bench
