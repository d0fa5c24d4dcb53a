#pragma once

#include "study/session/session.h"

namespace study::app {

/// Runs a session in the terminal: texts and questions are printed, answers are read line by line.
/// An interrupted session of the same participant (or, without a code, of the same run mode) is
/// resumed before a new participant is enrolled. The devices are those of @p deviceFile, or of the
/// study's device file, or else simulated with a hand that cuts when asked to.
/// @param takeOver  why a session is taken from a computer that is gone; empty: it is not.
/// @return the exit status: 0 when the session is over, 1 when the input ended before.
int runInTerminal(
    Study& study,
    Enrolment enrolment,
    const std::string& deviceFile,
    const std::string& takeOver = {});

}  // namespace study::app
