#include "haptics/reaming/bone/bone.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace haptics::reaming {

namespace {

constexpr std::size_t kMostChanges = 4096;            // changes reported per step
constexpr std::size_t kGroupsRestoredPerStep = 2048;  // groups restored, or checked, per step
constexpr std::size_t kPartialSlotsPerStep = 64;      // partly cut slots checked per step
constexpr std::size_t kSurfaceParts = 8;  // parts of the surface, one of which is cut per step
// When the tool has moved back from its cut by this fraction of the sphere's radius, it counts as
// having left the sphere.
constexpr double kWithdrawalShare = 0.1;

double ballVolume(double radius) noexcept {
  return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
}

/// Volume of the intersection of two balls of radii @p r and @p R that overlap by @p depth [m³].
double lensVolume(double r, double depth, double R) noexcept {
  if (depth <= 0.0) return 0.0;
  if (depth >= 2.0 * std::min(r, R)) return ballVolume(std::min(r, R));
  // Lens of two balls whose centres have the distance d (Weisstein, "Sphere-Sphere Intersection").
  const double d = R + r - depth;
  return std::numbers::pi * depth * depth * (d * d + 2.0 * d * (r + R) - 3.0 * (r - R) * (r - R)) /
         (12.0 * d);
}

Vec3 unitVectorOr(Vec3 v, Vec3 otherwise) noexcept {
  const double size = length(v);
  return size > 0.0 ? (1.0 / size) * v : otherwise;
}

Vec3 shortenedTo(Vec3 v, double size) noexcept {
  const double now = length(v);
  return now > size ? (size / now) * v : v;
}

const BoneOptions& validated(const BoneOptions& o) {
  const bool isSound = o.coverage > 0.0 && o.coverage <= 1.0 && o.coupling > 0.0 &&
                       std::isfinite(o.coupling) && o.cuttingDamping >= 0.0 &&
                       std::isfinite(o.cuttingDamping) && o.friction >= 0.0 &&
                       std::isfinite(o.friction) && o.mostAdvance > 0.0 && o.mostAdvance <= 0.01 &&
                       o.mostFeed >= 0.0;
  if (!isSound)
    throw std::invalid_argument("the bone's coverage, coupling or damping make no sense");
  return o;
}

}  // namespace

Bone::Bone(const Packing& packing, std::span<const double> densities, const BoneOptions& options)
    : options_(validated(options)),
      isSpinning_(options.isSpinning),
      field_(packing, densities),
      intactField_(field_) {
  const std::size_t slots = field_.slotCount();
  toolAtLastCut_.resize(slots);
  isPartial_.resize(slots);
  partialSlots_.reserve(slots);
  slotsToCut_.resize(slots + kLanes);
  changed_.reserve(kMostChanges);
  restoredGroups_ = field_.groups().size();
  double sum = 0.0;
  for (const auto& sphere : packing.spheres) sum += sphere.radius;
  leastRemainderRadius_ = 0.1 * sum / static_cast<double>(packing.spheres.size());
}

void Bone::reset() noexcept {
  isOutside_ = false;
  clearedGroups_ = 0;
  if (isCutSinceReset_) restoredGroups_ = 0;
}

/// Restores a part of the bone; returns true when all is restored.
bool Bone::restorePart() noexcept {
  const std::size_t groups = field_.groups().size();
  if (restoredGroups_ == groups) return true;
  const std::size_t end = std::min(groups, restoredGroups_ + kGroupsRestoredPerStep);
  for (std::size_t i = restoredGroups_; i < end; ++i) {
    field_.group(kLanes * i) = intactField_.group(kLanes * i);
    for (std::size_t lane = 0; lane < kLanes; ++lane) isPartial_[kLanes * i + lane] = 0;
  }
  // Copy in several steps, since copying all groups at once would take longer than a tick.
  restoredGroups_ = end;
  if (restoredGroups_ < groups) return false;
  field_.resetDrift();
  partialSlots_.clear();
  next_ = 0;
  pending_ = 0;
  nextPart_ = 0;
  removedMass_ = 0.0;
  ++restorations_;
  isCutSinceReset_ = false;
  return true;
}

