#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/session/erasure.h"

namespace study {

/// A copy of the study's data that the program made.
struct KnownCopy {
  std::string folder;   ///< path when the copy was made; or path of a file
  std::string what;     ///< name of the event: "made_backup", "exported"
  std::string madeUtc;  ///< empty if it was found in the study's folder, without an event
  bool isThere = false;

  /// Whether a file has the content that was written. Another file may have taken its name since.
  enum class Content {
    AsWritten,
    Changed,
    Unknown,  ///< a folder, or a file of a release that noted no fingerprint
  };
  Content content = Content::Unknown;
};

/// Backups, exports and reports that the audit trail lists, and the content of the study's folder
/// `exports`. Copies that were moved are not found. Copies of consent forms are not listed in the
/// trail, because their file names may name people and the trail is never deleted.
std::vector<KnownCopy> knownCopies(Study& study);

/// The result of eraseFromCopy().
struct ErasedCopy {
  enum class Outcome {
    Erased,   ///< a backup: the participant was erased from it
    NotInIt,  ///< a backup without the participant, or already erased from
    Removed,  ///< an export or a report: it can be made again
    Failed,   ///< unchanged or partly erased; try again
  };
  std::string folder;
  Outcome outcome = Outcome::Erased;
  std::string whyNot;  ///< if it failed: the error
  std::vector<std::string> filesWithTexts;
};

/// The known copies that are not in @p done.
std::vector<KnownCopy> copiesLeft(Study& study, const std::vector<ErasedCopy>& done);

/// Erases a participant from a copy of the study, too: from a backup, or by removing an export or
/// the file of a report. Failures are reported in the result, because the study itself is already
/// erased from.
/// @param texts  are searched for in every byte of the copy afterwards
/// @param known  knownCopies() of the study. A single file does not name its study, so it is
///     removed only if it is one of these with unchanged content.
ErasedCopy eraseFromCopy(
    const std::filesystem::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known = {});

}  // namespace study
