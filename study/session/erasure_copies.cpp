#include "study/session/erasure_copies.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "base/file.h"
#include "study/model/study_files.h"
#include "study/model/user_error.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;

constexpr std::array kSayWhose{"codebook.json", "study.json", "dataset_description.json"};

/// Whether a folder is an export of the study: its codebook, its document or its data set's
/// description says so.
bool isExportOf(const fs::path& folder, const std::string& uuid) {
  for (const char* name : kSayWhose) {
    std::ifstream stream(folder / name, std::ios::binary);
    const auto text = base::readAll(stream);
    if (text.find('"' + uuid + '"') != std::string::npos) return true;
  }
  return false;
}

/// What says whose the export is goes last: if this is interrupted, it can be done again.
void removeExport(const fs::path& folder) {
  const std::vector<fs::directory_entry> entries{fs::directory_iterator(folder), {}};
  for (const auto& entry : entries) {
    const auto name = entry.path().filename();
    if (std::find(kSayWhose.begin(), kSayWhose.end(), name) == kSayWhose.end()) {
      fs::remove_all(entry.path());
    }
  }
  fs::remove_all(folder);
}

/// @throws UserError  if it is another study
bool isToBeErasedFrom(const fs::path& folder, const storage::ListedErasure& erasure) {
  using storage::Database;
  auto database = Database::open(
      StudyFiles{folder}.study(), storage::studySchema(), Database::Access::ReadWrite);
  storage::Statement select(database, "SELECT uuid FROM study");
  if (!select.step() || select.text(0) != erasure.study) {
    throw UserError("It is another study. Nothing was changed in it.");
  }
  return !storage::missingErasures(database, {erasure}).empty();
}

/// @throws UserError  if the study's audit trail does not know the file
void removeFile(const fs::path& file, const std::vector<KnownCopy>& known) {
  const bool isKnown = std::any_of(known.begin(), known.end(), [&](const KnownCopy& copy) {
    std::error_code ignored;
    return fs::equivalent(copy.folder, file, ignored);
  });
  if (!isKnown) {
    throw UserError(
        "It is a file that this study did not write, or that was moved since: a file does not say "
        "whose it is. Delete it yourself.");
  }
  fs::remove(fs::canonical(file));  // not only a link to it
}

/// @throws UserError  if it is no copy of the study
ErasedCopy eraseFrom(
    const fs::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known) {
  ErasedCopy copy{.folder = folder.string()};
  if (fs::is_regular_file(folder)) {
    removeFile(folder, known);
    copy.outcome = ErasedCopy::Outcome::Removed;
    return copy;
  }
  if (!fs::exists(StudyFiles{folder}.study())) {
    // An empty folder is one whose removal was interrupted last.
    if (!fs::is_empty(folder) && !isExportOf(folder, erasure.study)) {
      throw UserError(
          "It is neither a backup nor an export of this study. Public exports do not say whose "
          "they are: delete them yourself.");
    }
    removeExport(folder);
    copy.outcome = ErasedCopy::Outcome::Removed;
    return copy;
  }
  if (isToBeErasedFrom(folder, erasure)) {
    auto study = Study::open(folder, clock);  // erases what this station has listed
    for (const auto& open : storage::missingErasures(study.database(), {erasure}))
      eraseAgain(study, open);
  } else {
    copy.outcome = ErasedCopy::Outcome::NotInIt;
  }
  copy.filesWithTexts = texts.filesIn(folder, {});
  return copy;
}

}  // namespace

std::vector<KnownCopy> knownCopies(Study& study) {
  std::vector<KnownCopy> copies;
  std::error_code ignored;
  for (const auto& event : study.events().read()) {
    const auto* value = event.visit ? nullptr : event.value("folder");
    const auto* folder = value == nullptr ? nullptr : std::get_if<std::string>(value);
    if (folder == nullptr) continue;
    copies.push_back(
        {.folder = *folder,
         .what = std::string(event.name()),
         .madeUtc = asUtc(event.when.wall),
         .isThere = fs::exists(*folder, ignored)});
  }
  const auto exports = study.folder() / "exports";
  if (!fs::is_directory(exports, ignored)) return copies;
  for (const auto& entry : fs::directory_iterator(exports)) {
    const bool isKnown = std::any_of(copies.begin(), copies.end(), [&](const auto& copy) {
      return fs::equivalent(copy.folder, entry.path(), ignored);
    });
    if (isKnown) continue;
    copies.push_back(
        {.folder = entry.path().string(), .what = "exported", .madeUtc = {}, .isThere = true});
  }
  return copies;
}

std::vector<KnownCopy> copiesLeft(Study& study, const std::vector<ErasedCopy>& done) {
  auto known = knownCopies(study);
  std::erase_if(known, [&](const KnownCopy& copy) {
    return std::any_of(done.begin(), done.end(), [&](const ErasedCopy& other) {
      std::error_code ignored;
      return copy.folder == other.folder || fs::equivalent(copy.folder, other.folder, ignored);
    });
  });
  return known;
}

ErasedCopy eraseFromCopy(
    const fs::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known) {
  try {
    return eraseFrom(folder, erasure, texts, clock, known);
  } catch (const std::runtime_error& error) {
    return {
        .folder = folder.string(), .outcome = ErasedCopy::Outcome::Failed, .whyNot = error.what()};
  }
}

}  // namespace study
