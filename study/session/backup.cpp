#include "study/session/backup.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/storage/study_schema.h"
#include "study/storage/transaction.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::Database;
using storage::StorageError;
using Access = Database::Access;

constexpr double kShareOfCopying = 0.6;  // of the time, taken roughly; the rest is reading it again

/// The three databases of a study as they were at one moment.
class Snapshot {
 public:
  explicit Snapshot(const StudyFiles& files)
      : databases_{
            Database::open(files.study(), storage::studySchema(), Access::ReadOnly),
            Database::open(files.traces(), storage::traceSchema(), Access::ReadOnly),
            Database::open(files.identity(), storage::identitySchema(), Access::ReadOnly)} {
    // Whatever is felt or answered ends with a commit to study.db: while nobody else may commit
    // there, the three belong together.
    auto writer = writerOf(files);
    std::optional<storage::Transaction> nobodyElse;
    if (writer) nobodyElse.emplace(*writer);
    for (auto& database : databases_) database.holdStill();
  }

  const std::array<Database, 3>& databases() const noexcept { return databases_; }

 private:
  /// Nothing where nobody may write any more: an archive, or a disk that is only read.
  static std::optional<Database> writerOf(const StudyFiles& files) {
    try {
      return Database::open(files.study(), storage::studySchema(), Access::ReadWrite);
    } catch (const StorageError& error) {
      if (error.kind() != StorageError::Kind::Other) throw;
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

/// Whether SQLite or the study itself makes this file anew where it is needed.
bool isMadeAnew(const std::string& name) {
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
      tell(
          progress,
          kShareOfCopying * (done + share * size) / std::max(all, 1.0),
          "copying " + from.filename().string());
    });
    std::error_code ignored;
    fs::permissions(copy, fs::status(from).permissions(), ignored);
    done += size;
  }
}

/// Exports, the device file, and whatever else somebody has put there.
void copyTheRest(const fs::path& from, const fs::path& to, const Progress& progress) {
  for (const auto& entry : fs::directory_iterator(from)) {
    const auto name = entry.path().filename().string();
    if (isMadeAnew(name)) continue;
    tell(progress, kShareOfCopying, "copying " + name);
    fs::copy(
        entry.path(), to / name, fs::copy_options::recursive | fs::copy_options::copy_symlinks);
  }
}

Verification verifyCopy(const fs::path& folder, const Progress& progress) {
  SystemClock clock;
  auto copy = Study::open(folder, clock, Access::ReadOnly);
  return verify(copy, [&](double share, const std::string& words) {
    tell(progress, kShareOfCopying + (1.0 - kShareOfCopying) * share, "reading the copy: " + words);
  });
}

/// What reading the copy left beside its databases.
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

/// As it is known without links and dots: "out/" means "out".
fs::path plain(const fs::path& folder) {
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

Backup copyInto(
    const fs::path& from,
    const fs::path& unfinished,
    const fs::path& target,
    const Progress& told) {
  {
    const Snapshot snapshot(StudyFiles{from});
    copyDatabases(snapshot, unfinished, told);
  }
  copyTheRest(from, unfinished, told);
  Backup backup;
  backup.verification = verifyCopy(unfinished, told);
  removeLogs(unfinished);
  backup.bytes = bytesIn(unfinished);
  fs::rename(unfinished, target);
  return backup;
}

}  // namespace

Backup backUp(const fs::path& folder, const fs::path& destination, const Progress& progress) {
  const auto from = plain(folder);
  const auto target = plain(destination);
  if (!fs::is_directory(from)) {
    throw StorageError("There is no study in " + folder.string() + ". Check the folder's name.");
  }
  refuseUnlessNew(from, target);
  const auto unfinished = newFolderBeside(target);
  try {
    // As open to others as the study itself, and no more: names of people lie in it.
    fs::permissions(unfinished, fs::status(from).permissions());
    return copyInto(from, unfinished, target, progress);
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

}  // namespace study
