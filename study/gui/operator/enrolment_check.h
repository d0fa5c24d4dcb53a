#pragma once

#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/findings_dialog.h"
#include "study/session/session.h"

namespace study::gui {

/// Findings about the texts that a newly enrolled participant would read. For a live session each
/// placeholder that is still in double square brackets fails. Empty if there are none, and in other
/// run modes.
std::vector<FindingsDialog::Found> checkTexts(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment);

}  // namespace study::gui
