#pragma once

#include "study/session/session.h"

namespace study::app {

/// Runs a session in the terminal: texts and questions are printed, answers are read line by line.
/// Goes on with an interrupted session of the same participant (or, without a code, of the same run
/// mode) before it enrols anybody. Devices are those of @p deviceFile, or of the study's own, or
/// else simulated: a simulated hand cuts when asked to.
/// @return the exit status: 0 when the session is over, 1 when the input ended before.
int runInTerminal(Study& study, Enrolment enrolment, const std::string& deviceFile);

}  // namespace study::app
