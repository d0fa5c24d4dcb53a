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
    std::vector<std::string> remarks = {};  ///< what it could not check, and why
  };

  std::vector<Check> checks;
  std::string head;  ///< of the audit trail: "812 events, 1a2b 3c4d …"

  bool isSound() const noexcept;
};

/// Knowledge about a study from outside of its folder.
struct VerifyOptions {
  /// A head of the audit trail that was noted earlier, outside of the study; empty: none. Anyone
  /// who can write the study's folder can cut off its last events or recompute the trail. The
  /// station that signed it detects that; other computers detect it only by a head that was noted.
  std::string noted = {};
  /// Path of a witness file, of heads that were signed earlier (storage::writeWitness()); empty:
  /// none.
  std::string witness = {};
  /// The study is an older copy, a backup: what this station noted later may be missing.
  bool isOlderCopy = false;
};

/// A remark if other accounts of the computer may enter the study's folder (release 0.1 made such
/// folders), with what to do; empty: only its owner may.
std::string describeOtherAccess(const std::filesystem::path& folder);

/// Reads a study to its last byte and checks the files and their references, the audit trail, every
/// answer against it, the hashes of names and protocols, every order against the one drawn from the
/// seed, every trace against its trial, tables and triggers against those that the program makes,
/// and the audit trail against all heads that this station signed. Changes nothing. Sees the study
/// in the state of one moment, even if other programs write meanwhile; the study must not be in a
/// transaction.
/// @param progress  called before every check and every trace; an exception that it throws ends the
///     verification.
/// @throws UserError  if VerifyOptions::noted is not a head, or the witness file cannot be read.
/// @throws storage::StorageError  (Busy) if others write without any pause.
Verification verify(Study& study, const Progress& progress = {}, const VerifyOptions& options = {});

}  // namespace study
