#pragma once

#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/findings_dialog.h"
#include "study/session/session.h"

namespace study::gui {

/// What is not fit about the texts that somebody would read who is enrolled now: of a live
/// participant whatever still stands in double square brackets. Nothing where all is well, and for
/// those who do not count.
std::vector<FindingsDialog::Found> textsBefore(
    const protocols::LoadedProtocol& protocol, const Enrolment& enrolment);

}  // namespace study::gui
