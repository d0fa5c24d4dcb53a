#pragma once

#include <QWidget>

#include "protocols/model/loaded_protocol.h"
#include "study/session/session.h"

namespace study::gui {

/// Whether a participant may be enrolled although a text that they would read still has a blank in
/// double square brackets: never for a live session, which is refused with a list of the blanks;
/// for a pilot if the operator says so.
bool confirmTexts(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment, QWidget* parent);

/// Whether a participant may be enrolled although this computer has seen later events of the study,
/// as in a backup: for a live session, if the operator says so.
bool confirmNewestCopy(Study& study, const Enrolment& enrolment, QWidget* parent);

}  // namespace study::gui
