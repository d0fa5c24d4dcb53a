#include "study/session/unblinding.h"

namespace study {

void noteUnblinding(Study& study, RunMode mode, EventKind kind, const std::string& reason) {
  if (mode == RunMode::Simulated) return;
  const bool isOpen = study.protocol().protocol.isBlindingOpen;
  if (isOpen && reason.empty()) return;
  if (reason.empty()) {
    throw storage::StorageError(
        "This names every condition beside the answers of real people, and whoever reads it is no "
        "longer blind. Say why it is wanted: it goes into the audit trail (--reason \"…\"). "
        "'palpate export' without --unblind is blinded.");
  }
  study.note(kind, reason);
}

}  // namespace study
