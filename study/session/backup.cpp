#include "study/session/backup.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include "base/joined.h"
#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/session/unblinding.h"
#include "study/storage/evidence/head_check.h"
#include "study/storage/lease.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::StorageError;
using Access = Database::Access;

constexpr double kShareOfCopying = 0.6;  // estimated share of the time; verifying takes the rest

/// Connections to the three databases of a study, each in a read snapshot of one common moment.
class Snapshot {
 public:
  explicit Snapshot(const StudyFiles& files)
      : databases_{
            Database::open(files.study(), storage::studySchema(), Access::ReadOnly),
            Database::open(files.traces(), storage::traceSchema(), Access::ReadOnly),
            Database::open(files.identity(), storage::identitySchema(), Access::ReadOnly)} {
    // Recording and answering both end with a commit to study.db. While this transaction holds the
    // write lock, no such commit is possible, so the three read snapshots belong together. They
    // stay unchanged after the lock is released.
    auto writer = openForWriting(files);
    std::optional<storage::Transaction> writeLock;
    if (writer) writeLock.emplace(*writer);
    for (auto& database : databases_) database.beginSnapshot();
  }

  const std::array<Database, 3>& databases() const noexcept { return databases_; }

 private:
  /// std::nullopt if the study cannot be written at all: an archive, a read-only or a full disk.
  static std::optional<Database> openForWriting(const StudyFiles& files) {
    try {
      return Database::open(files.study(), storage::studySchema(), Access::ReadWrite);
    } catch (const StorageError& error) {
      using Kind = StorageError::Kind;
      if (error.kind() != Kind::Other && error.kind() != Kind::DiskFull) throw;
      return std::nullopt;
    }
  }

  std::array<Database, 3> databases_;
};

std::uintmax_t sizeOf(const fs::path& file) {
  std::error_code ignored;
  const auto size = fs::file_size(file, ignored);
  return ignored ? 0 : size;
}

/// Whether the file is a database, or a file that SQLite or the study creates again when needed.
bool isDatabaseOrRecreated(const std::string& name) {
  if (name == "ballast") return true;
  const auto stem = name.substr(0, name.find(".db"));
  const auto rest = name.substr(stem.size());
  const bool isOurs = stem == "study" || stem == "traces" || stem == "identity";
  return isOurs &&
         (rest == ".db" || rest == ".db-wal" || rest == ".db-shm" || rest == ".db-journal");
}

void copyDatabases(const Snapshot& snapshot, const fs::path& to, const Progress& progress) {
  double all = 0.0;
  for (const auto& each : snapshot.databases()) all += static_cast<double>(sizeOf(each.path()));
  double done = 0.0;
  for (const auto& database : snapshot.databases()) {
    const fs::path from = database.path();
    const auto size = static_cast<double>(sizeOf(from));
    const auto copy = to / from.filename();
    database.copyTo(copy.string(), [&](double share) {
      announceProgress(
          progress,
          kShareOfCopying * (done + share * size) / std::max(all, 1.0),
          "copying " + from.filename().string());
    });
    std::error_code ignored;
    fs::permissions(copy, fs::perms::owner_read | fs::perms::owner_write, ignored);
    done += size;
  }
}

/// Copies exports, the device file and all other files in the folder.
void copyOtherFiles(const fs::path& from, const fs::path& to, const Progress& progress) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const auto name = entry.path().filename().string();
    if (isDatabaseOrRecreated(name)) continue;
    announceProgress(progress, kShareOfCopying, "copying " + name);
    fs::copy(
        entry.path(), to / name, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  }
}

Verification verifyCopy(const fs::path& folder, const Progress& progress) {
  auto copy = Study::open(folder, Access::ReadOnly);
  const auto progressCallback = [&](double share, const std::string& words) {
    announceProgress(
        progress, kShareOfCopying + (1.0 - kShareOfCopying) * share, "reading the copy: " + words);
  };
  return verify(copy, progressCallback, {.isOlderCopy = true});  // sessions may have ended while
                                                                 // the study was copied
}

/// Removes the log files that SQLite left beside the copy's databases when they were read.
void removeLogs(const fs::path& folder) {
  const StudyFiles files{folder};
  std::error_code ignored;
  for (const auto& file : {files.study(), files.traces(), files.identity()}) {
    fs::remove(file + "-wal", ignored);
    fs::remove(file + "-shm", ignored);
  }
}

std::uintmax_t bytesIn(const fs::path& folder) {
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) bytes += entry.file_size();
  }
  return bytes;
}

