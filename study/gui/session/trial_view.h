#pragma once

#include "protocols/model/protocol.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

/// A widget for the simulation of the current trial. The renderer is created a moment later,
/// follows the trial, and its frame statistics are saved with the trial. The controller must
/// outlive the widget.
/// @return nullptr, with nothing created, if the trial is not visualised.
QWidget* viewOfTrial(SessionController& controller, QWidget* parent);

/// The frame rate and latency of the current trial for the operator: " · 29.9 pictures a second, 18
/// ms old". Empty if the trial is not visualised.
QString viewInWords(const SessionController& controller);

/// Whether any trial of @p protocol is visualised.
bool isAnyTrialVisualised(const protocols::Protocol& protocol);

}  // namespace study::gui
