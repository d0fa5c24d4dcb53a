#pragma once

#include <cmath>
#include <cstdint>

namespace haptics::models {

/// Detects the cuts of a hand, and the four points of each, in real time.
///
/// It is fed one pair of travel and force per tick, of a punch or of any tool that is pressed home
/// and let go (a stroke of a reamer), and knows nothing of what comes later. A cut is a closure:
/// the travel rises above `closedAbove`, then falls below `openBelow`. Its points are those of the
/// punch paper, section II-B:
///
///     (i)   interception  the load begins to rise
///     (ii)  yield         the surface is cut through, and the force falls
///     (iii) bottom-out    the end of the travel, and the force rises again
///     (iv)  opening       the largest force of all, before the contact is lost
///
/// A point is confirmed only when the force has moved far enough away from it, so an event comes a
/// little later than its point; the point itself is the sample at which it occurred.
///
/// - The interception is the sample from which the force rises by `contactForce`, faster than
///   `creep` per unit of travel: of all samples since the hand last opened the one with the
///   smallest f − creep · x. Friction in the hinge rises more slowly and is passed over. A touch
///   that is let go is forgotten, unless no larger one follows before the hand opens.
/// - The yield is the largest force since then, once the force has fallen below it by the larger
///   of `yieldDrop` and `yieldDropRatio` times the load, while the handle closed on by `advance`:
///   a hand that merely lets go cuts nothing. A larger force before the bottom-out takes a yield
///   back (the surface had not been cut after all), and Event::Yield may come again: the last
///   one counts.
///   Where `yieldLoad` or `yieldKeeps` are set, a yield also needs that load, and is taken back
///   when less than that share of it is left while the handle closes on: a blow on the handle, no
///   tissue.
/// - The bottom-out is the smallest force after the yield at the end of the travel – beyond
///   `bottomAbove`, not farther than `advance` from the furthest travel – once the force has
///   risen from it by `bottomRise`. Until half of what the yield lost has come back, a smaller
///   force further on quietly takes its place.
/// - The opening is the largest force since the bottom-out, once the handle has gone back by
///   `retreat`. Where the surface never yielded it is the largest since the interception; where
///   it yielded and no bottom-out followed there is none.
///
/// Points that do not happen are not found; a cut in a hard recording may have none but its peak. A
/// sample that is NaN changes nothing. One tick is a handful of comparisons.
template <typename Scalar>
class CutDetector {
 public:
  enum class Event : std::uint8_t {
    Nothing,
    Interception,
    Yield,
    BottomOut,
    Opening,
    CutCompleted
  };

  /// The defaults are those of the punch recordings: travel units from 0 (open) to 10 (closed).
  struct Parameters {
    Scalar closedAbove = Scalar(7);  ///< closed as soon as the travel is above this [travel units]
    Scalar openBelow = Scalar(4);    ///< open again as soon as it is below this [travel units]
    Scalar contactForce = Scalar(0.2);  ///< the rise that is a contact [N]
    Scalar creep = Scalar(0.5);  ///< what rises no faster than this is friction [N/travel unit]
    Scalar yieldDrop = Scalar(0.25);       ///< the fall that is a yield, at least [N]
    Scalar yieldDropRatio = Scalar(0.08);  ///< … and this much of the load since the interception
    Scalar yieldLoad = Scalar(0);     ///< the load since the interception at a yield, at least [N]
    Scalar yieldKeeps = Scalar(0);    ///< the share of it that is left while it closes on; 0: any
    Scalar advance = Scalar(0.3);     ///< closing on by this is a movement [travel units]
    Scalar bottomAbove = Scalar(9);   ///< where the end of the travel can be [travel units]
    Scalar bottomRise = Scalar(0.3);  ///< the rise that is a bottom-out [N]
    Scalar retreat = Scalar(1);       ///< going back by this is an opening hand [travel units]
  };

  /// A point of a cut, where it was found.
  struct Landmark {
    Scalar travel{0};  ///< [travel units]
    Scalar force{0};   ///< [N]
    bool found = false;
  };

  struct Cut {
    Landmark interception;
    Landmark yield;
    Landmark bottomOut;
    Landmark opening;
    Scalar peakForce{0};      ///< largest since the contact, or since it was closed [N]
    Scalar largestTravel{0};  ///< [travel units]
  };

  CutDetector() noexcept = default;

