#pragma once

#include <functional>
#include <string>

#include "study/session/study.h"

namespace study::report {

using TextToHtml = std::function<std::string(const std::string& text)>;

/// Plain text as HTML. Empty lines separate paragraphs.
std::string plainTextAsHtml(const std::string& text);

/// A copy of a person's consent for them to keep, as a page: the information and the terms in the
/// language that was shown, the answers and their time, and the versions of the texts. The field
/// for a signature is empty: names stay in identity.db.
/// @param participant  their code.
/// @param htmlOf  converts Markdown to HTML (asHtml() of marked_text.h in builds with Qt).
/// @throws UserError  if no session of that participant has a completed consent form.
std::string consentCopy(
    Study& study, const std::string& participant, const TextToHtml& htmlOf = plainTextAsHtml);

}  // namespace study::report
