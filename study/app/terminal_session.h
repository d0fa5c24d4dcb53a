#pragma once

#include "study/session/session.h"

namespace study::app {

/// Runs a session in the terminal: texts and questions are printed, answers are read line by line.
/// An interrupted session of the same participant (or, without a code, of the same run mode) is
/// resumed before a new participant is enrolled. The devices are those of @p deviceFile, or of the
/// study's device file, or else simulated; the simulated hand cuts on request.
/// @param takeOver  the reason for taking the session over from a computer that is gone; empty: no
/// takeover.
/// @return the exit status: 0 if the session ended, 1 if the input ended before it.
int runInTerminal(
    Study& study,
    Enrolment enrolment,
    const std::string& deviceFile,
    const std::string& takeOver = {});

}  // namespace study::app