  /// @param parameters  isSound() has been asked.
  explicit CutDetector(const Parameters& parameters) noexcept : parameters_(parameters) {}

  static bool isSound(const Parameters& p) noexcept {
    const bool isOrdered = p.openBelow < p.closedAbove && std::isfinite(p.closedAbove) &&
                           std::isfinite(p.openBelow) && std::isfinite(p.bottomAbove);
    return isOrdered && isPositive(p.contactForce) && isPositive(p.bottomRise) &&
           isPositive(p.retreat) && isPositive(p.yieldDrop) && !isBad(p.creep) &&
           !isBad(p.yieldDropRatio) && !isBad(p.yieldLoad) && !isBad(p.yieldKeeps) &&
           p.yieldKeeps < Scalar(1) && !isBad(p.advance);
  }

  /// Looks at one tick's travel [travel units] and force [N], and says what has just become clear.
  /// @param isSettling  the force comes on softly or fades: while no contact is found, its rise is
  ///                    not that of a load, and the next tick is a new beginning.
  Event feed(Scalar travel, Scalar force, bool isSettling = false) noexcept {
    if (!std::isfinite(travel) || !std::isfinite(force)) return Event::Nothing;
    const Landmark sample{travel, force, true};
    if (isClosed_ && travel < parameters_.openBelow) return complete(sample);
    if (phase_ == Phase::Opened && travel > cut_.largestTravel) closeAgain();
    updateLargest(sample);
    if (travel < cut_.largestTravel - parameters_.retreat) return goBack(sample);
    switch (phase_) {
      case Phase::Searching:
        if (!isSettling) return search(sample);
        start_ = sample;
        return Event::Nothing;
      case Phase::Loading:
        return load(sample);
      case Phase::Falling:
        return fall(sample);
      case Phase::Bottomed:
        return press(sample);
      case Phase::Opened:
        break;
    }
    return Event::Nothing;
  }

  /// What is known so far of the cut that the hand is making.
  const Cut& cut() const noexcept { return cut_; }

  /// The cut that was completed last; empty before the first.
  const Cut& lastCut() const noexcept { return lastCut_; }

  std::uint32_t completedCuts() const noexcept { return completedCuts_; }

  /// Forgets everything but the parameters.
  void reset() noexcept { *this = CutDetector(parameters_); }

 private:
  enum class Phase : std::uint8_t { Searching, Loading, Falling, Bottomed, Opened };

  static bool isBad(Scalar value) noexcept { return !std::isfinite(value) || value < Scalar{0}; }
  static bool isPositive(Scalar value) noexcept { return !isBad(value) && value > Scalar{0}; }

  void updateLargest(const Landmark& sample) noexcept {
    const bool wasIdle = phase_ == Phase::Searching && !isClosed_;
    if (sample.travel > parameters_.closedAbove) isClosed_ = true;
    if (wasIdle || sample.travel > cut_.largestTravel) cut_.largestTravel = sample.travel;
    if (wasIdle || sample.force > cut_.peakForce) cut_.peakForce = sample.force;
  }

  Event search(const Landmark& sample) noexcept {
    const bool wentBack = sample.travel < start_.travel - parameters_.retreat;
    if (!start_.found || wentBack || aboveCreep(sample) <= aboveCreep(start_)) {
      start_ = sample;
      return Event::Nothing;
    }
    if (sample.force - start_.force < parameters_.contactForce) return Event::Nothing;
    const bool isLess = cut_.interception.found && sample.force <= highest_.force;
    if (isLess) return Event::Nothing;  // than a touch that was let go in the same closure
    cut_.interception = start_;
    highest_ = sample;
    phase_ = Phase::Loading;
    return Event::Interception;
  }

  Event load(const Landmark& sample) noexcept {
    if (sample.force >= highest_.force) {
      highest_ = sample;
      return Event::Nothing;
    }
    const bool closesOn = sample.travel - highest_.travel >= parameters_.advance;
    const bool isLoaded = highest_.force - cut_.interception.force >= parameters_.yieldLoad;
    if (closesOn && isLoaded && highest_.force - sample.force >= yieldDrop()) {
      cut_.yield = highest_;
      lowest_ = Landmark{};
      phase_ = Phase::Falling;
      return Event::Yield;
    }
    if (isLost(sample)) letGo(sample);
    return Event::Nothing;
  }

