#pragma once

#include <optional>

#include "haptics/models/response.h"

namespace haptics::engine {

/// Where the tool is along its device's axis, and how fast it goes. The unit of travel is the
/// device's: travel units for the punch (0 open, 10 closed), metres for the reamer.
struct ToolState {
  double travel = 0.0;     ///< [device's travel unit]
  double velocity = 0.0;   ///< [device's travel unit / s]
  double dt = 0.001;       ///< since the tick before [s], > 0
  bool isReamerOn = true;  ///< otherwise it stands still, and removes nothing
};

/// The force on the hand for every state of the tool.
class ForceModel {
 public:
  virtual ~ForceModel() = default;
  ForceModel() = default;
  ForceModel(const ForceModel&) = delete;
  ForceModel& operator=(const ForceModel&) = delete;

  /// Called once a tick, in order: a model may remember. Never allocates, waits or throws.
  virtual models::Response<double> respond(const ToolState& tool) noexcept = 0;

  /// Of the last answer, about the tool's axis, right-handed about the way of advancing [N·m].
  virtual double torque() const noexcept { return 0.0; }

  /// Whether it may answer with a torque other than 0.
  virtual bool hasTorque() const noexcept { return false; }

  /// Forgets what has been felt. Not while it is felt.
  virtual void reset() noexcept = 0;

  /// The steepest slope of the curves that it is made of [N per travel unit].
  virtual double largestStiffness() const noexcept = 0;

  /// An upper bound K of the stiffness that is rendered, for every motion: |ΔF| ≤ K |Δx|.
  /// std::nullopt where there is no proof, as for a filter: renderedSlope() then measures it.
  virtual std::optional<double> slopeBound() const noexcept { return largestStiffness(); }

  /// Whether the tool may move. A bone that is reamed first checks, over several ticks, that the
  /// tool is outside all its spheres.
  virtual bool isReady() const noexcept { return true; }

  /// How old the force is that it answers with, beyond the tick itself [ticks].
  virtual double delay() const noexcept { return 0.0; }
};

}  // namespace haptics::engine
