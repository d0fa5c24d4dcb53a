#pragma once

#include <string>

#include "study/export/export.h"
#include "study/session/study.h"

namespace study::app {

/// A page in English with all that the study stores about the participant of @p options, for them
/// to keep: names, sessions, answers with the questions' words, the trail's events about them, and
/// known copies. It lists what depends on the rendering only if @p options are not blinded.
std::string personPage(Study& study, const ExportOptions& options);

}  // namespace study::app
