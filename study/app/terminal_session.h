#pragma once

#include "study/session/session.h"

namespace study::app {

/// Runs a session in the terminal: prints texts and questions and reads answers line by line. An
/// unfinished session of the same run mode (with a code, of that participant) is resumed before a
/// new participant is enrolled. Uses the devices of @p deviceFile, or of the study's device file,
/// or else simulated ones, whose hand cuts on request.
/// @param takeOver  the reason for taking the session over from another computer; empty: no
///     takeover.
/// @return the exit status: 0 if the session ended, 1 if the input ended earlier or no participant
///     could be enrolled because of blanks in the texts.
int runInTerminal(
    Study& study,
    Enrolment enrolment,
    const std::string& deviceFile,
    const std::string& takeOver = {});

}  // namespace study::app
