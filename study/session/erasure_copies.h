#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/session/erasure.h"

namespace study {

/// A copy of the study's data that the program made.
struct KnownCopy {
  /// Path at the time of copying, of a file or a folder; empty for a copy of a consent form.
  std::string folder;
  std::string what;     ///< name of the kind of event: "made_backup", "exported"
  std::string madeUtc;  ///< empty if the copy was found in the study's folder, without an event
  bool isPresent = false;

  /// Whether a file still has the content that the program wrote.
  enum class Content {
    AsWritten,
    Changed,
    Unknown,  ///< not known for folders, and for files of a release that noted no fingerprint
  };
  Content content = Content::Unknown;
  /// Name of the run mode of the sessions in an export or a report; empty for backups and exports
  /// without an event, "all" for all. They have the data of no session of another run mode.
  std::string runMode = {};
  std::string participant = {};  ///< the only one in an export; empty: all
};

/// Backups, exports and reports that the audit trail lists, the folders that programs left beside
/// them when they were killed while copying, and the content of the folder `exports` in the study's
/// folder. Not the study's folder itself, which may be a restored backup. Copies that were moved
/// are not found.
std::vector<KnownCopy> knownCopies(Study& study);

/// The result of eraseFromCopy().
struct ErasedCopy {
  enum class Outcome {
    Erased,     ///< a backup: the participant was erased from it
    NotInCopy,  ///< a backup without the participant's data
    Removed,    ///< an export or a report was deleted; the program can make it again
    Failed,     ///< the copy is unchanged or partly erased; the erasure can be repeated
  };
  std::string folder;
  Outcome outcome = Outcome::Erased;
  std::string whyNot;  ///< Failed: the error
  std::vector<std::string> filesWithTexts;
};

/// The known copies that may have data of @p participant and are not in @p done, which also has
/// those where an erasure failed, and the copies of the consent form (recordConsentCopy()).
std::vector<KnownCopy> copiesNotErased(
    Study& study, const std::vector<ErasedCopy>& done, const std::string& participant);

/// Erases a participant from a copy of the study: from a backup, or by deleting an export or the
/// file of a report. Failures are reported in the result and not thrown, because the participant is
/// already erased from the study.
/// @param texts  all files of the copy are searched for these texts afterwards
/// @param known  knownCopies() of the study. A single file does not name its study, so it is
///     deleted only if it is in this list with unchanged content.
ErasedCopy eraseFromCopy(
    const std::filesystem::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known = {});

}  // namespace study
