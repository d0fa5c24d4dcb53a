#pragma once

#include "haptics/models/response.h"

namespace haptics::models {

/// Compensated summation (Kahan 1965): the relative error does not grow with the number of terms,
/// as long as they have the same sign. Not to be compiled with -ffast-math.
template <typename Scalar>
class CompensatedSum {
 public:
  constexpr void add(Scalar term) noexcept {
    const Scalar corrected = term - lost_;
    const Scalar sum = sum_ + corrected;
    lost_ = (sum - sum_) - corrected;
    if (!(lost_ - lost_ == Scalar{0})) lost_ = Scalar{0};  // after an infinite term
    sum_ = sum;
  }
  constexpr Scalar value() const noexcept { return sum_; }

 private:
  Scalar sum_{};
  Scalar lost_{};
};

/// How the ends of the string are fixed: docs/force-models.md.
enum class BoundaryCondition {
  A,  ///< eq. (6) as printed: a spring 2k₃ (half an element) joins each end to its nearest midpoint
  B,  ///< springs k₃ also at the ends, as in the authors' firmware
};

/// How the tool's position is expressed by the displacements of nodes.
enum class ToolInterpolation {
  Paper,            ///< eq. (7)–(8): interpolates between the two midpoints beside the tool
  AuthorsFirmware,  ///< eq. (7)–(8), but with the midpoints of the tool's element and of the next
                    ///< one, so it extrapolates if the tool is before the first of these
  ExactKink,  ///< an additional node at the tool: the string bends exactly there, without ripple
};

/// How the tissue behaves beyond the yield force.
enum class YieldLaw {
  Clip,       ///< the force is constant: it depends on position only, so opening retraces closing
  ReturnMap,  ///< the tissue yields permanently, so the force is lower while opening
};

/// The meniscus as a string of one-dimensional finite elements: eq. (3)–(11) of the punch paper.
/// The N unknowns are the displacements of the element midpoints; both ends are fixed.
///
/// Springs k₃ = kᵉ/2lᵉ join neighbouring midpoints: half an element has the flexibility lᵉ/kᵉ. The
/// tool presses at x_tool with weights c, so that
///
///     f = (y_tool) / (cᵀ K⁻¹ c),        y_mesh = K⁻¹ c f.
///
/// K is never formed: for springs in series, K⁻¹ᵢⱼ = S_min R_max / (S_min + s + R_max), with S the
/// flexibility (1/k) summed from the left end to the left node, R from the right node to the right
/// end, and s between the nodes. Sums and products of positive numbers lose no digits for any ratio
/// of the stiffnesses, whereas kᵢ + kᵢ₊₁ loses the softer one. Stiffnesses of 0 and infinity are
/// allowed. The force takes the same time for 5 elements and for 5,000.
template <typename Scalar>
class FiniteElements {
 public:
  struct Parameters {
    Scalar start{0.5};             ///< a, left end of the string [string units]
    Scalar end{2.0};               ///< b, right end
    int elements = 5;              ///< N
    Scalar elementStiffness{1.0};  ///< kᵉ [N·string units per travel unit]
    Scalar toolPosition{1.5};      ///< x_tool, strictly between a and b
    Scalar contact{4.0};           ///< travel at which the tool meets the tissue [travel units]
    Scalar yieldForce{7.0};        ///< [N]
    BoundaryCondition boundary = BoundaryCondition::A;
    ToolInterpolation weights = ToolInterpolation::Paper;
    YieldLaw yielding = YieldLaw::Clip;
    /// If not nullptr, an array of N stiffnesses, one per element, which replaces elementStiffness
    /// and must outlive the model.
    const Scalar* elementStiffnesses = nullptr;
  };

  /// The permanent displacement of the tissue [travel units]. It is reset when the tool leaves the
  /// tissue: the next cut meets intact tissue.
  struct State {
    Scalar offset{};
  };

  /// @param parameters  valid, see isSound().
  constexpr explicit FiniteElements(const Parameters& parameters) noexcept : p_(parameters) {
    if (p_.weights == ToolInterpolation::ExactKink) {
      const auto beside = flexibilitiesOnBothSides(p_.toolPosition);
      compliance_ = parallel(beside.left, beside.right);
    } else {
      tool_ = supportOfTool();
      compliance_ = complianceBetweenNodes();
    }
    stiffness_ = Scalar{1} / compliance_;
  }

