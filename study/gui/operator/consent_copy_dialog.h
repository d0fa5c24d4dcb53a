#pragma once

#include <string>

#include <QWidget>

#include "study/session/study.h"

namespace study::gui {

/// Asks where to, and writes a copy of what somebody agreed to, as a page or a PDF; says why where
/// that does not work. @param participant  their code.
void saveConsentCopy(Study& study, const std::string& participant, QWidget* parent);

/// The same without asking. @throws UserError, storage::StorageError  in words.
void writeConsentCopy(Study& study, const std::string& participant, const std::string& path);

}  // namespace study::gui
