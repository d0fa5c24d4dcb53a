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
  std::string head;  ///< of the audit trail: "812 events, 1a2b 3c4d …"

  bool isSound() const noexcept;
};

/// Reads a study to its last byte and checks the files and their references, the audit trail, every
/// answer against it, the hashes of names and protocols, every order against the one drawn from the
/// seed, and every trace against its trial. Changes nothing. Sees the study as it was at one
/// moment, whatever others write meanwhile; the study must not be in a transaction.
/// @param progress  called before every check and every trace; an exception that it throws ends the
///     verification.
/// @param noted  a head of the audit trail that was noted earlier, outside of the study; empty:
/// none.
///     Anyone who can write the study's folder can cut off its last events, or compute the trail
///     again; that shows in this check alone.
/// @throws UserError  if @p noted is no head.
/// @throws storage::StorageError  (Busy) if others write without any pause.
Verification verify(Study& study, const Progress& progress = {}, const std::string& noted = {});

}  // namespace study
