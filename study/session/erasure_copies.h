#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/session/erasure.h"

namespace study {

/// A copy of the study's data that the program made.
struct KnownCopy {
  std::string folder;   ///< as it was named then
  std::string what;     ///< "made_backup", "exported": the event
  std::string madeUtc;  ///< empty if it is found in the study's folder
  bool isThere = false;

  /// Of a file: whether it is still the one that was written. Until then another one may have been
  /// put under its name.
  enum class Content {
    AsWritten,
    Changed,
    Unknown,  ///< a folder; or a release that noted no fingerprint wrote it
  };
  Content content = Content::Unknown;
};

/// Backups, exports and reports that the audit trail knows, and what lies in the study's `exports`.
/// A copy that was moved is not found. Consent copies are not known: the names of their files
/// may name people, and the trail keeps them for good.
std::vector<KnownCopy> knownCopies(Study& study);

/// What was done with a copy.
struct ErasedCopy {
  enum class Outcome {
    Erased,   ///< a backup: the participant was erased from it
    NotInIt,  ///< a backup from before the participant came, or erased already
    Removed,  ///< an export or a report: it can be made again
    Failed,   ///< it is as it was, or partly erased: to be tried again
  };
  std::string folder;
  Outcome outcome = Outcome::Erased;
  std::string whyNot;  ///< it failed
  std::vector<std::string> filesWithTexts;
};

/// The known copies that nothing was done with.
std::vector<KnownCopy> copiesLeft(Study& study, const std::vector<ErasedCopy>& done);

/// Erases a participant from a copy of the study, too: from a backup, or by removing an export or
/// the file of a report.
/// @param texts  are searched for in every byte of the copy afterwards
/// @param known  of the study: a single file does not say whose it is, and is removed only if it is
///     among them, as it was written
/// What fails is told in the result: the study itself is erased from already.
ErasedCopy eraseFromCopy(
    const std::filesystem::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known = {});

}  // namespace study