Bone::StepForce Bone::step(const Reamer& device, double dt) noexcept {
  StepForce result;
  changed_.clear();
  const bool isPlace = std::isfinite(device.centre.x + device.centre.y + device.centre.z) &&
                       std::isfinite(device.axis.x + device.axis.y + device.axis.z);
  if (!isPlace) return result;
  result.isDefined = true;
  if (!restorePart()) return result;
  tool_.radius = device.radius;
  tool_.axis = device.axis;
  if (!isOutside_) {
    tool_.centre = device.centre;
    // Inside the bone there is no defined force: the tool must leave it first.
    result.isDefined = isClear();
    return result;
  }
  // The virtual tool is a god-object that can cut: it follows the device through a spring
  // (coupling) and stays outside the uncut bone; the rendered force is the spring's.
  result.contact = field_.touch(tool_, true);
  const Vec3 out = outwardOf(result.contact);
  moveTool(device, result.contact, out, dt);
  cut();
  replaceLeftSpheres();
  if (result.contact.area <= 0.0) return result;
  // Bone pushes, but never pulls a hand that moves back faster than the tool.
  const Vec3 held = tool_.centre - device.centre;
  result.force = options_.coupling * (held - std::min(dot(held, out), 0.0) * out);
  // Friction acts on the teeth against the spin, in proportion to the normal force: aρ if the bone
  // yields, a fraction of it if the tool is pushed less.
  const double resistance = dot(result.contact.force, out) / options_.coverage;
  const double pushed = resistance > 0.0 ? dot(result.force, out) / resistance : 0.0;
  const double share = std::clamp(pushed, 0.0, 1.0);
  result.frictionTorque = options_.friction * share * result.contact.lever / options_.coverage;
  return result;
}

/// Checks kGroupsRestoredPerStep groups for contact with the tool; returns false if it is inside a
/// sphere. Sets isOutside_ when all groups are known to be clear.
bool Bone::isClear() noexcept {
  const std::size_t groups = field_.groups().size();
  const std::size_t end = std::min(groups, clearedGroups_ + kGroupsRestoredPerStep);
  const bool isIn =
      field_.holds(tool_, clearedGroups_, end) || field_.touch(tool_, true).touched > 0;
  clearedGroups_ = isIn ? 0 : end;
  isOutside_ = clearedGroups_ == groups;
  return !isIn;
}

/// Direction of the bone's force on the tool (unit vector).
Vec3 Bone::outwardOf(const ReamerContact& contact) const noexcept {
  const Vec3 back = -1.0 * tool_.axis;
  return options_.isGuided ? back : unitVectorOr(contact.force, unitVectorOr(contact.normal, back));
}

/// Moves the tool towards the device, as far as the bone allows.
void Bone::moveTool(
    const Reamer& device, const ReamerContact& contact, Vec3 out, double dt) noexcept {
  const Vec3 axis = tool_.axis;
  Vec3 gap = device.centre - tool_.centre;
  if (options_.isGuided) gap = dot(gap, axis) * axis;
  if (contact.area <= 0.0) {
    // Outside the bone the tool moves so slowly that the next step can still stop it at the bone.
    tool_.centre = tool_.centre + shortenedTo(gap, 4.0 * options_.mostAdvance);
    return;
  }
  const double resistance = dot(contact.force, out) / options_.coverage;
  const double push = -options_.coupling * dot(gap, out);
  if (push > resistance && isSpinning_ && options_.mostFeed > 0.0) {
    // Move towards the device until the push has fallen to the resistance. Implicit integration:
    // with damping c the tool moves by share·gap / (1 + c/(k dt)), which is stable for every dt.
    const double share = (push - resistance) / push;
    const double brake = 1.0 + options_.cuttingDamping / (options_.coupling * dt);
    const double most = std::min(options_.mostAdvance, options_.mostFeed * dt);
    tool_.centre = tool_.centre + shortenedTo((share / brake) * gap, most);
    pending_ = kSurfaceParts;
  } else {
    tool_.centre = tool_.centre + shortenedTo(slideOf(gap, out, push), options_.mostAdvance);
  }
}