  static constexpr bool isSound(const Parameters& p) noexcept {
    const bool finite = isFinite(p.start) && isFinite(p.end) && isFinite(p.contact) &&
                        isFinite(p.yieldForce) && isFinite(p.toolPosition);
    if (!finite || !(p.end > p.start) || p.elements < 1) return false;
    if (!(p.toolPosition > p.start && p.toolPosition < p.end)) return false;
    for (int e = 0; e < (p.elementStiffnesses == nullptr ? 1 : p.elements); ++e) {
      const Scalar k =
          p.elementStiffnesses == nullptr ? p.elementStiffness : p.elementStiffnesses[e];
      if (!(k >= Scalar{0})) return false;
    }
    // The published code writes beyond its array if the tool is in the last element.
    const Scalar length = (p.end - p.start) / Scalar(p.elements);
    const bool isInTheLast = p.toolPosition >= p.end - length;
    return p.yieldForce >= Scalar{0} &&
           !(p.weights == ToolInterpolation::AuthorsFirmware && isInTheLast);
  }

  /// Stiffness at the tool while the tissue is elastic [N per travel unit]: 1 / (cᵀ K⁻¹ c).
  constexpr Scalar stiffness() const noexcept { return stiffness_; }
  constexpr int elements() const noexcept { return p_.elements; }
  constexpr const Parameters& parameters() const noexcept { return p_; }

  /// Force and stiffness at @p travel [travel units]; 0 and undefined if it is NaN.
  constexpr Response<Scalar> at(Scalar travel, State& state) const noexcept {
    const Scalar penetration = travel - p_.contact;
    if (!(penetration > Scalar{0})) {
      state.offset = Scalar{0};
      return {Scalar{0}, Scalar{0}, penetration <= Scalar{0}};
    }
    const Scalar stretch = penetration - state.offset;
    if (!(stretch > Scalar{0})) return {Scalar{0}, Scalar{0}, true};
    const Scalar elastic = stiffness_ * stretch;
    if (elastic < p_.yieldForce) return {elastic, stiffness_, true};
    if (p_.yielding == YieldLaw::ReturnMap) {
      state.offset = penetration - p_.yieldForce * compliance_;
    }
    return {p_.yieldForce, Scalar{0}, true};
  }

  /// Writes the N displacements of the midpoints per newton at the tool [travel units per N], K⁻¹ c
  /// of eq. (11). The caller multiplies them by the force.
  constexpr void writeMeshShape(Scalar* shape) const noexcept {
    if (p_.weights == ToolInterpolation::ExactKink) {
      const int before = nodesBefore(p_.toolPosition);
      const auto beside = flexibilitiesOnBothSides(p_.toolPosition);
      writeShapeLeftOf(shape, before, shareOf(beside.right, beside.left));
      writeShapeRightOf(shape, before + 1, shareOf(beside.left, beside.right));
      return;
    }
    const Scalar s = flexibilityLeftOf(tool_.left);
    const Scalar r = flexibilityRightOf(tool_.left + 1);
    const Scalar between = springFlexibilityAfter(tool_.left);
    const Scalar wl = tool_.weightLeft;
    const Scalar wr = tool_.weightRight;
    writeShapeLeftOf(
        shape, tool_.left, wl * shareOf(between + r, s) + wr * shareOf(r, s + between));
    writeShapeRightOf(
        shape, tool_.left + 1, wl * shareOf(s, between + r) + wr * shareOf(s + between, r));
  }

  /// Position of node 0 … N + 1 [string units]: the left end, the midpoints, the right end, eq.
  /// (4).
  constexpr Scalar position(int node) const noexcept {
    if (node <= 0) return p_.start;
    if (node > p_.elements) return p_.end;
    return p_.start + (Scalar(node) - Scalar(0.5)) * length();
  }

 private:
  struct Support {
    int left = 0;  ///< left of the two nodes between which the tool is interpolated
    Scalar weightLeft{};
    Scalar weightRight{};
  };
  struct Flexibilities {
    Scalar left{};
    Scalar right{};
  };

  static constexpr bool isInfinite(Scalar value) noexcept { return !isFinite(value); }

  /// a b / (a + b); either may be 0 or infinite.
  static constexpr Scalar parallel(Scalar a, Scalar b) noexcept {
    if (a == Scalar{0} || b == Scalar{0}) return Scalar{0};
    if (isInfinite(a)) return b;
    if (isInfinite(b)) return a;
    return a > b ? b / (Scalar{1} + b / a) : a / (Scalar{1} + a / b);
  }

  /// a / (a + b): two springs of flexibility a and b meet in a joint, on which a force acts; this
  /// is the fraction of the force that the spring of flexibility b carries.
  static constexpr Scalar shareOf(Scalar a, Scalar b) noexcept {
    if (a == Scalar{0}) return Scalar{0};
    if (isInfinite(a)) return Scalar{1};
    return isInfinite(b) ? Scalar{0} : Scalar{1} / (Scalar{1} + b / a);
  }

  constexpr Scalar length() const noexcept { return (p_.end - p_.start) / Scalar(p_.elements); }

  /// Flexibility of half of element @p e, counted from 0.
  constexpr Scalar half(int e) const noexcept {
    return length() /
           (p_.elementStiffnesses == nullptr ? p_.elementStiffness : p_.elementStiffnesses[e]);
  }

