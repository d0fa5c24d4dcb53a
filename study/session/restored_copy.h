#pragma once

#include <cstddef>
#include <string>

#include "study/session/study.h"

namespace study {

/// How many heads that this station signed a study neither has nor gave up: more than none of an
/// older copy that took its place, and of one whose end was cut off. @throws storage::StorageError
std::size_t headsMissingIn(Study& study);

/// Notes that an older copy, a backup, took the place of a study: what this station signed later is
/// given up, and verify() no longer takes it for an end that was cut off. Nothing is noted if
/// nothing is missing.
/// @return how many signed heads were given up
/// @throws storage::StorageError  if the station's list cannot be read, or the study not be written
std::size_t noteRestoredCopy(Study& study, const std::string& reason);

}  // namespace study