/// The path without links, dots and trailing slash: "out/" becomes "out".
fs::path normalised(const fs::path& folder) {
  fs::path path = fs::weakly_canonical(fs::absolute(folder));
  return path.has_filename() ? path : path.parent_path();
}

void refuseUnlessNew(const fs::path& from, const fs::path& target) {
  if (fs::exists(target)) {
    throw StorageError(
        target.string() + " is there already. Nothing is ever overwritten: choose another folder.");
  }
  const auto [end, ignored] = std::mismatch(from.begin(), from.end(), target.begin(), target.end());
  if (end == from.end()) {
    throw StorageError(
        "A copy inside " + from.string() +
        " would be lost with it. Choose a folder outside of the study, best on another disk.");
  }
}

/// Removes the leases from the copy, because it may be used on another computer, where no program
/// would end them.
void clearLeases(const fs::path& copy) {
  const auto file = StudyFiles{copy}.study();
  {
    const auto study = Database::open(file, storage::studySchema(), Access::ReadOnly);
    storage::Statement held(study, "SELECT 1 FROM lease");
    if (!held.step()) return;
  }
  auto study = Database::open(file, storage::studySchema(), Access::ReadWrite);
  storage::Lease::clear(study);
}

/// Notes the backup in the study's audit trail before copying, so that the copy has this event,
/// too. A study that cannot be written is copied without the event. @return  whether it is noted
bool noteBackup(const fs::path& from, const fs::path& target) {
  try {
    auto study = Study::open(from);
    return noteCopy(
        study,
        {.actor = storage::Actor::Operator,
         .kind = EventKind::MadeBackup,
         .values = {{"folder", pathForAuditTrail(target)}}});
  } catch (const StorageError& error) {
    if (error.kind() == StorageError::Kind::Busy) throw;
    return false;
  }
}

Backup copyInto(
    const fs::path& from,
    const fs::path& unfinished,
    const fs::path& target,
    const Progress& progressCallback) {
  {
    const Snapshot snapshot(StudyFiles{from});
    copyDatabases(snapshot, unfinished, progressCallback);
  }
  clearLeases(unfinished);
  copyOtherFiles(from, unfinished, progressCallback);
  Backup backup;
  backup.verification = verifyCopy(unfinished, progressCallback);
  removeLogs(unfinished);
  backup.bytes = bytesIn(unfinished);
  // Rename last, so that the target appears only when the copy is complete and verified.
  moveIntoPlace(unfinished, target);
  return backup;
}

}  // namespace

Backup backUp(const fs::path& folder, const fs::path& destination, const Progress& progress) {
  const auto from = normalised(folder);
  const auto target = normalised(destination);
  if (!fs::is_directory(from)) {
    throw StorageError("There is no study in " + folder.string() + ". Check the folder's name.");
  }
  refuseUnlessNew(from, target);
  const auto unfinished = makeFolderBeside(target);
  try {
    const bool isNoted = noteBackup(from, target);
    // The copy holds names of people. Only its owner may read it, even if an older release made the
    // study's folder readable for everyone.
    fs::permissions(unfinished, fs::perms::owner_all);
    auto backup = copyInto(from, unfinished, target, progress);
    backup.isNoted = isNoted;
    return backup;
  } catch (const fs::filesystem_error& error) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw StorageError(
        "Could not copy to " + target.string() + " (" + error.code().message() +
        "). Check the room on that disk, and who may write there.");
  } catch (...) {
    std::error_code ignored;
    fs::remove_all(unfinished, ignored);
    throw;
  }
}

std::size_t headsMissingIn(Study& study) {
  const auto station = storage::StationStore::find(storage::StationStore::defaultFolder());
  if (!station) return 0;
  const auto listed = readRecordedHeads(*station, study.uuid());
  return missingHeads(storage::TrailHeads(study.database()), listed).size();
}

std::size_t recordRestoredCopy(Study& study, const std::string& reason) {
  const auto station = storage::StationStore::find(storage::StationStore::defaultFolder());
  if (!station) return 0;
  const auto listed = readRecordedHeads(*station, study.uuid());
  const auto missing = missingHeads(storage::TrailHeads(study.database()), listed);
  if (missing.empty()) return 0;
  const auto names = base::joined(missing, " ", [](const auto& head) { return nameOf(head); });
  study.note(
      {.actor = storage::Actor::Operator,
       .kind = EventKind::RestoredCopy,
       .values = {{"reason", reason}, {"given_up", names}}});
  return missing.size();
}

}  // namespace study
