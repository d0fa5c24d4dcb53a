#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/model/progress.h"
#include "study/session/study.h"

namespace study {

/// The results of checking everything that a study has stored.
struct Verification {
  /// One check, and what it found.
  struct Check {
    std::string what;                       ///< "the audit trail is unbroken"
    std::vector<std::string> problems;      ///< empty if the check passed
    std::vector<std::string> remarks = {};  ///< what the check could not examine, and why
  };

  std::vector<Check> checks;
  std::string head;  ///< number of events and hash of the audit trail: "812 events, 1a2b 3c4d …"

  /// Whether no check found a problem.
  bool isSound() const noexcept;
};

/// Facts about a study that are known from outside of its folder.
struct VerifyOptions {
  /// A head of the audit trail that was written down earlier, outside of the study; empty: none.
  /// Anyone who can write the study's folder can cut off the last events or recompute the trail.
  /// The station that signed the trail detects this; other computers need such a head.
  std::string notedHead = {};
  /// Path of a witness file, which holds heads that were signed earlier (storage::writeWitness());
  /// empty: none.
  std::string witness = {};
  /// The study is a backup: it may lack events that this station has noted since.
  bool isOlderCopy = false;
};

/// A remark, with what to do, if other accounts of the computer may enter the study's folder
/// (release 0.1 made such folders); empty if only its owner may, and a group that it is shared with
/// (docs/installing.md, "Several accounts").
std::string describeOtherAccess(const std::filesystem::path& folder);

/// Reads all files of a study, without changing them, and checks: the files and their references;
/// the audit trail; every answer against the trail; the hashes of names and protocols; every order
/// against the one drawn from the seed; every trace against its trial; tables and triggers against
/// those that the program makes; and the audit trail against all heads that this station signed.
/// The study is read in the state of one moment, even if other programs write meanwhile; it must
/// not be in a transaction.
/// @param progress  called before every check and every trace; an exception that it throws ends the
///     verification.
/// @throws UserError  if VerifyOptions::noted is not a head, or the witness file cannot be read.
/// @throws storage::StorageError  (Busy) if other programs write without a pause.
Verification verify(Study& study, const Progress& progress = {}, const VerifyOptions& options = {});

}  // namespace study
