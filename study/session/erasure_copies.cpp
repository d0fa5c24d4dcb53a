#include "study/session/erasure_copies.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/file.h"
#include "study/model/new_file.h"
#include "study/model/study_files.h"
#include "study/model/user_error.h"
#include "study/session/unblinding.h"
#include "study/storage/statement.h"
#include "study/storage/stored_values.h"
#include "study/storage/study_schema.h"

namespace study {
namespace {

namespace fs = std::filesystem;

constexpr std::array kFilesNamingStudy{"codebook.json", "study.json", "dataset_description.json"};

/// Whether a folder is an export of the study: whether its codebook, document or data set
/// description contains the study's uuid.
bool isExportOf(const fs::path& folder, const std::string& uuid) {
  for (const char* name : kFilesNamingStudy) {
    const auto text = base::readFile(folder / name).value_or("");
    if (text.find('"' + uuid + '"') != std::string::npos) return true;
  }
  return false;
}

/// Deletes an export, and last the files that name the study, so that an interrupted deletion can
/// be repeated.
void removeExport(const fs::path& folder) {
  const std::vector<fs::directory_entry> entries{fs::directory_iterator(folder), {}};
  for (const auto& entry : entries) {
    const auto name = entry.path().filename();
    if (std::ranges::find(kFilesNamingStudy, name) == kFilesNamingStudy.end()) {
      fs::remove_all(entry.path());
    }
  }
  fs::remove_all(folder);
}

/// Whether the erasure must be repeated in this backup.
/// @throws UserError  if the folder is another study
bool isToBeErasedFrom(const fs::path& folder, const storage::ListedErasure& erasure) {
  using storage::Database;
  auto database = Database::open(
      StudyFiles{folder}.study(), storage::studySchema(), Database::Access::ReadWrite);
  storage::Statement select(database, "SELECT uuid FROM study");
  if (!select.step() || select.text(0) != erasure.study) {
    throw UserError("It is another study. Nothing was changed in it.");
  }
  return !storage::erasuresToRepeat(database, {erasure}).empty();
}

/// @throws UserError  if the study's audit trail does not prove that the study wrote the file
void requireOwnFile(const fs::path& file, const std::vector<KnownCopy>& known) {
  using Content = KnownCopy::Content;
  std::optional<Content> found;  // the same path may have been written several times
  for (const auto& copy : known) {
    std::error_code ignored;
    if (!fs::equivalent(copy.folder, file, ignored)) continue;
    if (copy.content == Content::AsWritten) return;
    if (found != Content::Changed) found = copy.content;
  }
  if (!found) {
    throw UserError(
        "It is a file that this study did not write, or that was moved since: a file does not say "
        "whose it is. Delete it yourself.");
  }
  if (*found == Content::Changed) {
    throw UserError(
        "This study wrote a report under this name, and the file that is there now has another "
        "content. It was kept. Look what it is, and delete it yourself if it shows participants' "
        "data.");
  }
  throw UserError(
      "An older release wrote a report under this name and did not note its content, so that "
      "another file may be there now. It was kept. Look whether it is the report, and delete it "
      "yourself.");
}

/// @throws UserError  if the trail does not prove that the study wrote the file
void removeFile(const fs::path& file, const std::vector<KnownCopy>& known) {
  requireOwnFile(file, known);
  fs::remove(fs::canonical(file));  // deletes the target if the path is a symbolic link
}

/// @throws UserError  if the folder is no copy of the study
ErasedCopy eraseFrom(
    const fs::path& folder,
    const storage::ListedErasure& erasure,
    const storage::ByteSearch& texts,
    Clock& clock,
    const std::vector<KnownCopy>& known) {
  ErasedCopy copy{.folder = folder.string()};
  if (!fs::exists(folder)) throw UserError("There is no file or folder of this name.");
  if (fs::is_regular_file(folder)) {
    removeFile(folder, known);
    copy.outcome = ErasedCopy::Outcome::Removed;
    return copy;
  }
  if (!fs::exists(StudyFiles{folder}.study())) {
    // A deletion that was interrupted at its end leaves an empty folder.
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
    auto study = Study::open(folder, clock);  // opening repeats the erasures of this station's list
    for (const auto& open : storage::erasuresToRepeat(study.database(), {erasure}))
      repeatErasure(study, open);
  } else {
    copy.outcome = ErasedCopy::Outcome::NotInCopy;
  }
  copy.filesWithTexts = texts.filesIn(folder, {});
  return copy;
}

/// A text value of an event without a session; empty if the event has no such value.
std::string textIn(const storage::Event& event, std::string_view name) {
  return event.visit ? std::string() : storage::storedText(event.values, name);
}

KnownCopy::Content contentOf(Study& study, const fs::path& file, const std::string& fingerprint) {
  std::error_code ignored;
  if (fingerprint.empty() || !fs::is_regular_file(file, ignored)) {
    return KnownCopy::Content::Unknown;
  }
  const auto content = base::readFile(file).value_or("");
  return fingerprintOf(study, content) == fingerprint ? KnownCopy::Content::AsWritten
                                                      : KnownCopy::Content::Changed;
}

/// Whether both are the same file or folder, also if it was deleted.
bool isSamePath(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return fs::equivalent(a, b, ignored) ||
         fs::absolute(a, ignored).lexically_normal() == fs::absolute(b, ignored).lexically_normal();
}

/// The folders that programs left beside @p copy because they were killed before it was complete.
std::vector<fs::path> unfinishedFoldersOf(const fs::path& copy) {
  std::vector<fs::path> folders;
  std::error_code error;
  const auto begin = copy.filename().string() + kUnfinished;
  for (fs::directory_iterator entry(copy.parent_path(), error); !error && entry != fs::end(entry);
       entry.increment(error)) {
    if (entry->path().filename().string().starts_with(begin)) folders.push_back(entry->path());
  }
  std::ranges::sort(folders);
  return folders;
}

/// The events without those of the stations from which the study was collected: their paths are of
/// other computers. The first event says how many events behind it were collected.
std::vector<storage::Event> eventsOfThisFolder(Study& study) {
  auto events = study.events().read();
  if (!study.isCollected() || events.empty()) return events;
  const auto ofStations = storage::storedValue<std::int64_t>(events.front().values, "events");
  const auto count = std::clamp<std::int64_t>(
      ofStations.value_or(0) + 1, 0, static_cast<std::int64_t>(events.size()));
  events.erase(events.begin(), events.begin() + count);
  return events;
}

/// Whether the copy may have data of sessions of @p mode.
bool mayHold(const KnownCopy& copy, RunMode mode) {
  return copy.runMode.empty() || copy.runMode == "all" || copy.runMode == nameOf(mode);
}

RunMode runModeOf(Study& study, const std::string& participant) {
  for (const auto& row : study.sessions().all()) {
    if (row.participant == participant) return row.runMode;
  }
  return RunMode::Live;
}

}  // namespace

std::vector<KnownCopy> knownCopies(Study& study) {
  std::vector<KnownCopy> copies;
  std::error_code ignored;
  for (const auto& event : eventsOfThisFolder(study)) {
    const auto folder = textIn(event, "folder");
    if (folder.empty() || isSamePath(folder, study.folder())) continue;
    copies.push_back(
        {.folder = folder,
         .what = std::string(event.name()),
         .madeUtc = asUtc(event.when.wall),
         .isPresent = fs::exists(folder, ignored),
         .content = contentOf(study, folder, textIn(event, "fingerprint")),
         .runMode = textIn(event, "run_mode"),
         .participant = textIn(event, "participant")});
    for (const auto& unfinished : unfinishedFoldersOf(folder)) {
      const bool isListed =
          std::ranges::any_of(copies, [&](const auto& copy) { return copy.folder == unfinished; });
      if (isListed) continue;
      auto copy = copies.back();
      copy.folder = unfinished.string();
      copy.isPresent = true;
      copies.push_back(std::move(copy));
    }
  }
  const auto exports = study.folder() / "exports";
  if (!fs::is_directory(exports, ignored)) return copies;
  for (const auto& entry : fs::directory_iterator(exports)) {
    const bool isKnown = std::ranges::any_of(copies, [&](const auto& copy) {
      return fs::equivalent(copy.folder, entry.path(), ignored);
    });
    if (isKnown) continue;
    copies.push_back(
        {.folder = entry.path().string(), .what = "exported", .madeUtc = {}, .isPresent = true});
  }
  return copies;
}

std::vector<KnownCopy> copiesNotErased(
    Study& study, const std::vector<ErasedCopy>& done, const std::string& participant) {
  auto known = knownCopies(study);
  const auto mode = runModeOf(study, participant);
  std::erase_if(known, [&](const KnownCopy& copy) {
    const bool isOfAnother = !copy.participant.empty() && copy.participant != participant;
    return isOfAnother || !mayHold(copy, mode) ||
           std::ranges::any_of(done, [&](const ErasedCopy& other) {
             return isSamePath(copy.folder, other.folder);
           });
  });
  for (const auto& event : study.events().read(EventKind::CopiedConsent)) {
    if (textIn(event, "participant") != participant) continue;
    known.push_back(
        {.folder = {},
         .what = std::string(event.name()),
         .madeUtc = asUtc(event.when.wall),
         .isPresent = true});
  }
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
