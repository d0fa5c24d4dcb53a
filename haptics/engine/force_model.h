#pragma once

#include "haptics/engine/tool_state.h"
#include "haptics/models/response.h"

namespace haptics::engine {

/// What a hand may feel: a force for every state of the tool.
class ForceModel {
 public:
  virtual ~ForceModel() = default;
  ForceModel() = default;
  ForceModel(const ForceModel&) = delete;
  ForceModel& operator=(const ForceModel&) = delete;

  /// Called once a tick, in order: a model may remember. Never allocates, waits or throws.
  virtual models::Response<double> respond(const ToolState& tool) noexcept = 0;

  /// Forgets what has been felt. Not while it is felt.
  virtual void reset() noexcept = 0;

  /// The steepest slope that it can render [N per travel unit]: K of eq. (25) of the punch paper.
  virtual double largestStiffness() const noexcept = 0;

  /// How old the force is that it answers with, beyond the tick itself [ticks].
  virtual double delay() const noexcept { return 0.0; }
};

}  // namespace haptics::engine