/// Motion of the tool without cutting: out of the bone, or along its surface against friction.
Vec3 Bone::slideOf(Vec3 gap, Vec3 out, double push) const noexcept {
  const Vec3 normal = dot(gap, out) * out;
  const Vec3 across = gap - normal;
  const Vec3 back = push <= 0.0 ? normal : Vec3{};
  // The friction cone, expressed as an extension of the coupling's spring: up to this extension
  // friction holds the tool.
  const double held = options_.friction * std::max(push, 0.0) / options_.coupling;
  const double slip = length(across) - held;
  return slip > 0.0 ? back + shortenedTo(across, slip) : back;
}

/// Cuts the spheres behind one of kSurfaceParts parts of the surface. Cutting continues for
/// kSurfaceParts steps after the tool has last advanced, so that every part is cut.
void Bone::cut() noexcept {
  if (pending_ == 0) return;
  --pending_;
  const std::size_t count = field_.findSpheresToCut(tool_, nextPart_, kSurfaceParts, slotsToCut_);
  nextPart_ = (nextPart_ + 1) % kSurfaceParts;
  for (std::size_t i = 0; i < count; ++i) cutSlot(slotsToCut_[i]);
}

void Bone::cutSlot(std::uint32_t slot) noexcept {
  auto& group = field_.group(slot);
  const std::size_t lane = slot % kLanes;
  const double r = group.radius[lane];
  const double before = lensVolume(r, group.depth[lane], tool_.radius);
  const double reached = tool_.radius + r - length(field_.centre(slot) - tool_.centre);
  const auto depth = static_cast<float>(std::min(reached, 2.0 * r));
  if (!(depth > group.depth[lane])) return;
  isCutSinceReset_ = true;
  group.depth[lane] = depth;
  removedMass_ += group.density[lane] * (lensVolume(r, depth, tool_.radius) - before);
  toolAtLastCut_[slot] = tool_.centre;
  if (depth >= 2.0F * group.radius[lane]) {
    empty(slot);
  } else if (isPartial_[slot] == 0) {
    isPartial_[slot] = 1;
    partialSlots_.push_back(slot);
  }
}

void Bone::empty(std::uint32_t slot) noexcept {
  auto& group = field_.group(slot);
  group.radius[slot % kLanes] = 0.0F;
  group.depth[slot % kLanes] = 0.0F;
  noteChange(slot);
}

void Bone::noteChange(std::uint32_t slot) noexcept {
  if (changed_.size() < kMostChanges) {
    changed_.push_back(slot);
  } else {
    ++droppedChanges_;
  }
}

/// Checks a few of the partly cut spheres, and replaces those that the tool has left.
void Bone::replaceLeftSpheres() noexcept {
  for (std::size_t looked = 0; looked < kPartialSlotsPerStep && !partialSlots_.empty(); ++looked) {
    if (next_ >= partialSlots_.size()) next_ = 0;
    const std::uint32_t slot = partialSlots_[next_];
    const bool isGone = field_.group(slot).radius[slot % kLanes] == 0.0F;
    if (!isGone && !hasToolLeft(slot)) {
      ++next_;
      continue;
    }
    partialSlots_[next_] = partialSlots_.back();
    partialSlots_.pop_back();
    isPartial_[slot] = 0;
    if (!isGone) splitRemainder(slot);
  }
}

