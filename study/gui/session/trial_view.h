#pragma once

#include <QLabel>

#include "protocols/model/protocol.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

/// The place of the simulation of the trial that the session stands before; what draws comes into
/// it a moment later and follows the trial, whose frames are kept with it. Nothing, and nothing of
/// it is made, where the trial is felt without being seen. The controller outlives it.
QWidget* viewOfTrial(SessionController& controller, QWidget* parent);

/// For the operator, how the present trial is seen: " · 29.9 pictures a second, 18 ms old"; nothing
/// where it is not.
QString viewInWords(const SessionController& controller);

/// Whether anything in @p protocol is seen.
bool isAnythingSeen(const protocols::Protocol& protocol);

/// For the operator, what there is to say about who draws: a sentence, and on hovering what to do
/// about it; nothing where a graphics card draws, or @p protocol shows nothing.
QLabel* graphicsRemark(const protocols::Protocol& protocol, QWidget* parent);

}  // namespace study::gui
