#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/model/progress.h"
#include "study/session/study.h"

namespace study {

/// The results of checking everything that a study has stored.
struct Verification {
  struct Check {
    std::string what;                       ///< "the audit trail is unbroken"
    std::vector<std::string> problems;      ///< empty if the check passed
    std::vector<std::string> remarks = {};  ///< what it could not look at, and why
  };

  std::vector<Check> checks;
  std::string head;  ///< of the audit trail: "812 events, 1a2b 3c4d …"

  bool isSound() const noexcept;
};

/// What is known of a study from elsewhere.
struct VerifyOptions {
  /// A head of the audit trail that was noted earlier, outside of the study; empty: none. Anyone
  /// who can write the study's folder can cut off its last events, or compute the trail again. On
  /// the station that signed it that is found; elsewhere by what was noted alone.
  std::string noted = {};
  /// A file of heads that were signed earlier (storage::writeWitness()); empty: none.
  std::string witness = {};
  /// The study is an older copy, a backup: what this station noted later may be missing.
  bool isOlderCopy = false;
};

/// That other accounts of the computer may enter the study's folder, and what to do; empty: only
/// its owner may. Folders that release 0.1 made are open to all.
std::string describeOtherAccess(const std::filesystem::path& folder);

/// Reads a study to its last byte and checks the files and their references, the audit trail, every
/// answer against it, the hashes of names and protocols, every order against the one drawn from the
/// seed, every trace against its trial, tables and triggers against those that the program makes,
/// and the audit trail against all that this station signed of it. Changes nothing. Sees the study
/// as it was at one moment, whatever others write meanwhile; the study must not be in a
/// transaction.
/// @param progress  called before every check and every trace; an exception that it throws ends the
///     verification.
/// @throws UserError  if the head that was noted is none, or the witness no file of heads.
/// @throws storage::StorageError  (Busy) if others write without any pause.
Verification verify(Study& study, const Progress& progress = {}, const VerifyOptions& options = {});

}  // namespace study