/// Whether the tool has moved back from its cut in the sphere.
bool Bone::hasToolLeft(std::uint32_t slot) const noexcept {
  const auto& group = field_.group(slot);
  const std::size_t lane = slot % kLanes;
  const double r = group.radius[lane];
  const Vec3 away = field_.centre(slot) - tool_.centre;
  const double reached = tool_.radius + r - length(away);
  return reached < group.depth[lane] - kWithdrawalShare * r || dot(away, tool_.axis) < -r;
}

double Bone::massOf(std::uint32_t slot) const noexcept {
  const auto& group = field_.group(slot);
  const std::size_t lane = slot % kLanes;
  const double r = group.radius[lane];
  return group.density[lane] * (ballVolume(r) - lensVolume(r, group.depth[lane], tool_.radius));
}

/// Replaces a partly cut sphere by spheres inside its remainder: the largest that fits, and three
/// beside it if they are not too small. They get the remaining mass.
void Bone::splitRemainder(std::uint32_t slot) noexcept {
  auto& group = field_.group(slot);
  const std::size_t lane = slot % kLanes;
  const double mass = massOf(slot);
  const double r = group.radius[lane];
  const double main = r - 0.5 * group.depth[lane];
  const Vec3 centre = field_.centre(slot);
  const Vec3 outward = unitVectorOr(centre - toolAtLastCut_[slot], tool_.axis);
  if (main < leastRemainderRadius_) {
    removedMass_ += mass;
    empty(slot);
    return;
  }
  // The reamer's surface counts as flat here: it has cut off a cap of thickness depth, so that the
  // largest sphere in the rest has the radius r - depth / 2, and touches the far side.
  const Vec3 middle = centre + (r - main) * outward;
  group.depth[lane] = 0.0F;
  group.radius[lane] = std::nextafter(static_cast<float>(main), 0.0F);
  field_.move(slot, middle);
  noteChange(slot);
  std::array<std::uint32_t, 4> spheres{slot};
  std::size_t count = 1;
  // A sphere of radius b beside the main one (radius m), touching it, the flat cut and the old
  // sphere (radius r): b = m (r − m)/r, at a distance of 2 √(b m) from the axis.
  const double beside = main * (r - main) / r;
  if (beside >= leastRemainderRadius_) {
    const Vec3 helper = std::abs(outward.z) < 0.9 ? Vec3{0.0, 0.0, 1.0} : Vec3{1.0, 0.0, 0.0};
    const Vec3 u = unitVectorOr(cross(outward, helper), {1.0, 0.0, 0.0});
    const Vec3 v = cross(outward, u);
    const double ring = 2.0 * std::sqrt(beside * main);
    const Vec3 foot = middle + (beside - main) * outward;
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / 3.0;
      const Vec3 place = foot + (ring * std::cos(angle)) * u + (ring * std::sin(angle)) * v;
      const std::size_t free = field_.freeSlot(place);
      if (free == field_.slotCount()) continue;
      auto& other = field_.group(free);
      other.radius[free % kLanes] = std::nextafter(static_cast<float>(beside), 0.0F);
      other.depth[free % kLanes] = 0.0F;
      field_.move(free, place);
      spheres[count++] = static_cast<std::uint32_t>(free);
      noteChange(static_cast<std::uint32_t>(free));
    }
  }
  double volume = 0.0;
  const auto radiusOf = [&](std::uint32_t i) { return double{field_.group(i).radius[i % kLanes]}; };
  for (std::size_t i = 0; i < count; ++i) volume += ballVolume(radiusOf(spheres[i]));
  const auto density = static_cast<float>(mass / volume);
  for (std::size_t i = 0; i < count; ++i) {
    field_.group(spheres[i]).density[spheres[i] % kLanes] = density;
  }
  removedMass_ += mass - density * volume;  // rounding error of the density in single precision
}

double Bone::remainingMass() const noexcept {
  double sum = 0.0;
  for (std::uint32_t slot = 0; slot < field_.slotCount(); ++slot) {
    if (field_.group(slot).radius[slot % kLanes] > 0.0F) sum += massOf(slot);
  }
  return sum;
}

}  // namespace haptics::reaming