  Event fall(const Landmark& sample) noexcept {
    if (sample.travel >= cut_.largestTravel && hasLostTheLoad(sample)) {
      cut_.yield = Landmark{};
      letGo(sample);
      return Event::Nothing;
    }
    const bool isAtTheEnd = sample.travel >= parameters_.bottomAbove &&
                            sample.travel > cut_.largestTravel - parameters_.advance;
    if (isAtTheEnd && (!lowest_.found || sample.force < lowest_.force)) lowest_ = sample;
    if (isAtTheEnd && sample.force - lowest_.force >= parameters_.bottomRise) {
      cut_.bottomOut = lowest_;
      highest_ = sample;
      phase_ = Phase::Bottomed;
      return Event::BottomOut;
    }
    if (sample.force > cut_.yield.force) {
      cut_.yield = Landmark{};
      highest_ = sample;
      phase_ = Phase::Loading;
    }
    if (!isClosed_ && isLost(sample)) letGo(sample);
    return Event::Nothing;
  }

  Event press(const Landmark& sample) noexcept {
    const Scalar lost = cut_.yield.force - cut_.bottomOut.force;
    const Scalar cameBack = highest_.force - cut_.bottomOut.force;
    const bool reachesFurther = sample.travel >= cut_.largestTravel;
    if (reachesFurther && cameBack < lost / Scalar{2} && sample.force < cut_.bottomOut.force) {
      cut_.bottomOut = sample;
      highest_ = sample;
    }
    if (sample.force > highest_.force) highest_ = sample;
    return Event::Nothing;
  }

  Event goBack(const Landmark& sample) noexcept {
    start_ = sample;
    if (phase_ == Phase::Searching || phase_ == Phase::Opened) return Event::Nothing;
    if (!isClosed_) {
      letGo(sample);
      return Event::Nothing;
    }
    settleOpening();
    phase_ = Phase::Opened;
    return cut_.opening.found ? Event::Opening : Event::Nothing;
  }

  Event complete(const Landmark& sample) noexcept {
    if (phase_ != Phase::Opened) settleOpening();
    lastCut_ = cut_;
    ++completedCuts_;
    isClosed_ = false;
    letGo(sample);
    return Event::CutCompleted;
  }

  void settleOpening() noexcept {
    if (cut_.interception.found && cut_.yield.found == cut_.bottomOut.found) {
      cut_.opening = highest_;
    }
  }

  /// The search begins again. What was found stays while the hand is closed, in case nothing
  /// better comes.
  void letGo(const Landmark& sample) noexcept {
    phase_ = Phase::Searching;
    start_ = sample;
    if (isClosed_) return;
    cut_ = Cut{};
    cut_.largestTravel = sample.travel;
    cut_.peakForce = sample.force;
  }

  /// The hand had only eased: it closes further than before.
  void closeAgain() noexcept {
    cut_.opening = Landmark{};
    phase_ = cut_.bottomOut.found ? Phase::Bottomed
                                  : (cut_.yield.found ? Phase::Falling : Phase::Loading);
  }

  /// The contact is lost.
  bool isLost(const Landmark& sample) const noexcept {
    const Scalar load = sample.force - cut_.interception.force;
    return load < parameters_.contactForce / Scalar{2};
  }

  /// Less is left than tissue that has just yielded would hold.
  bool hasLostTheLoad(const Landmark& sample) const noexcept {
    const Scalar load = cut_.yield.force - cut_.interception.force;
    return parameters_.yieldKeeps > Scalar(0) &&
           sample.force - cut_.interception.force < parameters_.yieldKeeps * load;
  }

  Scalar aboveCreep(const Landmark& sample) const noexcept {
    return sample.force - parameters_.creep * sample.travel;
  }

  Scalar yieldDrop() const noexcept {
    const Scalar load = highest_.force - cut_.interception.force;
    const Scalar relative = parameters_.yieldDropRatio * load;
    return relative > parameters_.yieldDrop ? relative : parameters_.yieldDrop;
  }

  Parameters parameters_;
  Phase phase_ = Phase::Searching;
  bool isClosed_ = false;
  Landmark start_;    ///< where the load may have begun to rise
  Landmark highest_;  ///< the largest force since the interception, or since the bottom-out
  Landmark lowest_;   ///< the smallest force since the yield, at the end of the travel
  Cut cut_;
  Cut lastCut_;
  std::uint32_t completedCuts_ = 0;
};

}  // namespace haptics::models
