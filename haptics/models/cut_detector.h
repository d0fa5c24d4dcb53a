#pragma once

#include <cmath>
#include <cstdint>
#include <utility>

namespace haptics::models {

/// Detects cuts, and the four landmarks of each, in real time.
///
/// feed() gets one pair of travel and force per tick, of a punch or of any tool that is pressed to
/// the end and released (a stroke of a reamer). A cut is one closure: the travel rises above
/// `closedAbove`, then falls below `openBelow`. What is closed at the first tick has to be opened
/// first. The landmarks of a cut are those of the punch paper, section II-B:
///
///     (i)   interception  the load begins to rise
///     (ii)  yield         the surface is cut through, and the force falls
///     (iii) bottom-out    the end of the travel, and the force rises again
///     (iv)  opening       the largest force of all, before the contact is lost
///
/// A landmark is reported only when the force has moved far enough away from it, so an event comes
/// a little later than its landmark; the landmark itself is the sample at which it occurred.
///
/// - The interception is the sample from which the force rises by `contactForce`, faster than
///   `frictionSlope` per unit of travel: of all samples since the hand last opened, the one with
///   the smallest f − frictionSlope · x. Friction in the hinge rises more slowly and is ignored. A
///   touch that is released is discarded when a larger one follows before the hand opens.
/// - The yield is the largest force since the interception, once the force has fallen below it by
///   the larger of `yieldDrop` and `yieldDropRatio` times the load, while the handle closed further
///   by `advance`: a hand that merely lets go cuts nothing. A larger force before the bottom-out
///   revokes the yield (the surface had not been cut after all), and Event::Yield may come again:
///   the last one counts. If `yieldLoad` is set, a yield also needs that load. If
///   `leastLoadAfterYield` is set, a yield is revoked when less than that fraction of its load is
///   left while the handle closes further: that was a blow on the handle, not tissue.
/// - The bottom-out is the smallest force after the yield at the end of the travel – beyond
///   `bottomOutAbove`, at most `advance` from the largest travel – once the force has risen from it
///   by `bottomOutRise`. Until the force has regained half of what it lost since the yield, a
///   smaller force at a larger travel replaces the bottom-out without an event.
/// - The opening is the largest force since the bottom-out, once the handle has moved back by
///   `retreat`. Without a yield it is the largest force since the interception; with a yield but no
///   bottom-out there is no opening.
///
/// Landmarks may be missing; a cut in a difficult recording may have only its peak. Samples that
/// are NaN are ignored.
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
    Scalar closedAbove = Scalar(7);     ///< closed when the travel exceeds this [travel units]
    Scalar openBelow = Scalar(4);       ///< open again when the travel is below this [travel units]
    Scalar contactForce = Scalar(0.2);  ///< rise of the force that counts as contact [N]
    Scalar frictionSlope =
        Scalar(0.5);                  ///< a force that rises no faster is friction [N/travel unit]
    Scalar yieldDrop = Scalar(0.25);  ///< least fall of the force at a yield [N]
    /// Least fall of the force at a yield, relative to the load.
    Scalar yieldDropRatio = Scalar(0.08);
    /// Least load (force above that of the interception) at a yield [N].
    Scalar yieldLoad = Scalar(0);
    Scalar leastLoadAfterYield = Scalar(0);  ///< least fraction of the load after a yield; 0: any
    Scalar advance = Scalar(0.3);  ///< closing further by this counts as a movement [travel units]
    Scalar bottomOutAbove = Scalar(9);   ///< the end of the travel is beyond this [travel units]
    Scalar bottomOutRise = Scalar(0.3);  ///< rise of the force that confirms a bottom-out [N]
    Scalar retreat = Scalar(1);          ///< moving back by this counts as opening [travel units]
  };

  /// A landmark of a cut; valid if found.
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
    Scalar peakForce{0};      ///< largest since the contact, or since closing if there was none [N]
    Scalar largestTravel{0};  ///< [travel units]
  };

  CutDetector() noexcept = default;

  /// @param parameters  valid, see isSound().
  explicit CutDetector(const Parameters& parameters) noexcept : parameters_(parameters) {}

  static bool isSound(const Parameters& p) noexcept {
    const bool isOrdered = p.openBelow < p.closedAbove && std::isfinite(p.closedAbove) &&
                           std::isfinite(p.openBelow) && std::isfinite(p.bottomOutAbove);
    return isOrdered && isPositive(p.contactForce) && isPositive(p.bottomOutRise) &&
           isPositive(p.retreat) && isPositive(p.yieldDrop) &&
           !isNegativeOrNotFinite(p.frictionSlope) && !isNegativeOrNotFinite(p.yieldDropRatio) &&
           !isNegativeOrNotFinite(p.yieldLoad) && !isNegativeOrNotFinite(p.leastLoadAfterYield) &&
           p.leastLoadAfterYield < Scalar(1) && !isNegativeOrNotFinite(p.advance);
  }

  /// Processes one tick's travel [travel units] and force [N], and returns the event that this tick
  /// confirms.
  /// @param isSettling  whether the force is being faded in or out. Until a contact is found, a
  /// rise
  ///                    of such a force is ignored, and the search starts again at the next tick.
  Event feed(Scalar travel, Scalar force, bool isSettling = false) noexcept {
    if (!std::isfinite(travel) || !std::isfinite(force)) return Event::Nothing;
    if (!std::exchange(hasBegun_, true)) isClosedFromTheStart_ = travel > parameters_.closedAbove;
    if (isClosedFromTheStart_ && travel >= parameters_.openBelow) return Event::Nothing;
    isClosedFromTheStart_ = false;
    const Landmark sample{travel, force, true};
    if (isClosed_ && travel < parameters_.openBelow) return complete(sample);
    if (phase_ == Phase::Opened && travel > cut_.largestTravel) resumeClosing();
    updateLargest(sample);
    if (travel < cut_.largestTravel - parameters_.retreat) return goBack(sample);
    switch (phase_) {
      case Phase::Searching:
        if (!isSettling) return search(sample);
        contactCandidate_ = sample;
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

  /// The present cut, as far as it is known.
  const Cut& cut() const noexcept { return cut_; }

  /// The last completed cut; empty before the first.
  const Cut& lastCut() const noexcept { return lastCut_; }

  std::uint32_t completedCuts() const noexcept { return completedCuts_; }

  /// Returns to the initial state; keeps the parameters.
  void reset() noexcept { *this = CutDetector(parameters_); }

 private:
  enum class Phase : std::uint8_t { Searching, Loading, Falling, Bottomed, Opened };

  static bool isNegativeOrNotFinite(Scalar value) noexcept {
    return !std::isfinite(value) || value < Scalar{0};
  }
  static bool isPositive(Scalar value) noexcept {
    return !isNegativeOrNotFinite(value) && value > Scalar{0};
  }

  void updateLargest(const Landmark& sample) noexcept {
    const bool wasIdle = phase_ == Phase::Searching && !isClosed_;
    if (sample.travel > parameters_.closedAbove) isClosed_ = true;
    if (wasIdle || sample.travel > cut_.largestTravel) cut_.largestTravel = sample.travel;
    if (wasIdle || sample.force > cut_.peakForce) cut_.peakForce = sample.force;
  }

  Event search(const Landmark& sample) noexcept {
    const bool wentBack = sample.travel < contactCandidate_.travel - parameters_.retreat;
    if (!contactCandidate_.found || wentBack ||
        forceAboveFriction(sample) <= forceAboveFriction(contactCandidate_)) {
      contactCandidate_ = sample;
      return Event::Nothing;
    }
    if (sample.force - contactCandidate_.force < parameters_.contactForce) return Event::Nothing;
    const bool isLess = cut_.interception.found && sample.force <= highestForce_.force;
    if (isLess) return Event::Nothing;  // than an earlier touch in the same closure
    cut_.interception = contactCandidate_;
    highestForce_ = sample;
    phase_ = Phase::Loading;
    return Event::Interception;
  }

  Event load(const Landmark& sample) noexcept {
    if (sample.force >= highestForce_.force) {
      highestForce_ = sample;
      return Event::Nothing;
    }
    const bool closesOn = sample.travel - highestForce_.travel >= parameters_.advance;
    const bool isLoaded = highestForce_.force - cut_.interception.force >= parameters_.yieldLoad;
    if (closesOn && isLoaded && highestForce_.force - sample.force >= yieldDrop()) {
      cut_.yield = highestForce_;
      lowestForce_ = Landmark{};
      phase_ = Phase::Falling;
      return Event::Yield;
    }
    if (isContactLost(sample)) restartSearch(sample);
    return Event::Nothing;
  }

  Event fall(const Landmark& sample) noexcept {
    if (sample.travel >= cut_.largestTravel && isBelowLeastLoad(sample)) {
      cut_.yield = Landmark{};
      restartSearch(sample);
      return Event::Nothing;
    }
    const bool isAtTheEnd = sample.travel >= parameters_.bottomOutAbove &&
                            sample.travel > cut_.largestTravel - parameters_.advance;
    if (isAtTheEnd && (!lowestForce_.found || sample.force < lowestForce_.force))
      lowestForce_ = sample;
    if (isAtTheEnd && sample.force - lowestForce_.force >= parameters_.bottomOutRise) {
      cut_.bottomOut = lowestForce_;
      highestForce_ = sample;
      phase_ = Phase::Bottomed;
      return Event::BottomOut;
    }
    if (sample.force > cut_.yield.force) {
      cut_.yield = Landmark{};
      highestForce_ = sample;
      phase_ = Phase::Loading;
    }
    if (!isClosed_ && isContactLost(sample)) restartSearch(sample);
    return Event::Nothing;
  }

  Event press(const Landmark& sample) noexcept {
    const Scalar lost = cut_.yield.force - cut_.bottomOut.force;
    const Scalar cameBack = highestForce_.force - cut_.bottomOut.force;
    const bool reachesFurther = sample.travel >= cut_.largestTravel;
    if (reachesFurther && cameBack < lost / Scalar{2} && sample.force < cut_.bottomOut.force) {
      cut_.bottomOut = sample;
      highestForce_ = sample;
    }
    if (sample.force > highestForce_.force) highestForce_ = sample;
    return Event::Nothing;
  }

  Event goBack(const Landmark& sample) noexcept {
    contactCandidate_ = sample;
    if (phase_ == Phase::Searching || phase_ == Phase::Opened) return Event::Nothing;
    if (!isClosed_) {
      restartSearch(sample);
      return Event::Nothing;
    }
    recordOpening();
    phase_ = Phase::Opened;
    return cut_.opening.found ? Event::Opening : Event::Nothing;
  }

  Event complete(const Landmark& sample) noexcept {
    if (phase_ != Phase::Opened) recordOpening();
    lastCut_ = cut_;
    ++completedCuts_;
    isClosed_ = false;
    restartSearch(sample);
    return Event::CutCompleted;
  }

  void recordOpening() noexcept {
    if (cut_.interception.found && cut_.yield.found == cut_.bottomOut.found) {
      cut_.opening = highestForce_;
    }
  }

  /// Restarts the search for a contact. While the hand is closed the landmarks are kept, in case no
  /// larger touch follows.
  void restartSearch(const Landmark& sample) noexcept {
    phase_ = Phase::Searching;
    contactCandidate_ = sample;
    if (isClosed_) return;
    cut_ = Cut{};
    cut_.largestTravel = sample.travel;
    cut_.peakForce = sample.force;
  }

  /// The hand had only paused: it closes further than before, so the opening is revoked.
  void resumeClosing() noexcept {
    cut_.opening = Landmark{};
    phase_ = cut_.bottomOut.found ? Phase::Bottomed
                                  : (cut_.yield.found ? Phase::Falling : Phase::Loading);
  }

  /// Whether the contact is lost.
  bool isContactLost(const Landmark& sample) const noexcept {
    const Scalar load = sample.force - cut_.interception.force;
    return load < parameters_.contactForce / Scalar{2};
  }

  /// Whether the force after the yield is less than tissue would keep: leastLoadAfterYield.
  bool isBelowLeastLoad(const Landmark& sample) const noexcept {
    const Scalar load = cut_.yield.force - cut_.interception.force;
    return parameters_.leastLoadAfterYield > Scalar(0) &&
           sample.force - cut_.interception.force < parameters_.leastLoadAfterYield * load;
  }

  Scalar forceAboveFriction(const Landmark& sample) const noexcept {
    return sample.force - parameters_.frictionSlope * sample.travel;
  }

  Scalar yieldDrop() const noexcept {
    const Scalar load = highestForce_.force - cut_.interception.force;
    const Scalar relative = parameters_.yieldDropRatio * load;
    return relative > parameters_.yieldDrop ? relative : parameters_.yieldDrop;
  }

  Parameters parameters_;
  Phase phase_ = Phase::Searching;
  bool hasBegun_ = false;  ///< whether a tick was processed
  bool isClosedFromTheStart_ = false;
  bool isClosed_ = false;
  Landmark contactCandidate_;  ///< candidate of the interception
  Landmark highestForce_;  ///< the largest force since the interception, or since the bottom-out
  Landmark lowestForce_;   ///< the smallest force since the yield, at the end of the travel
  Cut cut_;
  Cut lastCut_;
  std::uint32_t completedCuts_ = 0;
};

}  // namespace haptics::models