  constexpr int elementAt(Scalar x) const noexcept {
    int e = 0;
    while (e + 1 < p_.elements && p_.start + Scalar(e + 1) * length() <= x) ++e;
    return e;
  }

  /// Number of midpoints at or before @p x.
  constexpr int nodesBefore(Scalar x) const noexcept {
    int node = 0;
    while (node < p_.elements && position(node + 1) <= x) ++node;
    return node;
  }

  constexpr Support supportOfTool() const noexcept {
    const int left = p_.weights == ToolInterpolation::Paper ? nodesBefore(p_.toolPosition)
                                                            : elementAt(p_.toolPosition) + 1;
    const Scalar right = (p_.toolPosition - position(left)) / (position(left + 1) - position(left));
    return {left, Scalar{1} - right, right};
  }

  /// Flexibility of the spring between node @p node and the next one.
  constexpr Scalar springFlexibilityAfter(int node) const noexcept {
    if (node == 0) return endSpringFlexibility(0);
    if (node == p_.elements) return endSpringFlexibility(p_.elements - 1);
    return half(node - 1) + half(node);
  }
  constexpr Scalar endSpringFlexibility(int e) const noexcept {
    return p_.boundary == BoundaryCondition::A ? half(e) : Scalar{2} * half(e);
  }

  /// Flexibility summed from the left end to node @p node; flexibilityRightOf() sums from the node
  /// to the right end.
  constexpr Scalar flexibilityLeftOf(int node) const noexcept {
    CompensatedSum<Scalar> sum;
    for (int i = 0; i < node; ++i) sum.add(springFlexibilityAfter(i));
    return sum.value();
  }
  constexpr Scalar flexibilityRightOf(int node) const noexcept {
    CompensatedSum<Scalar> sum;
    for (int i = p_.elements; i >= node; --i) sum.add(springFlexibilityAfter(i));
    return sum.value();
  }

  /// Flexibilities from both ends to @p x, which need not be a node. Within a spring, each half
  /// element spreads its own flexibility evenly.
  constexpr Flexibilities flexibilitiesOnBothSides(Scalar x) const noexcept {
    const int node = nodesBefore(x);
    const Scalar before = (x - position(node)) / length();  // [elements]
    const Scalar after = (position(node + 1) - x) / length();
    Flexibilities within;
    if (node == 0 || node == p_.elements) {
      const Scalar whole = before + after;  // the end spring spans half an element
      const Scalar spring = springFlexibilityAfter(node);
      within = {spring * (before / whole), spring * (after / whole)};
    } else if (before <= after) {
      const Scalar here = Scalar{2} * half(node - 1);
      within = {here * before, here * (Scalar(0.5) - before) + half(node)};
    } else {
      const Scalar here = Scalar{2} * half(node);
      within = {half(node - 1) + here * (Scalar(0.5) - after), here * after};
    }
    return {flexibilityLeftOf(node) + within.left, within.right + flexibilityRightOf(node + 1)};
  }

  constexpr Scalar complianceBetweenNodes() const noexcept {
    const Scalar s = flexibilityLeftOf(tool_.left);
    const Scalar r = flexibilityRightOf(tool_.left + 1);
    const Scalar between = springFlexibilityAfter(tool_.left);
    const Scalar wl = tool_.weightLeft;
    const Scalar wr = tool_.weightRight;
    Scalar compliance{};
    if (wl != Scalar{0}) compliance += wl * wl * parallel(s, between + r);
    if (wr != Scalar{0}) compliance += wr * wr * parallel(s + between, r);
    const Scalar across = parallel(s, r + between) * shareOf(r, between);
    if (isFinite(compliance) && isFinite(across)) compliance += Scalar{2} * wl * wr * across;
    return compliance;
  }

  /// Writes midpoints 1 … last: the flexibility from the left end to each, times @p slope.
  constexpr void writeShapeLeftOf(Scalar* shape, int last, Scalar slope) const noexcept {
    CompensatedSum<Scalar> sum;
    for (int node = 1; node <= last; ++node) {
      sum.add(springFlexibilityAfter(node - 1));
      shape[node - 1] = slope == Scalar{0} ? Scalar{0} : slope * sum.value();
    }
  }
  constexpr void writeShapeRightOf(Scalar* shape, int first, Scalar slope) const noexcept {
    CompensatedSum<Scalar> sum;
    for (int node = p_.elements; node >= first && node >= 1; --node) {
      sum.add(springFlexibilityAfter(node));
      shape[node - 1] = slope == Scalar{0} ? Scalar{0} : slope * sum.value();
    }
  }

  Parameters p_;
  Support tool_;
  Scalar compliance_{};
  Scalar stiffness_{};
};

}  // namespace haptics::models
