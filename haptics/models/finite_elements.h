#pragma once

#include "haptics/models/response.h"

namespace haptics::models {

/// The meniscus as a string of one-dimensional finite elements: eq. (3)–(11) of the punch paper,
/// with the boundary read as printed ("reading A": the N unknowns sit at the element midpoints,
/// both ends are fixed and already eliminated).
///
/// Neighbouring midpoints are joined by springs k₃ = kᵉ/2lᵉ, each end to its nearest midpoint by
/// 2k₃. The tool presses at x_tool, between two midpoints that share it by the weights of
/// eq. (7)–(8), so that
///
///     f = (y_tool) / (cᵀ K⁻¹ c),        y_mesh = K⁻¹ c f.
///
/// K is never formed: for springs in a row, K⁻¹ᵢⱼ = S_min (T − S_max) / T with S the flexibility
/// (1/k) summed from the left end and T its total. Positive sums and products lose no digits, and
/// the force costs the same for 5 elements and for 5,000.
///
/// The force is elastic up to the yield force and stays there ("ideally plastic"). As in the paper
/// this is a function of position alone: opening the punch replays the cut.
template <typename Scalar>
class FiniteElements {
 public:
  struct Parameters {
    Scalar start{0.5};             ///< a, left end of the string [string units]
    Scalar end{2.0};               ///< b, right end
    int elements = 5;              ///< N
    Scalar elementStiffness{1.0};  ///< kᵉ [N·string units per travel unit]
    Scalar toolPosition{1.5};      ///< x_tool, strictly between a and b
    Scalar contact{4.0};           ///< where the tool meets the tissue [travel units]
    Scalar yieldForce{7.0};        ///< [N]
  };

  /// @param parameters  isSound() has been asked.
  constexpr explicit FiniteElements(const Parameters& parameters) noexcept : p_(parameters) {
    // Nodes count from 0 (left end) over the midpoints 1 … N to N + 1 (right end), eq. (4).
    left_ = 0;
    while (left_ < p_.elements && position(left_ + 1) <= p_.toolPosition) ++left_;
    const Scalar from = position(left_);
    const Scalar to = position(left_ + 1);
    weightRight_ = (p_.toolPosition - from) / (to - from);  // eq. (8)
    weightLeft_ = Scalar{1} - weightRight_;                 // eq. (7)
    const Scalar flexibility = weightLeft_ * weightLeft_ * inverse(left_, left_) +
                               Scalar{2} * weightLeft_ * weightRight_ * inverse(left_, left_ + 1) +
                               weightRight_ * weightRight_ * inverse(left_ + 1, left_ + 1);
    stiffness_ = Scalar{1} / flexibility;
  }

  static constexpr bool isSound(const Parameters& p) noexcept {
    const bool finite = p.start - p.start == Scalar{0} && p.end - p.end == Scalar{0} &&
                        p.contact - p.contact == Scalar{0} &&
                        p.yieldForce - p.yieldForce == Scalar{0};
    return finite && p.end > p.start && p.elements >= 1 && p.elementStiffness > Scalar{0} &&
           p.toolPosition > p.start && p.toolPosition < p.end && p.yieldForce >= Scalar{0};
  }

  /// What the tool feels while the tissue is elastic [N per travel unit]: 1 / (cᵀ K⁻¹ c).
  constexpr Scalar stiffness() const noexcept { return stiffness_; }
  constexpr int elements() const noexcept { return p_.elements; }

  constexpr Response<Scalar> at(Scalar travel) const noexcept {
    const Scalar penetration = travel - p_.contact;
    if (!(penetration > Scalar{0})) return {Scalar{0}, Scalar{0}, penetration <= Scalar{0}};
    const Scalar elastic = stiffness_ * penetration;
    if (elastic < p_.yieldForce) return {elastic, stiffness_, true};
    return {p_.yieldForce, Scalar{0}, true};
  }

  /// How far midpoint @p node, from 1 to N, gives way under @p force at the tool [travel units]:
  /// eq. (11). Nobody needs it who does not look at the tissue.
  constexpr Scalar displacement(int node, Scalar force) const noexcept {
    return force * (weightLeft_ * inverse(node, left_) + weightRight_ * inverse(node, left_ + 1));
  }

  /// Where node 0 … N + 1 lies [string units]: the left end, the midpoints, the right end.
  constexpr Scalar position(int node) const noexcept {
    if (node <= 0) return p_.start;
    if (node > p_.elements) return p_.end;
    const Scalar length = (p_.end - p_.start) / static_cast<Scalar>(p_.elements);
    return p_.start + (static_cast<Scalar>(node) - Scalar(0.5)) * length;
  }

 private:
  /// Summed from the left end to node i; uniform elements make it a line: S = 2 (x − a) / kᵉ.
  constexpr Scalar flexibilityTo(int node) const noexcept {
    return Scalar{2} * (position(node) - p_.start) / p_.elementStiffness;
  }
  constexpr Scalar flexibilityFrom(int node) const noexcept {
    return Scalar{2} * (p_.end - position(node)) / p_.elementStiffness;
  }
  constexpr Scalar inverse(int i, int j) const noexcept {
    const Scalar total = Scalar{2} * (p_.end - p_.start) / p_.elementStiffness;
    return flexibilityTo(i < j ? i : j) * flexibilityFrom(i < j ? j : i) / total;
  }

  Parameters p_;
  int left_ = 0;
  Scalar weightLeft_{};
  Scalar weightRight_{};
  Scalar stiffness_{};
};

}  // namespace haptics::models
