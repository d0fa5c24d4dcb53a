#pragma once

#include <string>

#include <QWidget>

#include "study/session/study.h"

namespace study::gui {

/// Asks for a file and writes a copy of the consent that the participant gave, as HTML or PDF.
/// Shows a message if that fails.
/// @param participant  the participant's code.
void saveConsentCopy(Study& study, const std::string& participant, QWidget* parent);

/// Writes the copy to @p path without asking: PDF if the name ends in .pdf, HTML otherwise.
/// @return  as noteCopy()
/// @throws UserError, storage::StorageError  with a message for the operator.
bool writeConsentCopy(Study& study, const std::string& participant, const std::string& path);

}  // namespace study::gui
