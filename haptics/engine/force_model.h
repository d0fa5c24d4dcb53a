#pragma once

#include <optional>

#include "haptics/models/response.h"

namespace haptics::engine {

/// Position and velocity of the tool along the device's axis. The unit of travel is the device's:
/// travel units for the punch (0 open, 10 closed), metres for the reamer.
struct ToolState {
  double travel = 0.0;     ///< [device's travel unit]
  double velocity = 0.0;   ///< [device's travel unit / s]
  double dt = 0.001;       ///< since the last tick [s], > 0
  bool isReamerOn = true;  ///< false: the reamer does not turn, and removes nothing
};

/// What a model knows of K, the largest |ΔF| / |Δx| of its force without jitter.
struct SlopeBound {
  double slope = 0.0;  ///< [N per travel unit]
  /// The slope is the largest between closely spaced travels, not a bound for every motion.
  bool isSampled = false;
};

/// Computes the force on the hand from the state of the tool.
class ForceModel {
 public:
  virtual ~ForceModel() = default;
  ForceModel() = default;
  ForceModel(const ForceModel&) = delete;
  ForceModel& operator=(const ForceModel&) = delete;

  /// Called once per tick, in order, so a model may have a state. Never allocates, waits or throws.
  virtual models::Response<double> respond(const ToolState& tool) noexcept = 0;

  /// Torque of the last response, about the tool's axis, right-handed about the direction of
  /// advance [N·m].
  virtual double torque() const noexcept { return 0.0; }

  /// Whether torque() can be other than 0.
  virtual bool hasTorque() const noexcept { return false; }

  /// Returns to the initial state. Must not be called between ticks that render the model.
  virtual void reset() noexcept = 0;

  /// The steepest slope of the model's force curves [N per travel unit].
  virtual double largestStiffness() const noexcept = 0;

  /// A bound K that holds for every motion: |ΔF| ≤ K |Δx|. std::nullopt if the model knows no such
  /// bound, as a filter or a curve with a jump; renderedSlope() then measures K.
  virtual std::optional<SlopeBound> slopeBound() const noexcept {
    return SlopeBound{.slope = largestStiffness()};
  }

  /// Whether the tool may move. A bone with removal first checks, over several ticks, that the tool
  /// is outside all its spheres.
  virtual bool isReady() const noexcept { return true; }

  /// Delay of the force, beyond the tick itself [ticks].
  virtual double delay() const noexcept { return 0.0; }
};

}  // namespace haptics::engine
