#pragma once

#include <string>

#include "study/session/study.h"

namespace study::report {

/// A copy of a person's consent for them to keep, as a page: the information and the terms in the
/// language that was shown, the answers and their time, and the versions of the texts. The field
/// for a signature is empty: names stay in identity.db.
/// @param participant  their code.
/// @throws UserError  if no participant of that code has completed a consent form.
std::string consentCopy(Study& study, const std::string& participant);

}  // namespace study::report
