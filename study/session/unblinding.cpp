#include "study/session/unblinding.h"

#include "base/text_table.h"
#include "study/session/backup.h"
#include "study/storage/hasher.h"

namespace study {

const std::string_view kCopyNotNoted =
    "The study cannot be written, so that this copy is not in its list of copies: an erasure will "
    "not name it. Write down where it is.";

const std::string_view kNamesNotNoted =
    "The study cannot be written, so that its audit trail does not say that the names were shown.";

bool noteCopy(Study& study, const storage::Event& event) {
  try {
    if (study.isWritable()) {
      study.note(event);
    } else {
      Study::open(study.folder(), study.clock()).note(event);
    }
    return true;
  } catch (const storage::StorageError& error) {
    if (error.kind() == storage::StorageError::Kind::Busy) throw;
    return false;
  }
}

void recordUnblinding(Study& study, RunMode mode, EventKind kind, const std::string& reason) {
  if (mode == RunMode::Simulated) return;
  const bool isOpen = study.protocol().protocol.isOpenLabel;
  const bool hasReason = !base::isBlank(reason);
  if (isOpen && !hasReason) return;
  if (!hasReason) {
    throw storage::StorageError(
        "This names every condition beside the answers of real people, and whoever reads it is no "
        "longer blind. Say why it is wanted: it goes into the audit trail (--reason \"…\"). "
        "'palpate export' without --unblind is blinded.");
  }
  study.note(kind, reason);
}

bool recordReportPath(
    Study& study,
    RunMode mode,
    const std::string& how,
    const std::filesystem::path& path,
    std::string_view content) {
  if (mode == RunMode::Simulated) return true;
  storage::Event event{
      .actor = storage::Actor::Operator,
      .kind = EventKind::Exported,
      .values = {
          {"how", how},
          {"run_mode", std::string(nameOf(mode))},
          {"folder", pathForAuditTrail(path)}}};
  if (!content.empty()) event.values.emplace_back("fingerprint", fingerprintOf(study, content));
  return noteCopy(study, event);
}

bool recordConsentCopy(Study& study, const std::string& participant) {
  return noteCopy(
      study,
      {.actor = storage::Actor::Operator,
       .kind = EventKind::CopiedConsent,
       .values = {{"participant", participant}}});
}

bool recordNamesShown(Study& study, std::size_t names) {
  if (names == 0) return true;
  return noteCopy(
      study,
      {.actor = storage::Actor::Operator,
       .kind = EventKind::ShowedNames,
       .values = {{"names", base::asArgument(names)}}});
}

std::string fingerprintOf(Study& study, std::string_view content) {
  storage::Hasher hasher;
  hasher.add(content);
  const auto* key = study.database().key();
  return storage::inHexadecimal(
      key == nullptr ? hasher.finish() : hasher.finish(key->hashingKey()));
}

}  // namespace study
