#pragma once

#include <string>

#include "study/session/study.h"

namespace study::report {

/// What somebody agreed to, as a page for them to keep: the information and the terms as they stood
/// in the language that they read, what they chose and when, and the versions of the texts. The
/// place for a signature is empty: names stay in identity.db.
/// @param participant  their code.
/// @throws UserError  if nobody of that code has come to the end of a consent form.
std::string consentCopy(Study& study, const std::string& participant);

}  // namespace study::report
