#pragma once

#include <string>
#include <vector>

#include "study/model/progress.h"
#include "study/session/study.h"

namespace study {

/// The results of checking everything that a study has stored.
struct Verification {
  struct Check {
    std::string what;                   ///< "the audit trail is unbroken"
    std::vector<std::string> problems;  ///< empty if the check passed
  };

  std::vector<Check> checks;

  bool isSound() const noexcept;
};

/// Reads a study to its last byte and checks the files and their references, the audit trail, every
/// answer against it, the hashes of names and protocols, every order against the one drawn from the
/// seed, and every trace against its trial. Changes nothing. Sees the study as it was at one moment,
/// whatever others write meanwhile; the study must not be in a transaction.
/// @param progress  called before every check and every trace; an exception that it throws ends the
///     verification.
/// @throws storage::StorageError  (Busy) if others write without any pause.
Verification verify(Study& study, const Progress& progress = {});

}  // namespace study
